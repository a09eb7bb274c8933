// SPDX-License-Identifier: LGPL-2.1-or-later
// The same pipes from this library and from OpenCASCADE.
#include "canal_cases.hpp"
#include "occt_pipes.hpp"
#include "pn/occt/shell.hpp"
#include "side_by_side.hpp"
#include "signed_distance.hpp"

namespace pn::bench {
namespace {

Way exact(const BezierCanal& canal) {
  return {"exact", "PN Surfaces", [=] {
            const PNSurface surface = surface_of(canal);
            return MadeShape{make_shell(surface.faces(Lines::kEven)),
                             surface.certificate(Lines::kEven).deviation};
          }};
}

std::vector<Way> ways_to_pipe(const BezierCanal& canal) {
  return {exact(canal),
          {"sweep", "MakePipeShell, 1e-6", [=] { return swept_circle(canal, {1e-6}); }},
          {"fine_sweep", "MakePipeShell, 1e-9", [=] { return swept_circle(canal, {1e-9}); }},
          {"fill", "GeomFill_Pipe, 1e-6", [=] { return filled_pipe(canal, {1e-6}); }},
          {"fine_fill", "GeomFill_Pipe, 1e-9", [=] { return filled_pipe(canal, {1e-9}); }}};
}

std::vector<Way> ways_to_horn(const BezierCanal& canal) {
  return {exact(canal),
          {"sweep", "MakePipeShell with law, 1e-6",
           [=] { return swept_circle_with_law(canal, {1e-6}); }},
          {"fine_sweep", "MakePipeShell with law, 1e-9",
           [=] { return swept_circle_with_law(canal, {1e-9}); }},
          {"fill", "GeomFill_Pipe, 21 circles, 1e-6",
           [=] { return filled_pipe_through_circles(canal, {1e-6}); }},
          {"loft_41", "ThruSections, 41 exact circles",
           [=] { return loft_through_characteristic_circles(canal, 41); }},
          {"loft_81", "ThruSections, 81 exact circles",
           [=] { return loft_through_characteristic_circles(canal, 81); }}};
}

bool register_all() {
  register_side_by_side("case_c1", distance_from(pipe()), ways_to_pipe(pipe()));
  register_side_by_side("case_c2", distance_from(horn()), ways_to_horn(horn()));
  return true;
}

const bool kRegistered = register_all();

}  // namespace
}  // namespace pn::bench
