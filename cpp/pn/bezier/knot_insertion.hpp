// SPDX-License-Identifier: LGPL-2.1-or-later
// Knot insertion: the control points of a spline over one more knot.
//
// A clamped spline of degree p over the knots t_i with control points c_i has over the knots with x
// inserted, t_k <= x < t_{k+1}, the control points
//
//     c_i for i <= k - p,    (1 - a_i) c_{i-1} + a_i c_i for k - p < i <= k,    c_{i-1} for i > k,
//
// a_i = (x - t_i) / (t_{i+p} - t_i). (W. Boehm, Inserting new knots into B-spline curves, CAD 12,
// 1980.) On a single Bezier piece all this is exact over Q.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "pn/algebra/rational.hpp"

namespace pn {

/// The values of a spline's control points, one for each component, and the full knots, each as
/// often as it counts.
template <class T>
struct SplineColumns {
  int degree;
  std::vector<Rational> knots;
  std::vector<std::vector<T>> points;
};

/// With the knot x inserted, which lies inside the domain. number_of turns a rational into a T.
template <class T, class NumberOf>
SplineColumns<T> with_knot(const SplineColumns<T>& spline, const Rational& x,
                           const NumberOf& number_of) {
  const auto p = static_cast<std::size_t>(spline.degree);
  const auto after = std::upper_bound(spline.knots.begin(), spline.knots.end(), x);
  const auto k = static_cast<std::size_t>(after - spline.knots.begin()) - 1;
  SplineColumns<T> result{spline.degree, spline.knots, {}};
  result.knots.insert(result.knots.begin() + static_cast<std::ptrdiff_t>(k) + 1, x);
  for (std::size_t i = 0; i <= spline.points.size(); ++i) {
    if (i + p <= k || i > k) {
      result.points.push_back(spline.points[i + p <= k ? i : i - 1]);
      continue;
    }
    const Rational a = (x - spline.knots[i]) / (spline.knots[i + p] - spline.knots[i]);
    const T right = number_of(a), left = number_of(Rational(1) - a);
    std::vector<T> mean = spline.points[i - 1];
    for (std::size_t c = 0; c < mean.size(); ++c) {
      mean[c] = mean[c] * left + spline.points[i][c] * right;
    }
    result.points.push_back(std::move(mean));
  }
  return result;
}

}  // namespace pn
