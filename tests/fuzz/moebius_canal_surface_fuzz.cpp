// SPDX-License-Identifier: LGPL-2.1-or-later
// Canal surfaces of which the squared radius is rational, along a spine or a curve in P^4.
#include "pn/bezier/conic_source.hpp"
#include "pn/shapes/moebius_canal_surface.hpp"
#include "surface_or_error.hpp"

namespace {

using namespace pn;

CanalSurfaceFromSquares canal_of(fuzz::FuzzInput& input) {
  if (input.flag()) return moebius_canal_surface(input.polynomials<5>(input.choice(3)));
  const Curve spine = input.curve({2, 2});
  return moebius_canal_surface(spine, input.law({2, 2}));
}

PNSurface surface_of(const CanalSurfaceFromSquares& canal) {
  if (const auto* chain = std::get_if<EnvelopeChain>(&canal)) return PNSurface(*chain);
  const auto& circles = std::get<std::vector<ConicSpan>>(canal);
  return PNSurface(std::make_shared<const ConicSource>(circles));
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzz::FuzzInput input(data, size);
  return fuzz::expect_result_or_error(
      [&] { fuzz::check_surface(surface_of(canal_of(input)), input); });
}
