// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/isotropic/spinor_factorization.hpp"

#include <catch2/catch.hpp>
#include <random>

#include "circle_families.hpp"
#include "enclosures.hpp"
#include "pn/algebra/precision.hpp"

using pn::CircleFamily;
using pn::ComplexBall;
using pn::Form;
using pn::RationalPolynomial;
using pn::RealBall;
using pn::SpinorMatrix;
using namespace pn::test;

namespace {

using ComplexForm = Form<ComplexBall>;

ComplexForm complex_form(const RationalPolynomial& re, const RationalPolynomial& im, int degree,
                         long precision) {
  auto form = ComplexForm::zero(degree);
  for (int i = 0; i <= degree; ++i) {
    form[i] =
        ComplexBall(RealBall(re.coefficient(i), precision), RealBall(im.coefficient(i), precision));
  }
  return form;
}

pn::HermitianMatrix<ComplexBall> hermitian(const CircleFamily& c, long precision) {
  const int h = c.degree();
  return {complex_form(c.level + c.axis[2], 0L, h, precision),
          complex_form(c.axis[0], -c.axis[1], h, precision),
          complex_form(c.level - c.axis[2], 0L, h, precision)};
}

/// The half of the roots in which `choice` (its bits, one for every copy of a pair) takes the upper
/// root.
pn::HalfRoots<ComplexBall> half_roots(const CircleFamily& circles, unsigned choice,
                                      long precision) {
  const RationalPolynomial d = circles.discriminant();
  const pn::RootSet set = isolate_roots(d, precision);
  pn::HalfRoots<ComplexBall> half;
  for (const auto& pair : set.pairs) {
    int copies = 0;
    for (int copy = 0; copy < pair.multiplicity; ++copy, choice /= 2) copies += choice % 2;
    half.pairs.push_back({pair.value, copies, pair.multiplicity - copies});
  }
  for (const auto& root : set.real) {
    REQUIRE(root.multiplicity % 2 == 0);
    half.real.push_back({ComplexBall(root.value), root.multiplicity / 2});
  }
  half.infinite = circles.degree() - d.degree() / 2;
  return half;
}

SpinorMatrix<ComplexBall> factorized(const CircleFamily& circles, unsigned choice) {
  return pn::at_sufficient_precision([&](long precision) {
    return spinor_factorization(hermitian(circles, precision),
                                half_roots(circles, choice, precision));
  });
}

/// Entry (j, k) of A* H A.
ComplexForm entry(const SpinorMatrix<ComplexBall>& a, const pn::HermitianMatrix<ComplexBall>& h,
                  int j, int k) {
  const std::array<std::array<ComplexForm, 2>, 2> matrix = {{{h.h00, h.h01}, {conj(h.h01), h.h11}}};
  ComplexForm sum;
  for (int r = 0; r < 2; ++r) {
    for (int s = 0; s < 2; ++s) sum += conj(a.entry[r][j]) * matrix[r][s] * a.entry[s][k];
  }
  return sum;
}

void check_zero(const ComplexForm& form) {
  for (const ComplexBall& c : form.coefficients()) {
    CHECK(encloses_zero(c.real(), 1e-6));
    CHECK(encloses_zero(c.imag(), 1e-6));
  }
}

/// A* H A = (D / lc D) J, coefficient by coefficient, and the degrees add up.
void check_factorization(const CircleFamily& circles, const SpinorMatrix<ComplexBall>& a) {
  const int h = circles.degree();
  CHECK(a.degree[0] + a.degree[1] == h);
  CHECK(a.degree[0] >= a.degree[1]);
  for (int j = 0; j < 2; ++j) {
    for (int i = 0; i < 2; ++i) REQUIRE(a.entry[i][j].degree() == a.degree[j]);
  }
  const auto matrix = hermitian(circles, 512);
  check_zero(entry(a, matrix, 0, 0));
  check_zero(entry(a, matrix, 1, 1));
  const RationalPolynomial d = circles.discriminant();
  const RationalPolynomial monic = exact_quotient(d, RationalPolynomial(d.coefficient(d.degree())));
  check_zero(entry(a, matrix, 0, 1) - complex_form(0L, monic, 2 * h, 512));
}

/// Checks every choice of roots and returns the least of the larger column degrees.
int least_degree(const CircleFamily& circles, int copies) {
  int least = circles.degree() + 1;
  for (unsigned choice = 0; choice < (1u << copies); ++choice) {
    INFO("root choice " << choice);
    const auto a = factorized(circles, choice);
    check_factorization(circles, a);
    least = std::min(least, a.degree[0]);
  }
  return least;
}

/// A family with D > 0 on the whole projective line and no other property.
class GenericFamilies {
 public:
  CircleFamily next(int h) {
    CircleFamily family{{any(h), any(h), any(h)}, 0L};
    // |level| < |axis|: a linear function of the axis of norm 3/5.
    const RationalPolynomial fifths(pn::Rational(1L) / pn::Rational(5L));
    family.level = fifths * (RationalPolynomial(2L) * family.axis[0] - family.axis[1] +
                             RationalPolynomial(2L) * family.axis[2]);
    return family;
  }

 private:
  RationalPolynomial any(int degree) {
    std::vector<long> c;
    for (int i = 0; i <= degree; ++i) c.push_back(static_cast<long>(generator_() % 19) - 9);
    c.back() = c.back() == 0 ? 1 : c.back();
    return polynomial(c);
  }
  std::mt19937_64 generator_{3};
};

}  // namespace

TEST_CASE("A* H A = D J for every choice of roots, and the best has degree ceil(h/2)",
          "[spinor_factorization]") {
  GenericFamilies generic;
  for (int h = 0; h <= 6; ++h) {
    INFO("h = " << h);
    CHECK(least_degree(generic.next(h), h) == (h + 1) / 2);
  }
}

TEST_CASE("Pipes: R = 0, in space and in the plane", "[spinor_factorization]") {
  GenericFamilies generic;
  for (int h = 1; h <= 5; ++h) {
    INFO("h = " << h);
    CircleFamily pipe = generic.next(h);
    pipe.level = 0L;
    CHECK(least_degree(pipe, h) == (h + 1) / 2);
    pipe.axis[2] = 0L;
    CHECK(least_degree(pipe, h) == (h + 1) / 2);
  }
}

TEST_CASE("Conjugate pairs of multiplicity two and three", "[spinor_factorization]") {
  const auto c = factor(1, 2), e = factor(-2, 1);
  CHECK(least_degree(turned(planted_family(product({c, c}), polynomial({3, 1, 2}))), 2) == 1);
  CHECK(least_degree(turned(planted_family(product({c, c, c}), polynomial({1, 0, 5, 1}))), 3) == 2);
  CHECK(least_degree(turned(planted_family(product({c, c, e, e}), polynomial({1, 4, 0, -2, 3}))),
                     4) == 2);
}

TEST_CASE("A real double root and one at infinity", "[spinor_factorization]") {
  const auto c = factor(1, 2), e = factor(-2, 1);
  CHECK(least_degree(turned(planted_family(product({factor(3, 0), c}), polynomial({1, 2, 5}))),
                     1) == 1);
  CHECK(least_degree(
            turned(planted_family(product({factor(-4, 0), c, e}), polynomial({1, 0, 5, 1}))), 2) ==
        2);
  CHECK(least_degree(turned(planted_family(product({c}), polynomial({1, 2, 5}))), 1) == 1);
  CHECK(least_degree(turned(planted_family(product({c, e}), polynomial({1, 2, 5, 2}))), 2) == 2);
  CHECK(least_degree(turned(planted_family(product({factor(3, 0), c}), polynomial({1, 2, 5, 2}))),
                     1) <= 2);
}

TEST_CASE("Every step costs few digits", "[spinor_factorization]") {
  constexpr long kBits = pn::kLeastPrecision, kBitsPerStep = 5, kBitsBeside = 15;
  GenericFamilies generic;
  for (int h = 1; h <= 8; ++h) {
    INFO("h = " << h);
    const CircleFamily family = generic.next(h);
    const auto a = spinor_factorization(hermitian(family, kBits), half_roots(family, 0, kBits));
    double size = 0, radius = 0;
    for (const auto& row : a.entry) {
      for (const ComplexForm& form : row) {
        for (const ComplexBall& z : form.coefficients()) {
          size = std::max(size, std::abs(z.midpoint()));
          radius = std::max({radius, z.real().radius(), z.imag().radius()});
        }
      }
    }
    CHECK(radius <= std::ldexp(size, kBitsBeside + kBitsPerStep * h - kBits));
  }
}

TEST_CASE("In doubles the factorization is that in balls up to rounding",
          "[spinor_factorization]") {
  GenericFamilies generic;
  for (int h = 1; h <= 5; ++h) {
    const CircleFamily family = generic.next(h);
    const auto in_balls = factorized(family, 5);
    const auto estimate = [](const ComplexForm& form) {
      std::vector<std::complex<double>> values;
      for (const ComplexBall& z : form.coefficients()) values.push_back(z.midpoint());
      return Form<std::complex<double>>(values);
    };
    const auto matrix = hermitian(family, 128);
    const auto half = half_roots(family, 5, 128);
    pn::HalfRoots<std::complex<double>> half_estimate;
    for (const auto& [root, copies, conjugates] : half.pairs) {
      half_estimate.pairs.push_back({root.midpoint(), copies, conjugates});
    }
    const auto in_doubles = pn::spinor_factorization<std::complex<double>>(
        {estimate(matrix.h00), estimate(matrix.h01), estimate(matrix.h11)}, half_estimate);
    REQUIRE(in_doubles.degree == in_balls.degree);
    for (int i = 0; i < 2; ++i) {
      for (int j = 0; j < 2; ++j) {
        for (int d = 0; d <= in_doubles.degree[j]; ++d) {
          const auto expected = in_balls.entry[i][j][d].midpoint();
          CHECK(std::abs(in_doubles.entry[i][j][d] - expected) < 1e-8 * (1 + std::abs(expected)));
        }
      }
    }
  }
}
