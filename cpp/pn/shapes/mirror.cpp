// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/shapes/mirror.hpp"

#include <algorithm>
#include <cstdio>
#include <limits>

#include "pn/algebra/parallel.hpp"
#include "pn/algebra/tensor_bernstein.hpp"
#include "pn/geometry_error.hpp"
#include "pn/input_numbers.hpp"

namespace pn {
namespace {

using Polynomial = BivariatePolynomial;
using Vector = std::array<Polynomial, 3>;
using Point = std::array<double, 3>;

Vector operator*(const Polynomial& factor, const Vector& a) {
  return {factor * a[0], factor * a[1], factor * a[2]};
}

Vector operator+(const Vector& a, const Vector& b) {
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}

Vector operator-(const Vector& a, const Vector& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

Polynomial dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

Vector derivative(const Vector& a, Variable variable) {
  return {a[0].derivative(variable), a[1].derivative(variable), a[2].derivative(variable)};
}

Vector exactly(const Point& p) {
  return {Polynomial(Rational::exactly(p[0])), Polynomial(Rational::exactly(p[1])),
          Polynomial(Rational::exactly(p[2]))};
}

[[noreturn]] void refuse_grazing() {
  throw GeometryError(ErrorCode::kGrazingLight,
                      "The light runs along the mirror everywhere: nothing is reflected.");
}

/// A normal field without common factors.
Vector normal_field(const RationalPatch& mirror) {
  const Vector &x = mirror.point, xu = derivative(x, Variable::kU),
               xv = derivative(x, Variable::kV);
  const Polynomial& w = mirror.weight;
  const Vector n = w * cross(xu, xv) + w.derivative(Variable::kU) * cross(xv, x) +
                   w.derivative(Variable::kV) * cross(x, xu);
  const Polynomial common = gcd(gcd(n[0], n[1]), n[2]);
  if (common.is_zero()) {
    throw GeometryError(ErrorCode::kZeroLength, "The mirror is a curve or a point, no surface.");
  }
  return {*quotient(n[0], common), *quotient(n[1], common), *quotient(n[2], common)};
}

/// The wavefronts of theorem 1, with X - W p in place of X.
RationalSections wavefronts(const RationalPatch& mirror, const ParallelLight& light) {
  const Polynomial& w = mirror.weight;
  const Vector n = normal_field(mirror), e = exactly(light.direction), p = exactly(light.from);
  const Polynomial square = dot(n, n), cosine = dot(e, n), two(2L);
  if (cosine.is_zero()) refuse_grazing();
  const Rational squared_length = leading_coefficient(dot(e, e));
  const Vector from_plane = mirror.point - w * p, reflected = square * e - two * cosine * n;
  const Polynomial path = dot(from_plane, e) * Polynomial(Rational(1L) / squared_length);
  return rational_sections(square * mirror.point - path * reflected, w * reflected, w * square,
                           squared_length);
}

/// A polynomial that is known not to vanish on the unit square, or its negative: positive there.
Polynomial with_positive_values(const Polynomial& p) {
  return p(Rational(), Rational()).sign() < 0 ? -p : p;
}

[[noreturn]] void refuse_plane_mirror(const std::array<Rational, 3>& image) {
  char sentence[200];
  std::snprintf(sentence, sizeof sentence,
                "The mirror is a plane: the wavefronts are spheres around the image of the light "
                "source, (%.6g, %.6g, %.6g).",
                image[0].to_double(), image[1].to_double(), image[2].to_double());
  throw GeometryError(ErrorCode::kZeroLength, sentence);
}

bool is_plane(const Vector& normal) {
  return std::all_of(normal.begin(), normal.end(), [](const auto& p) { return p.is_constant(); });
}

/// The wavefronts of theorem 2.
RationalSections wavefronts(const RationalPatch& mirror, const PointLight& light) {
  const Polynomial &w = mirror.weight, two(2L);
  const Vector n = normal_field(mirror), s = exactly(light.position);
  const Vector from_source = mirror.point - w * s;
  const Polynomial squared_path = dot(from_source, from_source), level = dot(from_source, n),
                   square = dot(n, n);
  if (!is_positive_on_square(squared_path)) {
    throw GeometryError(ErrorCode::kLightOnMirror,
                        "The light source lies on the mirror, or too near to it to tell.");
  }
  if (level.is_zero()) refuse_grazing();
  const Vector to_image = two * level * n, reflected = square * from_source - to_image;
  const Vector point = w * square * s + to_image;
  const Polynomial weight = w * square;
  if (is_plane(n)) {
    const Rational half = Rational(1L) / Rational(2L), at = weight(half, half);
    refuse_plane_mirror(
        {point[0](half, half) / at, point[1](half, half) / at, point[2](half, half) / at});
  }
  const Rational number = leading_coefficient(squared_path);
  const auto root = square_root(squared_path * Polynomial(Rational(1L) / number));
  if (!root) return rational_sections(point, reflected, weight, std::nullopt);
  const Polynomial path = with_positive_values(*root);
  return rational_sections(path * point, w * reflected, path * weight, number);
}

double length(const Point& a) { return std::hypot(a[0], a[1], a[2]); }

/// The mirror lies in the convex hull of its poles.
double path_to(const Point& pole, const ParallelLight& light) {
  double product = 0;
  for (std::size_t c = 0; c < 3; ++c) product += (pole[c] - light.from[c]) * light.direction[c];
  return product / length(light.direction);
}

double path_to(const Point& pole, const PointLight& light) {
  const Point& s = light.position;
  return length({pole[0] - s[0], pole[1] - s[1], pole[2] - s[2]});
}

void require_valid(const ParallelLight& light) {
  require_input_numbers(light.direction, "A coordinate of the direction of the light");
  require_input_numbers(light.from, "A coordinate of the point where the light starts");
  if (light.direction == Point{0, 0, 0}) {
    throw GeometryError(ErrorCode::kZeroLength, "The light has no direction.");
  }
}

void require_valid(const PointLight& light) {
  require_input_numbers(light.position, "A coordinate of the light source");
}

}  // namespace

Wavefronts mirror_wavefronts(const SplineSurfaceData& mirror, const Light& light) {
  std::visit([](const auto& some) { require_valid(some); }, light);
  const std::vector<RationalPatch> patches = rational_patches(mirror);
  Wavefronts result;
  result.patches.resize(patches.size());
  for_each_index(patches.size(), [&](std::size_t i) {
    result.patches[i] =
        std::visit([&](const auto& some) { return wavefronts(patches[i], some); }, light);
  });
  result.leaving = -std::numeric_limits<double>::infinity();
  for (const Point& pole : mirror.poles) {
    result.leaving = std::max(
        result.leaving, std::visit([&](const auto& some) { return path_to(pole, some); }, light));
  }
  const bool all_rational =
      std::all_of(result.patches.begin(), result.patches.end(),
                  [](const RationalSections& x) { return x.squared_length.has_value(); });
  if (!all_rational) {
    for (RationalSections& x : result.patches) x.squared_length.reset();
    result.notes.emplace_back(
        "The distance of the mirror from the light source is not rational, so only the wavefront "
        "at path length zero is, and its offsets are not.");
  }
  return result;
}

}  // namespace pn
