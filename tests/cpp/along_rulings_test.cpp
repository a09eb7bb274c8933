// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/isotropic/along_rulings.hpp"

#include <catch2/catch.hpp>

#include "enclosures.hpp"
#include "error_code.hpp"
#include "pn/algebra/roots.hpp"
#include "pn/isotropic/seam.hpp"
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

const RationalPolynomial kQuadratic = polynomial({2, -1, 1}),
                         kOtherQuadratic = polynomial({3, 1, 1}),
                         kCubic = polynomial({3, 1, -1, 1}),
                         kOtherCubic = polynomial({4, 1, 0, -1});

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
      {"conics", 2, 2, kQuadratic, kOtherQuadratic, 10},
      {"line and conic", 1, 2, 1L, kQuadratic, 9},
      {"cubics of the same weights", 3, 3, kCubic, kCubic, 15},
      {"cubics", 3, 3, kCubic, kOtherCubic, 16},
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

TEST_CASE("Joined rulings run from one sphere to the other", "[along_rulings]") {
  RandomDirectrices random(8);
  Directrices curves = random.lines(2, 2, kQuadratic, kOtherQuadratic);
  curves[0].radius = polynomial({5, 1, 2});
  curves[1].radius = polynomial({7, -2, 1});
  const JoinedRulings found = joined(curves[0], curves[1]);
  const RationalPolynomial scale = curves[0].denominator * curves[1].denominator;
  const auto difference = [&](const RationalPolynomial& a, const RationalPolynomial& b) {
    return b * curves[0].denominator - a * curves[1].denominator;
  };
  for (std::size_t i = 0; i < 3; ++i) {
    CHECK(found.content * found.rulings.direction.axis[i] ==
          difference(curves[0].centre[i], curves[1].centre[i]));
  }
  CHECK(found.content * found.rulings.direction.level ==
        difference(curves[0].radius, curves[1].radius));
  CHECK(scale.degree() == 4);
  CHECK(joined(curves[0], curves[0]).content.is_zero());
}

TEST_CASE("A common factor of the rulings is content", "[along_rulings]") {
  const RationalPolynomial factor = polynomial({1, 1});
  const SphereCurve first{{polynomial({0, 3}), 0L, 0L}, 0L, 1L};
  SphereCurve second = first;
  second.centre[1] += factor * polynomial({4, 0, 1});
  second.centre[2] += factor * polynomial({1, 3});
  const JoinedRulings found = joined(first, second);
  CHECK(found.content == factor);
  CHECK(found.rulings.direction.degree() == 2);
  CHECK(along({first, second}).degree() ==
        along_rulings(found.rulings, {first, second}, kAlone).degree());
  check_on_rulings({first, second}, along({first, second}));
}

TEST_CASE("The point of least denominator lies on the same lines", "[along_rulings]") {
  RandomDirectrices random(9);
  for (const auto& [first, second] : {std::pair{kQuadratic, kQuadratic},
                                      {kQuadratic, kOtherQuadratic},
                                      {kQuadratic * polynomial({4, -1}), kQuadratic},
                                      {RationalPolynomial(1L), kCubic}}) {
    const Directrices curves = random.lines(2, 3, first, second);
    const Rulings rulings = joined(curves[0], curves[1]).rulings;
    const Rulings least = with_least_denominator(rulings);
    CHECK(least.direction.axis == rulings.direction.axis);
    CHECK(least.direction.level == rulings.direction.level);
    const RationalPolynomial &p = rulings.point.denominator, &q = least.point.denominator;
    CHECK(q.degree() <= p.degree());
    // (a - b) ^ g = 0, and nothing divides b ^ g and its denominator any more.
    RationalPolynomial common = q;
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t j = (i + 1) % 3;
      const auto& g = rulings.direction.axis;
      const auto shift = [&](std::size_t c) {
        return rulings.point.centre[c] * q - least.point.centre[c] * p;
      };
      CHECK((shift(i) * g[j] - shift(j) * g[i]).is_zero());
      common = gcd(common, least.point.centre[i] * g[j] - least.point.centre[j] * g[i]);
      common =
          gcd(common, least.point.centre[i] * rulings.direction.level - least.point.radius * g[i]);
    }
    common = gcd(common, least.point.centre[0] * rulings.direction.axis[2] -
                             least.point.centre[2] * rulings.direction.axis[0]);
    CHECK(common.degree() == 0);
  }
}

TEST_CASE("With the same weights the point needs no more than one of the directrices",
          "[along_rulings]") {
  RandomDirectrices random(10);
  const Directrices same = random.lines(2, 2, kQuadratic, kQuadratic),
                    other = random.lines(2, 2, kQuadratic, kOtherQuadratic);
  CHECK(with_least_denominator(joined(same[0], same[1]).rulings).point.denominator.degree() == 2);
  CHECK(with_least_denominator(joined(other[0], other[1]).rulings).point.denominator.degree() == 0);
}

TEST_CASE("The torsion is the determinant of a', g and g'", "[along_rulings]") {
  // On the x-axis with g = (., 4, z) it is z' up to a constant.
  const RationalPolynomial z = polynomial({2, 3, -9, 6});
  const SphereCurve line{{polynomial({0, 5}), 0L, 0L}, 0L, 1L};
  const SphereCurve other{{polynomial({1, 7, 2}), 4L, z}, 0L, 1L};
  const RationalPolynomial turn = ruling_normal(joined(line, other).rulings).torsion;
  REQUIRE(turn.degree() == 2);
  const RationalPolynomial slope = z.derivative();
  CHECK(turn * RationalPolynomial(slope.coefficient(2)) ==
        slope * RationalPolynomial(turn.coefficient(2)));
  // Planes, cylinders, cones and tangent surfaces do not turn.
  const SphereCurve cubic{
      {polynomial({0, 1}), polynomial({0, 0, 1}), polynomial({0, 0, 0, 1})}, 0L, 1L};
  SphereCurve moved = cubic, tangent = cubic, cone = cubic;
  for (std::size_t i = 0; i < 3; ++i) {
    moved.centre[i] += RationalPolynomial(3L);
    tangent.centre[i] += cubic.centre[i].derivative();
    cone.centre[i] *= RationalPolynomial(2L);
  }
  cone.centre[2] += RationalPolynomial(-5L);
  SphereCurve planar = cubic;
  planar.centre[2] = 0L;
  SphereCurve in_plane = planar;
  in_plane.centre[1] += polynomial({3, 1});
  CHECK(ruling_normal(joined(cubic, moved).rulings).torsion.is_zero());
  CHECK(ruling_normal(joined(cubic, tangent).rulings).torsion.is_zero());
  CHECK(ruling_normal(joined(cubic, cone).rulings).torsion.is_zero());
  CHECK(ruling_normal(joined(planar, in_plane).rulings).torsion.is_zero());
}

TEST_CASE("Torsal roots inside, at joints exactly, and a little beyond free ends",
          "[along_rulings]") {
  const SphereCurve line{{polynomial({0, 5}), 0L, 0L}, 0L, 1L};
  const auto roots = [&](const RationalPolynomial& slope, const SpanPlace& place) {
    RationalPolynomial z(1L);
    for (int i = 0; i <= slope.degree(); ++i) {
      std::vector<Rational> power(static_cast<std::size_t>(i) + 2);
      power.back() = slope.coefficient(i) / Rational(long{i + 1});
      z += RationalPolynomial(power);
    }
    const Directrices curves = {line, {{polynomial({1, 7}), 4L, z}, 0L, 1L}};
    const auto rulings = joined(curves[0], curves[1]).rulings;
    return std::get<RulingForms<RealBall>>(local_forms(rulings, curves, place, 128).carrier)
        .torsal_roots;
  };
  const auto found = roots(polynomial({0, 1, -3, 2}), kBetween);  // 0, 1/2, 1
  REQUIRE(found.size() == 3);
  CHECK(found[0].is_zero());
  CHECK((found[1] - RealBall(1)).is_zero());
  CHECK(found[2].contains(Rational(1L) / Rational(2L)));
  for (const SpanPlace& place : {kAlone, kBetween}) {
    CHECK(roots(polynomial({2, 3, 1}), place).empty());          // -1, -2
    CHECK(roots(polynomial({1, 0, 1}), place).empty());          // none
    CHECK(roots(polynomial({-1, 2}), place).size() == 1);        // 1/2
    CHECK(roots(polynomial({-3, 16, -16}), place).size() == 2);  // 1/4, 3/4
  }
  const RationalPolynomial near = polynomial({-33, 1}) * polynomial({1, 32});  // -1/32, 33
  CHECK(roots(near, kAlone).size() == 1);
  CHECK(roots(near, kBetween).empty());
  CHECK(roots(near, {1L, false, true}).size() == 1);
  CHECK(roots(near, {1L, true, false}).empty());
}

TEST_CASE("Torsal rulings of cones are those where the normal N is isotropic", "[along_rulings]") {
  RandomDirectrices random(15);
  Directrices curves = random.lines(1, 2);
  curves[0].radius = polynomial({9, 4, -3});
  curves[1].radius = polynomial({8, -2, 3});
  const Rulings rulings = joined(curves[0], curves[1]).rulings;
  const RationalPolynomial found = torsal_polynomial(ruling_normal(rulings));
  // <N, N> is minus the Gram determinant of a', g, g' in R^{3,1}.
  using Vector = std::array<RationalPolynomial, 4>;
  const SphereCurve& a = rulings.point;
  REQUIRE(a.denominator.degree() == 0);
  const CircleFamily& g = rulings.direction;
  const std::array<Vector, 3> v = {Vector{a.centre[0].derivative(), a.centre[1].derivative(),
                                          a.centre[2].derivative(), -a.radius.derivative()},
                                   Vector{g.axis[0], g.axis[1], g.axis[2], -g.level},
                                   Vector{g.axis[0].derivative(), g.axis[1].derivative(),
                                          g.axis[2].derivative(), -g.level.derivative()}};
  const auto gram = [&](std::size_t i, std::size_t j) {
    return v[i][0] * v[j][0] + v[i][1] * v[j][1] + v[i][2] * v[j][2] - v[i][3] * v[j][3];
  };
  const RationalPolynomial determinant =
      gram(0, 0) * (gram(1, 1) * gram(2, 2) - gram(1, 2) * gram(1, 2)) -
      gram(0, 1) * (gram(0, 1) * gram(2, 2) - gram(1, 2) * gram(0, 2)) +
      gram(0, 2) * (gram(0, 1) * gram(1, 2) - gram(1, 1) * gram(0, 2));
  REQUIRE(determinant.degree() == found.degree());
  CHECK(determinant * RationalPolynomial(found.coefficient(0)) ==
        found * RationalPolynomial(determinant.coefficient(0)));
}

TEST_CASE("Cones: odd real roots of D are substituted away", "[along_rulings]") {
  // g = (4, 0, 3 t; 3 - 2 t): D = 16 + 9 t^2 - (3 - 2 t)^2 has the roots of 5 t^2 + 12 t + 7.
  const SphereCurve first{{0L, polynomial({0, 8}), polynomial({1, 0, 1})}, 1L, 1L};
  SphereCurve second = first;
  second.centre[0] += RationalPolynomial(4L);
  second.centre[2] += polynomial({0, 3});
  second.radius = polynomial({4, -2});
  const Rulings rulings = joined(first, second).rulings;
  REQUIRE(rulings.direction.discriminant()(Rational(-1L)).is_zero());
  const Envelope envelope = along({first, second});
  CHECK(envelope.is_substituted());
  check_gamma(envelope);
  // Without a real root of D the parameter stays, and the points lie on the generators of the
  // cones.
  second.radius = polynomial({2, -1});
  const Envelope gentle = along({first, second});
  check_gamma(gentle);
  check_on_rulings({first, second}, gentle);
}

TEST_CASE("Cones: the point moves the more the spheres differ", "[along_rulings]") {
  RandomDirectrices random(12);
  for (int k = 1; k <= 3; ++k) {
    Directrices curves = random.lines(k, k);
    // Slower than the centres by far, so that D has no real root: a linear function of x.
    for (SphereCurve& c : curves) {
      c.radius =
          RationalPolynomial(Rational(1L) / Rational(9L)) * c.centre[0] + RationalPolynomial(20L);
    }
    const Envelope envelope = along(curves);
    REQUIRE_FALSE(envelope.is_substituted());
    check_gamma(envelope);
    check_on_rulings(curves, envelope);
  }
}

TEST_CASE("The normal of the band is orthogonal to the ruling and to the motion",
          "[along_rulings]") {
  RandomDirectrices random(13);
  Directrices curves = random.lines(2, 3);
  curves[0].radius = polynomial({9, 1});
  curves[1].radius = polynomial({8, 0, 1});
  const auto gamma = along(curves).enclosure(128);
  const auto estimate = std::get<RulingForms<double>>(midpoint(gamma.carrier));
  for (const double t : {0.1, 0.6}) {
    for (const double v : {0.0, 0.3, 1.0}) {
      const Eigen::Vector3d n = band_normal(estimate, t, v);
      const auto value = [&](const RationalPolynomial& p) {
        return p(Rational::exactly(t)).to_double();
      };
      Eigen::Vector3d g, motion;
      for (std::size_t i = 0; i < 3; ++i) {
        const auto& a = curves[0].centre[i];
        const auto& b = curves[1].centre[i];
        g[static_cast<Eigen::Index>(i)] = value(b) - value(a);
        motion[static_cast<Eigen::Index>(i)] =
            (1 - v) * value(a.derivative()) + v * value(b.derivative());
      }
      const double change = value(curves[1].radius) - value(curves[0].radius);
      const double growth =
          (1 - v) * value(curves[0].radius.derivative()) + v * value(curves[1].radius.derivative());
      CHECK(n.norm() == Approx(1));
      CHECK(std::abs(n.dot(g) + change) < 1e-12 * g.norm());
      CHECK(std::abs(n.dot(motion) + growth) < 1e-12 * motion.norm());
      CHECK(n.dot(motion.cross(g)) > 0);
    }
  }
}

TEST_CASE("Slopes are by a parameter of the given length", "[along_rulings]") {
  RandomDirectrices random(14);
  const Directrices curves = random.lines(2, 2);
  const Rulings rulings = joined(curves[0], curves[1]).rulings;
  const auto unit =
      std::get<RulingForms<RealBall>>(local_forms(rulings, curves, kAlone, 128).carrier);
  const auto longer = std::get<RulingForms<RealBall>>(
      local_forms(rulings, curves, {4L, false, false}, 128).carrier);
  for (int i = 0; i < unit.axis_slope[1].degree(); ++i) {
    CHECK((unit.axis_slope[1][i] - RealBall(4) * longer.axis_slope[1][i]).contains_zero());
  }
}

TEST_CASE("A torsal ruling of the other sheet is none, however steep the cones",
          "[along_rulings]") {
  const Directrices curves = {
      SphereCurve{{polynomial({-310, 2495, -475}), polynomial({-378, 1062, -1067}),
                   polynomial({-30, 736, -379})},
                  polynomial({667, -1059, 670}),
                  1L},
      SphereCurve{{polynomial({-436, 2061}), polynomial({1347, -207}), polynomial({-612, 88})},
                  polynomial({12, 1104}),
                  1L}};
  for (const bool exchanged : {false, true}) {
    const Directrices sides = exchanged ? Directrices{curves[1], curves[0]} : curves;
    const Rulings rulings = joined(sides[0], sides[1]).rulings;
    const auto forms =
        std::get<RulingForms<double>>(midpoint(local_forms(rulings, sides, kAlone, 128).carrier));
    const auto candidates = roots_in_unit_interval(torsal_polynomial(ruling_normal(rulings)));
    REQUIRE(candidates.size() == 1);
    const double t = candidates.front().value.midpoint();
    // Both sheets have it on one side only, where all normals of the ruling are one.
    const bool is_torsal =
        (band_normal(forms, t, 0.25) - band_normal(forms, t, 0.75)).norm() < 1e-6;
    CHECK(forms.torsal_roots.size() == (is_torsal ? 1 : 0));
    CHECK(is_torsal == exchanged);
  }
}

TEST_CASE("The weights of the wanted side are positive, wherever the torsal ruling is",
          "[along_rulings]") {
  const SphereCurve line{{polynomial({0, 5}), 0L, 0L}, 0L, 1L};
  for (const long tenths : {1L, 3L, 4L, 5L, 7L}) {
    // z' = 10 t - tenths.
    const RationalPolynomial z({Rational(1L), Rational(-tenths), Rational(5L)});
    const auto gamma =
        midpoint(along({line, {{polynomial({1, 7}), 4L, z}, 0L, 1L}}).enclosure(128));
    const auto& rulings = std::get<RulingForms<double>>(gamma.carrier);
    REQUIRE(rulings.torsal_roots.size() == 1);
    const auto forms = sections(rulings, isotropic_vector<double>(gamma.spinor));
    for (const double t : {0.05, 0.45, 0.95}) {
      const Eigen::Vector2d u =
          parameter_of(value_at(gamma.spinor, t), band_normal(rulings, t, 0.5));
      CHECK(value(forms.weight, t, u.x(), u.y()) > 0);
    }
  }
}
