// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/conics/line_conditions.hpp"

#include <catch2/catch.hpp>

#include "conic_families.hpp"
#include "enclosures.hpp"

using namespace pn;
using namespace pn::test;

namespace {

/// x^2 - 2 y^2 + t^p z^2 in moving coordinates: at t = 0 of type (0, p), the lines irrational and
/// curved.
Conic with_curved_lines(int p) {
  const RationalPolynomial one(1L), t = power_of_t(1);
  const Conic moving = {{{one, t, conic_polynomial({0, 2})},
                         {RationalPolynomial(), one, conic_polynomial({0, 1, 1})},
                         {RationalPolynomial(), RationalPolynomial(), one}}};
  return transformed(diagonal(one, -RationalPolynomial(2L), power_of_t(p)), moving);
}

RationalSteps steps_leaving_lines(const ConicFamily& family) {
  const auto first = [](const RationalLattice&, const RationalLattice&) { return 0; };
  return rational_steps(family, singular_conics(family), first, Leave::kEveryChoice);
}

/// x^T C x at (t, u).
RealBall equation(const Conic& c, const QuadraticPoints& points, const Rational& t, long u) {
  std::array<RealBall, 3> x;
  for (std::size_t i = 0; i < 3; ++i) {
    const RealBall at(t, 256);
    const auto& b = points.coordinate[i];
    x[i] = b[0](at) + b[1](at) * RealBall(u) + b[2](at) * RealBall(u * u);
  }
  RealBall sum;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) sum += x[i] * RealBall(c[i][j](t), 256) * x[j];
  }
  return sum;
}

}  // namespace

TEST_CASE("Conditions of any order on two curved lines give points of the conics",
          "[line_conditions]") {
  for (int p = 1; p <= 5; ++p) {
    const Conic conic = with_curved_lines(p);
    const RationalSteps steps = steps_leaving_lines(conic_family(conic));
    const std::vector<LinePair> pairs = line_pairs(steps, 256);
    const LineConditions conditions(steps, pairs, 256);
    int balanced = 0;
    for (int i = 0; i <= p; ++i) {
      INFO("p = " << p << ", " << i << " conditions on the first line");
      LineChoice choice;
      for (const LinePair& pair : pairs) choice.push_back(pair.multiplicity == p ? i : 0);
      const auto points = conditions.balanced_points(choice);
      if (!points) continue;
      ++balanced;
      for (const long u : {-2L, 0L, 1L, 3L}) {
        for (const Rational& t : {Rational(0), Rational(1) / Rational(3), Rational(2)}) {
          CHECK(encloses_zero(equation(conic, *points, t, u), 1e-40));
        }
      }
    }
    CHECK(balanced > 0);
  }
}

TEST_CASE("A choice is recognised when the lines come in the other order", "[line_conditions]") {
  const ConicFamily family = conic_family(with_curved_lines(4));
  std::vector<LinePair> pairs = line_pairs(steps_leaving_lines(family), 128);
  REQUIRE_FALSE(pairs.empty());
  LineChoice choice;
  for (std::size_t i = 0; i < pairs.size(); ++i) choice.push_back(1);
  const std::vector<ChosenLine> chosen = places_of(pairs, choice);
  CHECK(recognized(pairs, chosen) == choice);
  for (LinePair& pair : pairs) std::swap(pair.line[0], pair.line[1]);
  const LineChoice other = recognized(pairs, chosen);
  for (std::size_t i = 0; i < pairs.size(); ++i) CHECK(other[i] == pairs[i].multiplicity - 1);
}
