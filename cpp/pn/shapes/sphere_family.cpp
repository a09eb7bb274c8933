// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/shapes/sphere_family.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "pn/geometry_error.hpp"
#include "pn/input_numbers.hpp"

namespace pn {
namespace {

using Spheres = std::array<std::array<double, 4>, 6>;

/// All centres lie on one line, or in one point.
bool are_collinear(const QuadraticFamily::Control& control) {
  const auto from_first = [&](std::size_t i) {
    return std::array{control[i][0] - control[0][0], control[i][1] - control[0][1],
                      control[i][2] - control[0][2]};
  };
  for (std::size_t i = 1; i < 6; ++i) {
    for (std::size_t j = i + 1; j < 6; ++j) {
      const auto a = from_first(i), b = from_first(j);
      for (std::size_t c = 0; c < 3; ++c) {
        const std::size_t d = (c + 1) % 3;
        if (!(a[c] * b[d] - a[d] * b[c]).is_zero()) return false;
      }
    }
  }
  return true;
}

/// Quarterings by which a refusal tells how much of the triangle has an envelope.
constexpr int kRegionHalvings = 5;

/// Of the whole triangle, in percent, rounded down.
int share(const std::vector<FamilyPart>& parts) {
  double area = 0;
  for (const FamilyPart& part : parts) {
    const auto& [a, b, c] = part.corners;
    area += std::abs((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]));
  }
  return static_cast<int>(100 * area);
}

/// Which part of the triangle has an envelope, as a sentence.
std::string extent(const RealRegion& region) {
  if (region.real.empty()) return " No part of the triangle was found that has one.";
  return " At least " + std::to_string(share(region.real)) +
         " % of the triangle has one, and at least " + std::to_string(share(region.unreal)) +
         " % has none.";
}

void check_envelope(const QuadraticFamily& family) {
  const auto place = unreal_place(family);
  if (!place) return;
  char where[80];
  std::snprintf(where, sizeof where, "(u, v) = (%.3g, %.3g)", (*place)[0], (*place)[1]);
  const auto corner = [&](double u, double v) { return (*place)[0] == u && (*place)[1] == v; };
  std::string near = corner(1, 0)   ? ", at the first corner"
                     : corner(0, 1) ? ", at the second corner"
                     : corner(0, 0) ? ", at the third corner"
                                    : "";
  throw GeometryError(ErrorCode::kRadiusTooSteep,
                      std::string("The spheres have no envelope near ") + where + near +
                          ": the radius changes at least as fast as the centre moves, so one "
                          "sphere swallows its neighbours." +
                          extent(real_region(family, kRegionHalvings)));
}

}  // namespace

QuadraticFamily quadratic_family(const Spheres& control_spheres) {
  QuadraticFamily::Control control;
  for (std::size_t i = 0; i < 6; ++i) {
    const auto& sphere = control_spheres[i];
    require_input_numbers(sphere, "A number of a sphere");
    for (std::size_t c = 0; c < 4; ++c) control[i][c] = Rational::exactly(sphere[c]);
    control[i][3] = -control[i][3];
  }
  return QuadraticFamily(std::move(control));
}

SphereFamily sphere_family(const Spheres& control_spheres) {
  SphereFamily result{quadratic_family(control_spheres), {}};
  if (are_collinear(result.family.control())) {
    throw GeometryError(ErrorCode::kZeroLength,
                        "The centres of the six spheres lie on one line, so they are no "
                        "mid-surface.");
  }
  check_envelope(result.family);
  const bool equal_radii =
      std::all_of(control_spheres.begin(), control_spheres.end(),
                  [&](const auto& sphere) { return sphere[3] == control_spheres[0][3]; });
  if (equal_radii) {
    result.notes.emplace_back("All radii are equal: the skins are the offsets of the mid-surface.");
  }
  return result;
}

}  // namespace pn
