// SPDX-License-Identifier: LGPL-2.1-or-later
// Wavefronts of light that a spline surface reflects.
#include "pn/bezier/rational_source.hpp"
#include "pn/shapes/mirror.hpp"
#include "surface_or_error.hpp"

namespace {

using namespace pn;

Light light_of(fuzz::FuzzInput& input) {
  if (input.flag()) return PointLight{input.point<3>()};
  return ParallelLight{input.point<3>(), input.point<3>()};
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzz::FuzzInput input(data, size);
  return fuzz::expect_result_or_error([&] {
    const Light light = light_of(input);
    const auto [patches, leaving, notes] = mirror_wavefronts(input.spline_surface({2, 2}), light);
    fuzz::check_surface(PNSurface(std::make_shared<const RationalSource>(patches, leaving, notes)),
                        input);
  });
}
