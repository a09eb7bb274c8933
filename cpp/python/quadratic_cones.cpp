// SPDX-License-Identifier: LGPL-2.1-or-later
#include "quadratic_cones.hpp"

#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <vector>

#include "arrays.hpp"
#include "pn/bezier/pn_surface.hpp"
#include "pn/bezier/quadratic_cone_source.hpp"
#include "pn/input_numbers.hpp"

namespace py = pybind11;

namespace {

pn::Vector4OfPolynomials vertex_of(const Array& vertex) {
  if (vertex.ndim() != 2) throw wrong_shape("The vertex must be an array of shape (h + 1, 4).");
  const std::vector<py::ssize_t> rows = {vertex.shape(0), 1, vertex.shape(1)};
  return polynomials_of<1, 4>(Array(vertex.attr("reshape")(rows)), "vertex").front();
}

std::optional<pn::ContactArc> arc_of(const std::optional<Array>& array) {
  if (!array) return std::nullopt;
  if (array->ndim() != 2 || array->shape(0) != 3 || array->shape(1) != 3) {
    throw wrong_shape("The arc must be an array of shape (3, 3).");
  }
  pn::ContactArc arc;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t c = 0; c < 3; ++c) arc[i][c] = array->data()[3 * i + c];
    pn::require_input_numbers(arc[i], "A number of the arc");
  }
  return arc;
}

/// make_cones is called without Python's lock.
template <class MakeCones>
pn::PNSurface surface_of(const MakeCones& make_cones, const std::optional<Array>& arc) {
  const std::optional<pn::ContactArc> points = arc_of(arc);
  const py::gil_scoped_release release;
  return pn::PNSurface(std::make_shared<const pn::QuadraticConeSource>(make_cones(), points));
}

}  // namespace

void define_quadratic_cones(py::module_& module) {
  module.def(
      "quadratic_cone_envelope",
      [](const Array& cones, const std::optional<Array>& arc) {
        const auto matrix = polynomials_of<4, 4>(cones, "matrix of the cones");
        return surface_of([&] { return pn::quadratic_cones(matrix); }, arc);
      },
      py::arg("cones"), py::kw_only(), py::arg("arc") = py::none(),
      "The envelope of the quadratic cones x^T C(t) x = 0, t in [0, 1], x = (x, y, z, 1) in mm. "
      "cones: (k + 1, 4, 4), Bernstein coefficients of the symmetric matrix C, of rank 3. arc: "
      "(3, 3), points near the contact curve of the cone at t = 1/2: of every contact curve the "
      "part from the generator nearest to the first of them past the second to the third is taken; "
      "without it all of it, which must be finite. Its offsets are not rational. Raises "
      "GeometryError.");

  module.def(
      "quadratic_cone_envelope",
      [](const Array& vertex, const Array& directions, const std::optional<Array>& arc) {
        const auto v = vertex_of(vertex);
        const auto m = polynomials_of<3, 3>(directions, "matrix of the directions");
        return surface_of([&] { return pn::quadratic_cones(v, m); }, arc);
      },
      py::arg("vertex"), py::arg("directions"), py::kw_only(), py::arg("arc") = py::none(),
      "The same for the cones of the directions d with d^T M(t) d = 0 through the vertex. vertex: "
      "(h + 1, 4), Bernstein coefficients of (x w, y w, z w, w), in mm. directions: (l + 1, 3, 3), "
      "those of the symmetric matrix M.");
}
