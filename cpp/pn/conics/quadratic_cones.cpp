// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/conics/quadratic_cones.hpp"

#include <algorithm>

#include "pn/conics/stereographic_projection.hpp"

namespace pn {
namespace {

using Polynomial = RationalPolynomial;
using Point = Vector4OfPolynomials;
using Matrix4 = Matrix4OfPolynomials;

int degree_of(const Point& p) {
  int degree = -1;
  for (const Polynomial& x : p) degree = std::max(degree, x.degree());
  return degree;
}

/// v.c = 1 for a v without common zeros.
Point bezout_point(const Point& v) {
  Point c;
  Polynomial sum;
  for (std::size_t i = 0; i < 4; ++i) {
    if (v[i].is_zero()) continue;
    const BezoutIdentity identity = extended_gcd(sum, v[i]);
    for (Polynomial& x : c) x *= identity.x;
    c[i] = identity.y;
    sum = identity.gcd;
  }
  return c;
}

/// p plus a multiple of v, of least degree: where v has its degree h, that of p is below h.
Point reduced(Point p, const Point& v) {
  const auto high = static_cast<std::size_t>(
      std::find_if(v.begin(), v.end(),
                   [&](const Polynomial& x) { return x.degree() == degree_of(v); }) -
      v.begin());
  const Polynomial factor = exact_quotient(p[high] - remainder(p[high], v[high]), v[high]);
  for (std::size_t i = 0; i < 4; ++i) p[i] -= factor * v[i];
  return p;
}

Point column(const std::array<Vector3<Polynomial>, 4>& m, std::size_t j) {
  return {m[0][j], m[1][j], m[2][j], m[3][j]};
}

/// r with a^T r = 1.
std::array<Vector3<Polynomial>, 4> right_inverse(const std::array<Vector3<Polynomial>, 4>& a,
                                                 const Point& v) {
  const Point c = bezout_point(v);
  std::array<Vector3<Polynomial>, 4> r;
  for (std::size_t j = 0; j < 3; ++j) {
    // Dual to the columns j + 1, j + 2 and c; its incidence with column j is a constant.
    const Point dual = join(column(a, (j + 1) % 3), column(a, (j + 2) % 3), c);
    const Rational det = contraction(column(a, j), dual).coefficient(0);
    const Point inverse = reduced(dual, v);
    for (std::size_t i = 0; i < 4; ++i) r[i][j] = inverse[i] * Polynomial(Rational(1L) / det);
  }
  return r;
}

Matrix4 without_common_factor(Matrix4 c) {
  Polynomial common;
  for (const Point& row : c) {
    for (const Polynomial& x : row) common = gcd(common, x);
  }
  for (Point& row : c) {
    for (Polynomial& x : row) x = exact_quotient(x, common);
  }
  return c;
}

}  // namespace

int QuadraticCones::degree() const {
  int degree = 0;
  for (const Point& row : matrix) degree = std::max(degree, degree_of(row));
  return degree;
}

int QuadraticCones::vertex_degree() const { return degree_of(vertex); }

QuadraticCones quadratic_cones(const Matrix4& c) {
  QuadraticCones cones;
  cones.vertex = kernel_of(c, "The matrix of the cones");
  cones.matrix = without_common_factor(c);
  cones.planes = plane_basis(cones.vertex);
  cones.inverse = right_inverse(cones.planes, cones.vertex);
  cones.conic = congruent(cones.matrix, cones.inverse);
  return cones;
}

QuadraticCones quadratic_cones(const Point& vertex, const Matrix3<Polynomial>& directions) {
  // From v to (x, y, z, 1) the direction is v4 (x, y, z) - (v1, v2, v3).
  std::array<Point, 3> direction;
  for (std::size_t i = 0; i < 3; ++i) {
    direction[i][i] = vertex[3];
    direction[i][3] = -vertex[i];
  }
  return quadratic_cones(congruent(directions, direction));
}

QuadraticCones tangent_planes_of(const MovingConic& conic) {
  std::array<Point, 3> frame;
  for (std::size_t i = 0; i < 3; ++i) frame[i] = column(conic.frame, i);
  return quadratic_cones(congruent(adjugate(conic.conic), frame));
}

ConicFamily family_of(const QuadraticCones& cones) {
  Vector3<int> degree{};
  for (std::size_t j = 0; j < 3; ++j) degree[j] = -degree_of(column(cones.planes, j));
  return conic_family(cones.conic, degree);
}

Point derivative(const Point& vector) {
  return {vector[0].derivative(), vector[1].derivative(), vector[2].derivative(),
          vector[3].derivative()};
}

Matrix4 derivative(const Matrix4& matrix) {
  return {derivative(matrix[0]), derivative(matrix[1]), derivative(matrix[2]),
          derivative(matrix[3])};
}

}  // namespace pn
