// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/isotropic/family_type.hpp"

#include "pn/algebra/rational_matrix.hpp"
#include "pn/minkowski/affine_class.hpp"

namespace pn {

namespace {

LineCoordinates<Rational> complex_of(const std::vector<Rational>& equation) {
  return {equation[3], equation[4], equation[5], equation[0], equation[1], equation[2]};
}

std::vector<QuadraticCoordinate> coordinates(const QuadraticFamily& family) {
  const auto a = family.power();
  const Rational half = Rational(1L) / Rational(2L);
  std::vector<QuadraticCoordinate> result;
  for (std::size_t c = 0; c < 4; ++c)
    result.push_back({half * a[0][c], a[1][c], half * a[2][c], a[3][c], a[4][c]});
  return result;
}

}  // namespace

std::optional<LineNet> normal_net(const QuadraticFamily& family) {
  const auto [fu, fv] = family.derivatives();
  const auto tangent_line = join(fu, fv);
  RationalMatrix monomials;
  for (std::size_t k = 0; k < tangent_line.front().coefficients().size(); ++k) {
    auto& row = monomials.emplace_back();
    for (const auto& coordinate : tangent_line) row.push_back(coordinate.coefficients()[k]);
  }
  const RationalMatrix equations = null_space(monomials, 6);
  if (equations.size() != 2) return std::nullopt;
  return LineNet{polar(complex_of(equations[0])), polar(complex_of(equations[1]))};
}

FamilyType family_type(const QuadraticFamily& family) {
  const auto all = coordinates(family);
  FamilyType type = {affine_class(all), affine_class({all[0], all[1], all[2]}),
                     affine_class({all[3]}), std::nullopt};
  if (const auto net = normal_net(family)) type.net = net_type(*net);
  return type;
}

CausalType tangent_plane_type(const QuadraticFamily& family, const Rational& u, const Rational& v) {
  const auto a = family.power();
  return causal_type(gram_determinant(translated(translated(a[3], u, a[0]), v, a[1]),
                                      translated(translated(a[4], u, a[1]), v, a[2])));
}

}  // namespace pn
