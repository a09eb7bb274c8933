// SPDX-License-Identifier: LGPL-2.1-or-later
// Random quadrics and regions of them, biased to the degeneracies of both.
//
// Every input is a function of its seed. Half-axes are equal, nearly equal, far apart or in
// proportion; bounds run through vertices, umbilics and planes of symmetry, touch the surface or
// nearly do.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <ostream>
#include <random>
#include <string>
#include <vector>

#include "pn/shapes/quadric.hpp"

namespace pn::test {

inline const char* name_of(QuadricKind kind) {
  switch (kind) {
    case QuadricKind::kEllipsoid:
      return "ellipsoid";
    case QuadricKind::kOneSheetHyperboloid:
      return "one-sheet hyperboloid";
    case QuadricKind::kTwoSheetHyperboloid:
      return "two-sheet hyperboloid";
    case QuadricKind::kEllipticParaboloid:
      return "elliptic paraboloid";
    case QuadricKind::kHyperbolicParaboloid:
      return "hyperbolic paraboloid";
    case QuadricKind::kEllipticCylinder:
      return "elliptic cylinder";
    case QuadricKind::kEllipticCone:
      return "elliptic cone";
    case QuadricKind::kParabolicCylinder:
      return "parabolic cylinder";
  }
  return "";
}

struct QuadricInput {
  QuadricKind kind;
  std::array<double, 3> half;
  QuadricBounds bounds;
  double distance;  ///< of an offset
  Box extent;       ///< from which the bounds are taken
};

inline std::ostream& operator<<(std::ostream& out, const QuadricInput& input) {
  const std::streamsize digits = out.precision(17);
  out << name_of(input.kind) << " " << input.half[0] << " " << input.half[1] << " "
      << input.half[2];
  for (std::size_t i = 0; i < 3; ++i) {
    const Interval& interval = input.bounds.box[i];
    out << ", "
        << "xyz"[i] << " " << interval.low << " " << interval.high;
  }
  if (input.bounds.angle) {
    out << ", angle " << input.bounds.angle->low << " " << input.bounds.angle->high;
  }
  out << ", distance " << input.distance;
  out.precision(digits);
  return out;
}

class RandomQuadric {
 public:
  explicit RandomQuadric(std::uint64_t seed) : generator_(seed) {}

  QuadricInput input() {
    QuadricInput input{kind(), {}, {}, 0, {}};
    input.half = half_axes(input.kind);
    choose_extent(input);
    choose_bounds(input);
    const double size = *std::min_element(input.half.begin(), input.half.end());
    input.distance = one_in(3) ? noise(2) * size : noise(0.25) * size;
    for (std::size_t i = 0; i < 3; ++i) input.extent[i] = {low_[i], high_[i]};
    return rescaled(input);
  }

 private:
  int below(int count) { return static_cast<int>(generator_() % static_cast<unsigned>(count)); }
  int between(int low, int high) { return low + below(high - low + 1); }
  bool one_in(int count) { return below(count) == 0; }
  /// A multiple of amplitude / 1024.
  double noise(double amplitude) { return amplitude * between(-1024, 1024) / 1024; }

  QuadricKind kind() {
    static const std::array<QuadricKind, 13> kinds = {
        QuadricKind::kEllipsoid,           QuadricKind::kEllipsoid,
        QuadricKind::kEllipsoid,           QuadricKind::kTwoSheetHyperboloid,
        QuadricKind::kTwoSheetHyperboloid, QuadricKind::kEllipticParaboloid,
        QuadricKind::kEllipticParaboloid,  QuadricKind::kOneSheetHyperboloid,
        QuadricKind::kOneSheetHyperboloid, QuadricKind::kHyperbolicParaboloid,
        QuadricKind::kParabolicCylinder,   QuadricKind::kEllipticCylinder,
        QuadricKind::kEllipticCone};
    return kinds[static_cast<std::size_t>(below(13))];
  }

  std::array<double, 3> half_axes(QuadricKind kind) {
    const auto any = [&] { return between(8, 64) / 16.0; };
    std::array<double, 3> half = {any(), any(), any()};
    switch (below(8)) {
      case 0:  // of revolution, about one axis or another
        half[static_cast<std::size_t>(below(3))] = half[static_cast<std::size_t>(below(3))];
        break;
      case 1:
        half[1] = half[0];
        break;
      case 2:
        half[1] = half[2] = half[0];
        break;
      case 3: {  // nearly equal
        static const std::array<double, 3> kDifferences = {2.3e-16, 1e-12, 1e-6};
        const double factor = 1 + kDifferences[static_cast<std::size_t>(below(3))];
        half[static_cast<std::size_t>(between(1, 2))] = half[0] * factor;
        break;
      }
      case 4: {  // in proportion
        const double ratio = between(5, 16) / 4.0;
        half = {half[0], half[0] / ratio, half[0] / (ratio * ratio)};
        std::shuffle(half.begin(), half.end(), generator_);
        break;
      }
      case 5:  // slender or flat
        half[static_cast<std::size_t>(below(3))] *= one_in(2) ? 10 : 0.1;
        break;
      default:
        break;
    }
    const bool is_round =
        kind == QuadricKind::kEllipticCylinder || kind == QuadricKind::kEllipticCone;
    if (is_round && !one_in(10)) half[1] = half[0];
    return half;
  }

  /// Half the extent in x, y and z from which bounds are taken, and where poles and vertices are.
  void choose_extent(const QuadricInput& input) {
    const auto [a, b, c] = input.half;
    low_ = {-a, -b, -c};
    high_ = {a, b, c};
    switch (input.kind) {
      case QuadricKind::kEllipsoid:
        special_ = umbilics({a * a, b * b, c * c});
        break;
      case QuadricKind::kOneSheetHyperboloid: {
        const double height = c * between(1, 8) / 4, scale = std::hypot(1, height / c);
        low_ = {-scale * a, -scale * b, -height};
        break;
      }
      case QuadricKind::kTwoSheetHyperboloid: {
        const double height = c * between(5, 16) / 4;
        const double scale = std::sqrt(height * height / (c * c) - 1);
        low_ = {-scale * a, -scale * b, 0.75 * c};
        high_[2] = height;
        special_ = umbilics({-a * a, -b * b, c * c});
        break;
      }
      case QuadricKind::kEllipticParaboloid: {
        const double height = c * between(1, 16) / 4, scale = std::sqrt(height / c);
        low_ = {-scale * a, -scale * b, -0.25 * height};
        high_[2] = height;
        const double p = a * a / (2 * c), q = b * b / (2 * c);
        special_ = {p > q ? std::array<double, 3>{0, std::sqrt(q * (p - q)), (p - q) / 2}
                          : std::array<double, 3>{std::sqrt(p * (q - p)), 0, (q - p) / 2}};
        break;
      }
      case QuadricKind::kEllipticCone:
        low_[2] = c / 4;
        high_[2] = c * between(2, 8);
        break;
      default:
        break;
    }
    for (std::size_t i = 0; i < 2; ++i) high_[i] = -low_[i];
    if (input.kind == QuadricKind::kOneSheetHyperboloid) high_[2] = -low_[2];
  }

  /// Those with real coordinates, for x^2 / s[0] + y^2 / s[1] + z^2 / s[2] = 1: one plane of
  /// symmetry holds them.
  static std::vector<std::array<double, 3>> umbilics(const std::array<double, 3>& s) {
    std::vector<std::array<double, 3>> result;
    for (std::size_t m = 0; m < 3; ++m) {
      const std::size_t i = (m + 1) % 3, j = (m + 2) % 3;
      const double first = s[i] * (s[i] - s[m]) / (s[i] - s[j]),
                   second = s[j] * (s[m] - s[j]) / (s[i] - s[j]);
      if (!(first >= 0 && second >= 0)) continue;
      std::array<double, 3> umbilic = {0, 0, 0};
      umbilic[i] = std::sqrt(first);
      umbilic[j] = std::sqrt(second);
      result.push_back(umbilic);
    }
    return result;
  }

  void choose_bounds(QuadricInput& input) {
    const bool has_height = input.kind == QuadricKind::kOneSheetHyperboloid ||
                            input.kind == QuadricKind::kEllipticCylinder ||
                            input.kind == QuadricKind::kEllipticCone;
    const bool has_width = input.kind == QuadricKind::kHyperbolicParaboloid ||
                           input.kind == QuadricKind::kParabolicCylinder;
    const bool is_bowl = input.kind == QuadricKind::kTwoSheetHyperboloid ||
                         input.kind == QuadricKind::kEllipticParaboloid;
    const bool is_box = is_bowl && one_in(2);
    for (std::size_t i = 0; i < 3; ++i) {
      const bool needed = i == 2 ? has_height || (is_bowl && !is_box) : has_width || is_box;
      if (needed || one_in(4)) input.bounds.box[i] = interval(i, needed);
    }
    // Parabolic cylinders have no sectors.
    const bool has_sector = input.kind != QuadricKind::kParabolicCylinder || one_in(4);
    if (has_sector && one_in(3)) input.bounds.angle = sector();
  }

  Interval interval(std::size_t axis, bool needs_both) {
    Interval result{place(axis), place(axis)};
    if (one_in(4)) result = {low_[axis], high_[axis]};
    if (one_in(6)) result.low = -(result.high = std::abs(result.high));
    if (result.high < result.low) std::swap(result.low, result.high);
    if (result.high == result.low) result = {low_[axis], high_[axis]};
    if (needs_both || !one_in(3)) return result;
    if (one_in(2)) {
      result.low = -HUGE_VAL;
    } else {
      result.high = HUGE_VAL;
    }
    return result;
  }

  /// A coordinate to cut at.
  double place(std::size_t axis) {
    const double low = low_[axis], high = high_[axis];
    switch (below(12)) {
      case 0:
        return std::max(low, std::min(high, 0.0));
      case 1: {
        if (special_.empty()) return high;
        const double at =
            special_[static_cast<std::size_t>(below(static_cast<int>(special_.size())))][axis];
        return one_in(2) ? at : -at;
      }
      case 2: {
        static const std::array<double, 4> kBeside = {0, 1e-15, 1e-9, 1e-6};
        const double beside = kBeside[static_cast<std::size_t>(below(4))];
        return (one_in(2) ? low : high) * (one_in(2) ? 1 - beside : 1 + beside);
      }
      default:
        return low + (high - low) * between(1, 255) / 256;
    }
  }

  Interval sector() {
    const double low = one_in(3) ? between(-4, 4) * M_PI / 4 : noise(M_PI);
    switch (below(6)) {
      case 0:
        return {low, low + between(1, 8) * M_PI / 4};
      case 1:
        return {low, low + 2 * M_PI * (one_in(2) ? 1 : 1 - 1e-9)};
      default:
        return {low, low + between(16, 390) / 64.0};
    }
  }

  QuadricInput rescaled(QuadricInput input) {
    const double size = std::ldexp(1, one_in(2) ? 0 : between(-10, 14));
    for (double& half : input.half) half *= size;
    for (Interval& interval : input.bounds.box) {
      interval.low *= size;
      interval.high *= size;
    }
    for (Interval& interval : input.extent) {
      interval.low *= size;
      interval.high *= size;
    }
    input.distance *= size;
    return input;
  }

  std::mt19937_64 generator_;
  std::array<double, 3> low_, high_;
  std::vector<std::array<double, 3>> special_;
};

}  // namespace pn::test
