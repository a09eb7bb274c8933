// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/isotropic/base_points.hpp"

#include "pn/algebra/form.hpp"
#include "pn/algebra/rational_polynomial.hpp"
#include "pn/algebra/roots.hpp"

namespace pn {
namespace {

using Vector = MinkowskiVector<Rational>;
using Row = std::array<RationalPolynomial, 4>;

/// l x + m y with l = 4 t - 3, m = 3 t + 4: no round (l : m) is at infinity.
Row combination(const Vector& x, const Vector& y) {
  Row row;
  for (std::size_t c = 0; c < 4; ++c) {
    const Rational sign(c == 3 ? -1L : 1L);  // <w, x> = w . row
    row[c] = RationalPolynomial({sign * (Rational(4L) * y[c] - Rational(3L) * x[c]),
                                 sign * (Rational(4L) * x[c] + Rational(3L) * y[c])});
  }
  return row;
}

RationalPolynomial determinant(const std::array<Row, 3>& rows, std::size_t i, std::size_t j,
                               std::size_t k) {
  const auto& [a, b, c] = rows;
  return a[i] * (b[j] * c[k] - b[k] * c[j]) - a[j] * (b[i] * c[k] - b[k] * c[i]) +
         a[k] * (b[i] * c[j] - b[j] * c[i]);
}

/// The vector perpendicular to three others.
Row perpendicular(const std::array<Row, 3>& rows) {
  return {determinant(rows, 1, 2, 3), -determinant(rows, 0, 2, 3), determinant(rows, 0, 1, 3),
          -determinant(rows, 0, 1, 2)};
}

RealBall value(const RationalPolynomial& p, const RealBall& t, long precision) {
  RealBall result;
  for (int i = p.degree(); i >= 0; --i) {
    result *= t;
    result += RealBall(p.coefficient(i), precision);
  }
  return result;
}

}  // namespace

std::vector<MinkowskiVector<RealBall>> base_points(const QuadraticFamily& family, long precision) {
  const auto a = family.power();
  const Row w =
      perpendicular({combination(a[0], a[1]), combination(a[1], a[2]), combination(a[3], a[4])});
  const RationalPolynomial sextic = w[0] * w[0] + w[1] * w[1] + w[2] * w[2] - w[3] * w[3];
  std::vector<MinkowskiVector<RealBall>> points;
  if (sextic.is_zero()) return points;
  for (const RealRoot& root : isolate_roots(sextic, precision).real) {
    if (root.multiplicity > 1) continue;
    MinkowskiVector<RealBall> point;
    for (std::size_t c = 0; c < 4; ++c) point[c] = value(w[c], root.value, precision);
    if (point[3].contains_zero()) throw Undecided("the sign of a base point");
    if (point[3].is_negative()) {
      for (RealBall& x : point) x = -x;
    }
    points.push_back(std::move(point));
  }
  return points;
}

}  // namespace pn
