// SPDX-License-Identifier: LGPL-2.1-or-later
// The same offsets of quadrics and ruled surfaces from this library and from OpenCASCADE.
#include "occt_offsets.hpp"
#include "offset_cases.hpp"
#include "pn/bezier/pn_surface.hpp"
#include "pn/occt/shell.hpp"
#include "side_by_side.hpp"
#include "signed_distance.hpp"

namespace pn::bench {
namespace {

MadeShape exact_offset(const OffsetCase& offset) {
  const PNSurface surface = PNSurface(chain_of(offset.base)).offset(offset.distance);
  return {make_shell(surface.faces(Lines::kEven)), surface.certificate(Lines::kEven).deviation};
}

std::vector<Way> ways_to(const OffsetCase& offset) {
  return {{"exact", "PN Surfaces, edges and shell", [=] { return exact_offset(offset); }},
          {"entity", "Geom_OffsetSurface", [=] { return offset_entity(offset); }},
          {"rough_fit", "ApproxSurface, 1e-3", [=] { return approximated_offset(offset, {1e-3}); }},
          {"fit", "ApproxSurface, 1e-6", [=] { return approximated_offset(offset, {1e-6}); }},
          {"fine_fit", "ApproxSurface, 1e-9", [=] { return approximated_offset(offset, {1e-9}); }},
          {"join", "MakeOffsetShape by join", [=] { return joined_offset(offset, {1e-6}); }}};
}

bool register_all() {
  for (const OffsetCase& offset : offset_cases()) {
    const SignedDistance from_base = distance_from(offset.base);
    const double distance = offset.distance;
    register_side_by_side(
        "offset_case/" + offset.name,
        [=](const Point& point) { return from_base(point) - distance; }, ways_to(offset));
  }
  return true;
}

const bool kRegistered = register_all();

}  // namespace
}  // namespace pn::bench
