// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/conics/quadratic_cone_envelope.hpp"

#include <algorithm>
#include <utility>

#include "pn/conics/conic_surface_type.hpp"
#include "pn/conics/stereographic_projection.hpp"
#include "pn/geometry_error.hpp"

namespace pn {
namespace {

template <class T>
T number(const Rational& x, long precision);
template <>
Rational number(const Rational& x, long) {
  return x;
}
template <>
RealBall number(const Rational& x, long precision) {
  return RealBall(x, precision);
}

/// p(t), constant in u.
template <class T>
TensorPolynomial<T> along_t(const RationalPolynomial& p, long precision) {
  TensorPolynomial<T> result(std::max(p.degree(), 0), 0);
  for (int i = 0; i <= p.degree(); ++i) result(i, 0) = number<T>(p.coefficient(i), precision);
  return result;
}

template <class T>
HomogeneousCoordinates<T> along_t(const Vector4OfPolynomials& x, long precision) {
  return {along_t<T>(x[0], precision), along_t<T>(x[1], precision), along_t<T>(x[2], precision),
          along_t<T>(x[3], precision)};
}

template <class T>
std::array<HomogeneousCoordinates<T>, 4> along_t(const Matrix4OfPolynomials& m, long precision) {
  return {along_t<T>(m[0], precision), along_t<T>(m[1], precision), along_t<T>(m[2], precision),
          along_t<T>(m[3], precision)};
}

/// The terms up to this degree in t, of a polynomial whose others vanish.
template <class T>
TensorPolynomial<T> of_degree(const TensorPolynomial<T>& p, int degree) {
  TensorPolynomial<T> result(degree, p.degree(Variable::kV));
  for (int i = 0; i <= std::min(degree, p.degree(Variable::kU)); ++i) {
    for (int j = 0; j <= p.degree(Variable::kV); ++j) result(i, j) = p(i, j);
  }
  return result;
}

template <class T>
HomogeneousCoordinates<T> of_degree(const HomogeneousCoordinates<T>& x, int degree) {
  return {of_degree(x[0], degree), of_degree(x[1], degree), of_degree(x[2], degree),
          of_degree(x[3], degree)};
}

/// Quadratic forms in u by their coefficients.
template <class T>
Vector3<TensorPolynomial<T>> in_t_and_u(const Matrix3<Form<T>>& columns) {
  Vector3<TensorPolynomial<T>> result;
  for (std::size_t i = 0; i < 3; ++i) {
    for (int k = 0; k < 3; ++k) {
      const Form<T>& form = columns[i][static_cast<std::size_t>(k)];
      TensorPolynomial<T> part(std::max(form.degree(), 0), 2);
      for (int d = 0; d <= form.degree(); ++d) part(d, k) = form[d];
      result[i] += part;
    }
  }
  return result;
}

/// z = r y less the multiple of v by which its degree falls below n + 1, for n >= h - 1: A. of the
/// component in which v has its degree h the remainder modulo v is enough.
template <class T>
HomogeneousCoordinates<T> lifted(const QuadraticCones& cones, const Vector3<TensorPolynomial<T>>& y,
                                 int n, long precision) {
  HomogeneousCoordinates<T> z;
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = 0; j < 3; ++j) z[i] += along_t<T>(cones.inverse[i][j], precision) * y[j];
  }
  const int h = cones.vertex_degree();
  std::size_t high = 0;
  while (cones.vertex[high].degree() < h) ++high;
  const T inverse = number<T>(Rational(1L) / cones.vertex[high].coefficient(h), precision);
  const HomogeneousCoordinates<T> v = along_t<T>(cones.vertex, precision);
  for (int i = z[high].degree(Variable::kU); i >= h; --i) {
    TensorPolynomial<T> multiple(i - h, 2);
    for (int k = 0; k <= 2; ++k) multiple(i - h, k) = z[high](i, k) * inverse;
    for (std::size_t c = 0; c < 4; ++c) z[c] -= multiple * v[c];
  }
  return of_degree(z, n);
}

/// Where the conic of contact is known, its points; the generators otherwise.
template <class T>
HomogeneousCoordinates<T> generators_of(const QuadraticCones& cones,
                                        const std::optional<MovingConic>& contact_conic,
                                        const Matrix3<Form<T>>& points, int n, long precision) {
  const Vector3<TensorPolynomial<T>> y = in_t_and_u(points);
  if (!contact_conic) {
    return lifted(cones, y, std::max(n, cones.vertex_degree() - 1), precision);
  }
  HomogeneousCoordinates<T> x;
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      x[i] += along_t<T>(contact_conic->frame[i][j], precision) * y[j];
    }
  }
  return x;
}

/// Of the points, in t and u.
std::array<int, 2> degree_of_points(const QuadraticCones& cones,
                                    const std::optional<MovingConic>& contact_conic, int n) {
  if (contact_conic) return {n, 2};
  return {2 * n + cones.vertex_degree() + cones.degree() - 2, 4};
}

template <class T>
ContactElements<T> elements_of(const QuadraticCones& cones,
                               const std::optional<MovingConic>& contact_conic,
                               const Matrix3<Form<T>>& points, int n, long precision) {
  const HomogeneousCoordinates<T> z = generators_of(cones, contact_conic, points, n, precision);
  const HomogeneousCoordinates<T> plane =
      of_degree(polar_of(along_t<T>(cones.matrix, precision), z), n + cones.degree());
  if (contact_conic) return {z, plane};
  const auto slope = along_t<T>(derivative(cones.matrix), precision);
  const auto v = along_t<T>(cones.vertex, precision);
  const int degree = degree_of_points(cones, contact_conic, n)[0];
  return {of_degree(stereographic_projection(slope, v, z), degree), plane};
}

/// In class C.
std::optional<MovingConic> contact_conic(const QuadraticCones& cones) {
  const auto plane = contact_plane(cones);
  if (!plane) return std::nullopt;
  MovingConic conic{plane_basis(*plane), {}};
  conic.conic = congruent(cones.matrix, conic.frame);
  return conic;
}

/// In the degrees that they have over Q.
HomogeneousCoordinates<Rational> without_common_factor(const HomogeneousCoordinates<Rational>& x) {
  std::array<BivariatePolynomial, 4> exact;
  BivariatePolynomial common;
  for (std::size_t i = 0; i < 4; ++i) {
    exact[i] = in_ring(x[i]);
    common = gcd(common, exact[i]);
  }
  HomogeneousCoordinates<Rational> result;
  for (std::size_t i = 0; i < 4; ++i) result[i] = dense(*quotient(exact[i], common));
  return result;
}

template <class T>
int degree_of(const HomogeneousCoordinates<T>& x, Variable variable) {
  int degree = 0;
  for (const auto& p : x) degree = std::max(degree, p.degree(variable));
  return degree;
}

HomogeneousCoordinates<RealBall> in_balls(const HomogeneousCoordinates<Rational>& x,
                                          long precision) {
  const auto balls = [&](const TensorPolynomial<Rational>& p) {
    return p.mapped([&](const Rational& c) { return RealBall(c, precision); });
  };
  return {balls(x[0]), balls(x[1]), balls(x[2]), balls(x[3])};
}

/// In the coordinates y of a generator, which are u, v, s, and t.
using GeneratorPolynomial = MultivariatePolynomial<4>;

template <std::size_t Rows, std::size_t Columns>
std::array<std::array<GeneratorPolynomial, Columns>, Rows> in_generators(
    const std::array<std::array<RationalPolynomial, Columns>, Rows>& m) {
  std::array<std::array<GeneratorPolynomial, Columns>, Rows> result;
  for (std::size_t i = 0; i < Rows; ++i) {
    for (std::size_t j = 0; j < Columns; ++j) {
      result[i][j] = GeneratorPolynomial(m[i][j], Variable::kT);
    }
  }
  return result;
}

QuadraticCones with_moving_vertex(QuadraticCones cones) {
  if (cones.vertex_degree() == 0) {
    throw GeometryError(ErrorCode::kZeroLength,
                        "All cones have one vertex: they envelop no surface.");
  }
  return cones;
}

}  // namespace

bool envelops_curve(const QuadraticCones& cones) {
  using P = GeneratorPolynomial;
  const std::array<P, 3> y = {P(Variable::kU), P(Variable::kV), P(Variable::kS)};
  const auto r = in_generators(cones.inverse);
  const Matrix4OfPolynomials slope = derivative(cones.matrix);
  std::array<P, 4> z, v;
  for (std::size_t i = 0; i < 4; ++i) {
    z[i] = contraction(r[i], y);
    v[i] = P(cones.vertex[i], Variable::kT);
  }
  const std::array<P, 4> point = stereographic_projection(in_generators(slope), v, z);
  const P second = polar_form(in_generators(derivative(slope)), point, point);
  return quotient(second, polar_form(in_generators(family_of(cones).matrix), y, y)).has_value();
}

QuadraticConeEnvelope::QuadraticConeEnvelope(QuadraticCones cones)
    : cones_(with_moving_vertex(std::move(cones))),
      contact_conic_(contact_conic(cones_)),
      conics_(contact_conic_ ? family_of(*contact_conic_) : family_of(cones_)),
      degree_(degree_of_points(cones_, contact_conic_, conics_.degree())) {
  if (const auto& points = conics_.rational_points()) {
    const ContactElements<Rational> elements =
        elements_of(cones_, contact_conic_, *points, conics_.degree(), 0);
    rational_ = {without_common_factor(elements.point), without_common_factor(elements.plane)};
    degree_ = {degree_of(rational_->point, Variable::kU),
               degree_of(rational_->point, Variable::kV)};
  }
}

HomogeneousCoordinates<RealBall> QuadraticConeEnvelope::generators(long precision) const {
  return generators_of(cones_, contact_conic_, conics_.points(precision).coordinate,
                       conics_.degree(), precision);
}

ContactElements<RealBall> QuadraticConeEnvelope::contact_elements(long precision) const {
  if (rational_) {
    return {in_balls(rational_->point, precision), in_balls(rational_->plane, precision)};
  }
  return elements_of(cones_, contact_conic_, conics_.points(precision).coordinate, conics_.degree(),
                     precision);
}

}  // namespace pn
