// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/isotropic/rational_sections.hpp"

#include <stdexcept>
#include <utility>
#include <vector>

namespace pn {
namespace {

TensorPolynomial<Rational> restricted(const TensorPolynomial<Rational>& p,
                                      const std::array<Rational, 2>& low,
                                      const std::array<Rational, 2>& high) {
  return p.substituted(Variable::kU, low[0], high[0] - low[0])
      .substituted(Variable::kV, low[1], high[1] - low[1]);
}

}  // namespace

RationalSections rational_sections(std::array<BivariatePolynomial, 3> point,
                                   std::array<BivariatePolynomial, 3> direction,
                                   BivariatePolynomial weight,
                                   std::optional<Rational> squared_length) {
  if (weight.is_zero()) throw std::domain_error("division by zero");
  BivariatePolynomial common = weight;
  for (const auto* vector : {&direction, &point}) {
    for (const BivariatePolynomial& p : *vector) common = gcd(common, p);
  }
  const Rational half = Rational(1L) / Rational(2L);
  const Rational middle = quotient(weight, common)->at({half, half});
  if (middle.sign() < 0) common = -common;
  const auto divided = [&](const BivariatePolynomial& p) { return dense(*quotient(p, common)); };
  RationalSections result;
  for (std::size_t i = 0; i < 3; ++i) {
    result.sections.point[i] = divided(point[i]);
    result.sections.direction[i] = divided(direction[i]);
  }
  result.sections.weight = divided(weight);
  result.squared_length = std::move(squared_length);
  return result;
}

RationalSections part_of(const RationalSections& sections, const std::array<Rational, 2>& low,
                         const std::array<Rational, 2>& high) {
  RationalSections result = sections;
  for (auto* vector : {&result.sections.point, &result.sections.direction}) {
    for (auto& p : *vector) p = restricted(p, low, high);
  }
  result.sections.weight = restricted(result.sections.weight, low, high);
  return result;
}

SurfaceSections<RealBall> enclosed(const RationalSections& sections, long bits) {
  SurfaceSections<RealBall> result = in_balls(sections.sections, bits);
  if (!sections.squared_length) return result;
  const RealBall inverse = RealBall(1) / sqrt(RealBall(*sections.squared_length, bits));
  for (auto& p : result.direction) p *= inverse;
  return result;
}

}  // namespace pn
