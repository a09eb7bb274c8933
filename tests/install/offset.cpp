// SPDX-License-Identifier: LGPL-2.1-or-later
// The library as others use it: a pipe and its offset. Ends with 0 when corresponding points of
// both lie the distance apart, along their common normal.
#include <cmath>
#include <iostream>

#include "pn/bezier/pn_surface.hpp"
#include "pn/shapes/canal_surface.hpp"

int main() {
  const pn::Curve spine = pn::Curve::bezier({{0, 0, 0}, {15, 5, 0}, {20, 15, 5}, {20, 20, 0}});
  const pn::PNSurface pipe(pn::canal_surface(spine, pn::Law::bezier({2, 1.8, 2, 2.5})));
  const pn::SurfacePoint inner = pipe.evaluate({0.5}, {1})[0];
  const pn::SurfacePoint outer = pipe.offset(0.5).evaluate({0.5}, {1})[0];
  double error = 0;
  for (int i = 0; i < 3; ++i) {
    error = std::max(error, std::abs(outer.point[i] - inner.point[i] - 0.5 * inner.normal[i]));
  }
  std::cout << "Off by " << error << " mm\n";
  return error < 1e-12 ? 0 : 1;
}
