// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/isotropic/from_planes.hpp"

#include "pn/geometry_error.hpp"

namespace pn {
namespace {

template <class T>
using Vector = std::array<T, 3>;

template <class T>
Vector<T> cross(const Vector<T>& a, const Vector<T>& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

template <class T>
T dot(const Vector<T>& a, const Vector<T>& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

template <class T>
Vector<T> derivative(const Vector<T>& a, Variable variable) {
  return {a[0].derivative(variable), a[1].derivative(variable), a[2].derivative(variable)};
}

MinkowskiVector<BivariateFunction> derivative(const MinkowskiVector<BivariateFunction>& f,
                                              Variable variable) {
  return {f[0].derivative(variable), f[1].derivative(variable), f[2].derivative(variable),
          f[3].derivative(variable)};
}

Vector<BivariateFunction> spatial(const MinkowskiVector<BivariateFunction>& f) {
  return {f[0], f[1], f[2]};
}

/// A multiple of both polynomials.
BivariatePolynomial common_multiple(const BivariatePolynomial& a, const BivariatePolynomial& b) {
  return a * *quotient(b, gcd(a, b));
}

}  // namespace

MinkowskiVector<BivariatePolynomial> universal_isotropic_vector(
    const std::array<BivariatePolynomial, 4>& a) {
  const BivariatePolynomial two(2L), upper = a[0] * a[0] + a[1] * a[1],
                                     lower = a[2] * a[2] + a[3] * a[3];
  return {two * (a[0] * a[2] + a[1] * a[3]), two * (a[1] * a[2] - a[0] * a[3]), upper - lower,
          upper + lower};
}

OrientedSurface from_planes(const MinkowskiVector<BivariatePolynomial>& w,
                            const BivariateFunction& h) {
  const Vector<BivariatePolynomial> n = {w[0], w[1], w[2]}, nu = derivative(n, Variable::kU),
                                    nv = derivative(n, Variable::kV);
  const Vector<BivariatePolynomial> uv = cross(nu, nv), v = cross(nv, n), u = cross(n, nu);
  const BivariatePolynomial f = dot(n, uv);
  if (f.is_zero()) {
    throw GeometryError(ErrorCode::kDevelopable,
                        "The normals of the planes lie on a curve of the sphere: the planes touch "
                        "no surface, or a developable one.");
  }
  const BivariateFunction hu = h.derivative(Variable::kU), hv = h.derivative(Variable::kV);
  OrientedSurface result;
  for (std::size_t i = 0; i < 3; ++i) {
    result.point[i] = (h * uv[i] + hu * v[i] + hv * u[i]) / f;
    result.normal[i] = BivariateFunction(n[i], w[3]);
  }
  return result;
}

MinkowskiVector<BivariateFunction> spheres_along(const OrientedSurface& surface,
                                                 const BivariateFunction& r) {
  MinkowskiVector<BivariateFunction> f;
  for (std::size_t i = 0; i < 3; ++i) f[i] = surface.point[i] + r * surface.normal[i];
  f[3] = r;
  return f;
}

std::optional<BivariateFunction> mos_root(const MinkowskiVector<BivariateFunction>& f) {
  const auto fu = derivative(f, Variable::kU), fv = derivative(f, Variable::kV);
  const BivariateFunction mixed = minkowski(fu, fv);
  return square_root(minkowski(fu, fu) * minkowski(fv, fv) - mixed * mixed);
}

std::array<OrientedSurface, 2> envelope_sheets(const MinkowskiVector<BivariateFunction>& f) {
  const auto fu = derivative(f, Variable::kU), fv = derivative(f, Variable::kV);
  const Vector<BivariateFunction> mu = spatial(fu), mv = spatial(fv), n = cross(mu, mv);
  const BivariateFunction square = dot(n, n);
  if (square.is_zero()) {
    throw GeometryError(ErrorCode::kZeroLength,
                        "The centres of the spheres lie on a curve, so they are no surface.");
  }
  const std::optional<BivariateFunction> root = mos_root(f);
  if (!root) {
    throw GeometryError(ErrorCode::kNotRational,
                        "The family of spheres is no MOS surface: the discriminant of its tangent "
                        "planes is not the square of a rational function, so the envelope has no "
                        "rational normals.");
  }
  const Vector<BivariateFunction> by_u = cross(mv, n), by_v = cross(n, mu);
  std::array<OrientedSurface, 2> sheets;
  for (std::size_t i = 0; i < 3; ++i) {
    const BivariateFunction tangential = fu[3] * by_u[i] + fv[3] * by_v[i];
    sheets[0].normal[i] = (tangential + *root * n[i]) / square;
    sheets[1].normal[i] = (tangential - *root * n[i]) / square;
    for (OrientedSurface& sheet : sheets) sheet.point[i] = f[i] - f[3] * sheet.normal[i];
  }
  return sheets;
}

RationalSections rational_sections(const OrientedSurface& surface) {
  BivariatePolynomial weight(1L);
  for (const auto* vector : {&surface.point, &surface.normal}) {
    for (const BivariateFunction& x : *vector) weight = common_multiple(weight, x.denominator());
  }
  const auto numerators = [&](const std::array<BivariateFunction, 3>& x) {
    const auto numerator = [&](const BivariateFunction& f) {
      return f.numerator() * *quotient(weight, f.denominator());
    };
    return std::array{numerator(x[0]), numerator(x[1]), numerator(x[2])};
  };
  return rational_sections(numerators(surface.point), numerators(surface.normal), weight,
                           Rational(1L));
}

}  // namespace pn
