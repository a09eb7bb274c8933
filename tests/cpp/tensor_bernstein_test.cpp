// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/algebra/tensor_bernstein.hpp"

#include <catch2/catch.hpp>
#include <random>

#include "pn/algebra/roots.hpp"

using namespace pn;

namespace {

const RationalPolynomial kT({Rational(0L), Rational(1L)});
const BivariatePolynomial kU(kT, Variable::kU), kV(kT, Variable::kV);

constexpr long kBits = 192;

/// Integer coefficients from -9 to 9.
BivariatePolynomial random_polynomial(std::mt19937& generator, int degree_u, int degree_v) {
  std::vector<std::vector<Rational>> coefficients(static_cast<std::size_t>(degree_u) + 1);
  for (auto& row : coefficients) {
    for (int j = 0; j <= degree_v; ++j) {
      row.emplace_back(static_cast<long>(generator() % 19) - 9);
    }
  }
  return BivariatePolynomial(coefficients);
}

/// p on the unit square that is mapped onto the rectangle, over Q.
BivariatePolynomial on(const BivariatePolynomial& p, const Rectangle& r) {
  const auto linear = [&](std::size_t i, Variable variable) {
    const Rational low = Rational::exactly(r.low[i]), high = Rational::exactly(r.high[i]);
    return BivariatePolynomial(RationalPolynomial({low, high - low}), variable);
  };
  return p.composed(linear(0, Variable::kU), linear(1, Variable::kV));
}

/// The Bernstein coefficient by its definition: b_ij = sum C(i, k) C(j, l) a_kl / (C(m, k) C(n,
/// l)).
Rational coefficient(const BivariatePolynomial& p, int degree_u, int degree_v, int i, int j) {
  const auto binomial = [](int n, int k) {
    Rational result(1L);
    for (int m = 0; m < k; ++m) result *= Rational(long{n - m}) / Rational(long{m + 1});
    return result;
  };
  Rational sum;
  for (int k = 0; k <= i; ++k) {
    for (int l = 0; l <= j; ++l) {
      sum += p.coefficient(k, l) * binomial(i, k) * binomial(j, l) /
             (binomial(degree_u, k) * binomial(degree_v, l));
    }
  }
  return sum;
}

void check_encloses(const TensorBernstein& b, const BivariatePolynomial& p) {
  for (int i = 0; i <= b.degree(Variable::kU); ++i) {
    for (int j = 0; j <= b.degree(Variable::kV); ++j) {
      const Rational exact = coefficient(p, b.degree(Variable::kU), b.degree(Variable::kV), i, j);
      CHECK(b.coefficient(i, j).contains(exact));
      CHECK((b.coefficient(i, j) - RealBall(exact, kBits)).magnitude_upper() < 1e-40);
    }
  }
}

void check_within_error(const RoundedBernstein& b, const BivariatePolynomial& p, int degree_u,
                        int degree_v) {
  for (int i = 0; i <= degree_u; ++i) {
    for (int j = 0; j <= degree_v; ++j) {
      const Rational difference =
          Rational::exactly(b.coefficient(i, j)) - coefficient(p, degree_u, degree_v, i, j);
      const Rational error = Rational::exactly(b.error());
      CHECK(!(difference > error));
      CHECK(!(-difference > error));
    }
  }
}

}  // namespace

TEST_CASE("Enclosures contain the coefficients, elevated or restricted", "[tensor_bernstein]") {
  std::mt19937 generator(1);
  const Rectangle rectangle = {{0.375, 0}, {0.5, 0.25}}, corner = {{0.5, 0.75}, {1, 1}};
  for (const auto& [m, n] : {std::array{0, 0}, {3, 1}, {1, 5}, {4, 4}}) {
    const BivariatePolynomial p = random_polynomial(generator, m, n);
    check_encloses(TensorBernstein(p, m, n, kBits), p);
    check_encloses(TensorBernstein(p, m + 2, n + 3, kBits), p);
    for (const Rectangle& part : {rectangle, corner, Rectangle()}) {
      check_encloses(TensorBernstein(p, m, n, kBits).on(part), on(p, part));
    }
  }
}

TEST_CASE("Sums and multiples are those of the polynomials", "[tensor_bernstein]") {
  std::mt19937 generator(2);
  const BivariatePolynomial p = random_polynomial(generator, 2, 3),
                            q = random_polynomial(generator, 2, 3);
  check_encloses(TensorBernstein(p, 2, 3, kBits) + TensorBernstein(q, 2, 3, kBits) * RealBall(-3L),
                 p - BivariatePolynomial(3L) * q);
}

TEST_CASE("Doubles stay within their error through halvings and differences",
          "[tensor_bernstein]") {
  std::mt19937 generator(3);
  for (int round = 0; round < 20; ++round) {
    const int m = static_cast<int>(generator() % 7), n = static_cast<int>(generator() % 7);
    // Thirds are not doubles.
    const BivariatePolynomial third(Rational(1L) / Rational(3L));
    const BivariatePolynomial p = random_polynomial(generator, m, n) * third,
                              q = random_polynomial(generator, m, n) * third;
    RoundedBernstein b(TensorBernstein(p, m, n, kBits)), c(TensorBernstein(q, m, n, kBits));
    Rectangle rectangle;
    for (int halvings = 0; halvings < 12; ++halvings) {
      const Variable variable = generator() % 2 == 0 ? Variable::kU : Variable::kV;
      const std::size_t side = generator() % 2;
      b = b.halved(variable)[side];
      c = c.halved(variable)[side];
      rectangle = rectangle.halved(variable)[side];
    }
    CHECK(b.error() < 1e-12);
    check_within_error(b, on(p, rectangle), m, n);
    check_within_error(b.minus(0.7, c),
                       on(p - BivariatePolynomial(Rational::exactly(0.7)) * q, rectangle), m, n);
  }
}

TEST_CASE("The error of the doubles counts: signs are proved or open", "[tensor_bernstein]") {
  const auto rounded = [](const BivariatePolynomial& p) {
    return RoundedBernstein(TensorBernstein(p, 2, 2, kBits));
  };
  const BivariatePolynomial one(1L);
  CHECK(rounded(kU + kV + one).is_positive());
  CHECK(rounded(-kU - one).is_negative());
  CHECK_FALSE(rounded(kU).is_positive());
  CHECK(rounded(kU).possible_sign() == 1);
  CHECK(rounded(-kU).possible_sign() == -1);
  CHECK(rounded(kU - kV).possible_sign() == 0);
  // After one halving at 1 the value 1e-17 is below the error that the larger coefficients left;
  // rounded anew near 0 it is not.
  const BivariatePolynomial p = kU * kU + kV * kV + BivariatePolynomial(Rational::exactly(1e-17));
  const RoundedBernstein quarter = rounded(p).halved(Variable::kU)[0].halved(Variable::kV)[0];
  CHECK_FALSE(quarter.is_positive());
  CHECK(quarter.possible_sign() == 1);
  CHECK_FALSE(rounded(kU).lacks_digits());
  RoundedBernstein corner = quarter;
  for (int i = 0; i < 20; ++i) corner = corner.halved(Variable::kU)[0].halved(Variable::kV)[0];
  CHECK_FALSE(corner.is_positive());
  CHECK(corner.lacks_digits());
  const Rectangle near = {{0, 0}, {0x1p-30, 0x1p-30}};
  CHECK(RoundedBernstein(TensorBernstein(p, 2, 2, kBits).on(near)).is_positive());
}

TEST_CASE("An enclosure wider than doubles is undecided", "[tensor_bernstein]") {
  const BivariatePolynomial third(Rational(1L) / Rational(3L));
  const TensorBernstein difference =
      TensorBernstein(third, 0, 0, 64) + TensorBernstein(third, 0, 0, 64) * RealBall(-1L);
  CHECK_THROWS_AS(RoundedBernstein(difference), Undecided);
  CHECK_FALSE(RoundedBernstein(TensorBernstein(BivariatePolynomial(), 1, 1, 64)).is_positive());
}

TEST_CASE("Coefficients may vanish", "[tensor_bernstein]") {
  CHECK(has_non_negative_coefficients(BivariatePolynomial()));
  CHECK(has_non_negative_coefficients(kU * kV));
  const BivariatePolynomial one(1L);
  CHECK(has_non_negative_coefficients((one - kU) * kV));
  CHECK_FALSE(has_non_negative_coefficients(kU - kV));
}

TEST_CASE("The variable to halve is the one that bends, else the one that changes",
          "[tensor_bernstein]") {
  const auto variable = [](const BivariatePolynomial& p) {
    return RoundedBernstein(TensorBernstein(p, 2, 2, kBits)).decisive_variable();
  };
  const BivariatePolynomial half(Rational(1L) / Rational(2L));
  const BivariatePolynomial tiny(Rational(1L) / Rational(1000L));
  CHECK(variable((kU - half) * (kU - half) + tiny + tiny * kV * kV) == Variable::kU);
  CHECK(variable((kV - half) * (kV - half) + tiny + tiny * kU * kU) == Variable::kV);
  CHECK(variable(kU - half) == Variable::kU);
  CHECK(variable(kV - half) == Variable::kV);
  const auto slope =
      RoundedBernstein(TensorBernstein(kU * BivariatePolynomial(3L) - kV, 3, 2, kBits)).slope();
  CHECK(slope[0] == Approx(3));
  CHECK(slope[1] == Approx(-1));
}

TEST_CASE("A polynomial is proved to be positive on the square, or is not", "[tensor_bernstein]") {
  const BivariatePolynomial one(1L), half(Rational(1L) / Rational(2L)),
      tiny(Rational(1L) / Rational(1000000L));
  const BivariatePolynomial bowl = (kU - half) * (kU - half) + (kV - half) * (kV - half);
  CHECK(is_positive_on_square(one));
  CHECK(is_positive_on_square(bowl + tiny));
  CHECK_FALSE(is_positive_on_square(bowl));
  CHECK_FALSE(is_positive_on_square(bowl - tiny));
  CHECK_FALSE(is_positive_on_square(kU + kV));
  CHECK_FALSE(is_positive_on_square(-one));
  CHECK_FALSE(is_positive_on_square(BivariatePolynomial()));
  // Positive on the square, not beyond it.
  CHECK(is_positive_on_square((kU + tiny) * (one + tiny - kV)));
}
