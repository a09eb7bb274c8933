// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/shapes/mirror.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <random>

#include "error_code.hpp"
#include "parabolic_mirror.hpp"

using namespace pn;
using test::code_of;
using test::parabolic_mirror;

namespace {

using Vector = std::array<Rational, 3>;

Rational dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

Vector minus(const Vector& a, const Vector& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }

Vector exact(const std::array<double, 3>& p) {
  return {Rational::exactly(p[0]), Rational::exactly(p[1]), Rational::exactly(p[2])};
}

/// A Bezier patch of these degrees with poles on a bent grid, from 0 to 10 in x and y.
SplineSurfaceData bent_patch(int m, int n, unsigned seed, bool is_rational) {
  std::mt19937 generator(seed);
  std::uniform_real_distribution<double> bend(0, 1), weight(0.5, 2);
  SplineSurfaceData data{{m, n}, {{{0, 1}, {0, 1}}}, {{{m + 1, m + 1}, {n + 1, n + 1}}}, {}, {}};
  for (int i = 0; i <= m; ++i) {
    for (int j = 0; j <= n; ++j) {
      data.poles.push_back({10.0 * i / m, 10.0 * j / n + bend(generator), bend(generator)});
      if (is_rational) data.weights.push_back(weight(generator));
    }
  }
  return data;
}

SplineSurfaceData plane() {
  return {{1, 1},
          {{{0, 1}, {0, 1}}},
          {{{2, 2}, {2, 2}}},
          {{0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {1, 1, 0}},
          {}};
}

struct Point {
  Vector x, normal;  ///< of the length of the direction
};

Point at(const RationalSections& wavefront, const Rational& u, const Rational& v) {
  Point result;
  const Rational weight = wavefront.sections.weight.at(u, v);
  for (std::size_t c = 0; c < 3; ++c) {
    result.x[c] = wavefront.sections.point[c].at(u, v) / weight;
    result.normal[c] = wavefront.sections.direction[c].at(u, v) / weight;
  }
  return result;
}

struct MirrorPoint {
  Vector x, normal;
};

MirrorPoint at(const RationalPatch& patch, const Rational& u, const Rational& v) {
  MirrorPoint result;
  std::array<Vector, 2> slope;
  const Rational w = patch.weight(u, v);
  for (std::size_t c = 0; c < 3; ++c) {
    result.x[c] = patch.point[c](u, v) / w;
    for (const Variable by : {Variable::kU, Variable::kV}) {
      slope[static_cast<std::size_t>(by)][c] =
          (patch.point[c].derivative(by)(u, v) - result.x[c] * patch.weight.derivative(by)(u, v)) /
          w;
    }
  }
  result.normal = cross(slope[0], slope[1]);
  return result;
}

Rational fraction(std::mt19937& generator) {
  return Rational(std::uniform_int_distribution<long>(1, 99)(generator)) / Rational(100L);
}

/// The ray from the mirror is that of the light, reflected: r - e is along N, and r + e across.
void check_reflected(const Vector& before, const Vector& after, const Vector& normal) {
  CHECK(dot(before, before) == dot(after, after));
  const Vector change = cross(minus(after, before), normal);
  CHECK(dot(change, change).is_zero());
  CHECK(dot(before, normal) == -dot(after, normal));
}

}  // namespace

TEST_CASE("Parallel light is reflected exactly, and its paths are as long as they should be",
          "[mirror]") {
  const ParallelLight light{{1, -2, -3.5}, {0.5, 0, 20}};
  const Vector e = exact(light.direction), from = exact(light.from);
  std::mt19937 generator(5);
  for (const bool is_rational : {false, true}) {
    const SplineSurfaceData mirror = bent_patch(2, 1, 3, is_rational);
    const RationalPatch patch = rational_patches(mirror).front();
    const Wavefronts wavefronts = mirror_wavefronts(mirror, light);
    REQUIRE(wavefronts.patches.size() == 1);
    const RationalSections& x = wavefronts.patches.front();
    CHECK(x.squared_length == dot(e, e));
    CHECK(wavefronts.notes.empty());
    for (int i = 0; i < 20; ++i) {
      const Rational u = fraction(generator), v = fraction(generator);
      const MirrorPoint on = at(patch, u, v);
      const auto [x0, r] = at(x, u, v);
      check_reflected(e, r, on.normal);
      // On the ray, as far back as the light came.
      const Rational path = dot(minus(on.x, from), e) / dot(e, e);
      for (std::size_t c = 0; c < 3; ++c) CHECK(on.x[c] - path * r[c] == x0[c]);
    }
  }
}

TEST_CASE("Wavefronts are perpendicular to the rays", "[mirror]") {
  const Wavefronts wavefronts =
      mirror_wavefronts(bent_patch(2, 2, 7, true), ParallelLight{{0.25, 0, -1}, {0, 0, 9}});
  const SurfaceSections<Rational>& x = wavefronts.patches.front().sections;
  for (const Variable by : {Variable::kU, Variable::kV}) {
    // V.(W X_i - W_i X) = 0 as polynomials
    TensorPolynomial<Rational> product;
    for (std::size_t c = 0; c < 3; ++c) {
      product += x.direction[c] *
                 (x.weight * x.point[c].derivative(by) - x.weight.derivative(by) * x.point[c]);
    }
    CHECK(in_ring(product).is_zero());
  }
}

TEST_CASE("Wavefronts have the degrees of the theorem", "[mirror]") {
  const ParallelLight light{{0, 0, -1}, {0, 0, 9}};
  for (const int m : {1, 2, 3}) {
    const auto polynomial = mirror_wavefronts(bent_patch(m, 2, 4, false), light);
    CHECK(polynomial.patches.front().sections.weight.degree(Variable::kU) <= 5 * m - 2);
    const auto rational = mirror_wavefronts(bent_patch(m, 2, 4, true), light);
    CHECK(rational.patches.front().sections.weight.degree(Variable::kU) <= 7 * m - 4);
  }
}

TEST_CASE("A paraboloid reflects light along its axis into spheres around its focus", "[mirror]") {
  const Wavefronts wavefronts =
      mirror_wavefronts(parabolic_mirror(), ParallelLight{{0, 0, -2}, {0, 0, 5}});
  std::mt19937 generator(2);
  for (int i = 0; i < 10; ++i) {
    const auto [x, r] = at(wavefronts.patches.front(), fraction(generator), fraction(generator));
    const Vector from_focus = minus(x, {Rational(), Rational(), Rational(1L)});
    // Light from z = 5 has a path of 6 to the focus.
    CHECK(dot(from_focus, from_focus) == Rational(36L));
  }
  CHECK(wavefronts.leaving == 5.5);  // at the lowest pole, z = -1/2
}

TEST_CASE("A paraboloid reflects light from its focus into planes", "[mirror]") {
  const Wavefronts wavefronts = mirror_wavefronts(parabolic_mirror(), PointLight{{0, 0, 1}});
  const RationalSections& x = wavefronts.patches.front();
  REQUIRE(x.squared_length.has_value());
  CHECK(wavefronts.notes.empty());
  std::mt19937 generator(2);
  for (int i = 0; i < 10; ++i) {
    const auto [point, normal] = at(x, fraction(generator), fraction(generator));
    CHECK(point[2] == Rational(-1L));
    CHECK((normal[0].is_zero() && normal[1].is_zero() && normal[2].sign() > 0));
    CHECK(dot(normal, normal) == *x.squared_length);
  }
}

TEST_CASE("Light from elsewhere has one rational wavefront, and that is said", "[mirror]") {
  const PointLight light{{0.5, 0.25, 3}};
  const Wavefronts wavefronts = mirror_wavefronts(parabolic_mirror(), light);
  const RationalPatch patch = rational_patches(parabolic_mirror()).front();
  const RationalSections& x = wavefronts.patches.front();
  CHECK_FALSE(x.squared_length.has_value());
  CHECK(wavefronts.notes.size() == 1);
  const Vector source = exact(light.position);
  std::mt19937 generator(2);
  for (int i = 0; i < 10; ++i) {
    const Rational u = fraction(generator), v = fraction(generator);
    const MirrorPoint on = at(patch, u, v);
    const auto [x0, r] = at(x, u, v);
    check_reflected(minus(on.x, source), minus(on.x, x0), on.normal);
  }
}

TEST_CASE("What cannot be reflected is refused with the reason", "[mirror]") {
  const auto refused = [](const SplineSurfaceData& mirror, const Light& light) {
    return code_of([&] { mirror_wavefronts(mirror, light); });
  };
  CHECK(refused(plane(), ParallelLight{{1, 2, 0}, {0, 0, 0}}) == ErrorCode::kGrazingLight);
  CHECK(refused(plane(), PointLight{{3, 3, 0}}) == ErrorCode::kGrazingLight);
  CHECK(refused(plane(), PointLight{{0.3, 0.3, 0}}) == ErrorCode::kLightOnMirror);
  CHECK(refused(plane(), PointLight{{0, 1, 0}}) == ErrorCode::kLightOnMirror);
  CHECK(refused(plane(), PointLight{{0, 1, 2}}) == ErrorCode::kZeroLength);
  CHECK(refused(parabolic_mirror(), PointLight{{0, 0, 0}}) == ErrorCode::kLightOnMirror);
  CHECK(refused(plane(), ParallelLight{{0, 0, 0}, {0, 0, 0}}) == ErrorCode::kZeroLength);
  CHECK(refused(plane(), ParallelLight{{0, NAN, 0}, {0, 0, 0}}) == ErrorCode::kNotFinite);
  CHECK(refused(plane(), PointLight{{0, INFINITY, 0}}) == ErrorCode::kNotFinite);
  SplineSurfaceData line = plane();
  line.poles[2] = line.poles[0];
  line.poles[3] = line.poles[1];
  CHECK(refused(line, ParallelLight{{0, 0, 1}, {0, 0, 0}}) == ErrorCode::kZeroLength);
  CHECK_FALSE(refused(plane(), ParallelLight{{1, 0, -1}, {0, 0, 9}}).has_value());
}
