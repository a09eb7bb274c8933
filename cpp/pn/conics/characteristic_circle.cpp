// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/conics/characteristic_circle.hpp"

#include <utility>

#include "pn/algebra/common_factor.hpp"

namespace pn {
namespace {

using Polynomial = RationalPolynomial;
using Equation = SphereEquation<Polynomial>;

/// The plane of the pencil: the combination of two equations without |y|^2.
Vector4OfPolynomials plane_in(const Equation& a, const Equation& b) {
  const Polynomial two(2L);
  Vector4OfPolynomials plane;
  for (std::size_t i = 0; i < 3; ++i) {
    plane[i] = two * (b.leading * a.linear[i] - a.leading * b.linear[i]);
  }
  plane[3] = a.leading * b.constant - b.leading * a.constant;
  return coprime(std::move(plane));
}

/// The value of the sphere's bilinear form at two points (y, y0).
Polynomial polar(const Equation& sphere, const Vector4OfPolynomials& x,
                 const Vector4OfPolynomials& y) {
  Polynomial value = sphere.constant * x[3] * y[3];
  for (std::size_t i = 0; i < 3; ++i) {
    value += sphere.leading * x[i] * y[i];
    value -= sphere.linear[i] * (x[i] * y[3] + x[3] * y[i]);
  }
  return value;
}

}  // namespace

MovingPencil tangent_pencil(const MoebiusPoint<Polynomial>& curve) {
  MovingPencil pencil{curve, {}};
  for (std::size_t i = 0; i < curve.size(); ++i) pencil.second[i] = curve[i].derivative();
  return pencil;
}

std::vector<Polynomial> line_coordinates(const MovingPencil& pencil) {
  const auto& [p, q] = pencil;
  std::vector<Polynomial> line;
  for (std::size_t i = 0; i < p.size(); ++i) {
    for (std::size_t j = i + 1; j < p.size(); ++j) line.push_back(p[i] * q[j] - p[j] * q[i]);
  }
  return coprime(std::move(line));
}

Polynomial circle_discriminant(const std::vector<Polynomial>& line) {
  // Lagrange's identity: the Gram determinant is the sum of squares, those with x0 negative; the
  // first four coordinates are those with x0.
  Polynomial sum;
  for (std::size_t k = 0; k < line.size(); ++k) {
    const Polynomial square = line[k] * line[k];
    sum += k < 4 ? -square : square;
  }
  return sum;
}

MovingConic shared_circle(const MovingPencil& pencil) {
  const Equation first = sphere_equation(pencil.first), second = sphere_equation(pencil.second);
  const Equation& sphere = first.leading.is_zero() ? second : first;
  MovingConic circle;
  circle.frame = plane_basis(plane_in(first, second));
  std::array<Vector4OfPolynomials, 3> points;
  for (std::size_t j = 0; j < 3; ++j) {
    for (std::size_t c = 0; c < 4; ++c) points[j][c] = circle.frame[c][j];
  }
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) circle.conic[i][j] = polar(sphere, points[i], points[j]);
  }
  return circle;
}

}  // namespace pn
