// SPDX-License-Identifier: LGPL-2.1-or-later
// The library and its OpenCASCADE layer as others use them: an offset of an ellipsoid into the STEP
// file of the first argument, read back and compared bit for bit.
#include <iostream>

#include "pn/bezier/pn_surface.hpp"
#include "pn/occt/shell.hpp"
#include "pn/occt/step.hpp"
#include "pn/shapes/quadric.hpp"

int main(int, char** arguments) {
  const pn::PNSurface ellipsoid(pn::quadric(pn::QuadricKind::kEllipsoid, {3, 2, 1}, {}));
  const TopoDS_Shell shell = pn::make_shell(ellipsoid.offset(0.5).faces(pn::Lines::kEven));
  const pn::StepReport report =
      pn::write_verified_step(arguments[1], {pn::NamedShape{shell, "Offset"}});
  std::cout << report.bytes << " bytes\n";
}
