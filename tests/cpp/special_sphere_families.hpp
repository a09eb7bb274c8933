// SPDX-License-Identifier: LGPL-2.1-or-later
// Special families of six spheres: those for which the general construction has no chart, and those
// whose charts meet a base point in a special place.
#pragma once

#include <array>
#include <functional>
#include <string>
#include <vector>

#include "random_sphere_families.hpp"

namespace pn::test {

/// (m, r) by (u, v). All values at multiples of 1/4 are exact in doubles.
using SphereFunction = std::function<std::array<double, 4>(double, double)>;

/// Of the quadratic polynomial f over the triangle with these corners u = 1, v = 1, w = 1.
inline ControlSpheres spheres_of(const SphereFunction& f,
                                 const std::array<std::array<double, 2>, 3>& corners = {
                                     {{1, 0}, {0, 1}, {0, 0}}}) {
  const auto at = [&](std::size_t i, std::size_t j) {
    return f((corners[i][0] + corners[j][0]) / 2, (corners[i][1] + corners[j][1]) / 2);
  };
  const auto control = [&](std::size_t i, std::size_t j) {
    const auto middle = at(i, j), a = at(i, i), b = at(j, j);
    std::array<double, 4> result;
    for (std::size_t c = 0; c < 4; ++c) result[c] = 2 * middle[c] - (a[c] + b[c]) / 2;
    return result;
  };
  return {at(0, 0), control(0, 1), at(1, 1), control(0, 2), control(1, 2), at(2, 2)};
}

struct NamedSpheres {
  std::string name;
  ControlSpheres spheres;
};

/// Both sheets have rational normals in (u, v).
inline std::vector<NamedSpheres> separated_spheres() {
  const auto bent = [](double u, double v) {
    return std::array{64 * u + 4 * v * v, 64 * v + 8 * u * v, 8 * u * u + 16 * u * v - 12 * v};
  };
  const auto with = [bent](double radius, double by_z) -> SphereFunction {
    return [=](double u, double v) {
      const auto m = bent(u, v);
      return std::array{m[0], m[1], m[2], radius + by_z * m[2]};
    };
  };
  return {{"a flat plate of constant thickness", spheres_of([](double u, double v) {
             return std::array{64 * u + 8 * v * v, 64 * v + 8 * u * v, 0.0, 3.0};
           })},
          {"a flat plate of linear thickness", spheres_of([](double u, double v) {
             const double x = 64 * u + 8 * v * v;
             return std::array{x, 64 * v + 8 * u * v, 0.0, 4 + x / 4};
           })},
          {"a plane in space and radius", spheres_of([](double u, double v) {
             return std::array{64 * u, 64 * v, 16 * u - 8 * v, 4 + 8 * u + 4 * v};
           })},
          {"spheres that touch one plane", spheres_of(with(16, 1))},
          {"spheres that touch one plane from the other side", spheres_of(with(16, -1))},
          {"spheres through one line", spheres_of([](double u, double v) {
             const double x = 1 + u, y = 0.75 * v;
             return std::array{(y * y - x * x) / 2, x * y, x, (x * x + y * y) / 2};
           })}};
}

/// Parabolic cylinders in space and radius: e = 0 for all w.
inline std::vector<NamedSpheres> developable_spheres() {
  const auto family = [](double l, double m) {
    return spheres_of([=](double u, double v) {
      const double p = l * u + m * v;
      return std::array{32 * p, 48 * v - 16 * u, 12 * p * p + 3 * v, 4 + p * p + v + u};
    });
  };
  return {{"a bent strip", family(1, 0)},
          {"a bent strip the other way", family(0, 1)},
          {"an oblique bent strip", family(1, 0.5)},
          {"an oblique bent strip that turns back", family(-1, 0.75)},
          {"a bent strip of constant thickness", spheres_of([](double u, double v) {
             return std::array{64 * u, 64 * v, 16 * u * u, 4.0};
           })}};
}

/// Spheres along whose line v = 0 one skin touches a plane, as a torus does on top: a base point of
/// the chart of normals. Where f is translational the root of the sextic is multiple.
inline std::vector<NamedSpheres> spheres_with_parabolic_line() {
  const SphereFunction translational = [](double u, double v) {
    return std::array{64 * u, 64 * v + 8 * u * u, -16 * v * v, 4.0};
  };
  const SphereFunction general = [](double u, double v) {
    return std::array{64 * u + u * u + 3 * u * v + v * v, 64 * v + 8 * u * u - 2 * u * v - v * v,
                      -u * u / 2 + 1.5 * u * v - 16 * v * v, 4 + u * u / 2 - 1.5 * u * v + v * v};
  };
  const std::vector<std::pair<std::string, std::array<std::array<double, 2>, 3>>> triangles = {
      {"across the triangle", {{{1, -0.5}, {0, 0.5}, {0, -0.25}}}},
      {"along an edge", {{{1, 0}, {0, 1}, {0, 0}}}},
      {"along a part of an edge's line", {{{1, 0}, {-0.25, 1}, {-0.25, 0}}}},
      {"through a corner only", {{{1, 0.5}, {0, 1}, {0, 0}}}},
      {"through a corner and the inside", {{{0.5, -1}, {1, 0.5}, {0, 0}}}}};
  std::vector<NamedSpheres> result;
  for (const auto& [where, corners] : triangles) {
    result.push_back({"translational, " + where, spheres_of(translational, corners)});
    result.push_back({"general, " + where, spheres_of(general, corners)});
  }
  return result;
}

}  // namespace pn::test
