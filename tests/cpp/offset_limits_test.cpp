// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/bezier/offset_limits.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "circle_spine.hpp"
#include "enclosures.hpp"
#include "pn/geometry_error.hpp"
#include "pn/shapes/canal_surface.hpp"
#include "random_canals.hpp"

using namespace pn;
using namespace pn::test;

namespace {

OffsetRange range(const Curve& spine, const Law& law) {
  const EnvelopeChain chain = canal_surface(spine, law);
  return regular_range(chain, default_tolerance(chain));
}

/// The range lies inside the true one and within 1e-6 of it.
void check_range(const OffsetRange& found, double lower, double upper) {
  CHECK(found.lower >= lower);
  CHECK(found.lower <= lower + 1e-6);
  if (std::isinf(upper)) {
    CHECK(std::isinf(found.upper));
  } else {
    CHECK(found.upper <= upper);
    CHECK(found.upper >= upper - 1e-6);
  }
}

using Point = std::array<double, 3>;

double distance(const Point& a, const Point& b) {
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

void check_point(const Point& found, const Point& expected) {
  CHECK(distance(found, expected) < 1e-6);
}

}  // namespace

TEST_CASE("Cylinder, cone, torus", "[offset_limits]") {
  check_range(range(Curve::bezier({{0, 0, 0}, {1, 2, 2}}), Law::constant(0.5)), -0.5, INFINITY);
  check_range(range(Curve::bezier({{0, 0, 0}, {1, 2, 2}}), Law::bezier({0.5, 2})), -0.5, INFINITY);
  check_range(range(circle(4), Law::constant(1)), -1, 3);
  check_range(range(Curve::bezier({{4, 0, 0}, {4, 4, 0}, {0, 4, 0}}, {1, 1, 2}), Law::constant(1)),
              -1, 3);
}

TEST_CASE("A pipe ends at the least radius of curvature of its spine", "[offset_limits]") {
  // The parabola (2 t - 1, (2 t - 1)^2) has radius of curvature 1/2 at its vertex t = 1/2.
  const Curve parabola = Curve::bezier({{-1, 1, 0}, {0, -1, 0}, {1, 1, 0}});
  check_range(range(parabola, Law::constant(0.125)), -0.125, 0.375);
  // The helix-like cubic (t, t^2, t^3): curvature 2 at t = 0, its largest on [0, 1].
  const Curve twisted =
      Curve::bezier({{0, 0, 0}, {1. / 4, 0, 0}, {1. / 2, 1. / 4, 0}, {3. / 4, 3. / 4, 3. / 4}});
  const OffsetRange found = range(twisted, Law::constant(0.01));
  double largest = 0;
  for (int i = 0; i <= 4000; ++i) {
    const double t = i / 4000.0;
    // (3/4 t, 3/4 t^2, 3/4 t^3) and its derivatives.
    const std::array<double, 3> a = {1, 2 * t, 3 * t * t}, b = {0, 2, 6 * t};
    const std::array<double, 3> c = {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2],
                                     a[0] * b[1] - a[1] * b[0]};
    const double speed = std::hypot(a[0], a[1], a[2]);
    largest = std::max(largest, std::hypot(c[0], c[1], c[2]) / (speed * speed * speed) / 0.75);
  }
  CHECK(found.upper == Approx(1 / largest - 0.01).epsilon(1e-5));
}

TEST_CASE("A bend between two samples is found by the proof", "[offset_limits]") {
  // x' = (t - a)(t - b), and y' is small at a and at b: bends at both, that at a so narrow that the
  // samples beside it are straighter than b, which is one of them.
  constexpr double kSize = 1e5, kA = 17.0 / 64, kB = 0.75, kAtA = 1e-3, kAtB = 0.05, kRadius = 0.01;
  const double rise = kAtB + kAtA, start = -kAtA - rise * kA / (kB - kA);
  const auto x = [&](double t) { return std::array{(t - kA) * (t - kB), 2 * t - kA - kB}; };
  const auto y = [&](double t) { return std::array{start * (kB - kA) + rise * t, rise}; };
  double least = HUGE_VAL;  // radius of curvature
  for (int i = -1000; i <= 1000; ++i) {
    const double t = kA + 1e-5 * i, speed = std::hypot(x(t)[0], y(t)[0]);
    const double bend = std::abs(x(t)[0] * y(t)[1] - y(t)[0] * x(t)[1]);
    least = std::min(least, kSize * speed * speed * speed / bend);
  }
  const auto pole = [&](double t1, double t2, double t3) {
    return std::array{kSize * (kA * kB * t1 - (kA + kB) / 2 * t2 + t3 / 3),
                      kSize * (start * (kB - kA) * t1 + rise / 2 * t2), 0.0};
  };
  const Curve spine =
      Curve::bezier({pole(0, 0, 0), pole(1. / 3, 0, 0), pole(2. / 3, 1. / 3, 0), pole(1, 1, 1)});
  const OffsetRange found = range(spine, Law::constant(kRadius));
  CHECK(found.upper == Approx(least - kRadius).epsilon(1e-2));
}

TEST_CASE("A radius that varies moves the focal distance", "[offset_limits]") {
  // A straight spine: the meridian (t + r n_x, r n_y) is a plane curve. For r = 2 - t^2 / 2 the
  // largest turn is at the middle of the bump; K = R' = -1 there for M = 1, so only rho = 0 counts
  // inside, while a dip r = 1 + t^2 / 2 has K = 1: rho < D = 1 - t^2, least at the ends of [-1/2,
  // 1/2].
  const Curve line = Curve::bezier({{-0.5, 0, 0}, {0.5, 0, 0}});
  check_range(range(line, Law::bezier({2, 2.25, 2})), -2, INFINITY);
  // r = 1 + (t - 1/2)^2 / 2: at t the focal distance is 1 - s^2 - r = -3/2 s^2 with s = t - 1/2.
  const OffsetRange dip = range(line, Law::bezier({1.125, 0.875, 1.125}));
  check_range(dip, -1, -0.375);
}

TEST_CASE("At a corner only the radius counts", "[offset_limits]") {
  const Curve corner =
      Curve::bspline({1, {0, 1, 2}, {2, 1, 2}, {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}}, {}});
  check_range(range(corner, Law::constant(0.5)), -0.5, INFINITY);
}

TEST_CASE("A place where the spine stands still leaves no regular offset", "[offset_limits]") {
  const OffsetRange cusp =
      range(Curve::bezier({{0, 0, 0}, {0, 0, 0}, {1, 0, 0}, {1, 1, 0}}), Law::constant(0.5));
  CHECK(cusp.lower >= cusp.upper - 1e-6);
}

TEST_CASE("The focal point of a pipe is on the spine inwards, and on its curvature axis outwards",
          "[offset_limits]") {
  // The vertex of the parabola (s, s^2) has its centre of curvature at (0, 1/2).
  const OffsetRange parabola =
      range(Curve::bezier({{-1, 1, 0}, {0, -1, 0}, {1, 1, 0}}), Law::constant(0.125));
  REQUIRE(parabola.at_upper);
  check_point(parabola.at_upper->base, {0, 0.125, 0});
  check_point(parabola.at_upper->point, {0, 0.5, 0});
  CHECK(parabola.at_upper->distance == Approx(0.375));

  const OffsetRange torus = range(circle(4), Law::constant(1));
  REQUIRE((torus.at_lower && torus.at_upper));
  const Point &tube = torus.at_lower->point, &hole = torus.at_upper->base;
  CHECK(std::hypot(tube[0], tube[1]) == Approx(4));
  CHECK(std::hypot(hole[0], hole[1]) == Approx(3));
  check_point(torus.at_upper->point, {0, 0, 0});
}

TEST_CASE("The focal point of a cone is its narrow end", "[offset_limits]") {
  const OffsetRange found = range(Curve::bezier({{0, 0, 0}, {0, 0, 5}}), Law::bezier({4, 1}));
  REQUIRE(found.at_lower);
  check_point(found.at_lower->point, {0, 0, 5});
  // r' / |m'| = -3/5: the normal has slope 3/5 along the axis.
  CHECK(found.at_lower->base[2] == Approx(5.6));
  CHECK(std::hypot(found.at_lower->base[0], found.at_lower->base[1]) == Approx(0.8));
  CHECK_FALSE(found.at_upper);
}

TEST_CASE("A spine that runs back, and one without a finite end, have no focal point there",
          "[offset_limits]") {
  const OffsetRange cusp =
      range(Curve::bezier({{0, 0, 0}, {4, 0, 0}, {0, 0, 0}}), Law::constant(0.5));
  CHECK_FALSE(cusp.at_lower);
  CHECK_FALSE(cusp.at_upper);
  CHECK_FALSE(range(Curve::bezier({{0, 0, 0}, {1, 2, 2}}), Law::constant(0.5)).at_upper);
}

TEST_CASE("At the focal points of random surfaces the offset is singular, and nowhere before",
          "[offset_limits]") {
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    const CanalInput input = RandomCanal(seed).input();
    std::optional<EnvelopeChain> chain;
    try {
      chain = canal_surface(Curve::bspline(input.spine), Law::bspline(input.radius));
    } catch (const GeometryError&) {
      continue;  // What is refused has no limits.
    }
    CAPTURE(input);
    const double tolerance = default_tolerance(*chain), size = tolerance / 1e-9;
    const OffsetRange found = regular_range(*chain, tolerance);
    for (const auto& focal : {found.at_lower, found.at_upper}) {
      if (!focal) continue;
      CHECK(distance(focal->base, focal->point) ==
            Approx(std::abs(focal->distance)).margin(1e-9 * size));
    }
    if (found.at_lower) CHECK(found.at_lower->distance <= found.lower);
    if (found.at_upper && found.lower < found.upper) {
      CHECK(found.at_upper->distance >= found.upper);
    }
  }
}

TEST_CASE("The tolerance is in proportion to the surface", "[offset_limits]") {
  const auto chain = [](double size) {
    return canal_surface(Curve::bezier({{0, 0, 0}, {size, 2 * size, 2 * size}}),
                         Law::constant(size));
  };
  CHECK(default_tolerance(chain(0x1p20)) == Approx(0x1p20 * default_tolerance(chain(1))));
  CHECK(default_tolerance(chain(1)) > 0);
  CHECK(default_tolerance(chain(1)) <= 1e-6);
}
