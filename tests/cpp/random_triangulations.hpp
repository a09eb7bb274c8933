// SPDX-License-Identifier: LGPL-2.1-or-later
// Random triangulations of a square with spheres and tangent planes, as a designer gives them.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

#include "pn/shapes/powell_sabin.hpp"

namespace pn::test {

struct SpheresOnTriangles {
  std::vector<PlacedSphere> spheres;
  std::vector<Triangle> triangles;

  PowellSabinFamily family() const { return powell_sabin_family(spheres, triangles); }
};

/// The parameter, sphere and derivatives of a mid-surface with a thickness.
template <class Surface>
PlacedSphere placed(const std::array<double, 2>& parameter, Surface&& surface) {
  const auto [sphere, by_s, by_t] = surface(parameter[0], parameter[1]);
  return {parameter, sphere, {by_s, by_t}};
}

/// A grid of squares over [0, 1]^2, each divided by one of its diagonals, with its inner points
/// moved by a part of their distance.
template <class Surface>
SpheresOnTriangles grid(std::size_t count, double moved, std::mt19937_64& random,
                        Surface&& surface) {
  const auto n = static_cast<double>(count);
  std::uniform_real_distribution<double> away(-moved / n, moved / n);
  SpheresOnTriangles result;
  for (std::size_t i = 0; i <= count; ++i) {
    for (std::size_t j = 0; j <= count; ++j) {
      std::array<double, 2> parameter = {static_cast<double>(i) / n, static_cast<double>(j) / n};
      if (0 < i && i < count) parameter[0] += away(random);
      if (0 < j && j < count) parameter[1] += away(random);
      result.spheres.push_back(placed(parameter, surface));
    }
  }
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t j = 0; j < count; ++j) {
      const std::size_t a = i * (count + 1) + j, b = a + count + 1, c = b + 1, d = a + 1;
      const bool rising = random() % 2 == 0;
      result.triangles.push_back(rising ? Triangle{a, b, c} : Triangle{a, b, d});
      result.triangles.push_back(rising ? Triangle{a, c, d} : Triangle{b, c, d});
    }
  }
  return result;
}

/// A dome over a square of this side [mm], in which no direction is special, and its derivatives.
struct Dome {
  double side = 100, height = 12, radius = 3, change = 1;

  std::array<std::array<double, 4>, 3> operator()(double s, double t) const {
    const double a = s - 0.5, b = t - 0.5, bent = a * a + 1.3 * b * b + 0.2 * a * b;
    const double bent_s = 2 * a + 0.2 * b, bent_t = 2.6 * b + 0.2 * a;
    // x and y bend a little as well, so that the centres lie on no graph of degree two.
    const double x = side * (s + 0.1 * a * b), y = side * (t - 0.05 * a * a * a);
    return {{{x, y, -height * std::sin(bent), radius + change * std::cos(3 * a) * b},
             {side * (1 + 0.1 * b), -0.15 * side * a * a, -height * std::cos(bent) * bent_s,
              -3 * change * std::sin(3 * a) * b},
             {0.1 * side * a, side, -height * std::cos(bent) * bent_t, change * std::cos(3 * a)}}};
  }
};

}  // namespace pn::test
