// SPDX-License-Identifier: LGPL-2.1-or-later
// Random families of six spheres as designers make them: bent plates of varying thickness.
#pragma once

#include <Eigen/Dense>
#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <cstdint>
#include <random>
#include <sstream>
#include <string>

#include "pn/isotropic/quadratic_family.hpp"

namespace pn::test {

using ControlSpheres = std::array<std::array<double, 4>, 6>;

/// A triangle with two sides of about this length [mm] and an angle of 50 to 75 degrees between
/// them; the middle control points are moved in its plane, and out of it by the sag.
class RandomSphereFamily {
 public:
  explicit RandomSphereFamily(std::uint64_t seed) : random_(seed) {}

  /// Biased to what is hard: nearly flat plates, one flat direction, constant radius, round
  /// numbers.
  ControlSpheres spheres() {
    using Eigen::Vector3d;
    const double side = std::pow(10.0, uniform(0, 3)), angle = uniform(0.87, 1.31);
    const Vector3d u(side, 0, 0), w(0, 0, 0), v(side * std::cos(angle), side * std::sin(angle), 0);
    std::array<Vector3d, 6> centre = {u, (u + v) / 2, v, (u + w) / 2, (v + w) / 2, w};
    const std::array<double, 5> sags = {0.05, 0.05, 0.005, 0.15, 0.25};
    const double sag = side * sags[random_() % sags.size()];
    const int shape = static_cast<int>(random_() % 4);
    for (const std::size_t i : {1, 3, 4}) {
      centre[i] += 0.03 * side * Vector3d(normal(), normal(), 0);
      centre[i].z() += sag * height(shape, i);
    }
    const bool constant = random_() % 8 == 0;
    const double radius = side * uniform(0.01, 0.06);
    const Eigen::Quaterniond turn =
        Eigen::Quaterniond(normal(), normal(), normal(), normal()).normalized();
    ControlSpheres result;
    for (std::size_t i = 0; i < 6; ++i) {
      const Vector3d m = random_() % 2 == 0 || shape > 0 ? Vector3d(turn * centre[i]) : centre[i];
      result[i] = {m.x(), m.y(), m.z(), constant ? radius : radius * uniform(0.75, 1.25)};
    }
    return result;
  }

 private:
  /// Of the middle of an edge, in sags: domes, saddles, anything, nearly a cylinder.
  double height(int shape, std::size_t i) {
    switch (shape) {
      case 0:
        return uniform(0.5, 1.5);
      case 1:
        return i == 1 ? uniform(-1.5, -0.5) : uniform(0.5, 1.5);
      case 2:
        return normal();
      default:
        return i == 3 ? 1.0 : uniform(-0.1, 0.1);
    }
  }
  double uniform(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random_);
  }
  double normal() { return std::normal_distribution<double>()(random_); }

  std::mt19937_64 random_;
};

inline std::string text(const ControlSpheres& spheres) {
  std::ostringstream out;
  out.precision(17);
  for (const auto& s : spheres) {
    out << "(" << s[0] << ", " << s[1] << ", " << s[2] << "; " << s[3] << ") ";
  }
  return out.str();
}

/// The family without the checks of a shape.
inline QuadraticFamily family_of(const ControlSpheres& spheres) {
  QuadraticFamily::Control control;
  for (std::size_t i = 0; i < 6; ++i) {
    for (std::size_t c = 0; c < 4; ++c) control[i][c] = Rational::exactly(spheres[i][c]);
    control[i][3] = -control[i][3];
  }
  return QuadraticFamily(std::move(control));
}

/// (m, -r) and its derivatives by de Casteljau's algorithm: a route of its own.
struct SphereJet {
  MinkowskiVector<Rational> value, by_u, by_v;
};

inline SphereJet jet(const QuadraticFamily& family, const Rational& u, const Rational& v) {
  const auto& [b200, b110, b020, b101, b011, b002] = family.control();
  const Rational w = Rational(1L) - u - v;
  SphereJet result;
  for (std::size_t c = 0; c < 4; ++c) {
    const Rational at_u = u * b200[c] + v * b110[c] + w * b101[c],
                   at_v = u * b110[c] + v * b020[c] + w * b011[c],
                   at_w = u * b101[c] + v * b011[c] + w * b002[c];
    result.value[c] = u * at_u + v * at_v + w * at_w;
    result.by_u[c] = Rational(2L) * (at_u - at_w);
    result.by_v[c] = Rational(2L) * (at_v - at_w);
  }
  return result;
}

}  // namespace pn::test
