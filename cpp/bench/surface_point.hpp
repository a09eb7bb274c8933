// SPDX-License-Identifier: LGPL-2.1-or-later
// Points of B-spline surfaces in long double, by de Boor's algorithm.
//
// Evaluation in doubles is off by some 1e-14 where degrees are high, more than the exact surfaces
// are themselves. What is measured is the surface of those poles, so its points need more digits.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "pn/bezier/bspline_surface.hpp"

namespace pn::bench {

using Point = Eigen::Matrix<long double, 3, 1>;

class SurfacePoints {
 public:
  explicit SurfacePoints(const BSplineSurface& surface);
  /// Parameters outside the knots continue the first or last span.
  Point at(long double u, long double v) const;

 private:
  using Homogeneous = Eigen::Matrix<long double, 4, 1>;

  struct Direction {
    std::size_t degree;
    std::vector<long double> knots;  ///< each as often as it counts

    /// The knot at which the span of t begins; the poles from `degree` before it on are active.
    std::size_t span(long double t) const;
    Homogeneous value(std::vector<Homogeneous> active, std::size_t span, long double t) const;
  };
  static Direction direction(int degree, const std::vector<double>& knots,
                             const std::vector<int>& multiplicities);

  Direction along_, around_;
  std::vector<Homogeneous> poles_;
  std::size_t columns_;
};

}  // namespace pn::bench
