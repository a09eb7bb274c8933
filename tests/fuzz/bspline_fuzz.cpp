// SPDX-License-Identifier: LGPL-2.1-or-later
// Splines of every degree: a curve, a law and a curve of spheres over Q, and a spline surface.
#include "surface_or_error.hpp"

namespace {

using namespace pn;
using pn::fuzz::FuzzInput;
using pn::fuzz::require;

constexpr fuzz::SplineSize kSize{9, 5};

template <std::size_t Dimension>
void check_spans(const PiecewiseRational<Dimension>& function) {
  require(function.breaks.size() == function.spans.size() + 1, "Spans lie between breaks.");
  for (const auto& span : function.spans) {
    require(span.denominator(Rational(1L) / Rational(3L)).sign() > 0, "Denominators are positive.");
  }
}

void check(FuzzInput& input) {
  switch (input.choice(5)) {
    case 0:
      return check_spans(input.curve(kSize).function());
    case 1:
      return check_spans(input.sphere_spline(kSize).function());
    case 2: {
      const Curve spine = input.curve(kSize);
      const auto& breaks = spine.function().breaks;
      return check_spans(input.law(kSize).over(breaks.front(), breaks.back()));
    }
    case 3: {
      std::vector<Curve> curves;
      for (int i = input.choice(4); i > 0; --i) curves.push_back(input.curve({2, 2}));
      return check_spans(Curve::chain(curves).function());
    }
    default:
      require(!rational_patches(input.spline_surface({3, 2})).empty(),
              "A spline surface has patches.");
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  FuzzInput input(data, size);
  return fuzz::expect_result_or_error([&] { check(input); });
}
