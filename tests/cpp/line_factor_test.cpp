// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/bezier/line_factor.hpp"

#include <catch2/catch.hpp>
#include <complex>
#include <random>

namespace {

using namespace pn::lines;
using Complex = std::complex<double>;
using Real = Matrix<double>;

constexpr double kRounding = 1e-12;

class Random {
 public:
  double number() { return distribution_(generator_); }
  Real real() { return {{{number(), number()}, {number(), number()}}}; }
  Matrix<Complex> complex() {
    const auto z = [&] { return Complex(number(), number()); };
    return {{{z(), z()}, {z(), z()}}};
  }

 private:
  std::mt19937 generator_{2024};
  std::uniform_real_distribution<double> distribution_{-1, 1};
};

Real at(const LineFactor<double>& factor, double t) {
  Real sum = scaled(factor.coefficients.back(), 0.0);
  for (std::size_t i = factor.coefficients.size(); i-- > 0;) {
    sum = scaled(sum, t) + factor.coefficients[i];
  }
  return sum;
}

template <class T>
double distance(const Matrix<T>& a, const Matrix<T>& b) {
  double largest = 0;
  for (int i = 0; i < 2; ++i) {
    for (int j = 0; j < 2; ++j) largest = std::max(largest, std::abs(a[i][j] - b[i][j]));
  }
  return largest;
}

Real slope_at(const LineFactor<double>& factor, double t) {
  constexpr double kStep = 1e-6;
  return scaled(at(factor, t + kStep) + scaled(at(factor, t - kStep), -1.0), 0.5 / kStep);
}

/// The ends that a factor keeps are those of its polynomial.
void check_ends(const LineFactor<double>& factor) {
  for (int end = 0; end < 2; ++end) {
    CHECK(distance(at(factor, end), factor.ends[end].value) < kRounding);
    CHECK(distance(slope_at(factor, end), factor.ends[end].slope) < 1e-8);
  }
}

}  // namespace

TEST_CASE("Line factors pass through what they are given") {
  Random random;
  const Real a = random.real(), b = random.real(), c = random.real(), d = random.real();
  check_ends(constant_line(a));
  const auto line = line_through(a, b);
  check_ends(line);
  CHECK(distance(line.ends[1].value, b) == 0);
  const auto parabola = parabola_through(a, b, c);
  check_ends(parabola);
  CHECK(distance(at(parabola, 0.5), b) < kRounding);
  const auto cubic = hermite_cubic<double>({a, b}, {c, d});
  check_ends(cubic);
  CHECK(distance(cubic.ends[0].slope, b) == 0);
  CHECK(distance(cubic.ends[1].slope, d) == 0);
}

TEST_CASE("Lines that meet a neighbour have its spinors up to a phase, to first order") {
  // A neighbour that is e^{-i phi(t)} A(t) F(t), stretched: Lemma 1 has to find F and its slope
  // again.
  Random random;
  for (int repetition = 0; repetition < 20; ++repetition) {
    const EndValue<Complex> own{random.complex(), random.complex()};
    const Real value = random.real(), slope = random.real();
    const Complex phase = std::polar(1.0, random.number());
    const double rate = random.number(), stretch = 1.5 + random.number();
    const Matrix<Complex> f = complexified<double>(value), f_slope = complexified<double>(slope);
    const Matrix<Complex> product = own.value * f;
    const Matrix<Complex> product_slope = own.derivative * f + own.value * f_slope;
    const EndValue<Complex> neighbour{
        scaled(product, phase),
        scaled(scaled(product_slope, phase) + scaled(product, phase * Complex(0, rate)),
               Complex(1 / stretch))};
    const LineEnd<double> met = matched<double>(own, neighbour, stretch, midpoint(value));
    CHECK(distance(met.value, value) < 1e-9);
    CHECK(distance(met.slope, slope) < 1e-8);
  }
}

TEST_CASE("A matched factor keeps to the nearer sign") {
  Random random;
  const EndValue<Complex> own{random.complex(), random.complex()};
  const Real value = random.real();
  const EndValue<Complex> neighbour{own.value * complexified<double>(value), own.derivative};
  const Eigen::Matrix2d near = midpoint(value);
  CHECK(distance(matched<double>(own, neighbour, 1.0, near).value, value) < 1e-9);
  CHECK(distance(matched<double>(own, neighbour, 1.0, -near).value, scaled(value, -1.0)) < 1e-9);
}

TEST_CASE("Short doubles keep 24 bits of numbers of any size") {
  for (const double size : {1e-200, 1e-40, 1.0, 1e60}) {
    const double x = size / 3;
    const double rounded = short_double(x);
    CHECK(std::abs(rounded - x) <= std::ldexp(x, -24));
    int exponent = 0;
    const double bits = std::ldexp(std::frexp(rounded, &exponent), 24);
    CHECK(bits == std::round(bits));
    CHECK(short_double(-x) == -rounded);
  }
  CHECK(short_double(0) == 0);
}
