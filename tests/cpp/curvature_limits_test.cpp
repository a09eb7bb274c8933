// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/bezier/curvature_limits.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <random>

using namespace pn;

namespace {

using Patch = RationalPatch;
using Polynomial = BivariatePolynomial;

Polynomial number(double x) { return Polynomial(Rational::exactly(x)); }

/// low + (high - low) t for the parameter t of [0, 1].
Polynomial between(double low, double high, Variable variable) {
  const Rational a = Rational::exactly(low), b = Rational::exactly(high);
  return Polynomial(RationalPolynomial({a, b - a}), variable);
}

/// The graph of z over [x0, x1] x [y0, y1]; its normal is upwards.
Patch graph(const Polynomial& z, double x0, double x1, double y0, double y1) {
  const Polynomial x = between(x0, x1, Variable::kU), y = between(y0, y1, Variable::kV);
  return {{x, y, z.composed(x, y)}, 1L, {}, 1};
}

const Polynomial kX = between(0, 1, Variable::kU), kY = between(0, 1, Variable::kV);
const Polynomial kOne(1L);

/// Half an ellipsoid and more, projected stereographically from (0, 0, -c) or (0, 0, c): the part
/// over [s0, s1] x [t0, t1]. Its normal is outwards.
Patch ellipsoid(double a, double b, double c, int pole, double s0, double s1, double t0,
                double t1) {
  const Polynomial s = between(s0, s1, Variable::kU), t = between(t0, t1, Variable::kV);
  const Polynomial square = s * s + t * t;
  return {{number(2 * a) * s, number(2 * b) * t, number(pole * c) * (kOne - square)},
          kOne + square,
          {},
          pole};
}

/// A quarter circle of radius 1, (1 - t^2, 2 t) / (1 + t^2).
struct Quarter {
  Polynomial cosine, sine, weight;
  explicit Quarter(Variable variable) {
    const Polynomial t = between(0, 1, variable);
    cosine = kOne - t * t;
    sine = number(2) * t;
    weight = kOne + t * t;
  }
};

/// A 90 x 90 degrees piece of the torus of radii 4 and 1, on the outer (side = 1) or inner (-1)
/// half. Its normal points out of the tube.
Patch torus_piece(int side) {
  const Quarter around(Variable::kU), tube(Variable::kV);
  const Polynomial radius = number(4) * tube.weight + number(side) * tube.cosine;
  return {{radius * around.cosine, radius * around.sine, tube.sine * around.weight},
          around.weight * tube.weight,
          {},
          side};
}

/// The principal radii towards n and against it, by mean and Gaussian curvature.
OffsetRange focal_distances(const Patch& patch, double u, double v) {
  const Rational at_u = Rational::exactly(u), at_v = Rational::exactly(v);
  const auto value = [&](const Polynomial& p) { return p(at_u, at_v).to_double(); };
  const auto slope = [&](const Polynomial& p, Variable by) { return value(p.derivative(by)); };
  std::array<std::array<double, 3>, 5> d;  // x_u, x_v, x_uu, x_uv, x_vv
  const Variable by_u = Variable::kU, by_v = Variable::kV;
  for (std::size_t i = 0; i < 3; ++i) {
    const Polynomial &x = patch.point[i], &w = patch.weight;
    // (x / w)' = (x' w - x w') / w^2, and once more.
    const auto first = [&](Variable by) { return x.derivative(by) * w - x * w.derivative(by); };
    const double w2 = value(w) * value(w);
    const auto second = [&](Variable a, Variable b) {
      return (slope(first(a), b) - 2 * value(first(a)) * slope(w, b) / value(w)) / w2;
    };
    d[0][i] = value(first(by_u)) / w2;
    d[1][i] = value(first(by_v)) / w2;
    d[2][i] = second(by_u, by_u);
    d[3][i] = second(by_u, by_v);
    d[4][i] = second(by_v, by_v);
  }
  const auto dot = [](const auto& a, const auto& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  };
  const std::array<double, 3> n = {d[0][1] * d[1][2] - d[0][2] * d[1][1],
                                   d[0][2] * d[1][0] - d[0][0] * d[1][2],
                                   d[0][0] * d[1][1] - d[0][1] * d[1][0]};
  const double area = std::sqrt(dot(n, n)), sign = patch.side / area;
  const double e = dot(d[0], d[0]), f = dot(d[0], d[1]), g = dot(d[1], d[1]);
  const double l = sign * dot(n, d[2]), m = sign * dot(n, d[3]), o = sign * dot(n, d[4]);
  const double gauss = (l * o - m * m) / (area * area);
  const double mean = (e * o - 2 * f * m + g * l) / (2 * area * area);
  const double root = std::sqrt(std::max(0.0, mean * mean - gauss));
  return {mean - root < 0 ? 1 / (mean - root) : -INFINITY,
          mean + root > 0 ? 1 / (mean + root) : INFINITY};
}

/// The smallest focal distances of a grid on the region.
OffsetRange sampled(const std::vector<Patch>& patches, int count) {
  OffsetRange least = {-INFINITY, INFINITY};
  for (const Patch& patch : patches) {
    for (int i = 0; i <= count; ++i) {
      for (int j = 0; j <= count; ++j) {
        const double u = static_cast<double>(i) / count, v = static_cast<double>(j) / count;
        bool inside = true;
        for (const Polynomial& g : patch.region) {
          inside = inside && g(Rational::exactly(u), Rational::exactly(v)).sign() >= 0;
        }
        if (!inside) continue;
        const OffsetRange here = focal_distances(patch, u, v);
        least = {std::max(least.lower, here.lower), std::min(least.upper, here.upper)};
      }
    }
  }
  return least;
}

constexpr double kTolerance = 1e-9;

/// The range lies inside the true one and within `slack` of it.
void check_range(const std::vector<Patch>& patches, double lower, double upper,
                 double slack = 1e-8) {
  const OffsetRange found = curvature_limits(patches, kTolerance);
  CAPTURE(found.lower, found.upper);
  const auto check_end = [&](double end, double truth) {
    if (std::isinf(truth)) {
      CHECK(std::isinf(end));
    } else {
      CHECK(end < truth);
      CHECK(end >= truth - slack);
    }
  };
  check_end(found.upper, upper);
  check_end(-found.lower, -lower);
}

void check_empty(const Patch& patch) {
  const OffsetRange found = curvature_limits({patch}, kTolerance);
  CHECK(found.lower == 0);
  CHECK(found.upper == 0);
}

}  // namespace

TEST_CASE("Nothing limits the offsets of a plane", "[curvature_limits]") {
  check_range({graph(number(3) * kX - kY, 0, 2, 0, 1)}, -INFINITY, INFINITY);
  // The same with a weight that varies.
  const Patch plane = {{kX, kY, kX + kY}, kOne + kX + number(2) * kY, {}, -1};
  check_range({plane}, -INFINITY, INFINITY);
}

TEST_CASE("A ridge between two samples is found by the proof", "[curvature_limits]") {
  // The slope K (x - a)(x - b)(x - c) bends most at a, where no sample is near, and less at c.
  constexpr double kSteep = 1000, kA = 9.0 / 32, kB = 0.75, kC = 1;
  const Polynomial z = number(kSteep / 12) * kX *
                       (number(3) * kX * kX * kX - number(4 * (kA + kB + kC)) * kX * kX +
                        number(6 * (kA * kB + kB * kC + kC * kA)) * kX - number(12 * kA * kB * kC));
  const OffsetRange found = curvature_limits({graph(z, 0, 1, 0, 1)}, kTolerance);
  CHECK(found.upper == Approx(1 / (kSteep * (kB - kA) * (kC - kA))).epsilon(1e-3));
}

TEST_CASE("A cylinder and a cone are limited on one side", "[curvature_limits]") {
  const Quarter circle(Variable::kU);
  const Polynomial height = between(0, 5, Variable::kV) * circle.weight;
  Patch cylinder = {
      {number(2) * circle.cosine, number(2) * circle.sine, height}, circle.weight, {}, 1};
  check_range({cylinder}, -2, INFINITY);
  cylinder.side = -1;
  check_range({cylinder}, -INFINITY, 2);
  // The radius of curvature of a cone is the distance from the axis along the normal.
  const Polynomial radius = between(1, 3, Variable::kV);
  const Patch cone = {
      {radius * circle.cosine, radius * circle.sine, radius * circle.weight}, circle.weight, {}, 1};
  check_range({cone}, -std::sqrt(2), INFINITY);
}

TEST_CASE("The sphere, all of whose points are umbilics", "[curvature_limits]") {
  for (const int pole : {1, -1}) {
    check_range({ellipsoid(3, 3, 3, pole, -1, 1, -1, 1)}, -3, INFINITY);
  }
  Patch inwards = ellipsoid(3, 3, 3, 1, 0, 0.5, -1, 1);
  inwards.side = -1;
  check_range({inwards}, -INFINITY, 3);
}

TEST_CASE("The torus: the tube inside, the hole outside", "[curvature_limits]") {
  check_range({torus_piece(1)}, -1, INFINITY);
  check_range({torus_piece(-1)}, -1, 3);
  check_range({torus_piece(1), torus_piece(-1)}, -1, 3);
}

TEST_CASE("The elliptic paraboloid", "[curvature_limits]") {
  const Polynomial z = (number(0.25) * kX * kX + number(0.5) * kY * kY) * number(0.5);
  check_range({graph(z, -1, 2, -1.5, 1)}, -INFINITY, 2);
  check_range({graph(z, 0, 2, 0, 2)}, -INFINITY, 2);
}

TEST_CASE("The hyperbolic paraboloid z = x y", "[curvature_limits]") {
  check_range({graph(kX * kY, -1, 1, -1, 1)}, -1, 1);
  check_range({graph(kX * kY, -1, 1.5, -0.5, 1)}, -1, 1);
  // On the diagonal k = (-x^2 +- (x^2 + 1)) / (1 + 2 x^2)^(3/2), largest at the corner (1, 1).
  check_range({graph(kX * kY, 1, 2, 1, 2)}, -std::sqrt(3), 3 * std::sqrt(3));
}

TEST_CASE("A triaxial ellipsoid ends at its sharpest points", "[curvature_limits]") {
  std::vector<Patch> whole;
  for (const int pole : {1, -1}) {
    for (const double s : {-1.0, 0.0}) {
      for (const double t : {-1.0, 0.0}) {
        whole.push_back(ellipsoid(3, 2, 1, pole, s, s + 1, t, t + 1));
      }
    }
  }
  check_range(whole, -1.0 / 3, INFINITY, 1e-7);
  // The half z >= 0 as a region: the sharpest points (+-3, 0, 0) are on its edge.
  Patch half = ellipsoid(3, 2, 1, 1, -1.5, 1.5, -1.25, 1.25);
  const Polynomial s = between(-1.5, 1.5, Variable::kU), t = between(-1.25, 1.25, Variable::kV);
  half.region = {kOne - s * s - t * t};
  check_range({half}, -1.0 / 3, INFINITY, 1e-7);
}

TEST_CASE("A region that leaves out the sharpest points", "[curvature_limits]") {
  const Polynomial x = between(-3, 3, Variable::kU), y = between(-3, 3, Variable::kV);
  Patch bowl = graph((kX * kX + kY * kY) * number(0.5), -3, 3, -3, 3);
  bowl.region = {x - number(1)};
  // On the parabola's meridian at radius 1: k = 1 / (1 + r^2)^(1/2) around the axis.
  check_range({bowl}, -INFINITY, std::sqrt(2));
  bowl.region = {x + number(2) * y - number(1)};  // at distance 1 / sqrt(5) from the axis
  check_range({bowl}, -INFINITY, std::sqrt(1.2));
  bowl.region = {x * x * number(0.25) + y * y - number(1), number(5) - x * x - y * y};
  check_range({bowl}, -INFINITY, std::sqrt(2));
  // Two edges that meet in the corner (1, 1 / 2), which is nearest to the axis.
  bowl.region = {x - number(1), x + y - number(1.5), y - number(0.5)};
  check_range({bowl}, -INFINITY, std::sqrt(2.25));
}

TEST_CASE("What is outside the region may be singular", "[curvature_limits]") {
  const Quarter circle(Variable::kU);
  const Polynomial radius = between(0, 2, Variable::kV);
  Patch cone = {
      {radius * circle.cosine, radius * circle.sine, radius * circle.weight}, circle.weight, {}, 1};
  check_empty(cone);
  cone.region = {radius - kOne};
  check_range({cone}, -std::sqrt(2), INFINITY);
  // An edge that is no multiple of a power of 2, so that all halves of the square straddle it.
  cone.region = {number(3) * radius - kOne};
  check_range({cone}, -std::sqrt(2) / 3, INFINITY);
  cone.region = {number(3) * radius - kOne, number(3) * kX - kOne};
  check_range({cone}, -std::sqrt(2) / 3, INFINITY);
}

TEST_CASE("Where the surface is not immersed no offset is regular", "[curvature_limits]") {
  // The tangents of the cubic (t, t^2, t^3), with its edge of regression.
  const Polynomial t = kX, v = between(-1, 1, Variable::kV);
  check_empty({{t + v, t * t + number(2) * t * v, t * t * t + number(3) * t * t * v}, 1L, {}, 1});
  // Whitney's umbrella, whose pinch point is no zero of a common factor.
  const Polynomial x = between(-1, 1, Variable::kU), y = between(-1, 1, Variable::kV);
  check_empty({{x * y, x, y * y}, 1L, {}, 1});
  // A plane folded along the line u = 0, where curvatures stay finite, and a cone of degree two
  // with its apex, whose convex side has no focal points.
  check_empty({{kX * kX, kY, 0L}, 1L, {}, 1});
  check_empty({{kX * kX, kY * kY, kX * kY}, 1L, {}, 1});
  // A curve, and a point.
  check_empty({{kX, kX * kX, kX}, 1L, {}, 1});
  check_empty({{1L, 2L, 3L}, 1L, {}, 1});
}

TEST_CASE("A narrow ridge", "[curvature_limits]") {
  // The cylinder over y = x^2 / 8 + h / (1 + k (x - a)^2): of curvature about 1/4 but for a ridge
  // that is 1 / sqrt(k) wide, of curvature 1/4 - 2 h k, and its feet of curvature up to 1/4 + h k
  // / 2.
  const double a = 0.54, k = 1e5, h = 1e-5;
  const Polynomial s = kX - number(a), weight = kOne + number(k) * s * s;
  const Patch ridge = {
      {kX * weight, kY * weight, kX * kX * number(0.125) * weight + number(h)}, weight, {}, 1};
  double most = 0, least = 0;
  for (int i = -4000; i <= 4000; ++i) {
    const double r = i * 5e-6, x = a + r, w = 1 + k * r * r;
    const double slope = x / 4 - 2 * h * k * r / (w * w);
    const double second = 0.25 + h * k * (6 * k * r * r - 2) / (w * w * w);
    const double curvature = second / std::pow(1 + slope * slope, 1.5);
    most = std::max(most, curvature);
    least = std::min(least, curvature);
  }
  REQUIRE(1 / most < 2);
  check_range({ridge}, 1 / least, 1 / most, 1e-6);
}

TEST_CASE("A maximum that the samples do not show is met by the proof", "[curvature_limits]") {
  // The cylinder over y with y'' = p / 100, p = 1 + e x - l x (x - a)^2: p is largest near a, half
  // way between two samples that are below the value 1 at x = 0.
  const double a = 17.0 / 32, l = 20, e = l / 2048;
  const std::vector<double> p = {1, e - l * a * a, 2 * l * a, -l};
  Polynomial height, power = kX * kX;
  for (std::size_t i = 0; i < p.size(); ++i) {
    const double n = static_cast<double>(i);
    height += power * number(p[i] / 100 / ((n + 1) * (n + 2)));
    power *= kX;
  }
  double most = 0;
  for (int i = -1000; i <= 1000; ++i) {
    const double x = a + i * 1e-5;
    double slope = 0, second = 0;
    for (std::size_t j = p.size(); j-- > 0;) {
      slope = slope * x + p[j] / 100 / (static_cast<double>(j) + 1);
      second = second * x + p[j] / 100;
    }
    slope *= x;
    most = std::max(most, second / std::pow(1 + slope * slope, 1.5));
  }
  REQUIRE(1 / most < 99.8);
  const OffsetRange found = curvature_limits({graph(height, 0, 1, 0, 1)}, kTolerance);
  CHECK(found.upper < 1 / most);
  CHECK(found.upper > 1 / most - 1e-6);
}

TEST_CASE("Bilinear patches against samples", "[curvature_limits]") {
  std::mt19937 generator(4);
  std::uniform_real_distribution<double> uniform(-1, 1);
  for (int round = 0; round < 20; ++round) {
    Patch patch = {{}, 1L, {}, round % 2 == 0 ? 1 : -1};
    for (std::size_t i = 0; i < 3; ++i) {
      patch.point[i] = number(uniform(generator)) + number(uniform(generator)) * kX +
                       number(uniform(generator)) * kY + number(uniform(generator)) * kX * kY;
    }
    patch.point[0] += number(2) * kX;
    patch.point[1] += number(2) * kY;
    CAPTURE(round);
    const OffsetRange samples = sampled({patch}, 32);
    const OffsetRange found = curvature_limits({patch}, kTolerance);
    CHECK(found.upper < samples.upper);
    CHECK(found.lower > samples.lower);
    CHECK(found.upper > samples.upper * 0.97);
    CHECK(found.lower < samples.lower * 0.97);
  }
}

TEST_CASE("Ruled patches of degree three against samples, also in a region", "[curvature_limits]") {
  std::mt19937 generator(5);
  std::uniform_real_distribution<double> uniform(-1, 1);
  for (int round = 0; round < 8; ++round) {
    Patch patch = {{}, 1L, {}, 1};
    for (std::size_t i = 0; i < 3; ++i) {
      Polynomial power(1L);
      for (int degree = 0; degree <= 3; ++degree) {
        patch.point[i] +=
            power * (number(uniform(generator)) + number(uniform(generator) / 2) * kY);
        power *= kX;
      }
    }
    patch.point[0] += number(6) * kX;
    patch.point[1] += number(4) * kY;
    if (round % 2 == 1) patch.region = {kX + kY - number(0.5), kOne - kX * kY * number(2)};
    CAPTURE(round);
    const OffsetRange samples = sampled({patch}, 32);
    const OffsetRange found = curvature_limits({patch}, kTolerance);
    CHECK(found.upper < samples.upper);
    CHECK(found.lower > samples.lower);
    CHECK(found.upper > samples.upper * 0.97);
    CHECK(found.lower < samples.lower * 0.97);
  }
}

TEST_CASE("The range of many patches is the common one, and grows with the size",
          "[curvature_limits]") {
  const Patch saddle = graph(kX * kY, 1, 2, 1, 2), ball = ellipsoid(3, 3, 3, 1, 0, 1, 0, 1);
  check_range({saddle, ball}, -std::sqrt(3), 3 * std::sqrt(3));
  check_range({ball, saddle, ellipsoid(1, 1, 1, 1, 0, 1, 0, 1)}, -1, 3 * std::sqrt(3));
  Patch large = saddle;
  for (Polynomial& p : large.point) p *= number(0x1p20);
  const OffsetRange found = curvature_limits({large}, 0x1p20 * kTolerance);
  const OffsetRange unit = curvature_limits({saddle}, kTolerance);
  CHECK(found.upper == 0x1p20 * unit.upper);
  CHECK(found.lower == 0x1p20 * unit.lower);
}

TEST_CASE("The focal points are on the normals of the sharpest points", "[curvature_limits]") {
  const auto check_point = [](const std::array<double, 3>& found, double x, double y, double z) {
    CHECK(std::hypot(found[0] - x, found[1] - y, found[2] - z) < 1e-6);
  };
  const OffsetRange end = curvature_limits({ellipsoid(3, 2, 1, 1, 0, 1.5, 0, 1)}, kTolerance);
  REQUIRE(end.at_lower);
  CHECK_FALSE(end.at_upper);
  check_point(end.at_lower->base, 3, 0, 0);
  check_point(end.at_lower->point, 8.0 / 3, 0, 0);
  CHECK(end.at_lower->distance == Approx(-1.0 / 3));

  const OffsetRange saddle = curvature_limits({graph(kX * kY, -1, 1, -1, 1)}, kTolerance);
  REQUIRE((saddle.at_lower && saddle.at_upper));
  check_point(saddle.at_lower->base, 0, 0, 0);
  check_point(saddle.at_lower->point, 0, 0, -1);
  check_point(saddle.at_upper->point, 0, 0, 1);

  // In a region the sharpest point may be on its edge.
  const Polynomial x = between(-3, 3, Variable::kU);
  Patch bowl = graph((kX * kX + kY * kY) * number(0.5), -3, 3, -3, 3);
  bowl.region = {x - number(1)};
  const OffsetRange edge = curvature_limits({bowl}, kTolerance);
  REQUIRE(edge.at_upper);
  check_point(edge.at_upper->base, 1, 0, 0.5);
  check_point(edge.at_upper->point, 0, 0, 1.5);
}

TEST_CASE("Nothing proved, no focal point; of many patches that of the sharpest",
          "[curvature_limits]") {
  const OffsetRange fold = curvature_limits({{{kX * kX, kY, 0L}, 1L, {}, 1}}, kTolerance);
  CHECK_FALSE(fold.at_lower);
  CHECK_FALSE(fold.at_upper);
  const OffsetRange plane = curvature_limits({graph(number(3) * kX - kY, 0, 2, 0, 1)}, kTolerance);
  CHECK_FALSE(plane.at_lower);
  CHECK_FALSE(plane.at_upper);
  const Patch large = ellipsoid(3, 3, 3, 1, 0, 1, 0, 1), small = ellipsoid(1, 1, 1, 1, 0, 1, 0, 1);
  const OffsetRange both = curvature_limits({large, small, large}, kTolerance);
  REQUIRE(both.at_lower);
  CHECK(both.at_lower->distance == Approx(-1));
  const auto& [px, py, pz] = both.at_lower->point;
  CHECK(std::hypot(px, py, pz) < 1e-9);
}

TEST_CASE("The focal points of random patches are centres of curvature", "[curvature_limits]") {
  std::mt19937 generator(6);
  std::uniform_real_distribution<double> uniform(-1, 1);
  for (int round = 0; round < 10; ++round) {
    Polynomial z;
    for (int i = 0; i <= 3; ++i) {
      for (int j = 0; i + j <= 3; ++j) {
        Polynomial term = number(uniform(generator));
        for (int k = 0; k < i; ++k) term *= kX;
        for (int k = 0; k < j; ++k) term *= kY;
        z += term;
      }
    }
    CAPTURE(round);
    const Patch patch = graph(z, 0, 1, 0, 1);
    const OffsetRange found = curvature_limits({patch}, kTolerance);
    for (const auto& focal : {found.at_lower, found.at_upper}) {
      if (!focal) continue;
      // The parameters of a graph over the unit square are its coordinates.
      const OffsetRange here = focal_distances(patch, focal->base[0], focal->base[1]);
      const double radius = focal->distance > 0 ? here.upper : here.lower;
      CHECK(focal->distance == Approx(radius).epsilon(1e-6));
      const auto& [x, y, height] = focal->base;
      CHECK(height ==
            Approx(z(Rational::exactly(x), Rational::exactly(y)).to_double()).margin(1e-12));
      const Polynomial zx = z.derivative(Variable::kU), zy = z.derivative(Variable::kV);
      const double p = zx(Rational::exactly(x), Rational::exactly(y)).to_double(),
                   q = zy(Rational::exactly(x), Rational::exactly(y)).to_double();
      const double scale = focal->distance / std::sqrt(1 + p * p + q * q);
      CHECK(focal->point[0] == Approx(x - scale * p).margin(1e-9));
      CHECK(focal->point[1] == Approx(y - scale * q).margin(1e-9));
      CHECK(focal->point[2] == Approx(height + scale).margin(1e-9));
    }
    const OffsetRange samples = sampled({patch}, 32);
    if (found.at_upper) CHECK(found.at_upper->distance <= samples.upper * (1 + 1e-12));
    if (found.at_lower) CHECK(found.at_lower->distance >= samples.lower * (1 + 1e-12));
  }
}
