// SPDX-License-Identifier: LGPL-2.1-or-later
#include "moebius_canal_surface.hpp"

#include <memory>
#include <utility>
#include <variant>

#include "arrays.hpp"
#include "pn/bezier/conic_source.hpp"
#include "pn/bezier/pn_surface.hpp"
#include "pn/shapes/moebius_canal_surface.hpp"

namespace py = pybind11;

namespace {

struct SurfaceOf {
  pn::PNSurface operator()(pn::EnvelopeChain chain) const {
    return pn::PNSurface(std::move(chain));
  }
  pn::PNSurface operator()(const std::vector<pn::ConicSpan>& circles) const {
    return pn::PNSurface(std::make_shared<const pn::ConicSource>(circles));
  }
};

pn::MoebiusCurve moebius_curve_of(const Array& array) {
  if (array.ndim() != 2) throw wrong_shape("The curve must be an array of shape (k + 1, 5).");
  const std::vector<py::ssize_t> rows = {array.shape(0), 1, array.shape(1)};
  return polynomials_of<1, 5>(Array(array.attr("reshape")(rows)), "curve").front();
}

}  // namespace

void define_moebius_canal_surface(py::module_& module) {
  using Release = py::call_guard<py::gil_scoped_release>;
  module.def(
      "moebius_canal_surface",
      [](const pn::Curve& spine, const pn::Law& squared_radius) {
        return std::visit(SurfaceOf(), pn::moebius_canal_surface(spine, squared_radius));
      },
      py::arg("spine"), py::arg("squared_radius"), Release(),
      "The envelope of the spheres around the points of the spine whose squared radius, in mm^2, "
      "is "
      "the law. If the radius is a rational function the result is that of canal_surface; "
      "otherwise "
      "it has no exact offsets, and no corners. Raises GeometryError.\n\n"
      ">>> spine = pn.Curve.bezier([[0, 0, 0], [0, 0, 10]])\n"
      ">>> pn.moebius_canal_surface(spine, pn.Law.bezier([1, 2, 1])).has_offsets\n"
      "False\n"
      ">>> pn.moebius_canal_surface(spine, pn.Law.bezier([1, 2, 4])).has_offsets\n"
      "True");
  module.def(
      "moebius_canal_surface",
      [](const Array& curve) {
        const pn::MoebiusCurve spheres = moebius_curve_of(curve);
        const py::gil_scoped_release release;
        return std::visit(SurfaceOf(), pn::moebius_canal_surface(spheres));
      },
      py::arg("curve"),
      "The same of a curve in P^4, t in [0, 1], by its Bernstein coefficients (k + 1, 5) in "
      "homogeneous coordinates x0, ..., x4: the spheres with centre (x1, x2, x3) / (x0 - x4) and "
      "squared radius (x1^2 + x2^2 + x3^2 + x4^2 - x0^2) / (x0 - x4)^2, in mm, or planes for x0 = "
      "x4. k = 2 gives a Darboux cyclide. Raises GeometryError.");
}
