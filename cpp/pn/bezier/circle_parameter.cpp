// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/bezier/circle_parameter.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "pn/bezier/knot_insertion.hpp"
#include "pn/isotropic/form_in_u.hpp"

namespace pn {
namespace {

using Point = std::array<Rational, 2>;

/// Bernstein coefficients of a polynomial in s.
using Bernstein = std::vector<Rational>;

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

Bernstein operator*(const Bernstein& a, const Bernstein& b) {
  const int n = static_cast<int>(a.size()) - 1, m = static_cast<int>(b.size()) - 1;
  Bernstein product(static_cast<std::size_t>(n + m) + 1);
  for (int i = 0; i <= n; ++i) {
    for (int j = 0; j <= m; ++j) {
      product[i + j] += a[i] * b[j] * (binomial(n, i) * binomial(m, j) / binomial(n + m, i + j));
    }
  }
  return product;
}

/// 1, a, a^2, ..., a^most.
std::vector<Bernstein> powers(const Bernstein& a, int most) {
  std::vector<Bernstein> result = {{Rational(1)}};
  for (int i = 0; i < most; ++i) result.push_back(result.back() * a);
  return result;
}

/// The columns of a form on the Bezier curve p(s) with these control points.
std::vector<std::vector<Rational>> composed(const std::vector<Point>& p, int form_degree) {
  Bernstein u0, u1;
  for (const Point& point : p) {
    u0.push_back(point[0]);
    u1.push_back(point[1]);
  }
  const std::vector<Bernstein> powers_of_u0 = powers(u0, form_degree),
                               powers_of_u1 = powers(u1, form_degree);
  const std::size_t count = form_degree * (p.size() - 1) + 1;
  std::vector<std::vector<Rational>> columns(count);
  for (int i = 0; i <= form_degree; ++i) {
    const Bernstein monomial = powers_of_u0[form_degree - i] * powers_of_u1[i];
    for (std::size_t j = 0; j < count; ++j) {
      columns[j].push_back(monomial[j] * binomial(form_degree, i));
    }
  }
  return columns;
}

}  // namespace

CircleColumns circle_part(int first, int last, int spans, int form_degree) {
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
