// SPDX-License-Identifier: LGPL-2.1-or-later
// Canal surfaces of a spine and a radius law.
#include "pn/shapes/canal_surface.hpp"
#include "surface_or_error.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace pn;
  fuzz::FuzzInput input(data, size);
  return fuzz::expect_result_or_error([&] {
    const Curve spine = input.curve({3, 3});
    const Law radius = input.law({2, 3});
    fuzz::check_surface(PNSurface(canal_surface(spine, radius)), input);
  });
}
