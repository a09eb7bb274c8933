// SPDX-License-Identifier: LGPL-2.1-or-later
// Both skins of a curve of spheres that is translated along another one.
#include "pn/bezier/translational_skin.hpp"
#include "pn/shapes/translational_spheres.hpp"
#include "surface_or_error.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace pn;
  fuzz::FuzzInput input(data, size);
  return fuzz::expect_result_or_error([&] {
    const Sheet sheet = input.flag() ? Sheet::kOuter : Sheet::kInner;
    const SphereSpline c = input.sphere_spline({2, 2}), d = input.sphere_spline({2, 2});
    const auto [spline, notes] = translational_spheres(c, d);
    fuzz::check_surface(PNSurface(std::make_shared<const TranslationalSkin>(spline, sheet, notes)),
                        input);
  });
}
