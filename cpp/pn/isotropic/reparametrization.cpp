// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/isotropic/reparametrization.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include "pn/algebra/elimination.hpp"
#include "pn/geometry_error.hpp"

namespace pn {
namespace {

using Polynomial = MultivariatePolynomial<4>;  ///< in Q[u, v, s, t]
using Vector = MinkowskiVector<BivariatePolynomial>;

SphereSurface derivative(const SphereSurface& f, Variable variable) {
  return {f[0].derivative(variable), f[1].derivative(variable), f[2].derivative(variable),
          f[3].derivative(variable)};
}

/// The multiple without denominators and without common factors.
Vector primitive(const SphereSurface& x) {
  BivariatePolynomial multiple(1L), common;
  for (const BivariateFunction& c : x) {
    multiple *= *quotient(c.denominator(), gcd(multiple, c.denominator()));
  }
  Vector result;
  for (std::size_t c = 0; c < 4; ++c) {
    result[c] = x[c].numerator() * *quotient(multiple, x[c].denominator());
    common = gcd(common, result[c]);
  }
  for (BivariatePolynomial& c : result) c = *quotient(c, common);
  return result;
}

int degree(const Vector& x) {
  int result = 0;
  for (const BivariatePolynomial& c : x) {
    result = std::max(result, c.degree(Variable::kU) + c.degree(Variable::kV));
  }
  return result;
}

/// The multiple of x - (xj / yj) y, which has no column j.
Vector without_column(const SphereSurface& x, const SphereSurface& y, std::size_t j) {
  SphereSurface result;
  for (std::size_t c = 0; c < 4; ++c) result[c] = y[j] * x[c] - x[j] * y[c];
  return primitive(result);
}

/// <x(u, v), w(s, t)>
Polynomial minkowski_in_four_variables(const Vector& x, const Vector& w) {
  const Polynomial u(Variable::kU), v(Variable::kV), s(Variable::kS), t(Variable::kT);
  MinkowskiVector<Polynomial> left, right;
  for (std::size_t c = 0; c < 4; ++c) {
    left[c] = x[c].composed(u, v);
    right[c] = w[c].composed(s, t);
  }
  return minkowski(left, right);
}

/// p without u: of the variables s, t, which take the places of u, v.
BivariatePolynomial in_s_and_t(const Polynomial& p) {
  return p.composed(BivariatePolynomial(), BivariatePolynomial(), BivariatePolynomial(Variable::kU),
                    BivariatePolynomial(Variable::kV));
}

/// x(s, t) for all factors of p that are linear in x and have neither u nor v besides.
std::vector<BivariateFunction> rational_zeros(const Polynomial& p, Variable x) {
  const Variable other = x == Variable::kU ? Variable::kV : Variable::kU;
  std::vector<BivariateFunction> result;
  for (const Polynomial& factor : irreducible_factors(p)) {
    if (factor.degree(x) != 1 || factor.degree(other) > 0) continue;
    result.emplace_back(-in_s_and_t(factor), in_s_and_t(factor.derivative(x)));
  }
  return result;
}

/// A polynomial that vanishes where both do, without u; constant when there is no such place.
Polynomial without_u(const Polynomial& p, const Polynomial& q) {
  if (p.degree(Variable::kU) > 0 && q.degree(Variable::kU) > 0) {
    return resultant(p, q, Variable::kU);
  }
  if (p.degree(Variable::kU) > 0) return q;
  if (q.degree(Variable::kU) > 0) return p;
  return gcd(p, q);
}

/// The numerator of p with v = v(s, t).
Polynomial with_v(const Polynomial& p, const BivariateFunction& v) {
  using Quotient = RationalFunction<4>;
  const Polynomial s(Variable::kS), t(Variable::kT);
  const Quotient value(v.numerator().composed(s, t), v.denominator().composed(s, t));
  return Quotient(p)
      .composed<4>({Quotient(Polynomial(Variable::kU)), value, Quotient(s), Quotient(t)})
      .numerator();
}

bool vanishes(const Polynomial& p, const Reparametrization& at) {
  const BivariateFunction s{BivariatePolynomial(Variable::kU)},
      t{BivariatePolynomial(Variable::kV)};
  return RationalFunction<4>(p).composed<2>({at.u, at.v, s, t}).is_zero();
}

bool are_independent(const BivariateFunction& x, const BivariateFunction& y) {
  return x.derivative(Variable::kU) * y.derivative(Variable::kV) !=
         x.derivative(Variable::kV) * y.derivative(Variable::kU);
}

std::vector<Reparametrization> common_zeros(const Polynomial& p, const Polynomial& q) {
  std::vector<Reparametrization> result;
  for (const BivariateFunction& v : rational_zeros(without_u(p, q), Variable::kV)) {
    for (const BivariateFunction& u :
         rational_zeros(gcd(with_v(p, v), with_v(q, v)), Variable::kU)) {
      result.push_back({u, v});
    }
  }
  return result;
}

}  // namespace

SphereSurface Reparametrization::operator()(const SphereSurface& f) const {
  const auto composed = [&](const BivariateFunction& c) { return c.composed<2>({u, v}); };
  return {composed(f[0]), composed(f[1]), composed(f[2]), composed(f[3])};
}

IsotropicField stereographic_field() {
  const BivariateFunction s{BivariatePolynomial(Variable::kU)},
      t{BivariatePolynomial(Variable::kV)};
  const BivariateFunction square = s * s + t * t;
  return {BivariateFunction(2L) * s, BivariateFunction(2L) * t, BivariateFunction(1L) - square,
          BivariateFunction(1L) + square};
}

std::array<Vector, 2> tangent_plane(const SphereSurface& f) {
  const SphereSurface fu = derivative(f, Variable::kU), fv = derivative(f, Variable::kV);
  std::optional<std::array<Vector, 2>> best;
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = i + 1; j < 4; ++j) {
      if (fu[i] * fv[j] == fu[j] * fv[i]) continue;
      std::array<Vector, 2> basis = {without_column(fu, fv, j), without_column(fu, fv, i)};
      if (!best || degree(basis[0]) + degree(basis[1]) < degree((*best)[0]) + degree((*best)[1])) {
        best = std::move(basis);
      }
    }
  }
  if (best) return *best;
  throw GeometryError(ErrorCode::kZeroLength,
                      "The spheres depend on one parameter only, so they are no surface of "
                      "spheres.");
}

bool has_developable_sheets(const SphereSurface& f) {
  // The plane decides the ratios in both vectors, and they decide the plane.
  std::vector<BivariateFunction> ratios;
  for (const Vector& x : tangent_plane(f)) {
    const auto first = std::find_if(x.begin(), x.end(), [](const auto& c) { return !c.is_zero(); });
    for (const BivariatePolynomial& c : x) ratios.emplace_back(c, *first);
  }
  for (const BivariateFunction& x : ratios) {
    for (const BivariateFunction& y : ratios) {
      if (are_independent(x, y)) return false;
    }
  }
  return true;
}

std::vector<Reparametrization> reparametrizations(const SphereSurface& f, const IsotropicField& w) {
  const auto plane = tangent_plane(f);
  const Vector direction = primitive(w);
  const Polynomial p = minkowski_in_four_variables(plane[0], direction),
                   q = minkowski_in_four_variables(plane[1], direction);
  const auto q_factors = irreducible_factors(q);
  std::vector<Reparametrization> result;
  for (const Polynomial& p_factor : irreducible_factors(p)) {
    for (const Polynomial& q_factor : q_factors) {
      for (Reparametrization& zero : common_zeros(p_factor, q_factor)) {
        const bool is_solution =
            are_independent(zero.u, zero.v) && vanishes(p, zero) && vanishes(q, zero);
        if (is_solution && std::find(result.begin(), result.end(), zero) == result.end()) {
          result.push_back(std::move(zero));
        }
      }
    }
  }
  return result;
}

}  // namespace pn
