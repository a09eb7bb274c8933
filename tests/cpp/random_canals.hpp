// SPDX-License-Identifier: LGPL-2.1-or-later
// Random spines and radius laws, biased to the degeneracies of canal surfaces.
//
// Every input is a function of its seed, and its numbers are short binary fractions unless stated,
// so that a circle closes and a corner is a corner exactly.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <ostream>
#include <random>
#include <string>
#include <vector>

#include "pn/algebra/bernstein.hpp"
#include "pn/algebra/rational_polynomial.hpp"
#include "pn/shapes/curve.hpp"
#include "spline_output.hpp"

namespace pn::test {

struct CanalInput {
  std::string kind;
  BSplineData<3> spine;
  BSplineData<1> radius;
};

inline std::ostream& operator<<(std::ostream& out, const CanalInput& input) {
  const std::streamsize digits = out.precision(17);
  out << input.kind << "\nspine  " << input.spine << "\nradius " << input.radius;
  out.precision(digits);
  return out;
}

class RandomCanal {
 public:
  explicit RandomCanal(std::uint64_t seed) : generator_(seed) {}

  CanalInput input() {
    switch (below(12)) {
      case 0:
        return torus();
      case 1:
        return closed_cubic();
      case 2:
        return closed_polygon();
      case 3:
        return hodograph_with_square_length();
      case 4:
        return common_factor();
      default:
        return rescaled(planted(open_spline()));
    }
  }

 private:
  using Point = std::array<double, 3>;

  int below(int count) { return static_cast<int>(generator_() % static_cast<unsigned>(count)); }
  int between(int low, int high) { return low + below(high - low + 1); }
  bool one_in(int count) { return below(count) == 0; }
  /// A multiple of amplitude / 1024.
  double noise(double amplitude) { return amplitude * between(-1024, 1024) / 1024; }
  Point noise_point(double amplitude) {
    return {noise(amplitude), noise(amplitude), noise(amplitude)};
  }

  /// A B-spline of one to twenty spans that advances along x, polynomial or rational.
  CanalInput open_spline() {
    const int degree = between(1, 6);
    const int spans = one_in(2) ? 1 : one_in(4) ? between(9, 20) : between(2, 8);
    BSplineData<3> spine;
    spine.degree = degree;
    double knot = noise(1);
    const int most = one_in(3) ? degree : 1;
    for (int i = 0; i <= spans; ++i) {
      spine.knots.push_back(knot);
      knot += between(2, 6) / 4.0;
      spine.multiplicities.push_back(i == 0 || i == spans ? degree + 1 : between(1, most));
    }
    BSplineData<1> radius{degree, spine.knots, spine.multiplicities, {}, {}};
    const std::size_t count = pole_count(spine);
    const double roughness = between(1, 6) / 8.0, slope = noise(0.25);
    for (std::size_t i = 0; i < count; ++i) {
      Point pole = noise_point(roughness);
      pole[0] += 2 * static_cast<double>(i);
      spine.poles.push_back(pole);
      radius.poles.push_back({1 + std::abs(slope) * static_cast<double>(count) +
                              slope * static_cast<double>(i) + noise(roughness / 8)});
    }
    if (degree <= 4 && one_in(3)) {
      for (std::size_t i = 0; i < count; ++i) spine.weights.push_back(between(4, 16) / 8.0);
      if (degree == 4 || one_in(2)) radius.weights = spine.weights;
    }
    return {"open spline", spine, radius};
  }

  static std::size_t pole_count(const BSplineData<3>& data) {
    int sum = 0;
    for (const int multiplicity : data.multiplicities) sum += multiplicity;
    return static_cast<std::size_t>(sum - data.degree - 1);
  }

  CanalInput planted(CanalInput input) {
    if (one_in(4)) {
      input.kind += ", planar";
      for (Point& pole : input.spine.poles) pole[2] = 0;
    }
    if (one_in(4)) {
      input.kind += ", straight piece";
      const std::size_t first =
          static_cast<std::size_t>(below(static_cast<int>(input.spine.poles.size())));
      const Point direction = {2, noise(1), noise(1)};
      for (std::size_t i = first + 1; i < input.spine.poles.size(); ++i) {
        if (i > first + static_cast<std::size_t>(input.spine.degree) + 1) break;
        for (std::size_t c = 0; c < 3; ++c) {
          input.spine.poles[i][c] =
              input.spine.poles[first][c] + static_cast<double>(i - first) * direction[c];
        }
      }
    }
    switch (below(6)) {
      case 0:
        input.kind += ", constant radius";
        for (auto& pole : input.radius.poles) pole = input.radius.poles.front();
        break;
      case 1:
        input.kind += ", steep taper";
        taper(input.radius, between(16, 28) / 16.0);
        break;
      case 2:
        input.kind += ", full doubles";
        for (Point& pole : input.spine.poles) {
          for (double& x : pole) x += noise(1) * M_PI / 64;
        }
        for (auto& pole : input.radius.poles) pole[0] *= 1 + noise(1) * M_PI / 64;
        break;
      default:
        break;
    }
    return input;
  }

  /// Coefficients that rise by `step` for every pole: the spine advances by about 2.
  static void taper(BSplineData<1>& radius, double step) {
    for (std::size_t i = 0; i < radius.poles.size(); ++i) {
      radius.poles[i][0] = 0.5 + step * static_cast<double>(i);
    }
  }

  CanalInput rescaled(CanalInput input) {
    if (!one_in(8)) return input;
    const int exponent = between(-20, 20);
    input.kind += ", scaled by 2^" + std::to_string(exponent);
    for (Point& pole : input.spine.poles) {
      for (double& x : pole) x = std::ldexp(x, exponent);
    }
    for (auto& pole : input.radius.poles) pole[0] = std::ldexp(pole[0], exponent);
    return input;
  }

  /// One to four exact quarter circles, weights 1 1 2 and 2 1 1 in turn, of constant or varying
  /// radius.
  CanalInput torus() {
    static const std::array<Point, 9> square = {{{1, 0, 0},
                                                 {1, 1, 0},
                                                 {0, 1, 0},
                                                 {-1, 1, 0},
                                                 {-1, 0, 0},
                                                 {-1, -1, 0},
                                                 {0, -1, 0},
                                                 {1, -1, 0},
                                                 {1, 0, 0}}};
    const int arcs = between(1, 4);
    const double major = between(8, 64) / 8.0, minor = major * between(1, 6) / 8;
    BSplineData<3> spine;
    spine.degree = 2;
    for (int i = 0; i <= arcs; ++i) {
      spine.knots.push_back(i);
      spine.multiplicities.push_back(i == 0 || i == arcs ? 3 : 2);
    }
    for (int i = 0; i <= 2 * arcs; ++i) {
      const Point& p = square[static_cast<std::size_t>(i)];
      spine.poles.push_back({major * p[0], major * p[1], major * p[2]});
      spine.weights.push_back(i % 4 == 2 ? 2 : 1);
    }
    BSplineData<1> radius{2, spine.knots, spine.multiplicities, {}, {}};
    const bool varying = one_in(2);
    for (int i = 0; i <= 2 * arcs; ++i)
      radius.poles.push_back({minor + (varying ? noise(major / 16) : 0)});
    if (arcs == 4) radius.poles.back() = radius.poles.front();
    return {varying ? "circle, varying radius" : "torus", spine, radius};
  }

  /// A uniform periodic cubic spline, written in its Bezier points: closed and C2 exactly.
  CanalInput closed_cubic() {
    const int count = between(4, 9);
    const bool planar = one_in(3), constant = one_in(3);
    std::vector<std::array<double, 4>> controls;
    for (int i = 0; i < count; ++i) {
      const double angle = 2 * M_PI * i / count;
      // Multiples of 6 / 64, so that the Bezier points are binary fractions.
      const auto on_grid = [](double x) { return 6 * std::round(x * 64 / 6) / 64; };
      controls.push_back({on_grid(10 * std::cos(angle) + noise(2)),
                          on_grid(10 * std::sin(angle) + noise(2)), planar ? 0 : on_grid(noise(4)),
                          constant ? 1.5 : on_grid(1.5 + noise(0.5))});
    }
    CanalInput input{"closed cubic", {3, {}, {}, {}, {}}, {3, {}, {}, {}, {}}};
    const auto add = [&](int a, int b, int c, int wa, int wb, int wc) {
      const auto &p = controls[static_cast<std::size_t>(a % count)],
                 &q = controls[static_cast<std::size_t>(b % count)],
                 &r = controls[static_cast<std::size_t>(c % count)];
      std::array<double, 4> mean;
      for (std::size_t i = 0; i < 4; ++i)
        mean[i] = (wa * p[i] + wb * q[i] + wc * r[i]) / (wa + wb + wc);
      input.spine.poles.push_back({mean[0], mean[1], mean[2]});
      input.radius.poles.push_back({mean[3]});
    };
    for (int i = 0; i <= count; ++i) {
      input.spine.knots.push_back(i);
      input.spine.multiplicities.push_back(i == 0 || i == count ? 4 : 3);
      add(i + count - 1, i, i + 1, 1, 4, 1);
      if (i == count) break;
      add(i, i + 1, i, 2, 1, 0);
      add(i, i + 1, i, 1, 2, 0);
    }
    input.radius.knots = input.spine.knots;
    input.radius.multiplicities = input.spine.multiplicities;
    return input;
  }

  /// Straight edges around a closed polygon, each corner a zone of a sphere.
  CanalInput closed_polygon() {
    const int count = between(3, 7);
    const bool planar = one_in(2), constant = one_in(2);
    CanalInput input{"closed polygon", {1, {}, {}, {}, {}}, {1, {}, {}, {}, {}}};
    for (int i = 0; i <= count; ++i) {
      const double angle = 2 * M_PI * i / count;
      input.spine.knots.push_back(i);
      input.spine.multiplicities.push_back(i == 0 || i == count ? 2 : 1);
      input.spine.poles.push_back(
          {8 * std::cos(angle), 8 * std::sin(angle), planar ? 0 : noise(3)});
      input.radius.poles.push_back({1 + (constant ? 0 : noise(0.5))});
    }
    input.spine.poles.back() = input.spine.poles.front();
    input.radius.poles.back() = input.radius.poles.front();
    input.radius.knots = input.spine.knots;
    input.radius.multiplicities = input.spine.multiplicities;
    return input;
  }

  RationalPolynomial integers(int degree, int most) {
    std::vector<Rational> coefficients;
    for (int i = 0; i <= degree; ++i)
      coefficients.emplace_back(static_cast<long>(between(-most, most)));
    return RationalPolynomial(coefficients);
  }

  /// The Bezier coefficients of the integral of p, times `scale`.
  static std::vector<double> integral(const RationalPolynomial& p, int degree, long scale) {
    std::vector<Rational> power(static_cast<std::size_t>(degree) + 1);
    for (int i = 0; i < degree; ++i) {
      power[static_cast<std::size_t>(i) + 1] = p.coefficient(i) * Rational(scale) / Rational(i + 1);
    }
    std::vector<double> result;
    for (const Rational& b : to_bernstein(power)) result.push_back(b.to_double());
    return result;
  }

  /// A Bezier spine with m' = axis and r' = level, both in integers: all poles are exact.
  static CanalInput bezier(std::string kind, const std::array<RationalPolynomial, 3>& axis,
                           const RationalPolynomial& level, int degree) {
    constexpr long kScale = 3600;  // a multiple of all denominators up to degree 6
    CanalInput input{std::move(kind),
                     {degree, {0, 1}, {degree + 1, degree + 1}, {}, {}},
                     {degree, {0, 1}, {degree + 1, degree + 1}, {}, {}}};
    const auto x = integral(axis[0], degree, kScale), y = integral(axis[1], degree, kScale),
               z = integral(axis[2], degree, kScale), r = integral(level, degree, kScale);
    const double least = *std::min_element(r.begin(), r.end());
    for (std::size_t i = 0; i < x.size(); ++i) {
      input.spine.poles.push_back({x[i] / 1024, y[i] / 1024, z[i] / 1024});
      input.radius.poles.push_back({(r[i] - least + 512) / 1024});
    }
    return input;
  }

  /// |m'| is a polynomial (R. T. Farouki's Pythagorean hodographs), so D of a pipe is a square.
  CanalInput hodograph_with_square_length() {
    const int degree = between(1, 2);
    const RationalPolynomial u = integers(degree, 4) + RationalPolynomial(5L),
                             v = integers(degree, 4), p = integers(degree, 4),
                             q = integers(degree, 4);
    const std::array<RationalPolynomial, 3> axis = {u * u + v * v - p * p - q * q,
                                                    RationalPolynomial(2L) * (u * q + v * p),
                                                    RationalPolynomial(2L) * (v * q - u * p)};
    return bezier("square length", axis, RationalPolynomial(), 2 * degree + 1);
  }

  /// m' and r' with a common factor: a place where the spine stands still or runs back, or none.
  /// The level is a linear function of the axis of norm below 1, so that D > 0.
  CanalInput common_factor() {
    const RationalPolynomial turn({Rational(static_cast<long>(-between(-2, 6))), Rational(4L)});
    const RationalPolynomial factor =
        one_in(2) ? turn : turn * turn + RationalPolynomial(long{below(2)});
    const int h = between(1, 5 - factor.degree());
    std::array<RationalPolynomial, 3> axis = {integers(h, 8) + RationalPolynomial(12L),
                                              integers(h, 8), integers(h, 8)};
    const auto eighths = [&](int n) {
      return RationalPolynomial(Rational(long{n}) / Rational(8L));
    };
    const RationalPolynomial level =
        one_in(3) ? RationalPolynomial()
                  : axis[0] * eighths(between(-4, 4)) + axis[1] * eighths(between(-4, 4));
    for (RationalPolynomial& component : axis) component *= factor;
    return bezier("common factor", axis, level * factor, h + factor.degree() + 1);
  }

  std::mt19937_64 generator_;
};

}  // namespace pn::test
