// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/bezier/circle_parameter.hpp"

#include <cmath>

namespace pn {
namespace {

using Point = std::array<Rational, 2>;

/// c_j, rounded to the 24 bits of a float so that all products stay short.
Point control_point(int j, int spans) {
  const int turns = j / spans;
  const double angle = M_PI * (j % spans) / spans;
  const long sign = turns % 2 == 0 ? 1 : -1;
  const auto rounded = [&](double x) {
    return Rational::exactly(static_cast<double>(static_cast<float>(x))) * Rational(sign);
  };
  // The cosine of a right angle is zero, which a float would not know.
  const double cosine = 2 * (j % spans) == spans ? 0.0 : std::cos(angle);
  return {rounded(cosine), rounded(std::sin(angle))};
}

Point midpoint(const Point& a, const Point& b) {
  const Rational half = Rational(1) / Rational(2);
  return {(a[0] + b[0]) * half, (a[1] + b[1]) * half};
}

/// The coefficients of the bilinear form of q at (a, b).
std::array<Rational, 3> product(const Point& a, const Point& b) {
  return {a[0] * b[0], a[0] * b[1] + a[1] * b[0], a[1] * b[1]};
}

std::array<Rational, 3> weighted_sum(const Rational& x, const std::array<Rational, 3>& a,
                                     const Rational& y, const std::array<Rational, 3>& b) {
  return {x * a[0] + y * b[0], x * a[1] + y * b[1], x * a[2] + y * b[2]};
}

/// The Bernstein coefficients of the square of a quadratic Bezier curve.
std::array<std::array<Rational, 3>, 5> squared(const Point& a, const Point& b, const Point& c) {
  const Rational third = Rational(1) / Rational(3), two_thirds = third + third;
  return {product(a, a), product(a, b),
          weighted_sum(third, product(a, c), two_thirds, product(b, b)), product(b, c),
          product(c, c)};
}

}  // namespace

CircleColumns whole_circle(int spans) {
  CircleColumns circle;
  circle.degree = 4;
  for (int j = 0; j <= spans; ++j) {
    circle.knots.push_back(j);
    circle.multiplicities.push_back(j == 0 || j == spans ? 5 : 3);
  }
  for (int j = 0; j < spans; ++j) {
    const Point a = control_point(j, spans), b = control_point(j + 1, spans),
                c = control_point(j + 2, spans);
    const auto bezier = squared(midpoint(a, b), b, midpoint(b, c));
    if (j == 0) circle.coefficients.push_back(bezier[0]);
    // A knot of multiplicity 3 has no control point of its own: C1 makes it a mean of its
    // neighbours.
    circle.coefficients.insert(circle.coefficients.end(), {bezier[1], bezier[2], bezier[3]});
    if (j == spans - 1) circle.coefficients.push_back(bezier[4]);
  }
  return circle;
}

CircleColumns circle_arc(int index, int arcs) {
  const Point a = control_point(index, arcs), b = control_point(index + 1, arcs);
  return {2,
          {static_cast<double>(index), static_cast<double>(index + 1)},
          {3, 3},
          {product(a, a), product(a, b), product(b, b)}};
}

}  // namespace pn
