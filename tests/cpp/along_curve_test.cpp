// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/isotropic/along_curve.hpp"

#include <catch2/catch.hpp>
#include <optional>
#include <random>

#include "circle_families.hpp"
#include "enclosures.hpp"

using namespace pn;
using namespace pn::test;

namespace {

Envelope along(const SphereCurve& curve) {
  return along_curve(curve, tangent_direction(curve).circles);
}

/// The curve of spheres that an envelope carries.
const SphereCurveForms<RealBall>& curve_of(const IsotropicHypersurface<RealBall>& gamma) {
  return std::get<SphereCurveForms<RealBall>>(gamma.carrier);
}

class RandomPolynomials {
 public:
  RationalPolynomial next(int degree) {
    std::vector<long> c;
    for (int i = 0; i <= degree; ++i) c.push_back(static_cast<long>(generator_() % 19) - 9);
    c.back() = c.back() == 0 ? 1 : c.back();
    return polynomial(c);
  }

  /// A curve of spheres with |r'| <= 3/5 |m'|, so that D has no real zero: r is a linear function
  /// of m.
  SphereCurve curve(int degree, const RationalPolynomial& denominator) {
    const RationalPolynomial x = next(degree), y = next(degree), z = next(degree);
    const RationalPolynomial fifth(Rational(1L) / Rational(5L)), two(2L);
    return {{x, y, z}, fifth * (two * x - y + two * z), denominator};
  }

 private:
  std::mt19937_64 generator_{11};
};

/// n.M + R = 0 as forms in t for each coefficient in u; |n| = 1 at some points.
void check_gamma(const Envelope& envelope) {
  const auto gamma = envelope.enclosure(128);
  const auto w = pn::isotropic_vector<RealBall>(gamma.spinor);
  for (std::size_t q = 0; q < 3; ++q) {
    auto sum = gamma.circles.level * w[3].coefficient[q];
    for (std::size_t i = 0; i < 3; ++i) sum += gamma.circles.axis[i] * w[i].coefficient[q];
    for (const RealBall& c : sum.coefficients()) CHECK(encloses_zero(c, 1e-6));
  }
  for (const double t : {0.0, 0.375, 1.0}) {
    for (const double angle : {0.0, 1.0, 2.5}) {
      const RealBall at = RealBall(t).at_precision(128);
      std::array<RealBall, 4> value;
      for (std::size_t i = 0; i < 4; ++i) {
        value[i] = jet(w[i], at, RealBall(std::cos(angle)), RealBall(std::sin(angle))).value;
      }
      REQUIRE(value[3].is_positive());
      const auto squares = value[0] * value[0] + value[1] * value[1] + value[2] * value[2];
      CHECK(encloses_zero(squares / (value[3] * value[3]) - RealBall(1), 1e-9));
    }
  }
}

/// A curve of which every sphere tells its parameter: centre (t, t^2, t^3), radius 2 - t.
SphereCurve telling_curve() {
  return {{polynomial({0, 1}), polynomial({0, 0, 1}), polynomial({0, 0, 0, 1})},
          polynomial({2, -1}),
          1L};
}

/// R = (f - g) / 2 and M = ((f + g) / 2, 0, 0), turned: D = f g.
CircleFamily family_with_discriminant(const RationalPolynomial& f, const RationalPolynomial& g) {
  return turned({{f + g, 0L, 0L}, f - g});
}

}  // namespace

TEST_CASE("Polynomial spine and radius of degree k: degrees 4, 5, 8, 9, 12, 13", "[along_curve]") {
  const std::array<int, 6> degrees = {4, 5, 8, 9, 12, 13};
  RandomPolynomials random;
  for (int k = 2; k <= 7; ++k) {
    INFO("k = " << k);
    const SphereCurve curve = random.curve(k, 1L);
    REQUIRE(tangent_direction(curve).circles.degree() == k - 1);
    const Envelope envelope = along(curve);
    CHECK(envelope.degree() == degrees[static_cast<std::size_t>(k - 2)]);
    CHECK_FALSE(envelope.is_substituted());
    check_gamma(envelope);
  }
}

TEST_CASE("Rational spine and radius of degree k: degree 3k - 2", "[along_curve]") {
  RandomPolynomials random;
  const std::array<RationalPolynomial, 3> denominators = {
      polynomial({3, 1, 2}), polynomial({4, 1, 2, 1}), polynomial({5, 1, 0, 2, 3})};
  for (int k = 2; k <= 4; ++k) {
    INFO("k = " << k);
    const SphereCurve curve = random.curve(k, denominators[static_cast<std::size_t>(k - 2)]);
    REQUIRE(tangent_direction(curve).circles.degree() == 2 * k - 2);
    const Envelope envelope = along(curve);
    CHECK(envelope.degree() == 3 * k - 2);
    check_gamma(envelope);
  }
}

TEST_CASE("Straight lines and circles keep their low degree", "[along_curve]") {
  CHECK(along({{polynomial({0, 4}), polynomial({1, 3}), 0L}, polynomial({2, 1}), 1L}).degree() ==
        1);
  // Speed that varies along a straight line is content: the circles stay those of the cylinder.
  CHECK(along({{polynomial({0, 1, 1, 1}), 0L, 0L}, 2L, 1L}).degree() == 3);
  const RationalPolynomial q = polynomial({1, 0, 1});
  const Envelope torus =
      along({{polynomial({5, 0, -5}), polynomial({0, 10}), 0L}, RationalPolynomial(2L) * q, q});
  CHECK(torus.degree() == 4);
  check_gamma(torus);
}

TEST_CASE("Odd real roots beside [0, 1] are substituted away", "[along_curve]") {
  const auto root = [](long r) { return polynomial({-r, 1}); };
  const auto pair = polynomial({3, 1, 1});
  struct Case {
    std::string roots;
    RationalPolynomial f, g;
    bool even_roots;
  };
  const std::vector<Case> cases = {
      {"-1 and 2", root(-1), -root(2), false},
      {"-1 and infinity", root(-1), 1L, false},
      {"infinity and 2", -root(2), 1L, false},
      {"-1, 2 and pairs", root(-1) * pair, -root(2) * polynomial({2, 0, 1}), false},
      {"-3, -1, 2, 5", root(-1) * root(5), root(2) * root(-3), false},
      {"-3, -2, -1 and infinity", root(-1) * root(-2), root(-3), false},
      {"-1, 2 and a double root -4 beyond", root(-1) * root(-4) * root(-4), -root(2), true},
      {"-5, 2 and a double root -1 between", root(-1) * root(-1) * root(-5), -root(2), true},
      {"a triple root -1 and 2", root(-1) * root(-1) * root(-1), -root(2), true},
  };
  for (const Case& c : cases) {
    INFO("D has the roots " << c.roots);
    const CircleFamily family = family_with_discriminant(c.f, c.g);
    REQUIRE(is_positive_on_unit_interval(family.discriminant()));
    const Envelope envelope = along_curve(telling_curve(), family);
    CHECK(envelope.is_substituted());
    const int least = 2 * 3 + 2 * family.degree();
    CHECK(envelope.degree() >= least);
    if (!c.even_roots) CHECK(envelope.degree() == least);
    check_gamma(envelope);

    // The local parameter moves t from 0 to 1 along the same curve of spheres.
    const auto gamma = envelope.enclosure(128);
    const auto& curve = curve_of(gamma);
    double before = -1;
    for (const double s : {0.0, 0.125, 0.5, 0.75, 1.0}) {
      const RealBall at = RealBall(s).at_precision(128), q = curve.denominator(at),
                     t = curve.centre[0](at) / q;
      CHECK(t.midpoint() > before);
      before = t.midpoint();
      if (s == 0) CHECK(t.contains(Rational(0L)));
      if (s == 1) CHECK(t.contains(Rational(1L)));
      CHECK(encloses_zero(curve.centre[1](at) / q - t * t, 1e-20));
      CHECK(encloses_zero(curve.centre[2](at) / q - t * t * t, 1e-20));
      CHECK(encloses_zero(curve.radius(at) / q - RealBall(2) + t, 1e-20));
    }
  }
}

TEST_CASE("Planted roots: multiple pairs, real double roots, double roots at infinity",
          "[along_curve]") {
  const auto c = factor(1, 2), conjugate = factor(1, -2), e = factor(-2, 1), real = factor(-1, 0),
             other = factor(-2, 0);
  struct Case {
    std::string roots;
    CircleFamily family;
    int most;  ///< the theorem's bound max(ceil(h/2), h - sum ceil(p/2)) on the larger column
               ///< degree
  };
  const std::vector<Case> cases = {
      {"c c", planted_family(product({c, c}), polynomial({3, 1, 2})), 1},
      {"c c~", planted_family(product({c, conjugate}), polynomial({7, 4, 1})), 1},
      {"c c c", planted_family(product({c, c, c}), polynomial({1, 0, 5, 1})), 2},
      {"c c~ c e", planted_family(product({c, conjugate, c, e}), polynomial({7, 4, 1, -2, 3})), 2},
      {"r", planted_family(product({real}), 1L), 1},
      {"r r", planted_family(product({real, real}), polynomial({1, 5})), 2},
      {"r c", planted_family(product({real, c}), polynomial({1, 5, 7})), 1},
      {"r s c", planted_family(product({real, other, c}), polynomial({1, 5, 7, 1})), 2},
      {"infinity infinity c", planted_family(product({c}), polynomial({1, 5, 7, 1})), 2},
      {"infinity r", planted_family(product({real}), polynomial({1, 5, 7})), 2},
      // Only real double roots: the low column (1, 0) spans every kernel.
      {"r s", planted_family(product({real, other}), 1L), 2},
  };
  for (const Case& planted : cases) {
    for (const CircleFamily& family : {planted.family, turned(planted.family)}) {
      INFO("f has the roots " << planted.roots);
      std::optional<Envelope> envelope;
      REQUIRE_NOTHROW(envelope = along_curve(telling_curve(), family));
      CHECK_FALSE(envelope->is_substituted());
      CHECK(envelope->degree() >= 3 + 2 * ((family.degree() + 1) / 2));
      CHECK(envelope->degree() <= 3 + 2 * planted.most);
      check_gamma(*envelope);
    }
  }
}

TEST_CASE("More precision encloses the same hypersurface more closely", "[along_curve]") {
  RandomPolynomials random;
  for (const auto& envelope :
       {along(random.curve(5, 1L)),
        along_curve(telling_curve(),
                    family_with_discriminant(polynomial({1, 1}), polynomial({2, -1})))}) {
    const auto coarse = envelope.enclosure(128), fine = envelope.enclosure(512);
    REQUIRE(coarse.spinor.degree == fine.spinor.degree);
    for (int i = 0; i < 2; ++i) {
      for (int j = 0; j < 2; ++j) {
        for (int d = 0; d <= fine.spinor.degree[static_cast<std::size_t>(j)]; ++d) {
          const auto &a = coarse.spinor.entry[i][j][d], &b = fine.spinor.entry[i][j][d];
          CHECK(a.real().overlaps(b.real()));
          CHECK(a.imag().overlaps(b.imag()));
        }
      }
    }
  }
}

TEST_CASE("Midpoints estimate the enclosure", "[along_curve]") {
  RandomPolynomials random;
  const auto gamma = along(random.curve(4, 1L)).enclosure(128);
  const auto estimate = midpoint(gamma);
  CHECK(estimate.spinor.degree == gamma.spinor.degree);
  CHECK(estimate.circles.axis[1](0.5) == Approx(gamma.circles.axis[1](RealBall(0.5)).midpoint()));
  CHECK(std::abs(estimate.spinor.entry[1][0][0] - gamma.spinor.entry[1][0][0].midpoint()) == 0);
}
