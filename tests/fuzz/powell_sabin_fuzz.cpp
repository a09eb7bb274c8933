// SPDX-License-Identifier: LGPL-2.1-or-later
// Both skins of spheres with derivatives at the points of a triangulation.
#include "pn/bezier/spline_skin.hpp"
#include "pn/shapes/powell_sabin.hpp"
#include "surface_or_error.hpp"

namespace {

using namespace pn;

// A square of two triangles and a point beside it; spheres over the plane have an envelope near
// them.
constexpr std::array<std::array<double, 2>, 5> kPoints = {
    {{0, 0}, {8, 0}, {0, 8}, {8, 8}, {16, 4}}};
constexpr std::array<Triangle, 3> kTriangles = {{{0, 1, 2}, {1, 3, 2}, {1, 4, 3}}};

PlacedSphere sphere_near(const std::array<double, 2>& place, fuzz::FuzzInput& input) {
  PlacedSphere placed;
  placed.parameter = input.point_near(place);
  const auto [s, t] = placed.parameter;
  placed.sphere = input.point_near<4>({s, t, 0, 1});
  placed.derivatives[0] = input.point_near<4>({1, 0, 0, 0});
  placed.derivatives[1] = input.point_near<4>({0, 1, 0, 0});
  return placed;
}

PowellSabinFamily family_of(fuzz::FuzzInput& input) {
  std::vector<PlacedSphere> spheres;
  for (const auto& place : kPoints) spheres.push_back(sphere_near(place, input));
  std::vector<Triangle> triangles(kTriangles.begin(), kTriangles.begin() + 1 + input.choice(3));
  if (input.seldom()) triangles.back()[0] = static_cast<std::size_t>(input.choice(6));
  return powell_sabin_family(spheres, triangles);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzz::FuzzInput input(data, size);
  return fuzz::expect_result_or_error([&] {
    const Sheet sheet = input.flag() ? Sheet::kOuter : Sheet::kInner;
    const auto [spline, notes] = family_of(input);
    fuzz::check_surface(PNSurface(std::make_shared<const SplineSkin>(spline, sheet, notes)), input);
  });
}
