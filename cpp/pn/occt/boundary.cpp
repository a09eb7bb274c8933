// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/occt/boundary.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pn {
namespace {

// Relative difference of two equal ratios of rounded numbers: half an ulp from each of the four
// numbers and from each of the two products that are compared, rounded up.
constexpr double kRatioRounding = 4 * std::numeric_limits<double>::epsilon();

bool proportional(const std::vector<double>& a, const std::vector<double>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [&](double a_i, double b_i) {
    const double product = a_i * b.front();
    return std::abs(product - b_i * a.front()) <= kRatioRounding * product;
  });
}

double length(const std::vector<double>& knots) { return knots.back() - knots.front(); }

// Position of a knot in its interval, from 0 to 1, can be known only this well: knots far from zero
// have lost digits.
double position_rounding(const std::vector<double>& knots) {
  return kRatioRounding * std::max(std::abs(knots.front()), std::abs(knots.back())) / length(knots);
}

bool affinely_equal(const std::vector<double>& a, const std::vector<double>& b) {
  const double rounding = kRatioRounding + position_rounding(a) + position_rounding(b);
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [&](double a_i, double b_i) {
    return std::abs((a_i - a.front()) / length(a) - (b_i - b.front()) / length(b)) <= rounding;
  });
}

BoundaryCurve row(const BSplineSurface& s, std::size_t i) {
  BoundaryCurve curve{s.v_degree, s.v_knots, s.v_multiplicities, {}, {}};
  for (std::size_t j = 0; j < s.v_count(); ++j) {
    curve.poles.push_back(s.poles[i * s.v_count() + j]);
    curve.weights.push_back(s.weights[i * s.v_count() + j]);
  }
  return curve;
}

BoundaryCurve column(const BSplineSurface& s, std::size_t j) {
  BoundaryCurve curve{s.u_degree, s.u_knots, s.u_multiplicities, {}, {}};
  for (std::size_t i = 0; i < s.u_count(); ++i) {
    curve.poles.push_back(s.poles[i * s.v_count() + j]);
    curve.weights.push_back(s.weights[i * s.v_count() + j]);
  }
  return curve;
}

}  // namespace

BoundaryCurve reversed(BoundaryCurve curve) {
  const double sum = curve.knots.front() + curve.knots.back();
  for (double& knot : curve.knots) knot = sum - knot;
  std::reverse(curve.knots.begin(), curve.knots.end());
  std::reverse(curve.multiplicities.begin(), curve.multiplicities.end());
  std::reverse(curve.poles.begin(), curve.poles.end());
  std::reverse(curve.weights.begin(), curve.weights.end());
  return curve;
}

bool is_degenerate(const BoundaryCurve& curve) {
  return std::all_of(curve.poles.begin(), curve.poles.end(),
                     [&](const auto& pole) { return pole == curve.poles.front(); });
}

bool coincide(const BoundaryCurve& a, const BoundaryCurve& b) {
  return a.degree == b.degree && a.multiplicities == b.multiplicities && a.poles == b.poles &&
         proportional(a.weights, b.weights) && affinely_equal(a.knots, b.knots);
}

std::array<Boundary, 4> boundaries(const BSplineSurface& s) {
  const double u_first = s.u_knots.front();
  const double u_last = s.u_knots.back();
  const double v_first = s.v_knots.front();
  const double v_last = s.v_knots.back();
  return {Boundary{column(s, 0), {u_first, v_first}, {u_last, v_first}},
          Boundary{row(s, s.u_count() - 1), {u_last, v_first}, {u_last, v_last}},
          Boundary{column(s, s.v_count() - 1), {u_first, v_last}, {u_last, v_last}},
          Boundary{row(s, 0), {u_first, v_first}, {u_first, v_last}}};
}

}  // namespace pn
