// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/isotropic/torsal_ruling.hpp"

#include <catch2/catch.hpp>

#include "enclosures.hpp"
#include "rulings_between.hpp"
#include "surface_concept.hpp"

using namespace pn;
using namespace pn::test;

namespace {

RationalPolynomial integral(const RationalPolynomial& slope) {
  std::vector<Rational> power = {Rational(1L)};
  for (int i = 0; i <= slope.degree(); ++i) {
    power.push_back(slope.coefficient(i) / Rational(long{i + 1}));
  }
  return RationalPolynomial(power);
}

/// On the x-axis with rulings (., 4, z): torsal where z' vanishes.
Directrices curves(const RationalPolynomial& slope) {
  const SphereCurve line{{polynomial({0, 5}), 0L, 0L}, 0L, 1L};
  return {line, {{polynomial({1, 7, 1}), 4L, integral(slope)}, 0L, 1L}};
}

struct Planted {
  std::string places;
  RationalPolynomial slope;
  std::vector<Rational> roots;
};

const Rational kHalf = Rational(1L) / Rational(2L), kQuarter = Rational(1L) / Rational(4L);

const std::vector<Planted> kPlanted = {
    {"inside", polynomial({-1, 2}), {kHalf}},
    {"at the beginning", polynomial({0, 1}), {Rational(0L)}},
    {"at the end", polynomial({1, -1}), {Rational(1L)}},
    {"at both ends", polynomial({0, 1, -1}), {Rational(0L), Rational(1L)}},
    {"two inside", polynomial({-3, 16, -16}), {kQuarter, Rational(3L) / Rational(4L)}},
};

}  // namespace

TEST_CASE("At a torsal ruling all normals are the one of the ruling", "[torsal_ruling]") {
  for (const Planted& planted : kPlanted) {
    INFO(planted.places);
    const Envelope envelope = along(curves(planted.slope));
    const auto gamma = envelope.enclosure(192);
    const auto w = isotropic_vector<RealBall>(gamma.spinor);
    REQUIRE(rulings_of(gamma).torsal_roots.size() == planted.roots.size());
    for (const Rational& root : planted.roots) {
      const RealBall t(root, 192);
      const auto normal = [&](double angle, std::size_t i) {
        const RealBall u0(std::cos(angle)), u1(std::sin(angle));
        return jet(w[i], t, u0, u1).value / jet(w[3], t, u0, u1).value;
      };
      for (std::size_t i = 0; i < 3; ++i) {
        for (const double angle : {0.7, 1.9}) {
          CHECK(encloses_zero(normal(angle, i) - normal(0.2, i), 1e-15));
        }
      }
    }
  }
}

TEST_CASE("Across a torsal ruling the sections stay regular and the ruling is a line",
          "[torsal_ruling]") {
  for (const Planted& planted : kPlanted) {
    INFO(planted.places);
    const Directrices lines = curves(planted.slope);
    const Envelope envelope = along(lines);
    const auto gamma = envelope.enclosure(192);
    const auto forms = sections(gamma.carrier, isotropic_vector<RealBall>(gamma.spinor));
    CHECK(forms.weight.coefficient[0].degree() == envelope.degree());
    for (const Rational& root : planted.roots) {
      const RealBall t(root, 192);
      std::vector<double> along_ruling;
      for (const double angle : {0.1, 0.4, 0.8, 1.3, 1.9, 2.6}) {
        const RealBall u0(std::cos(angle)), u1(std::sin(angle));
        const RealBall weight = jet(forms.weight, t, u0, u1).value;
        REQUIRE_FALSE(weight.contains_zero());
        const auto at = contact(forms, t, u0, u1);
        // y : z = 4 : z(t*), x free.
        CHECK(encloses_zero(
            at.point[2] * RealBall(4) - at.point[1] * RealBall(lines[1].centre[2](root), 192),
            1e-9 * (1 + at.point[1].magnitude_upper())));
        along_ruling.push_back((at.point[1] / RealBall(4)).midpoint());
        check_identities(forms, t, u0, u1);
      }
      // Different u are different points.
      for (std::size_t i = 1; i < along_ruling.size(); ++i) {
        CHECK(std::abs(along_ruling[i] - along_ruling[i - 1]) > 1e-6);
      }
    }
  }
}

TEST_CASE("A torsal ruling costs three degrees, and one for neighbours", "[torsal_ruling]") {
  // The same degrees of curves with slopes that have no zero in [0, 1].
  const int linear = along(curves(polynomial({3, 2}))).degree(),
            quadratic = along(curves(polynomial({3, 2, 1}))).degree();
  CHECK(along(curves(polynomial({-1, 2}))).degree() == linear + 3);
  CHECK(along(curves(polynomial({-1, 3})), kBetween).degree() == linear + 4);
  CHECK(along(curves(polynomial({0, 1, -1}))).degree() == quadratic + 6);
  CHECK(along(curves(polynomial({0, 1, -1})), kBetween).degree() <= quadratic + 7);
}

TEST_CASE("Without torsal rulings the spinors stay", "[torsal_ruling]") {
  const auto gamma = along(curves(polynomial({3, 2}))).enclosure(128);
  const auto same = pinched_at_torsal_rulings(gamma.spinor, rulings_of(gamma));
  CHECK(same.degree == gamma.spinor.degree);
}
