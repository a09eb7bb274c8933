// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/shapes/canal_surface.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "circle_spine.hpp"
#include "error_code.hpp"
#include "pn/bezier/pn_surface.hpp"

using namespace pn;
using namespace pn::test;

namespace {

using Point = std::array<double, 3>;

Curve polyline(const std::vector<Point>& points) {
  BSplineData<3> data;
  data.degree = 1;
  for (std::size_t i = 0; i < points.size(); ++i) {
    data.knots.push_back(static_cast<double>(i));
    data.multiplicities.push_back(i == 0 || i + 1 == points.size() ? 2 : 1);
  }
  data.poles = points;
  return Curve::bspline(data);
}

/// An exact quarter of the unit circle from (1, 0, 0) to (0, 1, 0).
Curve quarter() { return Curve::bezier({{1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {1, 1, 2}); }

std::vector<Joint> joints(const EnvelopeChain& chain) {
  std::vector<Joint> result;
  for (const ChainLink& link : chain.links) result.push_back(link.joint_before);
  return result;
}

/// The sentence of a refusal with this code.
std::string refusal(ErrorCode code, const Curve& spine, const Law& law) {
  try {
    canal_surface(spine, law);
  } catch (const GeometryError& error) {
    CHECK(error.code() == code);
    return error.what();
  }
  FAIL("the input was accepted");
  return {};
}

/// Parallel and of the same direction, exactly: the same oriented circle.
bool is_same_circle(const CircleFamily& a, long at, const CircleFamily& b, long bt) {
  const auto value = [](const CircleFamily& family, long t) {
    const Rational x(t);
    return std::array<Rational, 4>{family.axis[0](x), family.axis[1](x), family.axis[2](x),
                                   family.level(x)};
  };
  const auto p = value(a, at), q = value(b, bt);
  Rational product;
  for (std::size_t i = 0; i < 4; ++i) {
    product += p[i] * q[i];
    for (std::size_t j = 0; j < i; ++j) {
      if (p[i] * q[j] != p[j] * q[i]) return false;
    }
  }
  return product.sign() > 0;
}

const Curve kLine = Curve::bezier({{0, 0, 0}, {2, 0, 0}});

}  // namespace

TEST_CASE("A corner gets the zone of its sphere, between the circles on both sides",
          "[canal_surface]") {
  const auto chain = canal_surface(polyline({{0, 0, 0}, {3, 0, 0}, {3, 4, 1}}), Law::constant(0.5));
  REQUIRE(chain.links.size() == 3);
  const ChainLink& zone = chain.links[1];
  CHECK(zone.stands_still());
  CHECK_FALSE(chain.links[0].stands_still());
  CHECK(zone.begin == 1);
  CHECK(zone.end == 1);
  CHECK(is_same_circle(chain.links[0].spheres->circles, 1, zone.spheres->circles, 0));
  CHECK(is_same_circle(zone.spheres->circles, 1, chain.links[2].spheres->circles, 0));
  CHECK(joints(chain) == std::vector<Joint>{Joint::kNone, Joint::kTangent, Joint::kTangent});
  CHECK(zone.spheres->curve.centre[0](Rational(0L)) == Rational(3L));
  CHECK_FALSE(chain.closed);
}

TEST_CASE("A kink of the radius law gets a zone too", "[canal_surface]") {
  const auto law = Law::bspline({1, {0, 0.5, 1}, {2, 1, 2}, {{1}, {1}, {1.25}}, {}});
  const auto chain = canal_surface(kLine, law);
  REQUIRE(chain.links.size() == 3);
  CHECK(chain.links[1].stands_still());
}

TEST_CASE("Closed spines close: smoothly, or with a corner", "[canal_surface]") {
  const auto torus = canal_surface(circle(1), Law::constant(0.25));
  CHECK(torus.closed);
  CHECK(torus.links.size() == 4);
  for (const Joint joint : joints(torus)) CHECK(joint != Joint::kNone);

  const auto triangle =
      canal_surface(polyline({{0, 0, 0}, {3, 0, 0}, {0, 4, 0}, {0, 0, 0}}), Law::constant(0.25));
  CHECK(triangle.closed);
  REQUIRE(triangle.links.size() == 6);
  CHECK(triangle.links.back().stands_still());
  CHECK(triangle.links.front().joint_before == Joint::kTangent);
  CHECK(is_same_circle(triangle.links.back().spheres->circles, 1,
                       triangle.links.front().spheres->circles, 0));

  // The same place with another radius is no closed chain.
  const auto open =
      canal_surface(circle(1), Law::bspline({1, {0, 4}, {2, 2}, {{0.25}, {0.5}}, {}}));
  CHECK_FALSE(open.closed);
  CHECK(open.links.front().joint_before == Joint::kNone);
}

TEST_CASE("Joints are smooth where centre and radius are C2, else tangent", "[canal_surface]") {
  const BSplineData<3> cubic{
      3, {0, 1, 3}, {4, 1, 4}, {{0, 0, 0}, {1, 0, 0}, {2, 1, 0}, {3, 1, 1}, {4, 0, 1}}, {}};
  CHECK(joints(canal_surface(Curve::bspline(cubic), Law::constant(0.1)))[1] == Joint::kSmooth);
  // C1 only: a double knot with poles in line.
  const BSplineData<3> once{3,
                            {0, 1, 2},
                            {4, 2, 4},
                            {{0, 0, 0}, {1, 0, 0}, {2, 1, 0}, {4, 1, 0}, {5, 3, 1}, {6, 0, 2}},
                            {}};
  CHECK(joints(canal_surface(Curve::bspline(once), Law::constant(0.1)))[1] == Joint::kTangent);
  // A line that runs into an arc.
  const auto chain = canal_surface(
      Curve::chain({Curve::bezier({{1, -2, 0}, {1, 0, 0}}), quarter()}), Law::constant(0.1));
  CHECK(joints(chain) == std::vector<Joint>{Joint::kNone, Joint::kTangent});
}

TEST_CASE("Cones, cylinders and tori come out in their own degrees", "[canal_surface]") {
  CHECK(canal_surface(kLine, Law::constant(1)).links[0].envelope.degree() == 1);
  CHECK(canal_surface(kLine, Law::bezier({1, 2})).links[0].envelope.degree() == 1);
  CHECK(canal_surface(quarter(), Law::constant(0.5)).links[0].envelope.degree() == 4);
}

TEST_CASE("A span that runs back in itself keeps its circles", "[canal_surface]") {
  const auto chain =
      canal_surface(Curve::bezier({{0, 0, 0}, {1, 0, 0}, {0, 0, 0}}), Law::constant(0.1));
  REQUIRE(chain.links.size() == 1);
  CHECK(chain.links[0].spheres->content(Rational(0L)).sign() == 1);
  CHECK(chain.links[0].spheres->content(Rational(1L)).sign() == -1);
}

TEST_CASE("A rounding gap between directions is closed and said so", "[canal_surface]") {
  const auto chain =
      canal_surface(polyline({{0, 0, 0}, {1, 0, 0}, {2, 1e-9, 0}}), Law::constant(0.1));
  CHECK(chain.links.size() == 2);
  REQUIRE(chain.notes.size() == 1);
  CHECK_THAT(chain.notes[0], Catch::Contains("parameter 1"));
  // The same angle with a radius at which the gap is visible is a corner.
  CHECK(canal_surface(polyline({{0, 0, 0}, {1, 0, 0}, {2, 1e-9, 0}}), Law::constant(1e4))
            .links.size() == 3);
}

TEST_CASE("Bad radii are refused with the interval and the place", "[canal_surface]") {
  CHECK_THAT(refusal(ErrorCode::kNegativeRadius, kLine, Law::bezier({1, -1})),
             Catch::Contains("0.5 to 1") && Catch::Contains("(1.5, 0, 0)"));
  CHECK_THAT(refusal(ErrorCode::kNegativeRadius, kLine, Law::constant(-1)),
             Catch::Contains("0 to 1"));
  // r = 1 + 3 t^2 and |m'| = 2: too steep from t = 1/3 on.
  CHECK_THAT(refusal(ErrorCode::kRadiusTooSteep, kLine, Law::bezier({1, 1, 4})),
             Catch::Contains("0.333333 to 1") && Catch::Contains("near point ("));
  // Parameters are those of the spine, not of the span.
  const Curve shifted =
      Curve::bspline({1, {10, 12, 14}, {2, 1, 2}, {{0, 0, 0}, {2, 0, 0}, {4, 0, 0}}, {}});
  const auto law = Law::bspline({1, {10, 12, 14}, {2, 1, 2}, {{1}, {1}, {-1}}, {}});
  CHECK_THAT(refusal(ErrorCode::kNegativeRadius, shifted, law), Catch::Contains("13 to 14"));
  refusal(ErrorCode::kDevelopable, kLine, Law::bezier({1, 3}));
  // r' = 2 only at t = 1/2: r = 1 + 4 t^2 - 8/3 t^3, three times as large.
  CHECK_THAT(refusal(ErrorCode::kPinched, Curve::bezier({{0, 0, 0}, {6, 0, 0}}),
                     Law::bezier({2, 2, 6, 6})),
             Catch::Contains("parameter 0.5") && Catch::Contains("(3, 0, 0)"));
  // r' = m' only at the end.
  refusal(ErrorCode::kPinched, kLine, Law::bezier({1, 1, 2}));
  CHECK_FALSE(code_of([] { canal_surface(kLine, Law::constant(0)); }));
}

TEST_CASE("Spines without an envelope are refused", "[canal_surface]") {
  refusal(ErrorCode::kZeroLength, Curve::bezier({{1, 2, 3}, {1, 2, 3}}), Law::constant(1));
  CHECK_THAT(refusal(ErrorCode::kZeroLength, polyline({{0, 0, 0}, {1, 0, 0}, {1, 0, 0}, {2, 0, 0}}),
                     Law::constant(1)),
             Catch::Contains("1 to 2"));
  CHECK_THAT(refusal(ErrorCode::kCornerTooSharp, polyline({{0, 0, 0}, {1, 0, 0}, {0, 0, 0}}),
                     Law::constant(0.1)),
             Catch::Contains("parameter 1") && Catch::Contains("(1, 0, 0)"));
  refusal(ErrorCode::kDomainMismatch, kLine, Law::bspline({1, {0, 2}, {2, 2}, {{1}, {1}}, {}}));
}

TEST_CASE("Degrees beyond 25 are refused with what to do", "[canal_surface]") {
  const auto spine = [](int degree) {
    std::vector<Point> poles;
    for (int i = 0; i <= degree; ++i)
      poles.push_back({double(i), double(i * i % 7), double(i * i * i % 5)});
    return Curve::bezier(poles);
  };
  CHECK_FALSE(code_of([&] { canal_surface(spine(13), Law::constant(0.1)); }));
  CHECK_THAT(refusal(ErrorCode::kDegreeTooHigh, spine(14), Law::constant(0.1)),
             Catch::Contains("28") && Catch::Contains("25") && Catch::Contains("Lower the degree"));
}

TEST_CASE("Knots as close as doubles allow give a surface or a GeometryError", "[canal_surface]") {
  const Curve spine =
      Curve::bspline({3,
                      {0, 1, std::nextafter(1.0, 2.0), 2},
                      {4, 1, 1, 4},
                      {{0, 0, 0}, {1, 0, 0}, {2, 1, 0}, {2, 2, 1}, {1, 3, 3}, {1, 4, 4}},
                      {}});
  try {
    PNSurface(canal_surface(spine, Law::constant(0.1))).faces(Lines::kEven);
    SUCCEED();
  } catch (const GeometryError&) {
    SUCCEED();
  }
}

TEST_CASE("Only the ratios of weights matter, however small they are", "[canal_surface]") {
  const std::vector<Point> poles = {{0, 0, 0}, {1, 0, 0}, {2, 1, 0}, {2, 2, 1}};
  const auto weights = [](double scale) {
    return std::vector<double>{scale, 2 * scale, scale, 3 * scale};
  };
  const auto deviation = [&](double scale) {
    return PNSurface(canal_surface(Curve::bezier(poles, weights(scale)), Law::constant(0.1)))
        .certificate(Lines::kEven)
        .deviation;
  };
  const double expected = deviation(1);
  for (const double scale : {0x1p-30, 0x1p30, 0x1p-330, 0x1p330}) {
    INFO("scale " << scale);
    double found = INFINITY;
    CHECK_NOTHROW(found = deviation(scale));
    CHECK(found < 4 * expected);
  }
}
