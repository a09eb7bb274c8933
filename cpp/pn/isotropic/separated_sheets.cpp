// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/isotropic/separated_sheets.hpp"

#include <algorithm>
#include <utility>

namespace pn {
namespace {

using Polynomial = BivariatePolynomial;
using Vector = std::array<Polynomial, 3>;

Polynomial dot(const Vector& x, const Vector& y) { return x[0] * y[0] + x[1] * y[1] + x[2] * y[2]; }

Vector cross(const Vector& x, const Vector& y) {
  return {x[1] * y[2] - x[2] * y[1], x[2] * y[0] - x[0] * y[2], x[0] * y[1] - x[1] * y[0]};
}

Vector sum(const Polynomial& a, const Vector& x, const Polynomial& b, const Vector& y) {
  return {a * x[0] + b * y[0], a * x[1] + b * y[1], a * x[2] + b * y[2]};
}

/// A coordinate of f in (u, v).
TensorPolynomial<Rational> coordinate(const PowerForm<Rational>& f, std::size_t i) {
  const Rational half = Rational(1L) / Rational(2L);
  TensorPolynomial<Rational> result(2, 2);
  result(2, 0) = half * f[0][i];
  result(1, 1) = f[1][i];
  result(0, 2) = half * f[2][i];
  result(1, 0) = f[3][i];
  result(0, 1) = f[4][i];
  result(0, 0) = f[5][i];
  return result;
}

/// T, N, |N|^2 and Delta of sheet.hpp.
struct NormalForm {
  Vector along, across;
  Polynomial square, delta;

  explicit NormalForm(const PowerForm<Rational>& f) {
    Vector mu, mv;
    for (std::size_t i = 0; i < 3; ++i) {
      const Polynomial m = in_ring(coordinate(f, i));
      mu[i] = m.derivative(Variable::kU);
      mv[i] = m.derivative(Variable::kV);
    }
    const Polynomial p = in_ring(coordinate(f, 3)), pu = p.derivative(Variable::kU),
                     pv = p.derivative(Variable::kV);
    const Polynomial uu = dot(mu, mu), uv = dot(mu, mv), vv = dot(mv, mv);
    along = sum(vv * pu - uv * pv, mu, uu * pv - uv * pu, mv);
    across = cross(mu, mv);
    square = dot(across, across);
    delta = square - (vv * pu * pu - Polynomial(2L) * uv * pu * pv + uu * pv * pv);
  }
};

/// c D^2 with D > 0 at u = v = 0 and a c that is 1 or no square.
struct MultipleOfSquare {
  Rational factor;
  Polynomial root;
};

std::optional<MultipleOfSquare> as_multiple_of_square(const Polynomial& p) {
  Rational factor = leading_coefficient(p);
  std::optional<Polynomial> root = square_root(p * Polynomial(Rational(1L) / factor));
  if (!root) return std::nullopt;
  if (const auto rational = square_root(factor)) {
    *root *= Polynomial(*rational);
    factor = 1L;
  }
  if ((*root)(0L, 0L).sign() < 0) root = -*root;
  return MultipleOfSquare{std::move(factor), std::move(*root)};
}

RationalNormal without_common_factor(Vector rational, Vector irrational, Rational radicand,
                                     const Polynomial& weight) {
  Polynomial common = weight;
  for (const Polynomial& p : rational) common = gcd(common, p);
  for (const Polynomial& p : irrational) common = gcd(common, p);
  if ((weight(0L, 0L) / common(0L, 0L)).sign() < 0) common = -common;
  const auto divided = [&](const Polynomial& p) { return dense(*quotient(p, common)); };
  return {{divided(rational[0]), divided(rational[1]), divided(rational[2])},
          {divided(irrational[0]), divided(irrational[1]), divided(irrational[2])},
          std::move(radicand),
          divided(weight)};
}

}  // namespace

std::optional<RationalNormal> rational_normal(const QuadraticFamily& family, Sheet sheet) {
  const NormalForm form(family.power());
  const auto delta = as_multiple_of_square(form.delta);
  if (!delta) return std::nullopt;
  Vector across = form.across;
  for (Polynomial& p : across) p *= sheet == Sheet::kOuter ? delta->root : -delta->root;
  if (delta->factor == Rational(1L)) {
    return without_common_factor(sum(1L, form.along, 1L, across), {}, 1L, form.square);
  }
  return without_common_factor(form.along, across, delta->factor, form.square);
}

SurfaceSections<RealBall> sections(const QuadraticFamily& family, const RationalNormal& normal,
                                   long bits) {
  const auto in_balls = [bits](const TensorPolynomial<Rational>& p) {
    return p.mapped([bits](const Rational& c) { return RealBall(c, bits); });
  };
  const RealBall root = sqrt(RealBall(normal.radicand, bits));
  const PowerForm<Rational> f = family.power();
  SurfaceSections<RealBall> result;
  result.weight = in_balls(normal.weight);
  for (std::size_t i = 0; i < 3; ++i) {
    result.direction[i] = in_balls(normal.rational[i]) + in_balls(normal.irrational[i]) * root;
    result.point[i] = in_balls(coordinate(f, i) * normal.weight) -
                      in_balls(coordinate(f, 3)) * result.direction[i];
  }
  return result;
}

}  // namespace pn
