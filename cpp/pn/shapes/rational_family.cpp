// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/shapes/rational_family.hpp"

#include <cmath>

#include "pn/geometry_error.hpp"
#include "pn/isotropic/supported_fibration.hpp"

namespace pn {
namespace {

Rational finite(double x) {
  if (!std::isfinite(x)) {
    throw GeometryError(ErrorCode::kNotFinite, "A coefficient or a bound is not a finite number.");
  }
  return Rational::exactly(x);
}

BivariatePolynomial polynomial(const Coefficients& rows) {
  std::vector<std::vector<Rational>> exact(rows.size());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    for (const double x : rows[i]) exact[i].push_back(finite(x));
  }
  return BivariatePolynomial(exact);
}

MinkowskiVector<BivariateFunction> vector_of(const std::array<Coefficients, 4>& x) {
  return {polynomial(x[0]), polynomial(x[1]), polynomial(x[2]), polynomial(x[3])};
}

RationalFamily family_of(const SphereSurface& spheres) {
  return {spheres, rational_envelope(spheres)};
}

}  // namespace

RationalFamily family_from_surface(const std::array<Coefficients, 4>& spheres,
                                   const Coefficients& weight) {
  const BivariatePolynomial w = polynomial(weight);
  if (w.is_zero()) throw GeometryError(ErrorCode::kNonPositiveWeight, "The weight is zero.");
  SphereSurface f = vector_of(spheres);
  f[3] = -f[3];
  for (BivariateFunction& x : f) x /= w;
  return family_of(f);
}

RationalFamily family_from_net(const std::array<Coefficients, 4>& c,
                               const std::array<Coefficients, 4>& d, const Coefficients& a,
                               const Coefficients& b) {
  return family_of(supported_surface({vector_of(c), vector_of(d), polynomial(a), polynomial(b)}));
}

RationalSections part_of(const OrientedSurface& sheet, const ParameterBounds& bounds) {
  std::array<Rational, 2> low, high;
  for (std::size_t i = 0; i < 2; ++i) {
    low[i] = finite(bounds.low[i]);
    high[i] = finite(bounds.high[i]);
    if ((high[i] - low[i]).sign() <= 0) {
      throw GeometryError(ErrorCode::kBadBounds, "The bounds of the parameters are empty.");
    }
  }
  return part_of(rational_sections(sheet), low, high);
}

}  // namespace pn
