// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/bezier/self_intersection.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <optional>
#include <random>

#include "circle_spine.hpp"
#include "pn/bezier/evaluation.hpp"
#include "pn/bezier/pn_surface.hpp"
#include "pn/shapes/canal_surface.hpp"
#include "pn/shapes/quadric.hpp"
#include "pn/shapes/ruled_surface.hpp"
#include "random_canals.hpp"

using namespace pn;
using namespace pn::test;
using Eigen::Vector3d;

namespace {

PNSurface pipe(const Curve& spine, double radius) {
  return PNSurface(canal_surface(spine, Law::constant(radius)));
}

/// A crossing is two different parameters of one place.
std::optional<SelfIntersection> confirmed(const PNSurface& surface) {
  const auto found = surface.self_intersection();
  if (!found) return found;
  const auto faces = surface.faces(Lines::kEven);
  const auto& [a, b] = found->places;
  CHECK((a.face != b.face || std::hypot(a.u - b.u, a.v - b.v) > 1e-6));
  const Vector3d point(found->point.data());
  for (const FacePoint& place : found->places) {
    const Vector3d x(evaluate(faces[place.face], place.u, place.v).data());
    CHECK((x - point).norm() < 1e-9 * (1 + point.norm()));
  }
  CHECK(found->angle > kLeastCrossing);
  return found;
}

Curve line(const std::array<double, 3>& a, const std::array<double, 3>& b) {
  return Curve::bezier({a, b});
}

/// From a to b on the half circle around the middle that goes out by `side`, of the length of the
/// radius.
std::vector<Curve> half_circle(const Vector3d& a, const Vector3d& b, const Vector3d& side) {
  const auto p = [](const Vector3d& x) { return std::array<double, 3>{x.x(), x.y(), x.z()}; };
  const Vector3d top = (a + b) / 2 + side;
  return {Curve::bezier({p(a), p(a + side), p(top)}, {2, 1, 1}),
          Curve::bezier({p(top), p(b + side), p(b)}, {1, 1, 2})};
}

/// Three parallel lines joined by half circles of radii 25 and 20; the first and the last are 30
/// apart, and nothing else is as near.
Curve bent_twice() {
  std::vector<Curve> parts = {line({-100, 0, 0}, {0, 0, 0})};
  for (const Curve& arc : half_circle({0, 0, 0}, {0, 0, 50}, {25, 0, 0})) parts.push_back(arc);
  parts.push_back(line({0, 0, 50}, {-100, 0, 50}));
  for (const Curve& arc : half_circle({-100, 0, 50}, {-100, 24, 18}, {-20, 0, 0})) {
    parts.push_back(arc);
  }
  parts.push_back(line({-100, 24, 18}, {0, 24, 18}));
  return Curve::chain(parts);
}

Curve helix(double radius, double pitch, int poles) {
  BSplineData<3> data{3, {}, {}, {}, {}};
  const int spans = poles - 3;
  for (int i = 0; i <= spans; ++i) {
    data.knots.push_back(i);
    data.multiplicities.push_back(i == 0 || i == spans ? 4 : 1);
  }
  for (int i = 0; i < poles; ++i) {
    const double angle = i * M_PI / 6;
    data.poles.push_back(
        {radius * std::cos(angle), radius * std::sin(angle), pitch * angle / (2 * M_PI)});
  }
  return Curve::bspline(data);
}

PNSurface saddle(double x0, double x1) {
  QuadricBounds bounds;
  bounds.box[0] = Interval{x0, x1};
  bounds.box[1] = Interval{-15, 15};
  return PNSurface(quadric(QuadricKind::kHyperbolicParaboloid, {10, 10, 5}, bounds));
}

}  // namespace

TEST_CASE("Surfaces that do not meet themselves", "[self_intersection]") {
  CHECK_FALSE(confirmed(pipe(line({0, 0, 0}, {1, 2, 30}), 2)));
  CHECK_FALSE(confirmed(pipe(circle(4), 1)));
  CHECK_FALSE(confirmed(pipe(circle(4), 1).offset(2.9)));
  CHECK_FALSE(confirmed(pipe(helix(8, 3, 33), 0)));
  CHECK_FALSE(confirmed(PNSurface(quadric(QuadricKind::kEllipsoid, {30, 20, 10}, {}))));
  CHECK_FALSE(confirmed(PNSurface(quadric(QuadricKind::kEllipsoid, {30, 20, 10}, {})).offset(9)));
  CHECK_FALSE(confirmed(PNSurface(quadric(QuadricKind::kEllipsoid, {20, 20, 20}, {}))));
  CHECK_FALSE(confirmed(saddle(-15, 15).offset(9.9)));
  const PNSurface sheet(ruled_surface(Curve::bezier({{0, 0, 0}, {20, 0, 0}, {40, 10, 0}}),
                                      Curve::bezier({{0, 30, 0}, {20, 30, 10}, {40, 40, 30}})));
  CHECK_FALSE(confirmed(sheet.offset(5)));
}

TEST_CASE("A cone that ends in its tip does not meet itself, one that goes on does",
          "[self_intersection]") {
  const PNSurface cone(canal_surface(line({0, 0, 0}, {0, 0, 5}), Law::bezier({2, 0})));
  CHECK_FALSE(confirmed(cone));
  const auto found = confirmed(cone.offset(-1));
  REQUIRE(found);
  CHECK(std::hypot(found->point[0], found->point[1]) < 1e-9);
}

TEST_CASE("Parallel parts of a pipe cross from the half distance of their axes on",
          "[self_intersection]") {
  const PNSurface thin = pipe(bent_twice(), 10);
  CHECK_FALSE(confirmed(thin));
  CHECK_FALSE(confirmed(thin.offset(5 * (1 - 1e-3))));
  const double radius = 15 * (1 + 1e-3);
  const auto found = confirmed(thin.offset(radius - 10));
  REQUIRE(found);
  // In the plane between the lines, at the angle of two circles whose centres are 30 apart.
  const Vector3d x(found->point.data());
  CHECK(x.dot(Vector3d(0, 0.8, 0.6)) == Approx(15).epsilon(1e-9));
  CHECK(found->angle == Approx(2 * std::acos(15 / radius)).epsilon(1e-6));
}

TEST_CASE("A torus whose tube is thicker than its ring meets itself on its axis",
          "[self_intersection]") {
  for (const double radius : {4.01, 5.0}) {
    const auto found = confirmed(pipe(circle(4), 1).offset(radius - 1));
    REQUIRE(found);
    CHECK(std::hypot(found->point[0], found->point[1]) < 1e-9);
    CHECK(std::abs(found->point[2]) == Approx(std::sqrt(radius * radius - 16)));
  }
}

TEST_CASE("The turns of a helix cross when the pitch is too small", "[self_intersection]") {
  // The turns are 3 cos(atan(3 / (16 pi))) = 2.995 apart on a true helix.
  CHECK_FALSE(confirmed(pipe(helix(8, 3, 33), 1.46)));
  CHECK(confirmed(pipe(helix(8, 3, 33), 1.54)));
}

TEST_CASE("Far offsets of a saddle cross themselves above its middle", "[self_intersection]") {
  // z = (x^2 - y^2) / 20 is symmetric to the planes x = 0 and y = 0, and of radius 10 there.
  const auto above = confirmed(saddle(-15, 15).offset(12)),
             below = confirmed(saddle(-15, 15).offset(-12));
  REQUIRE(above);
  REQUIRE(below);
  CHECK(std::abs(above->point[0]) < 1e-9);
  CHECK(std::abs(below->point[1]) < 1e-9);
}

TEST_CASE("A trimmed face counts inside its trims only", "[self_intersection]") {
  CHECK_FALSE(confirmed(saddle(1, 15).offset(12)));
  CHECK(confirmed(saddle(-8, 15).offset(12)));
}

TEST_CASE("The overlap at a corner is no crossing, another one of the same pipe is",
          "[self_intersection]") {
  const Curve corner =
      Curve::bspline({1, {0, 1, 2}, {2, 1, 2}, {{0, 0, 0}, {10, 0, 0}, {10, 10, 0}}, {}});
  CHECK_FALSE(confirmed(pipe(corner, 1)));
  const Curve loop =
      Curve::bspline({1,
                      {0, 1, 2, 3, 4},
                      {2, 1, 1, 1, 2},
                      {{0, 0, 0}, {20, 0, 0}, {20, 20, 0}, {10, 20, 0}, {10, -20, 1}},
                      {}});
  const auto found = confirmed(pipe(loop, 1));
  REQUIRE(found);
  CHECK(std::hypot(found->point[0] - 10, found->point[1]) < 3);
}

TEST_CASE("Closed spines and seams do not alarm", "[self_intersection]") {
  int closed = 0;
  for (std::uint64_t seed = 0; closed < 5; ++seed) {
    const CanalInput input = RandomCanal(seed).input();
    if (input.kind != "closed cubic") continue;
    ++closed;
    // A ring of radius 10 about the origin, of which opposite parts are far apart.
    const PNSurface surface(canal_surface(Curve::bspline(input.spine), Law::bspline(input.radius)));
    const OffsetRange range = surface.regular_range();
    const double thinner = std::max(-1.0, range.lower / 2);
    if (range.upper > thinner) CHECK_FALSE(confirmed(surface.offset(thinner)));
  }
}

TEST_CASE("The same crossing is found again", "[self_intersection]") {
  const PNSurface surface = pipe(helix(8, 3, 33), 2);
  const auto first = confirmed(surface);
  REQUIRE(first);
  for (int round = 0; round < 5; ++round) {
    const auto again = surface.self_intersection();
    REQUIRE(again);
    CHECK(again->point == first->point);
    CHECK(again->places[0].u == first->places[0].u);
    CHECK(again->places[1].v == first->places[1].v);
  }
}

namespace {

/// A polynomial spine by its definition, sampled densely: positions, directions, lengths.
class SampledSpine {
 public:
  static constexpr int kCount = 120;

  explicit SampledSpine(const std::vector<std::array<double, 3>>& poles) {
    for (int i = 0; i <= kCount; ++i) {
      const double t = static_cast<double>(i) / kCount;
      const auto p = derivatives(poles, t);
      points_.push_back(p[0]);
      directions_.push_back(p[1].normalized());
      const double speed = p[1].norm();
      curvature_ = std::max(curvature_, p[1].cross(p[2]).norm() / (speed * speed * speed));
      lengths_.push_back(i == 0 ? 0
                                : lengths_.back() + (points_[static_cast<std::size_t>(i)] -
                                                     points_[static_cast<std::size_t>(i) - 1])
                                                        .norm());
    }
  }

  double largest_curvature() const { return curvature_; }

  /// How far points of the pipe are outside its parts elsewhere, at least. Parts within half a turn
  /// of the osculating circle are at least as far away as the own axis (A. Schur).
  double clearance(double radius) const {
    const double near = M_PI / curvature_;
    double least = HUGE_VAL;
    for (std::size_t i = 0; i < points_.size(); ++i) {
      const Vector3d e = directions_[i].unitOrthogonal(), f = directions_[i].cross(e);
      for (int k = 0; k < 16; ++k) {
        const double angle = k * M_PI / 8;
        const Vector3d x = points_[i] + radius * (std::cos(angle) * e + std::sin(angle) * f);
        for (std::size_t j = 1; j + 1 < points_.size(); ++j) {
          if (std::abs(lengths_[i] - lengths_[j]) < near) continue;
          const double distance = (x - points_[j]).norm();
          // Only where the axis is nearest inside it: beyond its ends there is no pipe.
          if (distance > (x - points_[j - 1]).norm() || distance > (x - points_[j + 1]).norm()) {
            continue;
          }
          least = std::min(least, distance - radius);
        }
      }
    }
    return least;
  }

 private:
  static std::array<Vector3d, 3> derivatives(const std::vector<std::array<double, 3>>& poles,
                                             double t) {
    std::vector<Vector3d> b;
    for (const auto& p : poles) b.emplace_back(p[0], p[1], p[2]);
    std::array<Vector3d, 3> result;
    const double n = static_cast<double>(b.size()) - 1;
    while (b.size() > 1) {
      if (b.size() == 3) result[2] = n * (n - 1) * (b[2] - 2 * b[1] + b[0]);
      if (b.size() == 2) result[1] = n * (b[1] - b[0]);
      for (std::size_t i = 0; i + 1 < b.size(); ++i) b[i] = (1 - t) * b[i] + t * b[i + 1];
      b.pop_back();
    }
    result[0] = b[0];
    return result;
  }

  std::vector<Vector3d> points_, directions_;
  std::vector<double> lengths_;
  double curvature_ = 0;
};

}  // namespace

TEST_CASE("200 pipes against the distances of their surfaces from their axes",
          "[self_intersection]") {
  std::mt19937 generator(3);
  std::uniform_real_distribution<double> uniform(-1, 1);
  int alone = 0, crossing = 0;
  while (alone + crossing < 200) {
    std::vector<std::array<double, 3>> poles;
    const int degree = 3 + static_cast<int>(generator() % 3);
    for (int i = 0; i <= degree; ++i) {
      poles.push_back({10 * uniform(generator), 10 * uniform(generator), 3 * uniform(generator)});
    }
    const SampledSpine spine(poles);
    const double radius = (0.5 + 0.45 * std::abs(uniform(generator))) / spine.largest_curvature();
    // Too near to call by samples, or so thin that they are coarse.
    if (radius < 0.15) continue;
    const double clearance = spine.clearance(radius);
    if (std::abs(clearance) < 0.05 * radius) continue;
    // As many of each kind.
    if (clearance > 0 && alone >= 100) continue;
    INFO("radius " << radius << ", clearance " << clearance);
    for (const auto& p : poles) UNSCOPED_INFO(p[0] << ", " << p[1] << ", " << p[2]);
    const bool found = confirmed(pipe(Curve::bezier(poles), radius)).has_value();
    CHECK(found == (clearance < 0));
    ++(clearance < 0 ? crossing : alone);
  }
}
