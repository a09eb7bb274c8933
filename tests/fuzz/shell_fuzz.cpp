// SPDX-License-Identifier: LGPL-2.1-or-later
// Shells and solids of B-spline surfaces as plain data, trimmed or not.
#include "pn/occt/shell.hpp"

#include "pn/occt/brep.hpp"
#include "pn/occt/bspline_geometry.hpp"
#include "pn/occt/caps.hpp"
#include "pn/occt/shape_check.hpp"
#include "pn/occt/spherical_caps.hpp"
#include "pn/occt/thick_solid.hpp"
#include "shape_or_error.hpp"

namespace {

using namespace pn;
using fuzz::FuzzInput;

TrimLoop trim_loop(FuzzInput& input) {
  TrimLoop loop;
  for (int i = input.choice(4); i > 0; --i) {
    const auto curve = input.bspline<2>({2, 2});
    loop.push_back({curve.degree, curve.knots, curve.multiplicities, curve.poles});
    if (i > 1 || loop.back().poles.empty() || loop.front().poles.empty()) continue;
    loop.back().poles.back() = loop.front().poles.front();
  }
  return loop;
}

BSplineSurface surface_of(FuzzInput& input) {
  auto [degree, knots, multiplicities, poles, weights] = input.spline_surface({3, 2});
  if (weights.empty()) weights.assign(poles.size(), 1);
  BSplineSurface surface{degree[0],        degree[1],          knots[0],
                         knots[1],         multiplicities[0],  multiplicities[1],
                         std::move(poles), std::move(weights), {}};
  if (input.choice(4) == 3) surface.trims = {trim_loop(input)};
  return surface;
}

/// Another surface with the same first row of poles.
BSplineSurface neighbour(BSplineSurface surface, FuzzInput& input) {
  for (std::size_t i = surface.v_count(); i < surface.poles.size(); ++i) {
    surface.poles[i] = input.point<3>();
  }
  return surface;
}

void check(FuzzInput& input) {
  std::vector<BSplineSurface> surfaces = {surface_of(input)};
  fuzz::require(from_geometry(*to_geometry(surfaces.front())).poles == surfaces.front().poles,
                "OpenCASCADE's surface has the same poles.");
  if (input.flag()) surfaces.push_back(neighbour(surfaces.front(), input));
  const int choice = input.choice(4);
  if (choice == 3) {
    std::vector<BSplineSurface> others;
    for (const BSplineSurface& surface : surfaces) others.push_back(neighbour(surface, input));
    fuzz::require(!make_thick_solids(surfaces, others).empty(), "There is a solid.");
    return;
  }
  for (const TopoDS_Shell& shell : make_shells(surfaces)) {
    const std::size_t faces = bspline_surfaces(from_brep(to_brep(shell))).size();
    fuzz::require(faces > 0 && faces <= surfaces.size(), "BREP text keeps the faces.");
    faults(shell);
    if (choice == 1) make_capped_solid(shell);
    if (choice == 2) make_domed_solid(shell);
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  FuzzInput input(data, size);
  return fuzz::expect_shape_or_error([&] { check(input); });
}
