// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/shapes/quadric_patches.hpp"

#include <algorithm>
#include <cmath>

namespace pn {
namespace {

using Polynomial = BivariatePolynomial;

Polynomial constant(double x) { return Polynomial(Rational::exactly(x)); }

/// From -width to width over [0, 1] of a variable.
Polynomial symmetric(double width, Variable variable) {
  const Rational w = Rational::exactly(width);
  return Polynomial(RationalPolynomial({-w, w + w}), variable);
}

/// How far a stereographic parameter reaches beyond the region: never less than it.
constexpr double kOutward = 1 + 1e-9;

}  // namespace

RationalPatch bounded(RationalPatch patch, const QuadricBounds& bounds) {
  for (std::size_t i = 0; i < 3; ++i) {
    const Interval& interval = bounds.box[i];
    if (std::isfinite(interval.low)) {
      patch.region.push_back(patch.point[i] - constant(interval.low) * patch.weight);
    }
    if (std::isfinite(interval.high)) {
      patch.region.push_back(constant(interval.high) * patch.weight - patch.point[i]);
    }
  }
  if (!bounds.angle || bounds.angle->high - bounds.angle->low >= M_PI) return patch;
  const auto left_of = [&](double angle) {
    return patch.point[1] * constant(std::cos(angle)) - patch.point[0] * constant(std::sin(angle));
  };
  patch.region.push_back(left_of(bounds.angle->low));
  patch.region.push_back(-left_of(bounds.angle->high));
  return patch;
}

std::vector<RationalPatch> ellipsoid_patches(const HalfAxes& half, const QuadricBounds& bounds) {
  const Polynomial p = symmetric(1, Variable::kU), q = symmetric(1, Variable::kV);
  const Polynomial one(1L), two(2L), r = p * p + q * q;
  std::vector<RationalPatch> patches;
  for (const int side : {1, -1}) {
    const Rational c = side > 0 ? half[2] : -half[2];
    patches.push_back(bounded(
        {{two * Polynomial(half[0]) * p, two * Polynomial(half[1]) * q, Polynomial(c) * (one - r)},
         one + r,
         {one - r},
         side},
        bounds));
  }
  return patches;
}

std::vector<RationalPatch> two_sheet_hyperboloid_patches(const HalfAxes& half,
                                                         const QuadricBounds& bounds,
                                                         const std::array<double, 2>& widths) {
  // z / c = (1 + r) / (1 - r) at the corners of the rectangle, and below.
  const double high =
      std::hypot(1, std::hypot(widths[0] / half[0].to_double(), widths[1] / half[1].to_double()));
  const double largest = kOutward * (high - 1) / (high + 1);
  const Polynomial p = symmetric(std::sqrt(largest), Variable::kU),
                   q = symmetric(std::sqrt(largest), Variable::kV);
  const Polynomial one(1L), two(2L), r = p * p + q * q;
  return {bounded({{two * Polynomial(half[0]) * p, two * Polynomial(half[1]) * q,
                    Polynomial(half[2]) * (one + r)},
                   one - r,
                   {constant(largest) - r},
                   -1},
                  bounds)};
}

std::vector<RationalPatch> paraboloid_patches(const HalfAxes& half, int sign, int side,
                                              const QuadricBounds& bounds,
                                              const std::array<double, 2>& widths) {
  const Polynomial x = symmetric(widths[0], Variable::kU), y = symmetric(widths[1], Variable::kV);
  const Rational first = half[2] / (half[0] * half[0]), second = half[2] / (half[1] * half[1]);
  const Polynomial z = Polynomial(first) * x * x + Polynomial(Rational(sign) * second) * y * y;
  return {bounded({{x, y, z}, Polynomial(1L), {}, side}, bounds)};
}

std::vector<RationalPatch> cone_patches(const HalfAxes& half, const Interval& heights) {
  const Polynomial u(RationalPolynomial({Rational(0), Rational(1)}), Variable::kU);
  const Rational low = Rational::exactly(heights.low), high = Rational::exactly(heights.high);
  const Polynomial z(RationalPolynomial({low, high - low}), Variable::kV);
  const bool is_below = heights.high < 0;
  const Rational slope = (is_below ? -half[0] : half[0]) / half[2];
  const Polynomial one(1L), weight = one + u * u, radius = Polynomial(slope) * z;
  const Polynomial cosine = radius * (one - u * u), sine = radius * (u + u);
  // Quarter turns; along rising angle and rising z the cross product points outwards.
  const std::array<std::array<Polynomial, 2>, 4> quarters = {
      {{cosine, sine}, {-sine, cosine}, {-cosine, -sine}, {sine, -cosine}}};
  std::vector<RationalPatch> patches;
  for (const auto& [x, y] : quarters) patches.push_back({{x, y, z * weight}, weight, {}, 1});
  return patches;
}

RationalPatch ruled_patch(const SphereCurve& first, const SphereCurve& second) {
  const bool same = first.denominator == second.denominator;
  const RationalPolynomial one(1L);
  const RationalPolynomial& p = same ? one : first.denominator;
  const RationalPolynomial& q = same ? one : second.denominator;
  const Polynomial v(RationalPolynomial({Rational(0), Rational(1)}), Variable::kV);
  RationalPatch patch;
  for (std::size_t i = 0; i < 3; ++i) {
    const Polynomial low(first.centre[i] * q, Variable::kU),
        high(second.centre[i] * p, Variable::kU);
    patch.point[i] = low + v * (high - low);
  }
  patch.weight = Polynomial(first.denominator * q, Variable::kU);
  patch.side = 1;
  return patch;
}

}  // namespace pn
