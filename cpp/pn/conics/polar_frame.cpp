// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/conics/polar_frame.hpp"

#include <stdexcept>

#include "pn/algebra/common_factor.hpp"
#include "pn/conics/stereographic_projection.hpp"
#include "pn/geometry_error.hpp"

namespace pn {
namespace {

using Polynomial = RationalPolynomial;
using Vector = Vector3<Polynomial>;

Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

bool vanishes(const Vector& x) { return x[0].is_zero() && x[1].is_zero() && x[2].is_zero(); }

/// A line through p that does not touch the conic. At most two lines through p touch it, and a line
/// contains at most two of the points (1, s, s^2): one of six of them is joined with p by another.
Vector secant_through(const Vector& p, const Matrix3<Polynomial>& conic) {
  for (long s = 0; s < 6; ++s) {
    const Vector line = cross(p, {1L, s, s * s});
    if (!polar_form(conic, line, line).is_zero()) return coprime(line);
  }
  throw std::logic_error("more than two tangents through a point");
}

/// The second tangent through a point q of the tangent g.
Vector second_tangent(const Vector& q, const Vector& g, const Matrix3<Polynomial>& conic) {
  for (std::size_t i = 0; i < 3; ++i) {
    Vector corner;
    corner[i] = Polynomial(1L);
    const Vector line = cross(q, corner);
    // The line must not be g itself.
    if (!vanishes(cross(line, g))) {
      return coprime(stereographic_projection(conic, g, line));
    }
  }
  throw std::logic_error("a point with one line through it");
}

}  // namespace

PolarFrame polar_frame(const QuadraticCones& cones) {
  if (cones.vertex_degree() == 0) {
    throw GeometryError(ErrorCode::kZeroLength,
                        "All conics lie in one plane, or all cones have one vertex.");
  }
  const Matrix3<Polynomial>& conic = cones.conic;
  const Vector4OfPolynomials slope = derivative(cones.vertex);
  Vector g;
  for (std::size_t j = 0; j < 3; ++j) {
    for (std::size_t i = 0; i < 4; ++i) g[j] += cones.planes[i][j] * slope[i];
  }
  PolarFrame frame;
  frame.g = coprime(g);
  frame.p = coprime(polar_of(conic, frame.g));
  frame.eta = secant_through(frame.p, conic);
  frame.q = coprime(polar_of(conic, frame.eta));
  frame.is_parabolic = polar_form(conic, frame.g, frame.g).is_zero();
  frame.zeta = frame.is_parabolic ? second_tangent(frame.q, frame.g, conic)
                                  : coprime(cross(frame.p, frame.q));
  frame.r = coprime(frame.is_parabolic ? cross(frame.eta, frame.zeta) : cross(frame.g, frame.eta));
  const std::array<Vector, 3> rows = {frame.g, frame.eta, frame.zeta};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) frame.form[i][j] = polar_form(conic, rows[i], rows[j]);
  }
  return frame;
}

Vector4OfPolynomials in_space(const QuadraticCones& cones, const Vector& point) {
  Vector4OfPolynomials result;
  for (std::size_t i = 0; i < 4; ++i) result[i] = contraction(cones.planes[i], point);
  return result;
}

}  // namespace pn
