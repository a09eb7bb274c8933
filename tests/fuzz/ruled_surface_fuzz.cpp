// SPDX-License-Identifier: LGPL-2.1-or-later
// Ruled surfaces between two curves, and envelopes of cones between two curves of spheres.
#include "pn/shapes/ruled_surface.hpp"
#include "surface_or_error.hpp"

namespace {

pn::EnvelopeChain chain_of(pn::fuzz::FuzzInput& input) {
  constexpr pn::fuzz::SplineSize kSize{2, 2};
  const bool has_radii = input.flag();
  const pn::Curve first = input.curve(kSize), second = input.curve(kSize);
  if (!has_radii) return pn::ruled_surface(first, second);
  const pn::Law first_radii = input.law(kSize), second_radii = input.law(kSize);
  return pn::cone_envelope(first, first_radii, second, second_radii);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  pn::fuzz::FuzzInput input(data, size);
  return pn::fuzz::expect_result_or_error(
      [&] { pn::fuzz::check_surface(pn::PNSurface(chain_of(input)), input); });
}
