// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/isotropic/along_surface.hpp"

#include <algorithm>

namespace pn {
namespace {

bool is_constant(const BivariatePolynomial& p) {
  return p.degree(Variable::kU) <= 0 && p.degree(Variable::kV) <= 0;
}

TensorPolynomial<Rational> divided(const TensorPolynomial<Rational>& p,
                                   const BivariatePolynomial& factor) {
  return dense(*quotient(in_ring(p), factor));
}

}  // namespace

IntegerPowerForm integer_power_form(const QuadraticFamily& family) {
  IntegerPowerForm result{family.power(), Rational(1L)};
  for (const auto& x : result.form) {
    for (const Rational& c : x) result.factor = common_denominator(Rational(1L) / result.factor, c);
  }
  result.factor *= Rational(2L);
  for (auto& x : result.form) {
    for (Rational& c : x) c *= result.factor;
  }
  return result;
}

SurfaceSections<Rational> scaled_sections(const IntegerPowerForm& f,
                                          const IsotropicPolynomials<Rational>& w,
                                          const Contact<Rational>& contact) {
  SurfaceSections<Rational> result = sections(f.form, w, contact);
  for (auto& p : result.direction) p *= f.factor;
  result.weight *= f.factor;
  return result;
}

SurfaceSections<Rational> without_common_factor(SurfaceSections<Rational> sections,
                                                const TensorPolynomial<Rational>& e) {
  // All directions and the weight have the factor e^2 and no other one in common.
  const BivariatePolynomial single = in_ring(e);
  BivariatePolynomial common = single;
  for (const auto& p : sections.point) {
    if (is_constant(common)) return sections;
    common = gcd(common, in_ring(p));
  }
  if (is_constant(common)) return sections;
  common = single * single;
  for (const auto& p : sections.point) common = gcd(common, in_ring(p));
  const Rational middle = Rational(1L) / Rational(2L);
  if (common(middle, middle).sign() < 0) common = -common;
  for (std::size_t i = 0; i < 3; ++i) {
    sections.point[i] = divided(sections.point[i], common);
    sections.direction[i] = divided(sections.direction[i], common);
  }
  sections.weight = divided(sections.weight, common);
  return sections;
}

SurfaceSections<RealBall> in_balls(const SurfaceSections<Rational>& exact, long bits) {
  const auto converted = [bits](const TensorPolynomial<Rational>& p) {
    return p.mapped([bits](const Rational& c) { return RealBall(c, bits); });
  };
  return {
      {converted(exact.point[0]), converted(exact.point[1]), converted(exact.point[2])},
      {converted(exact.direction[0]), converted(exact.direction[1]), converted(exact.direction[2])},
      converted(exact.weight)};
}

}  // namespace pn
