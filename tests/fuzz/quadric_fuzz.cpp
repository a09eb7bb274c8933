// SPDX-License-Identifier: LGPL-2.1-or-later
// Quadrics of every kind within bounds.
#include "pn/shapes/quadric.hpp"
#include "surface_or_error.hpp"

namespace {

using pn::fuzz::FuzzInput;

/// One in four is infinite at an end.
pn::Interval interval(FuzzInput& input) {
  pn::Interval result;
  if (input.choice(4) < 3) result.low = input.number();
  if (input.choice(4) < 3) result.high = input.number();
  return result;
}

pn::QuadricBounds bounds(FuzzInput& input) {
  pn::QuadricBounds result;
  for (pn::Interval& side : result.box) {
    if (input.flag()) side = interval(input);
  }
  if (input.flag()) result.angle = interval(input);
  return result;
}

double half_axis(FuzzInput& input) {
  return input.choice(16) == 15 ? input.number() : (1 + input.choice(16)) / 2.0;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  FuzzInput input(data, size);
  return pn::fuzz::expect_result_or_error([&] {
    const auto kind = static_cast<pn::QuadricKind>(input.choice(8));
    const std::array half_axes = {half_axis(input), half_axis(input), half_axis(input)};
    pn::fuzz::check_surface(pn::PNSurface(pn::quadric(kind, half_axes, bounds(input))), input);
  });
}
