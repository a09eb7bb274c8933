// SPDX-License-Identifier: LGPL-2.1-or-later
#include "moving_conic_section.hpp"

#include <pybind11/stl.h>

#include <memory>
#include <string>
#include <tuple>

#include "pn/bezier/conic_source.hpp"
#include "pn/bezier/pn_surface.hpp"
#include "pn/shapes/conic_section.hpp"

namespace py = pybind11;

namespace {

using Point = std::array<double, 3>;
using HalfAxisLaws = std::pair<pn::Law, pn::Law>;
using VertexLaws = std::tuple<pn::Law, pn::Law, pn::Law>;

pn::ConicSection section_of(const std::optional<HalfAxisLaws>& axes,
                            const std::optional<VertexLaws>& vertex) {
  if (axes.has_value() == vertex.has_value()) {
    throw py::value_error("either half_axes or vertex must be given");
  }
  if (axes) return pn::HalfAxes{axes->first, axes->second};
  const auto& [radius, conic_constant, depth] = *vertex;
  return pn::VertexForm{radius, conic_constant, depth};
}

pn::SectionPlanes planes_of(const Point& up, const std::string& planes,
                            const std::optional<Point>& normal) {
  if (normal && planes == "perpendicular") return {up, pn::ParallelPlanes{*normal}};
  if (!normal && planes == "perpendicular") return {up, pn::PerpendicularPlanes{}};
  if (!normal && planes == "upright") return {up, pn::UprightPlanes{}};
  throw py::value_error(
      "planes must be 'perpendicular', to the spine or to normal, or 'upright' without normal");
}

}  // namespace

void define_moving_conic_section(py::module_& module) {
  module.def(
      "moving_conic_section",
      [](const pn::Curve& spine, const Point& up, const std::string& planes,
         const std::optional<Point>& normal, const std::optional<HalfAxisLaws>& axes,
         const std::optional<VertexLaws>& vertex) {
        const pn::SectionPlanes where = planes_of(up, planes, normal);
        const pn::ConicSection section = section_of(axes, vertex);
        const py::gil_scoped_release release;
        return pn::PNSurface(std::make_shared<const pn::ConicSource>(
            pn::moving_conic_section(spine, where, section)));
      },
      py::arg("spine"), py::kw_only(), py::arg("up"), py::arg("planes") = "perpendicular",
      py::arg("normal") = py::none(), py::arg("half_axes") = py::none(),
      py::arg("vertex") = py::none(),
      "The surface of a conic section that moves along a spine. Its planes are "
      "'perpendicular' to the spine, or to normal (3,), or 'upright': through up and perpendicular "
      "to the spine as it is seen along up. up (3,) gives the direction upwards in them, at the "
      "start of the "
      "spine, and with it the one to the side, both of unit length. Either half_axes, two laws (a "
      "to "
      "the side, b upwards) of ellipses around the spine, in mm; or vertex, three laws (R, K, h) "
      "of "
      "the conics x^2 = 2 R z - (1 + K) z^2, x to the side and z upwards from the spine, as far as "
      "z = h: radius of curvature in mm, conic constant, depth in mm. There are no exact offsets. "
      "Raises GeometryError, and ValueError for arguments that do not fit together.\n\n"
      ">>> spine = pn.Curve.bezier([[0, 0, 0], [10, 0, 0]])\n"
      ">>> half_axes = pn.Law.constant(2), pn.Law.constant(1)\n"
      ">>> pn.moving_conic_section(spine, up=[0, 0, 1], half_axes=half_axes).degree\n"
      "(1, 2)");
}
