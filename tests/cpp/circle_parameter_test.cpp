// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/bezier/circle_parameter.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "enclosures.hpp"

using pn::CircleColumns;
using pn::Rational;
using namespace pn::test;

namespace {

CircleColumns whole_circle(int spans) { return pn::circle_part(0, spans, spans, 2); }

/// The coefficients are those of a square (x u0 + y u1)^2 with (x, y) not zero.
void check_square(const std::vector<Rational>& c) {
  CHECK(c[1] * c[1] == Rational(4L) * c[0] * c[2]);
  CHECK((c[0] + c[2]).sign() > 0);
}

/// The angle of the normal that u = (u0 : u1) has where the weight is even.
double angle(const std::vector<Rational>& c) {
  return std::atan2(c[1].to_double(), (c[0] - c[2]).to_double());
}

/// Parameters from the first to the last knot.
std::vector<double> parameters(const CircleColumns& columns) {
  std::vector<double> result;
  const double first = columns.knots.front(), last = columns.knots.back();
  const int steps = 16 * static_cast<int>(columns.knots.size() - 1);
  for (int i = 0; i <= steps; ++i) result.push_back(first + (last - first) * i / steps);
  return result;
}

/// The sum of the steps of the angle, each of which must go forward.
double turn(const CircleColumns& columns) {
  double sum = 0, before = angle(circle_coefficients(columns, columns.knots.front()));
  for (const double v : parameters(columns)) {
    const double next = angle(circle_coefficients(columns, v));
    const double step = std::remainder(next - before, 2 * M_PI);
    CHECK(step >= 0);
    sum += step;
    before = next;
  }
  return sum;
}

}  // namespace

TEST_CASE("The whole circle is the square of a closed curve, once around", "[circle_parameter]") {
  for (const int spans : {3, 4, 5, 8, 32}) {
    INFO(spans << " spans");
    const CircleColumns circle = whole_circle(spans);
    REQUIRE(circle.coefficients.size() == pn::pole_count(circle.degree, circle.multiplicities));
    for (const double v : parameters(circle)) check_square(circle_coefficients(circle, v));
    CHECK(turn(circle) == Approx(2 * M_PI));
    CHECK(circle.coefficients.front() == circle.coefficients.back());
    CHECK(circle.knots.back() == spans);
    for (std::size_t i = 1; i + 1 < circle.multiplicities.size(); ++i) {
      CHECK(circle.multiplicities[i] <= circle.degree - 1);
    }
  }
}

TEST_CASE("The circle closes C1", "[circle_parameter]") {
  for (const int spans : {3, 4, 7}) {
    const auto& c = whole_circle(spans).coefficients;
    const std::size_t last = c.size() - 1;
    for (std::size_t q = 0; q < 3; ++q) CHECK(c[1][q] - c[0][q] == c[last][q] - c[last - 1][q]);
  }
}

TEST_CASE("Four spans keep an even weight within a factor of 1.2", "[circle_parameter]") {
  double least = INFINITY, largest = 0;
  for (const auto& c : whole_circle(4).coefficients) {
    const double weight = (c[0] + c[2]).to_double();
    least = std::min(least, weight);
    largest = std::max(largest, weight);
  }
  CHECK(least > 0);
  CHECK(largest < 1.2 * least);
}

TEST_CASE("The arcs are squares that continue each other once around", "[circle_parameter]") {
  for (const int arcs : {3, 4, 16}) {
    double sum = 0;
    for (int i = 0; i < arcs; ++i) {
      const CircleColumns arc = pn::circle_arc(i, arcs, 2);
      REQUIRE(arc.coefficients.size() == 3);
      for (const double v : parameters(arc)) check_square(circle_coefficients(arc, v));
      CHECK(arc.coefficients.back() ==
            pn::circle_arc((i + 1) % arcs, arcs, 2).coefficients.front());
      sum += turn(arc);
    }
    CHECK(sum == Approx(2 * M_PI));
  }
}

TEST_CASE("Forms of degree n in u take the monomials of p, degree 2 n along",
          "[circle_parameter]") {
  // Of degree 4: the square of the columns of degree 2, where c2 = (p^2, 2 p q, q^2) are taken.
  const CircleColumns two = pn::circle_part(0, 4, 4, 2), four = pn::circle_part(0, 4, 4, 4);
  CHECK(four.degree == 8);
  REQUIRE(four.coefficients.size() == pn::pole_count(four.degree, four.multiplicities));
  CHECK(four.coefficients.front() == four.coefficients.back());
  for (const double v : parameters(two)) {
    const auto a = circle_coefficients(two, v), b = circle_coefficients(four, v);
    REQUIRE(b.size() == 5);
    CHECK(b[0] == a[0] * a[0]);
    CHECK(b[1] == Rational(2L) * a[0] * a[1]);
    CHECK(b[2] == Rational(2L) * a[0] * a[2] + a[1] * a[1]);
    CHECK(b[3] == Rational(2L) * a[1] * a[2]);
    CHECK(b[4] == a[2] * a[2]);
  }
}

TEST_CASE("A part of the circle is that part of the whole", "[circle_parameter]") {
  for (const int degree : {2, 4}) {
    const CircleColumns whole = pn::circle_part(0, 4, 4, degree),
                        half = pn::circle_part(1, 3, 4, degree);
    CHECK(half.knots == std::vector<double>{1, 2, 3});
    for (const double v : parameters(half)) {
      CHECK(circle_coefficients(half, v) == circle_coefficients(whole, v));
    }
  }
}

TEST_CASE("The straight band is u = (1 - s : s) for any number of spans", "[circle_parameter]") {
  for (const int degree : {2, 4}) {
    for (const int spans : {1, 2, 8}) {
      const CircleColumns band = pn::straight_band(spans, degree);
      CHECK(band.degree == degree);
      CHECK(band.knots.front() == 0);
      CHECK(band.knots.back() == 1);
      CHECK(static_cast<int>(band.knots.size()) == spans + 1);
      REQUIRE(band.coefficients.size() == pn::pole_count(degree, band.multiplicities));
      for (const double v : parameters(band)) {
        const auto c = circle_coefficients(band, v);
        const Rational s = Rational::exactly(v), r = Rational(1L) - s;
        // C(n, i) r^(n - i) s^i
        Rational expected(1L);
        for (int i = 0; i < degree; ++i) expected *= r;
        CHECK(c[0] == expected);
        CHECK(c[1] * r == Rational(long{degree}) * expected * s);
        Rational last(1L);
        for (int i = 0; i < degree; ++i) last *= s;
        CHECK(c.back() == last);
      }
    }
  }
}
