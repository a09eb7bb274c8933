// SPDX-License-Identifier: LGPL-2.1-or-later
// BREP text, and what is asked of the shapes in it.
#include "pn/occt/brep.hpp"

#include <string>

#include "pn/occt/bspline_geometry.hpp"
#include "pn/occt/shape_check.hpp"
#include "shape_or_error.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace pn;
  const std::string text(reinterpret_cast<const char*>(data), size);
  return fuzz::expect_shape_or_error([&] {
    const TopoDS_Shape shape = from_brep(text);
    faults(shape);
    fuzz::require(!from_brep(to_brep(shape)).IsNull(), "What is written can be read.");
    bspline_surfaces(shape);
  });
}
