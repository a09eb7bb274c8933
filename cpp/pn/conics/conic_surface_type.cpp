// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/conics/conic_surface_type.hpp"

#include <algorithm>
#include <bitset>

#include "pn/conics/stereographic_projection.hpp"

namespace pn {
namespace {

using Polynomial = RationalPolynomial;
using Point = Vector4OfPolynomials;
using Matrix4 = Matrix4OfPolynomials;

/// The coefficient of lambda^(4 - k) mu^k in det(lambda C + mu D): rows of C, k of them replaced.
Polynomial pencil_coefficient(const Matrix4& c, const Matrix4& d, std::size_t k) {
  Polynomial sum;
  for (unsigned long mask = 0; mask < 16; ++mask) {
    const std::bitset<4> replaced(mask);
    if (replaced.count() != k) continue;
    const auto row = [&](std::size_t i) { return replaced[i] ? d[i] : c[i]; };
    sum += contraction(row(0), join(row(1), row(2), row(3)));
  }
  return sum;
}

Vector3<Polynomial> pencil(const Matrix4& c, const Matrix4& d) {
  return {pencil_coefficient(c, d, 2), pencil_coefficient(c, d, 3), pencil_coefficient(c, d, 4)};
}

bool vanishes(const Point& x) {
  return std::all_of(x.begin(), x.end(), [](const Polynomial& p) { return p.is_zero(); });
}

/// All 3x3 minors are zero.
bool has_rank_below_three(const Matrix4& m) {
  for (std::size_t k = 0; k < 4; ++k) {
    if (!vanishes(join(m[(k + 1) % 4], m[(k + 2) % 4], m[(k + 3) % 4]))) return false;
  }
  return true;
}

/// That of lambda : mu = -b : 2 a.
Matrix4 quadric_of_double_zero(const Matrix4& matrix, const Matrix4& derivative) {
  const auto [a, b, c] = pencil(matrix, derivative);
  Matrix4 quadric;
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = 0; j < 4; ++j) {
      quadric[i][j] = Polynomial(2L) * a * derivative[i][j] - b * matrix[i][j];
    }
  }
  return quadric;
}

/// Of a tangent C, C' of the variety of singular quadrics.
ThomsenClass class_of(const Matrix4& matrix, const Matrix4& derivative) {
  const auto [a, b, c] = pencil(matrix, derivative);
  if (a.is_zero()) {
    return !b.is_zero() ? ThomsenClass::kD : !c.is_zero() ? ThomsenClass::kE : ThomsenClass::kF;
  }
  if (!(b * b - Polynomial(4L) * a * c).is_zero()) return ThomsenClass::kA;
  return has_rank_below_three(quadric_of_double_zero(matrix, derivative)) ? ThomsenClass::kC
                                                                          : ThomsenClass::kB;
}

Matrix4 at(const Matrix4& matrix, const Rational& t) {
  Matrix4 result;
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = 0; j < 4; ++j) result[i][j] = Polynomial(matrix[i][j](t));
  }
  return result;
}

bool moves_at(const Point& v, const Rational& t) {
  const Point slope = derivative(v);
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (!(v[i](t) * slope[j](t) - v[j](t) * slope[i](t)).is_zero()) return true;
    }
  }
  return false;
}

bool is_regular_at(const QuadraticCones& cones, const Rational& t) {
  return !determinant(cones.conic)(t).is_zero() && moves_at(cones.vertex, t);
}

}  // namespace

Polynomial type_discriminant(const QuadraticCones& cones) {
  const Point slope = derivative(cones.vertex);
  return determinant(cones.conic) * polar_form(cones.matrix, slope, slope);
}

std::optional<ConicType> conic_type(const QuadraticCones& cones, const Rational& t) {
  if (!is_regular_at(cones, t)) return std::nullopt;
  const int sign = type_discriminant(cones)(t).sign();
  return sign > 0   ? ConicType::kElliptic
         : sign < 0 ? ConicType::kHyperbolic
                    : ConicType::kParabolic;
}

Vector3<Polynomial> tangent_pencil(const QuadraticCones& cones) {
  return pencil(cones.matrix, derivative(cones.matrix));
}

std::optional<ThomsenClass> thomsen_class(const QuadraticCones& cones) {
  if (cones.vertex_degree() == 0) return std::nullopt;
  return class_of(cones.matrix, derivative(cones.matrix));
}

std::optional<Point> contact_plane(const QuadraticCones& cones) {
  if (thomsen_class(cones) != ThomsenClass::kC) return std::nullopt;
  const Matrix4 slope = derivative(cones.matrix);
  const Point first = polar_of(slope, cones.vertex);
  const Matrix4 pair = quadric_of_double_zero(cones.matrix, slope);
  std::size_t i = 0;
  while (first[i].is_zero()) ++i;
  // From 2 Q = p q^T + q p^T.
  Point second;
  Polynomial common;
  for (std::size_t j = 0; j < 4; ++j) {
    second[j] = Polynomial(2L) * first[i] * pair[i][j] - pair[i][i] * first[j];
    common = gcd(common, second[j]);
  }
  for (Polynomial& x : second) x = exact_quotient(x, common);
  return second;
}

std::optional<ThomsenClass> thomsen_class(const QuadraticCones& cones, const Rational& t) {
  if (!is_regular_at(cones, t)) return std::nullopt;
  return class_of(at(cones.matrix, t), at(derivative(cones.matrix), t));
}

}  // namespace pn
