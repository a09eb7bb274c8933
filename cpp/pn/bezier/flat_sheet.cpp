// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/bezier/flat_sheet.hpp"

namespace pn {
namespace {

using Vector = MinkowskiVector<Rational>;

/// The normal of the outer sheet at u = v = 0, by the formula of sheet.hpp.
std::array<RealBall, 3> outer_normal(const TranslationalFamily& family, long bits) {
  const Vector &mu = family.c.first, &mv = family.d.first;
  const auto dot = [](const Vector& x, const Vector& y) {
    return x[0] * y[0] + x[1] * y[1] + x[2] * y[2];
  };
  const Vector across = {mu[1] * mv[2] - mu[2] * mv[1], mu[2] * mv[0] - mu[0] * mv[2],
                         mu[0] * mv[1] - mu[1] * mv[0], Rational(0L)};
  const Rational &pu = mu[3], &pv = mv[3], square = dot(across, across);
  const Rational along_u = dot(mv, mv) * pu - dot(mu, mv) * pv,
                 along_v = dot(mu, mu) * pv - dot(mu, mv) * pu;
  const RealBall root = sqrt(RealBall(square - (along_u * pu + along_v * pv), bits));
  std::array<RealBall, 3> n;
  for (std::size_t i = 0; i < 3; ++i) {
    n[i] = RealBall((along_u * mu[i] + along_v * mv[i]) / square, bits) +
           root * RealBall(across[i] / square, bits);
  }
  return n;
}

/// A coordinate of f in (u, v).
TensorPolynomial<RealBall> coordinate(const TranslationalFamily& family, std::size_t i, long bits) {
  const auto& [c, d] = family;
  const Rational half = Rational(1L) / Rational(2L);
  TensorPolynomial<RealBall> f(2, 2);
  f(0, 0) = RealBall(c.start[i] + d.start[i], bits);
  f(1, 0) = RealBall(c.first[i], bits);
  f(2, 0) = RealBall(half * c.second[i], bits);
  f(0, 1) = RealBall(d.first[i], bits);
  f(0, 2) = RealBall(half * d.second[i], bits);
  return f;
}

SurfaceSections<RealBall> outer_sections(const TranslationalFamily& family, long bits) {
  const std::array<RealBall, 3> n = outer_normal(family, bits);
  const TensorPolynomial<RealBall> f4 = coordinate(family, 3, bits);
  SurfaceSections<RealBall> result;
  for (std::size_t i = 0; i < 3; ++i) {
    result.point[i] = coordinate(family, i, bits) - f4 * n[i];
    result.direction[i] = TensorPolynomial<RealBall>::constant(n[i]);
  }
  result.weight = TensorPolynomial<RealBall>::constant(RealBall(1));
  return result;
}

}  // namespace

SkinPatch flat_patch(const TranslationalFamily& family, Sheet sheet) {
  const bool is_outer = sheet == Sheet::kOuter;
  // The inner sheet is the outer one with the curves exchanged.
  return {{2, 2},
          [outer = is_outer ? family : family.exchanged()](long bits) {
            return outer_sections(outer, bits);
          },
          [is_outer](const std::array<double, 2>& uv) {
            return is_outer ? uv : std::array{uv[1], uv[0]};
          },
          sheet,
          1};
}

}  // namespace pn
