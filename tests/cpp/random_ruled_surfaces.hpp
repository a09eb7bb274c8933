// SPDX-License-Identifier: LGPL-2.1-or-later
// Random pairs of curves and radius laws, biased to the degeneracies of ruled surfaces.
//
// Every input is a function of its seed, and its numbers are short binary fractions unless stated,
// so that torsal rulings, closed curves and parallel tangents are what they are exactly.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <ostream>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "pn/algebra/bernstein.hpp"
#include "pn/algebra/rational_polynomial.hpp"
#include "pn/algebra/roots.hpp"
#include "pn/bezier/bspline_surface.hpp"
#include "pn/shapes/curve.hpp"
#include "spline_output.hpp"

namespace pn::test {

struct RuledInput {
  std::string kind;
  std::array<BSplineData<3>, 2> curves;
  std::optional<std::array<BSplineData<1>, 2>> radii;  ///< of the spheres that cones join
};

inline std::ostream& operator<<(std::ostream& out, const RuledInput& input) {
  const std::streamsize digits = out.precision(17);
  out << input.kind << "\nfirst  " << input.curves[0] << "\nsecond " << input.curves[1];
  if (input.radii) out << "\nradii  " << (*input.radii)[0] << "\n       " << (*input.radii)[1];
  out.precision(digits);
  return out;
}

class RandomRuledSurface {
 public:
  explicit RandomRuledSurface(std::uint64_t seed) : generator_(seed) {}

  RuledInput input() {
    switch (below(12)) {
      case 0:
        return rescaled(torsal_inside());
      case 1:
        return rescaled(two_torsal_rulings());
      case 2:
        return rescaled(parallel_end_tangents());
      case 3:
        return closed_cubics();
      case 4:
        return circles();
      case 5:
        return rescaled(common_factor());
      case 6:
        return rescaled(cones());
      default:
        return rescaled(planted(open_splines()));
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

  /// A C1 B-spline over [begin, end] that runs from `start` along x, by `stride` in all.
  BSplineData<3> open_spline(int degree, int spans, double begin, double end, const Point& start,
                             double stride) {
    BSplineData<3> curve;
    curve.degree = degree;
    const int most = std::max(1, degree - 1);
    if (degree == 1) spans = 1;
    for (int i = 0; i <= spans; ++i) {
      const bool is_end = i == 0 || i == spans;
      // Sixteenths of the domain, unevenly.
      const double part = is_end ? i / spans : (16 * i / spans + below(2)) / 16.0;
      curve.knots.push_back(begin + part * (end - begin));
      curve.multiplicities.push_back(is_end ? degree + 1 : one_in(3) ? most : 1);
    }
    const std::size_t count = pole_count(degree, curve.multiplicities);
    // A short binary fraction, as are all numbers here.
    const double step = std::ldexp(std::round(std::ldexp(stride / (count - 1.0), 6)), -6);
    const double roughness = step * between(0, 4) / 8.0;
    for (std::size_t i = 0; i < count; ++i) {
      Point pole = noise_point(roughness);
      pole[0] += step * static_cast<double>(i);
      for (std::size_t c = 0; c < 3; ++c) pole[c] += start[c];
      curve.poles.push_back(pole);
    }
    return curve;
  }

  std::vector<double> weights(std::size_t count) {
    std::vector<double> result;
    for (std::size_t i = 0; i < count; ++i) result.push_back(between(4, 16) / 8.0);
    return result;
  }

  /// Degrees 1 to 4 on each side, one to six spans, the same knots or others, rational or not.
  RuledInput open_splines() {
    const int p = between(1, 4), q = one_in(2) ? p : between(1, 4);
    const int spans = one_in(3) ? between(2, 6) : 1;
    const double begin = noise(1), stride = 8;
    RuledInput input{"open splines", {}, {}};
    input.curves[0] = open_spline(p, spans, begin, begin + 2, {0, 0, 0}, stride);
    const Point across = {noise(2), 4 + noise(2), noise(4)};
    if (one_in(3)) {
      input.kind += ", other domain";
      const double other = noise(4);
      // An odd length makes breaks that are no doubles in the first curve's domain.
      input.curves[1] =
          open_spline(q, between(1, 3), other, other + between(1, 5), across, stride + noise(4));
    } else {
      input.curves[1] = open_spline(q, p == q ? spans : between(1, 3), begin, begin + 2, across,
                                    stride + noise(4));
      if (p == q && one_in(2)) {
        input.curves[1].knots = input.curves[0].knots;
        if (input.curves[1].poles.size() == input.curves[0].poles.size()) {
          input.curves[1].multiplicities = input.curves[0].multiplicities;
        }
      }
    }
    if (p <= 3 && one_in(3)) {
      input.kind += ", rational";
      input.curves[0].weights = weights(input.curves[0].poles.size());
      const bool same = input.curves[0].poles.size() == input.curves[1].poles.size();
      if (same && one_in(2)) {
        input.curves[1].weights = input.curves[0].weights;
      } else if (q <= 2 && one_in(2)) {
        input.curves[1].weights = weights(input.curves[1].poles.size());
      }
    }
    return input;
  }

  RuledInput planted(RuledInput input) {
    if (one_in(4)) {
      input.kind += ", planar directrices";
      const double height = noise(4);
      for (Point& pole : input.curves[0].poles) pole[2] = 0;
      for (Point& pole : input.curves[1].poles) pole[2] = height;
    }
    if (one_in(6)) {
      input.kind += ", a straight directrix";
      BSplineData<3>& curve = input.curves[0];
      const Point direction = {1, noise(0.5), noise(0.5)};
      for (std::size_t i = 0; i < curve.poles.size(); ++i) {
        for (std::size_t c = 0; c < 3; ++c) {
          curve.poles[i][c] = 2 * static_cast<double>(i) * direction[c];
        }
      }
    }
    if (one_in(6)) {
      input.kind += ", full doubles";
      for (BSplineData<3>& curve : input.curves) {
        for (Point& pole : curve.poles) {
          for (double& x : pole) x += noise(1) * M_PI / 64;
        }
      }
    }
    return input;
  }

  RuledInput rescaled(RuledInput input) {
    if (one_in(2)) {
      input.kind += ", sides exchanged";
      std::swap(input.curves[0], input.curves[1]);
      if (input.radii) std::swap((*input.radii)[0], (*input.radii)[1]);
    }
    if (!one_in(6)) return input;
    const int exponent = between(-12, 14);
    input.kind += ", scaled by 2^" + std::to_string(exponent);
    for (BSplineData<3>& curve : input.curves) {
      for (Point& pole : curve.poles) {
        for (double& x : pole) x = std::ldexp(x, exponent);
      }
    }
    if (!input.radii) return input;
    for (BSplineData<1>& law : *input.radii) {
      for (auto& pole : law.poles) pole[0] = std::ldexp(pole[0], exponent);
    }
    return input;
  }

  RationalPolynomial integers(int degree, int most) {
    std::vector<Rational> coefficients;
    for (int i = 0; i <= degree; ++i)
      coefficients.emplace_back(static_cast<long>(between(-most, most)));
    return RationalPolynomial(coefficients);
  }

  /// A Bezier curve whose coordinates are these polynomials; all poles are exact when the
  /// coefficients are multiples of the binomials up to `degree`.
  static BSplineData<3> bezier(const std::array<RationalPolynomial, 3>& coordinates, int degree) {
    BSplineData<3> curve{degree, {0, 1}, {degree + 1, degree + 1}, {}, {}};
    curve.poles.resize(static_cast<std::size_t>(degree) + 1);
    for (std::size_t c = 0; c < 3; ++c) {
      const auto bernstein = to_bernstein(coefficients(coordinates[c], degree));
      for (std::size_t i = 0; i < bernstein.size(); ++i) {
        curve.poles[i][c] = bernstein[i].to_double();
      }
    }
    return curve;
  }

  static std::array<RationalPolynomial, 3> sum(std::array<RationalPolynomial, 3> a,
                                               const std::array<RationalPolynomial, 3>& b) {
    for (std::size_t i = 0; i < 3; ++i) a[i] += b[i];
    return a;
  }

  /// g and g' span a' at a parameter of sixteenths in (0, 1): one torsal ruling there.
  RuledInput torsal_inside() {
    const Rational at = Rational(static_cast<long>(between(1, 15))) / Rational(16);
    const RationalPolynomial from({-at, Rational(1)}), three(3L);
    std::array<RationalPolynomial, 3> a, g;
    const long tilt = between(-1, 1), along = between(-1, 1);
    for (std::size_t i = 0; i < 3; ++i) {
      a[i] = three * integers(one_in(2) ? 3 : 2, 2);
      if (i == 0) a[i] += RationalPolynomial({Rational(0), Rational(24)});
      const Rational ruling(static_cast<long>(i == 1 ? 24 : 3 * between(-4, 4)));
      const Rational slope = Rational(tilt) * ruling + Rational(along) * a[i].derivative()(at);
      g[i] = RationalPolynomial(ruling) + from * RationalPolynomial(slope) +
             three * from * from * integers(0, 2);
    }
    return {"a torsal ruling inside", {bezier(a, 3), bezier(sum(a, g), 3)}, {}};
  }

  /// On a straight directrix with g = (., 1, z) the torsion is z', with zeros at two places of one
  /// span, or with a double one.
  RuledInput two_torsal_rulings() {
    const int first = between(1, 7), second = one_in(8) ? first : between(first, 8);
    const auto root = [](int eighths) {
      return RationalPolynomial({Rational(long{-eighths}), Rational(8L)});
    };
    const RationalPolynomial slope = root(first) * root(second);
    RationalPolynomial z(long{between(-3, 3)});
    std::vector<Rational> power = {Rational(0)};
    for (int i = 0; i <= slope.degree(); ++i) {
      power.push_back(slope.coefficient(i) * Rational(3) / Rational(long{8 * (i + 1)}));
    }
    z += RationalPolynomial(power);
    const std::array<RationalPolynomial, 3> line = {RationalPolynomial({Rational(0), Rational(24)}),
                                                    0L, 0L};
    const std::array<RationalPolynomial, 3> g = {RationalPolynomial(3L) * integers(3, 2), 24L, z};
    return {"two torsal rulings", {bezier(line, 1), bezier(sum(line, g), 3)}, {}};
  }

  /// The tangents of both curves are parallel at one end or both.
  RuledInput parallel_end_tangents() {
    RuledInput input{"parallel end tangents", {}, {}};
    const bool rounded = one_in(4);
    const int degree = between(2, 3), spans = between(1, 3);
    input.curves[0] = open_spline(degree, spans, 0, 2, {0, 0, 0}, 8);
    input.curves[1] =
        open_spline(degree, spans, 0, 2, {noise(1), 4 + noise(1), noise(3)}, 8 + noise(3));
    const auto make_parallel = [&](std::size_t end, std::size_t beside_a, std::size_t beside_b,
                                   std::size_t end_b) {
      auto &a = input.curves[0].poles, &b = input.curves[1].poles;
      // A factor of many digits leaves the tangents parallel but for the rounding of the poles.
      const double factor = rounded ? between(3, 6) * M_PI / 12 : between(3, 6) / 4.0;
      for (std::size_t c = 0; c < 3; ++c) {
        b[beside_b][c] = b[end_b][c] + factor * (a[beside_a][c] - a[end][c]);
      }
    };
    const std::size_t last_a = input.curves[0].poles.size() - 1,
                      last_b = input.curves[1].poles.size() - 1;
    const int which = between(1, 3);
    if (which & 1) make_parallel(0, 1, 1, 0);
    if (which & 2) make_parallel(last_a, last_a - 1, last_b - 1, last_b);
    return input;
  }

  /// On the first of two C2 spans the rulings have a common factor, which vanishes beside it: their
  /// length varies, their lines are of lower degree.
  RuledInput common_factor() {
    const RationalPolynomial factor(
        {Rational(long{between(1, 3)}), Rational(long{between(-3, 3)})});
    if (!is_positive_on_unit_interval(factor)) return torsal_inside();
    const auto quadratic = [&](long constant) {
      return RationalPolynomial(6L) * (integers(2, 1) + RationalPolynomial(constant));
    };
    const std::array<RationalPolynomial, 3> a = {quadratic(0) + RationalPolynomial(
                                                                    {Rational(0), Rational(24)}),
                                                 quadratic(0), quadratic(0)},
                                            g = {factor * quadratic(0), factor * quadratic(4),
                                                 factor * quadratic(0)};
    RuledInput input{"a common factor of the rulings", {}, {}};
    const std::array<BSplineData<3>, 2> first = {bezier(a, 3), bezier(sum(a, g), 3)};
    for (std::size_t side = 0; side < 2; ++side) {
      // C2 at the joint of two equal spans: the last pole is free.
      const auto& p = first[side].poles;
      BSplineData<3> curve{3, {0, 1, 2}, {4, 3, 4}, p, {}};
      Point one, two, three;
      for (std::size_t c = 0; c < 3; ++c) {
        one[c] = 2 * p[3][c] - p[2][c];
        two[c] = p[1][c] - 4 * p[2][c] + 4 * p[3][c];
        three[c] = 2 * two[c] - one[c] + noise(4);
      }
      curve.poles.insert(curve.poles.end(), {one, two, three});
      input.curves[side] = curve;
    }
    return input;
  }

  /// A uniform periodic cubic spline, written in its Bezier points: closed and C2 exactly.
  BSplineData<3> closed_cubic(int count, double radius, double height, double roughness) {
    std::vector<Point> controls;
    // Multiples of 6 / 64, so that the Bezier points are binary fractions.
    const auto on_grid = [](double x) { return 6 * std::round(x * 64 / 6) / 64; };
    for (int i = 0; i < count; ++i) {
      const double angle = 2 * M_PI * i / count;
      controls.push_back({on_grid(radius * std::cos(angle) + noise(roughness)),
                          on_grid(radius * std::sin(angle) + noise(roughness)),
                          on_grid(height + noise(roughness))});
    }
    BSplineData<3> curve{3, {}, {}, {}, {}};
    const auto add = [&](int a, int b, int c, int wa, int wb, int wc) {
      Point mean;
      for (std::size_t i = 0; i < 3; ++i) {
        mean[i] = (wa * controls[static_cast<std::size_t>(a % count)][i] +
                   wb * controls[static_cast<std::size_t>(b % count)][i] +
                   wc * controls[static_cast<std::size_t>(c % count)][i]) /
                  (wa + wb + wc);
      }
      curve.poles.push_back(mean);
    };
    for (int i = 0; i <= count; ++i) {
      curve.knots.push_back(i);
      curve.multiplicities.push_back(i == 0 || i == count ? 4 : 3);
      add(i + count - 1, i, i + 1, 1, 4, 1);
      if (i == count) break;
      add(i, i + 1, i, 2, 1, 0);
      add(i, i + 1, i, 1, 2, 0);
    }
    return curve;
  }

  RuledInput closed_cubics() {
    const int count = between(4, 6);
    return {"closed cubics",
            {closed_cubic(count, 10, 0, 1), closed_cubic(count, 8 + noise(1), 6, 1)},
            {}};
  }

  /// One to four exact quarter circles in parallel planes: the second one turned by a quarter, or
  /// tilted. Four are closed.
  RuledInput circles() {
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
    const double radius = between(8, 64) / 8.0, tilt = one_in(2) ? 0 : noise(2);
    RuledInput input{"circles", {}, {}};
    const auto circle = [&](int turn, double r, double height, double slope) {
      BSplineData<3> curve{2, {}, {}, {}, {}};
      for (int i = 0; i <= arcs; ++i) {
        curve.knots.push_back(i);
        curve.multiplicities.push_back(i == 0 || i == arcs ? 3 : 2);
      }
      for (int i = 0; i <= 2 * arcs; ++i) {
        const Point& p = square[static_cast<std::size_t>((i + 2 * turn) % 8)];
        curve.poles.push_back({r * p[0], r * p[1], height + slope * p[0]});
        curve.weights.push_back(i % 4 == 2 ? 2 : 1);
      }
      return curve;
    };
    input.curves = {circle(0, radius, 0, 0),
                    circle(between(0, 1), radius * between(4, 12) / 8, radius, tilt)};
    return input;
  }

  /// Spheres of radii that vary along both curves, mostly over one span, rational or not.
  RuledInput cones() {
    RuledInput input{"cones", {}, std::array<BSplineData<1>, 2>()};
    const int spans = one_in(4) ? 2 : 1;
    const bool rational = one_in(3);
    if (spans > 1) input.kind += ", several spans";
    if (rational) input.kind += ", rational";
    const double steepness = one_in(4) ? 0.75 : 0.25;
    for (std::size_t side = 0; side < 2; ++side) {
      const Point start = side == 0 ? Point{0, 0, 0} : Point{noise(2), 4 + noise(2), noise(4)};
      BSplineData<3>& curve = input.curves[side];
      curve = open_spline(between(1, 2), spans, 0, 2, start, 8);
      if (rational) curve.weights = weights(curve.poles.size());
      BSplineData<1> law{curve.degree, curve.knots, curve.multiplicities, {}, {}};
      if (rational && one_in(2)) law.weights = curve.weights;
      const double least = 1 + noise(0.5), step = 8 / (static_cast<double>(curve.poles.size()) - 1);
      for (std::size_t i = 0; i < curve.poles.size(); ++i) {
        law.poles.push_back({std::abs(least + noise(steepness * step))});
      }
      (*input.radii)[side] = law;
    }
    return input;
  }

  std::mt19937_64 generator_;
};

}  // namespace pn::test
