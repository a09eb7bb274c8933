// SPDX-License-Identifier: LGPL-2.1-or-later
#include "conic_surfaces.hpp"

#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <memory>
#include <optional>
#include <tuple>
#include <vector>

#include "arrays.hpp"
#include "pn/bezier/conic_source.hpp"
#include "pn/bezier/pn_surface.hpp"

namespace py = pybind11;

namespace {

/// Frame, conic and cut.
using SpanArrays = std::tuple<Array, Array, std::optional<Array>>;

pn::Vector3<pn::RationalPolynomial> line_of(const Array& cut) {
  if (cut.ndim() != 2) throw wrong_shape("The cut must be an array of shape (l + 1, 3).");
  const std::vector<py::ssize_t> rows = {cut.shape(0), 1, cut.shape(1)};
  return polynomials_of<1, 3>(Array(cut.attr("reshape")(rows)), "cut").front();
}

pn::ConicSpan span_of(const SpanArrays& arrays) {
  const auto& [frame, conic, cut] = arrays;
  pn::ConicSpan span;
  span.conic = {polynomials_of<4, 3>(frame, "frame"), polynomials_of<3, 3>(conic, "conic")};
  if (cut) span.cut = line_of(*cut);
  return span;
}

pn::PNSurface surface_of(const std::vector<pn::ConicSpan>& spans) {
  const py::gil_scoped_release release;
  return pn::PNSurface(std::make_shared<const pn::ConicSource>(spans));
}

}  // namespace

void define_conic_surfaces(py::module_& module) {
  module.def(
      "conic_surface",
      [](const Array& frame, const Array& conic, const std::optional<Array>& cut) {
        return surface_of({span_of({frame, conic, cut})});
      },
      py::arg("frame"), py::arg("conic"), py::arg("cut") = py::none(),
      "The surface of the conics y^T C(t) y = 0, t in [0, 1], in the planes of three points. "
      "frame: "
      "(k + 1, 4, 3), Bernstein coefficients of a matrix whose columns are the points (x w, y w, z "
      "w, w), in mm; a direction has w = 0. conic: (h + 1, 3, 3), Bernstein coefficients of the "
      "symmetric matrix C. cut: (l + 1, 3), of a line, takes of each conic the part where cut(t) . "
      "y > 0; without it the conics are ellipses. Its offsets are not rational. Raises "
      "GeometryError.\n\n"
      ">>> start = [[1, 0, 0], [0, 1, 0], [0, 0, 0], [0, 0, 1]]\n"
      ">>> end = [[1, 0, 0], [0, 1, 0], [0, 0, 10], [0, 0, 1]]\n"
      ">>> ellipse = [[1, 0, 0], [0, 4, 0], [0, 0, -4]]\n"
      ">>> cylinder = pn.conic_surface([start, end], [ellipse, ellipse])\n"
      ">>> cylinder.degree, cylinder.has_offsets\n"
      "((1, 2), False)");

  module.def(
      "conic_surface_of_spans",
      [](const std::vector<SpanArrays>& arrays) {
        std::vector<pn::ConicSpan> spans;
        for (const SpanArrays& span : arrays) spans.push_back(span_of(span));
        return surface_of(spans);
      },
      py::arg("spans"),
      "The surface of several spans (frame, conic, cut), each as conic_surface has it, cut None "
      "without one; each begins with the conic with which the one before ends. Number i is the "
      "surface over [i, i + 1]. Closed when the last conic is the first. Raises GeometryError.");

  module.def(
      "conic_surface_of_tangent_planes",
      [](const Array& d) {
        const auto planes = polynomials_of<4, 4>(d, "matrix of the tangent planes");
        return surface_of({{pn::conic_of_tangent_planes(planes), std::nullopt}});
      },
      py::arg("d"),
      "The surface of the ellipses that are touched by the planes e1 x + e2 y + e3 z + e4 = 0 with "
      "e^T D(t) e = 0, t in [0, 1]. d: (k + 1, 4, 4), Bernstein coefficients of the symmetric "
      "matrix D, of rank 3, for x, y, z in mm. Raises GeometryError.");
}
