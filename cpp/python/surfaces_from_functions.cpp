// SPDX-License-Identifier: LGPL-2.1-or-later
#include "surfaces_from_functions.hpp"

#include <pybind11/stl.h>

#include <memory>

#include "arrays.hpp"
#include "pn/bezier/pn_surface.hpp"
#include "pn/bezier/rational_source.hpp"
#include "pn/isotropic/from_planes.hpp"
#include "pn/shapes/mirror.hpp"
#include "rational_functions.hpp"

namespace py = pybind11;

namespace {

using Point = std::array<double, 3>;

std::vector<double> numbers_of(const py::handle& values) {
  const Array array = py::cast<Array>(values);
  return {array.data(), array.data() + array.size()};
}

pn::SplineSurfaceData spline_surface_of(const py::object& face) {
  const auto read = [&](const char* name) { return py::object(face.attr(name)); };
  pn::SplineSurfaceData data;
  const std::array<std::string, 2> directions = {"u", "v"};
  for (std::size_t i = 0; i < 2; ++i) {
    const auto of = [&](const char* name) { return read((directions[i] + name).c_str()); };
    data.degree[i] = py::cast<int>(of("_degree"));
    data.knots[i] = numbers_of(of("_knots"));
    data.multiplicities[i] = py::cast<std::vector<int>>(of("_multiplicities"));
  }
  const Array poles = py::cast<Array>(read("poles"));
  if (poles.ndim() != 3 || poles.shape(2) != 3) {
    throw wrong_shape("The poles must be an array of shape (nu, nv, 3).");
  }
  for (py::ssize_t i = 0; i < poles.size(); i += 3) {
    data.poles.push_back({poles.data()[i], poles.data()[i + 1], poles.data()[i + 2]});
  }
  const py::object weights = read("weights");
  if (!weights.is_none()) data.weights = numbers_of(weights);
  return data;
}

pn::Light light_of(const std::optional<Point>& direction, const Point& start,
                   const std::optional<Point>& source) {
  if (direction.has_value() == source.has_value()) {
    throw py::value_error("either direction or source must be given");
  }
  if (source) return pn::PointLight{*source};
  return pn::ParallelLight{*direction, start};
}

pn::PNSurface surface_of(const pn::OrientedSurface& surface) {
  return pn::PNSurface(std::make_shared<const pn::RationalSource>(
      std::vector<pn::RationalSections>{rational_sections(surface)}, 0,
      std::vector<std::string>{}));
}

}  // namespace

void define_surfaces_from_functions(py::module_& module) {
  module.def(
      "mirror",
      [](const py::object& surface, const std::optional<Point>& direction, const Point& start,
         const std::optional<Point>& source) {
        const pn::SplineSurfaceData data = spline_surface_of(surface);
        const pn::Light light = light_of(direction, start, source);
        const py::gil_scoped_release release;
        const pn::Wavefronts wavefronts = pn::mirror_wavefronts(data, light);
        return pn::PNSurface(std::make_shared<const pn::RationalSource>(
            wavefronts.patches, wavefronts.leaving, wavefronts.notes));
      },
      py::arg("surface"), py::kw_only(), py::arg("direction") = py::none(),
      py::arg("start") = Point{0, 0, 0}, py::arg("source") = py::none(),
      "The wavefronts of light that a mirror reflects; offset(d) is that of path length d in mm, "
      "and "
      "its normal the direction of the light. surface: any object with the attributes of "
      "BSplineSurface, taken whole; weights may be None. Either parallel light of this direction "
      "(3,), whose paths begin at the perpendicular plane through start (3,), or light from the "
      "point source (3,). Where its distance from the mirror is not rational only distance zero is "
      "exact: a note says so, and offset raises GeometryError, \"not_rational\". The regular range "
      "is the one just behind the mirror. Raises GeometryError.");

  module.def(
      "pn_surface",
      [](const std::array<Array, 4>& normals, const py::object& level) {
        std::array<pn::BivariatePolynomial, 4> a;
        for (std::size_t i = 0; i < 4; ++i) a[i] = polynomial_of(normals[i]);
        const pn::BivariateFunction h = function_of(level);
        const py::gil_scoped_release release;
        return surface_of(pn::from_planes(pn::universal_isotropic_vector(a), h));
      },
      py::arg("normals"), py::arg("level"),
      "The surface over the unit square that touches the planes A x + B y + C z = h(u, v), with "
      "(A, "
      "B, C) = (2 (ac + bd), 2 (bc - ad), a^2 + b^2 - c^2 - d^2). normals: a, b, c, d, each an "
      "array of the coefficients of u^i v^j; level: h, such an array or a tuple of numerator and "
      "denominator. Raises GeometryError.");

  module.def(
      "mos_envelope",
      [](const std::array<py::object, 3>& centre, const py::object& radius) {
        pn::MinkowskiVector<pn::BivariateFunction> f;
        for (std::size_t i = 0; i < 3; ++i) f[i] = function_of(centre[i]);
        f[3] = -function_of(radius);
        const py::gil_scoped_release release;
        const auto sheets = pn::envelope_sheets(f);
        return std::pair(surface_of(sheets[0]), surface_of(sheets[1]));
      },
      py::arg("centre"), py::arg("radius"),
      "The two sheets of the envelope of the spheres with this centre, three rational functions, "
      "and radius over the unit square, as pairs of PNSurfaces m + r n; functions are given as in "
      "pn_surface. Raises GeometryError, \"not_rational\" where the family is no MOS surface.");
}
