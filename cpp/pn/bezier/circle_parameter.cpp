// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/bezier/circle_parameter.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "pn/algebra/memo.hpp"
#include "pn/algebra/rational_polynomial.hpp"
#include "pn/bezier/knot_insertion.hpp"
#include "pn/isotropic/form_in_u.hpp"

namespace pn {
namespace {

using Point = std::array<Rational, 2>;

/// c_j, rounded to the 24 bits of a float so that all products stay short.
Eigen::Vector2d control_double(int j, int spans) {
  const int turns = j / spans;
  const double angle = M_PI * (j % spans) / spans;
  const double sign = turns % 2 == 0 ? 1 : -1;
  // The cosine of a right angle is zero, which a float would not know.
  const double cosine = 2 * (j % spans) == spans ? 0.0 : std::cos(angle);
  return Eigen::Vector2f(static_cast<float>(cosine), static_cast<float>(std::sin(angle)))
             .cast<double>() *
         sign;
}

Point control_point(int j, int spans) {
  const Eigen::Vector2d c = control_double(j, spans);
  return {Rational::exactly(c(0)), Rational::exactly(c(1))};
}

/// The Bezier control points of a span of p(s), in doubles.
std::array<Eigen::Vector2d, 3> span_in_doubles(int j, int spans) {
  const Eigen::Vector2d a = control_double(j, spans), b = control_double(j + 1, spans),
                        c = control_double(j + 2, spans);
  return {(a + b) / 2, b, (b + c) / 2};
}

Point midpoint(const Point& a, const Point& b) {
  const Rational half = Rational(1) / Rational(2);
  return {(a[0] + b[0]) * half, (a[1] + b[1]) * half};
}

Rational binomial(int n, int j) { return Rational(static_cast<long>(small_binomial(n, j))); }

/// With x = s / (1 - s): Bernstein coefficients times their binomials are the coefficients of a
/// polynomial in x, and multiply like those.
RationalPolynomial in_ratio(const std::vector<Rational>& bernstein) {
  const int n = static_cast<int>(bernstein.size()) - 1;
  std::vector<Rational> coefficients;
  for (int j = 0; j <= n; ++j) coefficients.push_back(bernstein[j] * binomial(n, j));
  return RationalPolynomial(coefficients);
}

/// 1, a, a^2, ..., a^most.
std::vector<RationalPolynomial> powers(const RationalPolynomial& a, int most) {
  std::vector<RationalPolynomial> result = {RationalPolynomial(1L)};
  for (int i = 0; i < most; ++i) result.push_back(result.back() * a);
  return result;
}

/// The columns of a form on the Bezier curve p(s) with these control points.
std::vector<std::vector<Rational>> composed(const std::vector<Point>& p, int form_degree) {
  std::array<std::vector<RationalPolynomial>, 2> powers_of_u;
  for (std::size_t c = 0; c < 2; ++c) {
    std::vector<Rational> u;
    for (const Point& point : p) u.push_back(point[c]);
    powers_of_u[c] = powers(in_ratio(u), form_degree);
  }
  const int degree = form_degree * (static_cast<int>(p.size()) - 1);
  std::vector<std::vector<Rational>> columns(static_cast<std::size_t>(degree) + 1);
  for (int i = 0; i <= form_degree; ++i) {
    const RationalPolynomial monomial = powers_of_u[0][form_degree - i] * powers_of_u[1][i];
    for (int j = 0; j <= degree; ++j) {
      columns[j].push_back(monomial.coefficient(j) * binomial(form_degree, i) /
                           binomial(degree, j));
    }
  }
  return columns;
}

CircleColumns computed_circle_part(int first, int last, int spans, int form_degree) {
  CircleColumns circle;
  circle.degree = 2 * form_degree;
  for (int j = first; j <= last; ++j) {
    const bool is_end = j == first || j == last;
    circle.knots.push_back(j);
    circle.multiplicities.push_back(is_end ? circle.degree + 1 : circle.degree - 1);
  }
  for (int j = first; j < last; ++j) {
    const Point a = control_point(j, spans), b = control_point(j + 1, spans),
                c = control_point(j + 2, spans);
    const auto bezier = composed({midpoint(a, b), b, midpoint(b, c)}, form_degree);
    if (j == first) circle.coefficients.push_back(bezier.front());
    // A knot of multiplicity degree - 1 has no control point of its own: C1 makes it a mean of its
    // neighbours.
    circle.coefficients.insert(circle.coefficients.end(), bezier.begin() + 1, bezier.end() - 1);
    if (j == last - 1) circle.coefficients.push_back(bezier.back());
  }
  return circle;
}

}  // namespace

CircleColumns circle_part(int first, int last, int spans, int form_degree) {
  static Memo<std::array<int, 4>, CircleColumns> known;
  return known({first, last, spans, form_degree},
               [&] { return computed_circle_part(first, last, spans, form_degree); });
}

Eigen::Vector2d circle_point(double s, int spans) {
  const int j = std::min(static_cast<int>(s), spans - 1);
  const double x = s - j;
  const auto [a, b, c] = span_in_doubles(j, spans);
  return (1 - x) * (1 - x) * a + 2 * x * (1 - x) * b + x * x * c;
}

double circle_parameter(double u0, double u1, int spans) {
  const double step = M_PI / spans, start = step / 2;
  const double angle = std::atan2(u1, u0) - start;
  const double turned = angle - M_PI * std::floor(angle / M_PI);
  const int j = std::min(static_cast<int>(turned / step), spans - 1);
  // The component of p(s) across u, a quadratic in s - j with one zero in the span.
  const auto across = [&](const Eigen::Vector2d& p) { return p(0) * u1 - p(1) * u0; };
  const auto [a, b, c] = span_in_doubles(j, spans);
  const double q0 = across(a), q1 = across(b), q2 = across(c);
  const double root = std::sqrt(std::max(0.0, q1 * q1 - q0 * q2));
  const double larger = q1 < 0 ? q1 - root : q1 + root;
  const double first = q0 / (q0 - larger), second = larger / (larger - q2);
  return j + (std::abs(first - 0.5) < std::abs(second - 0.5) ? first : second);
}

CircleColumns circle_arc(int index, int arcs, int form_degree) {
  return {form_degree,
          {static_cast<double>(index), static_cast<double>(index + 1)},
          {form_degree + 1, form_degree + 1},
          composed({control_point(index, arcs), control_point(index + 1, arcs)}, form_degree)};
}

CircleColumns refined(const CircleColumns& columns, int spans) {
  SplineColumns<Rational> spline{columns.degree, {}, columns.coefficients};
  for (std::size_t i = 0; i < columns.knots.size(); ++i) {
    spline.knots.insert(spline.knots.end(), static_cast<std::size_t>(columns.multiplicities[i]),
                        Rational::exactly(columns.knots[i]));
  }
  CircleColumns result{columns.degree, {}, {}, {}};
  for (std::size_t i = 0; i < columns.knots.size(); ++i) {
    result.knots.push_back(columns.knots[i]);
    result.multiplicities.push_back(columns.multiplicities[i]);
    if (i + 1 == columns.knots.size()) break;
    for (int part = 1; part < spans; ++part) {
      const double knot =
          columns.knots[i] + (columns.knots[i + 1] - columns.knots[i]) * part / spans;
      spline = with_knot(spline, Rational::exactly(knot), [](const Rational& x) { return x; });
      result.knots.push_back(knot);
      result.multiplicities.push_back(1);
    }
  }
  result.coefficients = std::move(spline.points);
  return result;
}

CircleColumns straight_band(int spans, int form_degree) {
  return refined({form_degree,
                  {0, 1},
                  {form_degree + 1, form_degree + 1},
                  composed({{Rational(1), Rational(0)}, {Rational(0), Rational(1)}}, form_degree)},
                 spans);
}

}  // namespace pn
