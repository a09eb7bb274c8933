// SPDX-License-Identifier: LGPL-2.1-or-later
// Evaluation of B-splines by their basis functions (L. Piegl, W. Tiller, The NURBS Book, 2nd ed.
// 1997, algorithms A2.1, A2.2 and A4.3), in doubles.
#pragma once

#include <Eigen/Dense>
#include <array>
#include <cstddef>
#include <vector>

#include "pn/bezier/bspline_surface.hpp"
#include "pn/isotropic/envelope.hpp"

namespace pn {

/// The basis functions that do not vanish at a parameter, their derivatives, and the index of the
/// first of them.
struct ActiveBasis {
  using Numbers = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, kLargestDegree + 1, 1>;
  std::size_t first;
  Numbers values, slopes;
};

/// The basis functions of a degree up to the largest one, over these knots.
class SplineBasis {
 public:
  SplineBasis(int degree, const std::vector<double>& knots, const std::vector<int>& multiplicities);

  /// Parameters outside the knots are taken at the nearest end.
  ActiveBasis at(double parameter) const;

 private:
  std::size_t degree_;
  std::vector<double> knots_;  ///< each as often as it counts
};

/// The points of a surface, which has to outlive this. Parameters outside the knots are taken at
/// the nearest end.
class SurfaceEvaluation {
 public:
  explicit SurfaceEvaluation(const BSplineSurface& surface);

  std::array<double, 3> operator()(double u, double v) const;
  /// S_u x S_v, not of unit length.
  std::array<double, 3> normal(double u, double v) const;

 private:
  using Numbers = ActiveBasis::Numbers;
  struct Place {
    ActiveBasis along, around;
  };
  Place place(double u, double v) const;
  /// The weighted sum of the active poles, and of their weights.
  Eigen::Vector4d combination(const Place& place, const Numbers& along,
                              const Numbers& around) const;

  const BSplineSurface& surface_;
  SplineBasis along_, around_;
};

/// A single point.
std::array<double, 3> evaluate(const BSplineSurface& surface, double u, double v);

}  // namespace pn
