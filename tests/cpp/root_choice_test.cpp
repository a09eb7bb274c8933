// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/isotropic/root_choice.hpp"

#include <catch2/catch.hpp>

#include "circle_families.hpp"
#include "pn/isotropic/envelope.hpp"

using namespace pn;
using namespace pn::test;

namespace {

/// The circles in numbers and the roots of their D.
struct Local {
  CircleForms<RealBall> circles;
  DoubleRoots roots;
};

Local local_at(const CircleFamily& circles, long precision) {
  const LocalFamily family = local_family(circles, precision);
  return {circle_forms(circles, *family.parameter), family.roots};
}

/// Pairs of multiplicity two and one; D has no real zero.
CircleFamily circles() {
  const auto c = factor(1, 2), e = factor(-2, 1);
  return turned(planted_family(product({c, c, e}), polynomial({1, 0, 5, 1})));
}

int column_degree(const Local& local, const RootChoice& choice) {
  return spinor_factorization(hermitian_matrix(local.circles), half_roots(local.roots, choice))
      .degree[0];
}

}  // namespace

TEST_CASE("A choice stands for half of the roots", "[root_choice]") {
  const Local local = local_at(circles(), 128);
  REQUIRE(local.roots.pairs.size() == 2);
  const std::size_t twice = local.roots.pairs[0].multiplicity == 2 ? 0 : 1;
  RootChoice choice(2, 0);
  choice[twice] = 1;
  const auto half = half_roots(local.roots, choice);
  int copies = 0, conjugates = 0;
  for (const auto& pair : half.pairs) {
    CHECK(pair.root.imag().is_positive());
    copies += pair.copies;
    conjugates += pair.conjugates;
  }
  CHECK(copies == 1);
  CHECK(conjugates == 2);
  CHECK(half.real.empty());
  CHECK(half.infinite == 0);
}

TEST_CASE("No choice has a lower degree than the best", "[root_choice]") {
  const Local local = local_at(circles(), 256);
  const int best = column_degree(local, best_root_choice(local.circles, local.roots));
  CHECK(best == 2);
  for (int a = 0; a <= local.roots.pairs[0].multiplicity; ++a) {
    for (int b = 0; b <= local.roots.pairs[1].multiplicity; ++b) {
      CHECK(column_degree(local, {a, b}) >= best);
    }
  }
}

TEST_CASE("The matrix of the circles has determinant -D", "[root_choice]") {
  const Local local = local_at(circles(), 128);
  const auto h = hermitian_matrix(local.circles);
  const auto determinant = h.h00 * h.h11 - h.h01 * conj(h.h01);
  const RationalPolynomial d = circles().discriminant();
  for (int i = 0; i <= determinant.degree(); ++i) {
    CHECK(determinant[i].real().contains(-d.coefficient(i)));
    CHECK(determinant[i].imag().contains_zero());
  }
}
