// SPDX-License-Identifier: LGPL-2.1-or-later
// Conics y^T C(t) y = 0 in moving planes, whole or cut by lines.
#include "pn/bezier/conic_source.hpp"
#include "surface_or_error.hpp"

namespace {

using namespace pn;

ConicSpan span_of(fuzz::FuzzInput& input) {
  ConicSpan span;
  const int frame_degree = input.choice(3), degree = input.choice(3);
  for (auto& row : span.conic.frame) row = input.polynomials<3>(frame_degree);
  span.conic.conic = input.symmetric_matrix<3>(degree);
  if (input.flag()) span.cut = input.polynomials<3>(input.choice(3));
  return span;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzz::FuzzInput input(data, size);
  return fuzz::expect_result_or_error([&] {
    std::vector<ConicSpan> spans;
    for (int i = 1 + input.choice(2); i > 0; --i) spans.push_back(span_of(input));
    fuzz::check_surface(PNSurface(std::make_shared<const ConicSource>(spans)), input);
  });
}
