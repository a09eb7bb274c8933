// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/minkowski/line_congruence.hpp"

#include <algorithm>
#include <stdexcept>

#include "pn/algebra/rational_matrix.hpp"

namespace pn {

CubicChords::CubicChords(const std::array<MinkowskiVector<Rational>, 4>& coefficients) {
  RationalMatrix columns(4, std::vector<Rational>(4));
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = 0; j < 4; ++j) columns[i][j] = coefficients[j][i];
  }
  const RationalMatrix rows = inverse(columns);
  for (std::size_t i = 0; i < 4; ++i) std::copy_n(rows[i].begin(), 4, coordinates_[i].begin());
}

AxisCurveCongruence::AxisCurveCongruence(const std::array<PlaneAtInfinity<Rational>, 2>& axis,
                                         Curve curve)
    : axis_(axis), curve_(std::move(curve)), degree_(0) {
  for (const RationalPolynomial& c : curve_) degree_ = std::max(degree_, c.degree());
  const std::array<RationalPolynomial, 2> on_axis = {incidence(axis_[0], curve_),
                                                     incidence(axis_[1], curve_)};
  const RationalPolynomial meets = gcd(on_axis[0], on_axis[1]);
  const int at_infinity = degree_ - std::max(on_axis[0].degree(), on_axis[1].degree());
  if (meets.is_zero() || meets.degree() + at_infinity != degree_ - 1)
    throw std::domain_error("A curve of degree n must meet the axis in n - 1 points.");
  for (std::size_t i = 0; i < 2; ++i) {
    const RationalPolynomial cofactor = exact_quotient(on_axis[i], meets);
    cofactors_[i] = {cofactor.coefficient(0), cofactor.coefficient(1)};
  }
}

}  // namespace pn
