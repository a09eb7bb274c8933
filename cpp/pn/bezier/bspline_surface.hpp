// SPDX-License-Identifier: LGPL-2.1-or-later
// B-spline surface: plain data, as OpenCASCADE, STEP and NumPy want it.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

namespace pn {

/// A clamped B-spline curve in the parameter plane of a surface, not rational.
struct ParameterCurve {
  int degree = 0;
  std::vector<double> knots;
  std::vector<int> multiplicities;
  std::vector<std::array<double, 2>> poles;  ///< (u, v)
};

/// A closed loop: every curve ends where the next one begins, bit for bit.
using TrimLoop = std::vector<ParameterCurve>;

/// A clamped rational tensor-product B-spline surface of IEEE doubles.
///
/// The first parameter runs along the spine (or directrix), the second around it (or across).
/// Knots are strictly increasing, each with its multiplicity; the first and last have multiplicity
/// degree + 1. Pole (i, j) is poles[i * v_count() + j], in millimetres; its weight, positive, has
/// the same index.
///
/// `trims` bounds the face: the region lies to the left of every loop, so that outer loops run
/// counterclockwise. A curve of degree 1 with two poles along a side of the parameter rectangle is
/// a piece of that side. Without loops the face is the whole surface.
struct BSplineSurface {
  int u_degree = 0;
  int v_degree = 0;
  std::vector<double> u_knots;
  std::vector<double> v_knots;
  std::vector<int> u_multiplicities;
  std::vector<int> v_multiplicities;
  std::vector<std::array<double, 3>> poles;
  std::vector<double> weights;
  std::vector<TrimLoop> trims;

  std::size_t u_count() const;
  std::size_t v_count() const;
};

/// Number of poles that a clamped spline of this degree has over knots of these multiplicities.
std::size_t pole_count(int degree, const std::vector<int>& multiplicities);

}  // namespace pn
