// SPDX-License-Identifier: LGPL-2.1-or-later
// Ellipses around a spine, and conics from their vertex on it.
#include "pn/bezier/conic_source.hpp"
#include "pn/shapes/conic_section.hpp"
#include "surface_or_error.hpp"

namespace {

using namespace pn;

SectionPlanes planes_of(fuzz::FuzzInput& input) {
  const std::array<double, 3> up = input.point<3>();
  switch (input.choice(3)) {
    case 0:
      return {up, PerpendicularPlanes{}};
    case 1:
      return {up, UprightPlanes{}};
    default:
      return {up, ParallelPlanes{input.point<3>()}};
  }
}

ConicSection section_of(fuzz::FuzzInput& input) {
  constexpr fuzz::SplineSize kSize{2, 2};
  if (input.flag()) return HalfAxes{input.law(kSize), input.law(kSize)};
  return VertexForm{input.law(kSize), input.law(kSize), input.law(kSize)};
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzz::FuzzInput input(data, size);
  return fuzz::expect_result_or_error([&] {
    const Curve spine = input.curve({2, 2});
    const SectionPlanes planes = planes_of(input);
    const auto spans = moving_conic_section(spine, planes, section_of(input));
    fuzz::check_surface(PNSurface(std::make_shared<const ConicSource>(spans)), input);
  });
}
