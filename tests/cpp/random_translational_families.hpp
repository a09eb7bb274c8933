// SPDX-License-Identifier: LGPL-2.1-or-later
// Random curves of spheres as designers make them, for plates of varying thickness.
#pragma once

#include <Eigen/Dense>
#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <cstdint>
#include <random>
#include <sstream>
#include <string>
#include <vector>

#include "pn/shapes/translational_spheres.hpp"

namespace pn::test {

/// Two curves of about one length [mm] that cross at 50 to 75 degrees, each bent out of the plane
/// of both by its sag; clamped splines of simple knots.
class RandomTranslation {
 public:
  explicit RandomTranslation(std::uint64_t seed, int most_spans = 1) : random_(seed) {
    using Eigen::Vector3d;
    side_ = std::pow(10.0, uniform(0, 3));
    const double angle = uniform(0.87, 1.31);
    const Eigen::Quaterniond turn =
        Eigen::Quaterniond(normal(), normal(), normal(), normal()).normalized();
    const bool is_constant = random_() % 8 == 0;
    const auto spans = [&] {
      return 1 + static_cast<int>(random_() % static_cast<unsigned>(most_spans));
    };
    c_ = curve(turn * Vector3d(side_, 0, 0), turn * Vector3d::UnitZ(), spans(), is_constant);
    d_ = curve(turn * Vector3d(side_ * std::cos(angle), side_ * std::sin(angle), 0),
               turn * Vector3d::UnitZ(), spans(), is_constant);
  }

  double side() const { return side_; }
  const BSplineData<4>& c() const { return c_; }
  const BSplineData<4>& d() const { return d_; }
  TranslationalSpheres spheres() const {
    return translational_spheres(SphereSpline::bspline(c_), SphereSpline::bspline(d_));
  }

 private:
  /// Biased to what is hard: domes, saddles, nearly flat curves, lines, constant radius.
  BSplineData<4> curve(const Eigen::Vector3d& chord, const Eigen::Vector3d& up, int spans,
                       bool is_constant) {
    const std::array<double, 6> sags = {0.05, -0.05, 0.005, 0.15, -0.15, 0};
    const double sag = side_ * sags[random_() % sags.size()];
    const bool is_line = sag == 0 && random_() % 2 == 0;
    BSplineData<4> data;
    data.degree = 2;
    const int poles = spans + 2;
    const double radius = side_ * uniform(0.005, 0.03);
    for (int k = 0; k <= spans; ++k) {
      data.knots.push_back(k);
      data.multiplicities.push_back(k == 0 || k == spans ? 3 : 1);
    }
    for (int k = 0; k < poles; ++k) {
      // Greville abscissae: a straight curve has constant speed.
      const double at = k == 0 ? 0 : k == poles - 1 ? 1 : (k - 0.5) / spans;
      Eigen::Vector3d m = at * chord + sag * 4 * at * (1 - at) * up;
      double r = radius;
      if (!is_line && k != 0 && k != poles - 1) {
        const double part = 0.03 * side_ / spans / spans;
        m += part * Eigen::Vector3d(normal(), normal(), normal());
      }
      if (!is_constant && !is_line) r *= uniform(0.75, 1.25);
      data.poles.push_back({m.x(), m.y(), m.z(), r});
    }
    return data;
  }
  double uniform(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random_);
  }
  double normal() { return std::normal_distribution<double>()(random_); }

  std::mt19937_64 random_;
  double side_;
  BSplineData<4> c_, d_;
};

inline std::string text(const RandomTranslation& translation) {
  std::ostringstream out;
  out.precision(17);
  for (const auto* curve : {&translation.c(), &translation.d()}) {
    for (const auto& s : curve->poles) {
      out << "(" << s[0] << ", " << s[1] << ", " << s[2] << "; " << s[3] << ") ";
    }
    out << "\n";
  }
  return out.str();
}

/// The family of two Bezier curves of three spheres (x, y, z, r) each.
inline TranslationalFamily family_of(const std::array<std::array<double, 4>, 3>& c,
                                     const std::array<std::array<double, 4>, 3>& d) {
  const auto parabola = [](const std::array<std::array<double, 4>, 3>& b) {
    SphereParabola result;
    for (std::size_t i = 0; i < 4; ++i) {
      const auto pole = [&](std::size_t k) {
        return Rational::exactly(i == 3 ? -b[k][i] : b[k][i]);
      };
      const Rational two(2L);
      result.start[i] = pole(0);
      result.first[i] = two * (pole(1) - pole(0));
      result.second[i] = two * (pole(0) - two * pole(1) + pole(2));
    }
    return result;
  };
  return {parabola(c), parabola(d)};
}

}  // namespace pn::test
