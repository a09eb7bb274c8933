// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/isotropic/along_rulings.hpp"

#include <catch2/catch.hpp>

#include "enclosures.hpp"
#include "error_code.hpp"
#include "pn/algebra/roots.hpp"
#include "rulings_between.hpp"
#include "surface_concept.hpp"

using namespace pn;
using namespace pn::test;

namespace {

/// Identities at some normals, and x_d - x = d n with n from w itself.
void check_gamma(const Envelope& envelope) {
  const auto gamma = envelope.enclosure(192);
  const auto w = isotropic_vector<RealBall>(gamma.spinor);
  const auto forms = sections(gamma.carrier, w);
  CHECK(forms.weight.degree() == 4);
  CHECK(forms.weight.coefficient[0].degree() == envelope.degree());
  CHECK(forms.point[0].coefficient[0].degree() == envelope.degree());
  for (const double place : {0.125, 0.5, 0.875}) {
    for (const double angle : {0.1, 1.0, 2.4}) {
      const RealBall t = RealBall(place).at_precision(192), u0(std::cos(angle)),
                     u1(std::sin(angle));
      const RealBall weight = jet(forms.weight, t, u0, u1).value;
      if (!weight.is_positive()) continue;  // the part of the circle where v turns back
      check_identities(forms, t, u0, u1);
      const auto contact_point = contact(forms, t, u0, u1);
      const RealBall w4 = jet(w[3], t, u0, u1).value;
      for (std::size_t i = 0; i < 3; ++i) {
        CHECK(encloses_zero(jet(w[i], t, u0, u1).value / w4 - contact_point.normal[i], 1e-12));
      }
    }
  }
}

/// The point lies on the ruling of t, between spheres whose radii vary as the centres do.
void check_on_rulings(const Directrices& curves, const Envelope& envelope) {
  REQUIRE_FALSE(envelope.is_substituted());
  const auto gamma = envelope.enclosure(192);
  const auto forms = sections(gamma.carrier, isotropic_vector<RealBall>(gamma.spinor));
  for (const long eighths : {1L, 3L, 6L}) {
    const Rational t = Rational(eighths) / Rational(8L);
    const auto at = contact(forms, RealBall(t, 192), RealBall(0.6), RealBall(0.8));
    const auto end = [&](const SphereCurve& c, std::size_t i) {
      const RationalPolynomial& p = i < 3 ? c.centre[i] : c.radius;
      return RealBall(p(t) / c.denominator(t), 192);
    };
    // x - r n - c0 is parallel to c1 - c0; with r = r0 + v (r1 - r0) so is x - r0 n - c0 to
    // c1 - c0 + (r1 - r0) n.
    const RealBall r0 = end(curves[0], 3), change = end(curves[1], 3) - r0;
    std::array<RealBall, 3> from, to;
    for (std::size_t i = 0; i < 3; ++i) {
      from[i] = at.point[i] - r0 * at.normal[i] - end(curves[0], i);
      to[i] = end(curves[1], i) - end(curves[0], i) + change * at.normal[i];
    }
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t j = (i + 1) % 3;
      const RealBall cross = from[i] * to[j] - from[j] * to[i];
      const double scale = 1 + from[i].magnitude_upper() + from[j].magnitude_upper();
      CHECK(encloses_zero(cross, 1e-9 * scale * (1 + to[i].magnitude_upper())));
    }
  }
}

const RationalPolynomial kQuadratic = polynomial({2, -1, 1}), kOtherQuadratic = polynomial({3, 1, 1}),
                         kCubic = polynomial({3, 1, -1, 1}), kOtherCubic = polynomial({4, 1, 0, -1});

}  // namespace

TEST_CASE("Between polynomial curves of degree k: 5, 7, 13, 15, 21, 23", "[along_rulings]") {
  RandomDirectrices random(5);
  const std::array<int, 6> degrees = {5, 7, 13, 15, 21, 23};
  for (int k = 1; k <= 6; ++k) {
    INFO("k = " << k);
    const Directrices curves = random.lines(k, k);
    REQUIRE(joined(curves[0], curves[1]).rulings.direction.degree() == k);
    const Envelope envelope = along(curves);
    CHECK(envelope.degree() == degrees[static_cast<std::size_t>(k - 1)]);
    CHECK(envelope.degree_around() == 4);
    check_gamma(envelope);
    check_on_rulings(curves, envelope);
  }
}

TEST_CASE("Between curves of unequal degree the higher one decides", "[along_rulings]") {
  RandomDirectrices random(6);
  for (const auto& [p, q] : {std::pair{1, 2}, {2, 1}, {1, 3}, {3, 1}, {2, 3}}) {
    INFO(p << " and " << q);
    const int h = std::max(p, q);
    const Directrices curves = random.lines(p, q);
    const Envelope envelope = along(curves);
    // The degree of a ^ g is p + q, that of both points in Pluecker coordinates.
    CHECK(envelope.degree() == p + q - 1 + 4 * ((h + 1) / 2));
    check_on_rulings(curves, envelope);
  }
}

TEST_CASE("Between rational curves, of the same weights or not", "[along_rulings]") {
  struct Case {
    std::string name;
    int p, q;
    RationalPolynomial first, second;
    int degree;
  };
  const std::vector<Case> cases = {
      {"conics of the same weights", 2, 2, kQuadratic, kQuadratic, 8},
      {"conics", 2, 2, kQuadratic, kOtherQuadratic, 14},
      {"line and conic", 1, 2, 1L, kQuadratic, 9 + 4},
      {"cubics of the same weights", 3, 3, kCubic, kCubic, 15},
      {"cubics", 3, 3, kCubic, kOtherCubic, 20},
  };
  RandomDirectrices random(7);
  for (const Case& c : cases) {
    INFO(c.name);
    const Directrices curves = random.lines(c.p, c.q, c.first, c.second);
    const Envelope envelope = along(curves);
    CHECK(envelope.degree() == c.degree);
    check_gamma(envelope);
    check_on_rulings(curves, envelope);
  }
}
