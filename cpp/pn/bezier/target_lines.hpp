// SPDX-License-Identifier: LGPL-2.1-or-later
// Target lines: where the lines u = const of a chain of envelopes would best run.
//
// At every t of a link a real matrix F, such that the columns of A F are the spinors of the normals
// that the lines u = (1 : 0) and u = (0 : 1) should have. The polynomial F of line_factor.hpp only
// has to be near it. The sign of F is free at each t and chosen continuously along a link.
#pragma once

#include <Eigen/Dense>
#include <cstddef>
#include <vector>

namespace pn {

class TargetLines {
 public:
  virtual ~TargetLines() = default;

  /// The target on a link at t in [0, 1].
  Eigen::Matrix2d at(std::size_t link, double t) const;
  /// Its derivative by t, nearly.
  Eigen::Matrix2d derivative(std::size_t link, double t) const;

 protected:
  /// Steps of the grid on a link: fine enough that the target turns little from one to the next.
  static constexpr int kGrid = 32;
  static double grid_parameter(int g) { return static_cast<double>(g) / kGrid; }
  static std::size_t nearest(double t);

  /// The target up to its sign.
  virtual Eigen::Matrix2d factor(std::size_t link, double t) const = 0;
  /// To be called by the constructor of a derived class, once `factor` works: chooses the signs.
  void choose_signs(std::size_t link_count);

 private:
  std::vector<std::vector<Eigen::Matrix2d>> grid_;  ///< with continuous sign on each link
};

}  // namespace pn
