// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/shapes/conic_section.hpp"

#include <Eigen/Dense>
#include <catch2/catch.hpp>
#include <cmath>

#include "circle_spine.hpp"
#include "pn/bezier/conic_points.hpp"
#include "pn/geometry_error.hpp"

using namespace pn;
using namespace pn::test;

namespace {

using Eigen::Vector3d;

Vector3d point(const Curve& curve, double t) {
  const auto& function = curve.function();
  std::size_t i = 0;
  while (i + 2 < function.breaks.size() && function.breaks[i + 1].to_double() < t) ++i;
  const double begin = function.breaks[i].to_double(), end = function.breaks[i + 1].to_double();
  const Rational local = Rational::exactly((t - begin) / (end - begin));
  Vector3d x;
  for (std::size_t c = 0; c < 3; ++c) {
    x[static_cast<long>(c)] =
        (function.spans[i].numerator[c](local) / function.spans[i].denominator(local)).to_double();
  }
  return x;
}

Vector3d tangent(const Curve& curve, double t) {
  constexpr double kStep = 1e-4;
  return (point(curve, t + kStep) - point(curve, t - kStep)).normalized();
}

/// Unit vectors to the side and upwards.
std::array<Vector3d, 2> directions(const Vector3d& normal, const Vector3d& up) {
  const Vector3d side = normal.cross(up).normalized();
  return {side, side.cross(normal.normalized())};
}

/// Values of a polynomial matrix or vector at a local parameter.
Eigen::Matrix<double, 4, 3> frame_at(const MovingConic& conic, double t) {
  Eigen::Matrix<double, 4, 3> values;
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      values(static_cast<long>(i), static_cast<long>(j)) =
          conic.frame[i][j](Rational::exactly(t)).to_double();
    }
  }
  return values;
}

Eigen::Matrix3d conic_at(const MovingConic& conic, double t) {
  Eigen::Matrix3d values;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      values(static_cast<long>(i), static_cast<long>(j)) =
          conic.conic[i][j](Rational::exactly(t)).to_double();
    }
  }
  return values;
}

/// Coordinates y of a point in the plane of a conic, whose weight is positive.
Vector3d coordinates(const MovingConic& conic, double t, const Vector3d& x) {
  const auto frame = frame_at(conic, t);
  const Eigen::Vector4d homogeneous(x[0], x[1], x[2], 1);
  const Vector3d y = frame.colPivHouseholderQr().solve(homogeneous);
  CHECK((frame * y - homogeneous).norm() < 1e-7 * homogeneous.norm());
  return y;
}

/// |y^T C y| in parts of the sum of its terms.
double residual(const MovingConic& conic, double t, const Vector3d& x) {
  const Vector3d y = coordinates(conic, t, x);
  const Eigen::Matrix3d c = conic_at(conic, t);
  return std::abs(y.dot(c * y)) / y.cwiseAbs().dot(c.cwiseAbs() * y.cwiseAbs());
}

/// A bent spine in space.
Curve bent() { return Curve::bezier({{0, 0, 0}, {40, 5, 0}, {70, 40, 10}, {80, 90, 5}}); }

std::string refusal_of(ErrorCode code, const Curve& spine, const SectionPlanes& planes,
                       const ConicSection& section) {
  try {
    moving_conic_section(spine, planes, section);
  } catch (const GeometryError& error) {
    CHECK(error.code() == code);
    return error.what();
  }
  FAIL("the input was accepted");
  return {};
}

bool mentions(const std::string& sentence, const std::string& part) {
  return sentence.find(part) != std::string::npos;
}

HalfAxes constant_axes(double a, double b) { return {Law::constant(a), Law::constant(b)}; }

/// An exact quarter of a circle between straight pieces, in the plane z = 0.
Curve elbow() {
  return Curve::chain({Curve::bezier({{-20, 30, 0}, {0, 30, 0}}),
                       Curve::bezier({{0, 30, 0}, {30, 30, 0}, {30, 0, 0}}, {1, 1, 2}),
                       Curve::bezier({{30, 0, 0}, {30, -10, 0}})});
}

}  // namespace

TEST_CASE("Ellipses have the true half-axes, perpendicular to the spine", "[conic_section]") {
  const Curve spine = bent();
  const Vector3d up(0.1, 0.2, 1);
  const auto spans = moving_conic_section(
      spine, {{0.1, 0.2, 1}, {}}, HalfAxes{Law::bezier({12, 20, 8}), Law::bezier({6, 9}, {1, 2})});
  REQUIRE(spans.size() == 1);
  CHECK_FALSE(spans[0].cut);
  for (const double t : {0.125, 0.5, 0.75}) {
    const double a = 12 * (1 - t) * (1 - t) + 2 * 20 * t * (1 - t) + 8 * t * t;
    const double b = (6 * (1 - t) + 2 * 9 * t) / (1 - t + 2 * t);
    const auto [side, above] = directions(tangent(spine, t), up);
    for (int i = 0; i < 7; ++i) {
      const Vector3d x = point(spine, t) + a * std::cos(i) * side + b * std::sin(i) * above;
      CHECK(residual(spans[0].conic, t, x) < 1e-6);
    }
  }
}

TEST_CASE("Ellipses in parallel planes", "[conic_section]") {
  const Curve spine = bent();
  const Vector3d normal(1, 1, 0.5), up(0, 0, 1);
  const auto spans =
      moving_conic_section(spine, {{0, 0, 1}, ParallelPlanes{{1, 1, 0.5}}}, constant_axes(7, 3));
  for (const double t : {0.0, 0.5, 1.0}) {
    const auto [side, above] = directions(normal, up);
    for (int i = 0; i < 7; ++i) {
      const Vector3d x = point(spine, t) + 7 * std::cos(i) * side + 3 * std::sin(i) * above;
      CHECK(residual(spans[0].conic, t, x) < 1e-12);
    }
  }
}

TEST_CASE("Ellipses in upright planes, across the spine as it is seen from above",
          "[conic_section]") {
  const Curve spine = bent();
  const Vector3d up(0.25, 0, 1);
  const auto spans =
      moving_conic_section(spine, {{0.25, 0, 1}, UprightPlanes{}}, constant_axes(7, 3));
  for (const double t : {0.1, 0.5, 0.9}) {
    const Vector3d above = up.normalized(), side = tangent(spine, t).cross(up).normalized();
    for (int i = 0; i < 7; ++i) {
      const Vector3d x = point(spine, t) + 7 * std::cos(i) * side + 3 * std::sin(i) * above;
      // The tangent is a difference of points.
      CHECK(residual(spans[0].conic, t, x) < 1e-6);
    }
  }
}

TEST_CASE("A depth beyond the top of an ellipse is refused", "[conic_section]") {
  const VertexForm section{Law::constant(10), Law::bezier({-2, 1}), Law::constant(20)};
  CHECK(mentions(refusal_of(ErrorCode::kBadAxis, bent(), {{0, 0, 1}, UprightPlanes{}}, section),
                 "ellipse above the depth is negative at parameters 0.666667 to 1"));
}

TEST_CASE("Sections from the vertex have the optician's equation and depth", "[conic_section]") {
  // In parallel planes whose direction upwards has an irrational length.
  const Curve spine = bent();
  const Vector3d normal(1, 1, 0), up(0, 0.25, 1);
  const VertexForm section{Law::bezier({10, 14}), Law::bezier({-2.5, 0.5}), Law::constant(5)};
  const auto spans =
      moving_conic_section(spine, {{0, 0.25, 1}, ParallelPlanes{{1, 1, 0}}}, section);
  REQUIRE(spans.size() == 1);
  REQUIRE(spans[0].cut);
  const auto [side, above] = directions(normal, up);
  for (const double t : {0.0, 0.25, 0.5, 1.0}) {
    const double radius = 10 + 4 * t, constant = -2.5 + 3 * t;
    for (const double z : {0.5, 2.0, 4.999, 5.001}) {
      const double across = std::sqrt(2 * radius * z - (1 + constant) * z * z);
      for (const double sign : {-1.0, 1.0}) {
        const Vector3d x = point(spine, t) + sign * across * side + z * above;
        CHECK(residual(spans[0].conic, t, x) < 1e-12);
        const Vector3d y = coordinates(spans[0].conic, t, x);
        double height = 0;
        for (std::size_t i = 0; i < 3; ++i) {
          height += y[static_cast<long>(i)] * (*spans[0].cut)[i](Rational::exactly(t)).to_double();
        }
        CHECK((height > 0) == (z < 5));
      }
    }
  }
}

TEST_CASE("Sections from the vertex go around a circle, upwards or outwards", "[conic_section]") {
  const VertexForm section{Law::constant(4), Law::constant(-1), Law::constant(2)};
  for (const SectionPlanes& planes : {SectionPlanes{{0, 0, 1}, {}}, SectionPlanes{{1, 0, 0}, {}}}) {
    const auto spans = moving_conic_section(circle(20), planes, section);
    REQUIRE(spans.size() == 4);
    const double t = 0.25;
    const auto [side, above] =
        directions(tangent(circle(20), t), Vector3d(planes.up[0], planes.up[1], planes.up[2]));
    const Vector3d x = point(circle(20), t) + std::sqrt(8) * side + above;
    CHECK(residual(spans[0].conic, t, x) < 1e-6);
  }
}

TEST_CASE("Spans end at the breaks of spine and laws", "[conic_section]") {
  BSplineData<1> kinked{1, {0, 0.25, 1}, {2, 1, 2}, {{3}, {5}, {4}}, {}};
  const auto spans = moving_conic_section(bent(), {{0, 0, 1}, {}},
                                          HalfAxes{Law::bspline(kinked), Law::constant(2)});
  CHECK(spans.size() == 2);
}

TEST_CASE("A tangent joint is none, a corner is refused", "[conic_section]") {
  CHECK(moving_conic_section(elbow(), {{0, 0, 1}, {}}, constant_axes(5, 3)).size() == 3);
  const Curve corner = Curve::chain(
      {Curve::bezier({{0, 0, 0}, {30, 0, 0}}), Curve::bezier({{30, 0, 0}, {60, 30, 0}})});
  const std::string sentence =
      refusal_of(ErrorCode::kCornerTooSharp, corner, {{0, 0, 1}, {}}, constant_axes(5, 3));
  CHECK(mentions(sentence, "45 degrees at parameter 1, point (30, 0, 0)"));
  CHECK(moving_conic_section(corner, {{0, 0, 1}, ParallelPlanes{{1, 0, 0}}}, constant_axes(5, 3))
            .size() == 2);
}

TEST_CASE("Half-axes must be positive", "[conic_section]") {
  const SectionPlanes planes{{0, 0, 1}, {}};
  CHECK(mentions(refusal_of(ErrorCode::kBadAxis, bent(), planes,
                            HalfAxes{Law::bezier({4, -4}), Law::constant(2)}),
                 "to the side is negative at parameters 0.5 to 1"));
  CHECK(mentions(refusal_of(ErrorCode::kBadAxis, bent(), planes,
                            HalfAxes{Law::constant(2), Law::bezier({1, -1, 1})}),
                 "upwards is zero at parameter 0.5, point ("));
  CHECK(mentions(refusal_of(ErrorCode::kBadAxis, bent(), planes, constant_axes(2, 0)),
                 "upwards is zero at parameters 0 to 1"));
}

TEST_CASE("Directions must give a plane and an upright in it", "[conic_section]") {
  const Curve straight = Curve::bezier({{0, 0, 0}, {0, 0, 50}});
  const HalfAxes axes = constant_axes(5, 3);
  CHECK(mentions(refusal_of(ErrorCode::kBadAxis, straight, {{0, 0, 2}, {}}, axes),
                 "is that of the spine at parameters 0 to 1"));
  refusal_of(ErrorCode::kBadAxis, straight, {{0, 0, 0}, {}}, axes);
  refusal_of(ErrorCode::kNotFinite, straight, {{0, NAN, 1}, {}}, axes);
  CHECK(mentions(
      refusal_of(ErrorCode::kBadAxis, straight, {{0, 1, 0}, ParallelPlanes{{1, 0, 0}}}, axes),
      "within the plane of a section"));
  CHECK(mentions(refusal_of(ErrorCode::kBadAxis, Curve::bezier({{0, 0, 0}, {9, 9, 0}, {0, 18, 0}}),
                            {{0, 0, 1}, ParallelPlanes{{1, 0, 0}}}, axes),
                 "parallel to the sections at parameter 0.5"));
}

TEST_CASE("Where the direction upwards has no rational length", "[conic_section]") {
  const VertexForm section{Law::constant(4), Law::constant(-1), Law::constant(2)};
  CHECK(mentions(refusal_of(ErrorCode::kNotRational, bent(), {{0, 0, 1}, {}}, section),
                 "Take parallel sections"));
}

TEST_CASE("Where the spine runs upwards for a moment the directions go on", "[conic_section]") {
  // x' = 3 (1 - 2t)(1 + 2t), y' = 6t (1 - 2t)
  const Curve spine = Curve::bezier({{0, 0, 0}, {1, 0, 10}, {2, 1, 20}, {-1, -1, 30}});
  const auto spans = moving_conic_section(spine, {{0, 0, 1}, {}}, constant_axes(5, 3));
  const Vector3d side = Vector3d(1, -2, 0).normalized(), above = side.cross(Vector3d(0, 0, 1));
  for (int i = 0; i < 7; ++i) {
    const Vector3d x = point(spine, 0.5) + 5 * std::cos(i) * side + 3 * std::sin(i) * above;
    CHECK(residual(spans[0].conic, 0.5, x) < 1e-12);
  }
}

TEST_CASE("A direction upwards in the plane of the spine may meet the tangent", "[conic_section]") {
  // The side is the normal of the plane wherever the spine turns to.
  const auto spans = moving_conic_section(circle(20), {{1, 0, 0}, {}}, constant_axes(5, 3));
  CHECK(spans.size() == 4);
}

TEST_CASE("Numbers of many spans, too long for doubles, give surfaces as those of one do",
          "[conic_section]") {
  const BSplineData<3> data{
      3,
      {0, 0.2, 0.5, 0.7, 1},
      {4, 1, 1, 1, 4},
      {{0, 0, 0}, {10, 3, 1}, {22, -4, 5}, {30, 6, 9}, {41, 12, 4}, {50, 10, 0}, {61, 15, 3}},
      {}};
  const auto spans =
      moving_conic_section(Curve::bspline(data), {{0, 0, 1}, {}}, constant_axes(3, 1.5));
  REQUIRE(spans.size() == 4);
  for (const ConicSpan& span : spans) CHECK(ConicPoints(span).degree() == 9);
}
