// SPDX-License-Identifier: LGPL-2.1-or-later
// Envelopes of quadratic cones, by their matrices or by their vertices and directions, whole or
// along an arc.
#include "pn/bezier/quadratic_cone_source.hpp"
#include "surface_or_error.hpp"

namespace {

using namespace pn;

QuadraticCones cones_of(fuzz::FuzzInput& input) {
  if (input.flag()) return quadratic_cones(input.symmetric_matrix<4>(input.choice(3)));
  const auto vertex = input.polynomials<4>(input.choice(3));
  return quadratic_cones(vertex, input.symmetric_matrix<3>(input.choice(3)));
}

std::optional<ContactArc> arc_of(fuzz::FuzzInput& input) {
  if (input.flag()) return std::nullopt;
  return ContactArc{input.point<3>(), input.point<3>(), input.point<3>()};
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzz::FuzzInput input(data, size);
  return fuzz::expect_result_or_error([&] {
    const QuadraticCones cones = cones_of(input);
    const auto arc = arc_of(input);
    fuzz::check_surface(PNSurface(std::make_shared<const QuadraticConeSource>(cones, arc)), input);
  });
}
