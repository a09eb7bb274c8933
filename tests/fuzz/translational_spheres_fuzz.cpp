// SPDX-License-Identifier: LGPL-2.1-or-later
// Both skins of a curve of spheres that is translated along another one.
#include "pn/bezier/translational_skin.hpp"
#include "pn/shapes/translational_spheres.hpp"
#include "surface_or_error.hpp"

namespace {

/// Near spheres in a row along an axis, so that there often is an envelope.
pn::SphereSpline spheres_along(std::size_t axis, pn::fuzz::FuzzInput& input) {
  auto data = input.bspline<4>({2, 2});
  for (std::size_t i = 0; i < data.poles.size(); ++i) {
    for (double& x : data.poles[i]) x /= 8;
    data.poles[i][axis] += 8.0 * static_cast<double>(i);
  }
  return pn::SphereSpline::bspline(data);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace pn;
  fuzz::FuzzInput input(data, size);
  return fuzz::expect_result_or_error([&] {
    const Sheet sheet = input.flag() ? Sheet::kOuter : Sheet::kInner;
    const SphereSpline c = spheres_along(0, input), d = spheres_along(1, input);
    const auto [spline, notes] = translational_spheres(c, d);
    fuzz::check_surface(PNSurface(std::make_shared<const TranslationalSkin>(spline, sheet, notes)),
                        input);
  });
}
