// SPDX-License-Identifier: LGPL-2.1-or-later
// Both skins of spheres with derivatives at the points of a triangulation.
#include "pn/bezier/spline_skin.hpp"
#include "pn/shapes/powell_sabin.hpp"
#include "surface_or_error.hpp"

namespace {

using namespace pn;

PowellSabinFamily family_of(fuzz::FuzzInput& input) {
  std::vector<PlacedSphere> spheres(static_cast<std::size_t>(3 + input.choice(3)));
  for (PlacedSphere& placed : spheres) {
    placed.parameter = input.point<2>();
    placed.sphere = input.point<4>();
    placed.derivatives = {input.point<4>(), input.point<4>()};
  }
  std::vector<Triangle> triangles(static_cast<std::size_t>(1 + input.choice(3)));
  for (Triangle& triangle : triangles) {
    for (std::size_t& corner : triangle) corner = static_cast<std::size_t>(input.choice(6));
  }
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
