// SPDX-License-Identifier: LGPL-2.1-or-later
#include "rational_family.hpp"

#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <memory>

#include "pn/bezier/pn_surface.hpp"
#include "pn/bezier/rational_source.hpp"
#include "pn/geometry_error.hpp"
#include "pn/shapes/rational_family.hpp"

namespace py = pybind11;

namespace {

using Array = py::array_t<double, py::array::c_style | py::array::forcecast>;
using Interval = std::array<double, 2>;

pn::GeometryError wrong_shape(const std::string& sentence) {
  return {pn::ErrorCode::kWrongShape, sentence};
}

pn::Coefficients rows_of(const double* values, py::ssize_t rows, py::ssize_t columns) {
  pn::Coefficients result;
  for (py::ssize_t i = 0; i < rows; ++i) {
    result.emplace_back(values + i * columns, values + (i + 1) * columns);
  }
  return result;
}

pn::Coefficients polynomial_of(const Array& array) {
  if (array.ndim() != 2) throw wrong_shape("A polynomial must be an array of shape (m, n).");
  return rows_of(array.data(), array.shape(0), array.shape(1));
}

std::array<pn::Coefficients, 4> vector_of(const Array& array) {
  if (array.ndim() != 3 || array.shape(0) != 4) {
    throw wrong_shape("Four polynomials must be an array of shape (4, m, n).");
  }
  std::array<pn::Coefficients, 4> result;
  for (std::size_t c = 0; c < 4; ++c) {
    const py::ssize_t size = array.shape(1) * array.shape(2);
    result[c] =
        rows_of(array.data() + static_cast<py::ssize_t>(c) * size, array.shape(1), array.shape(2));
  }
  return result;
}

Array spheres_at(const pn::RationalFamily& family, const Array& p, const Array& q) {
  if (p.ndim() != 1 || q.ndim() != 1 || p.size() != q.size()) {
    throw wrong_shape("The parameters must be two lists of numbers of the same length.");
  }
  Array result({p.size(), py::ssize_t{4}});
  auto spheres = result.mutable_unchecked<2>();
  for (py::ssize_t i = 0; i < p.size(); ++i) {
    const std::array<pn::Rational, 2> at = {pn::Rational::exactly(p.data()[i]),
                                            pn::Rational::exactly(q.data()[i])};
    for (py::ssize_t c = 0; c < 4; ++c) {
      const double x = family.envelope.spheres[static_cast<std::size_t>(c)].at(at).to_double();
      spheres(i, c) = c == 3 ? -x : x;
    }
  }
  return result;
}

pn::PNSurface skin(const pn::RationalFamily& family, std::size_t sheet,
                   const std::array<Interval, 2>& bounds) {
  if (sheet > 1) throw py::value_error("sheet must be 0 or 1");
  const py::gil_scoped_release release;
  const auto& [first, second] = bounds;
  const pn::RationalSections part =
      pn::part_of(family.envelope.sheets[sheet], {{first[0], second[0]}, {first[1], second[1]}});
  return pn::PNSurface(std::make_shared<const pn::RationalSource>(
      std::vector<pn::RationalSections>{part}, 0, std::vector<std::string>{}));
}

}  // namespace

void define_rational_family(py::module_& module) {
  using Family = pn::RationalFamily;
  py::class_<Family>(module, "RationalFamily",
                     "A rational two-parameter family of spheres with both sheets of its envelope. "
                     "Sheets and spheres are over the same parameters (p, q): those of the family "
                     "where its normals are rational in them, else stereographic normals (s, t).")
      .def_property_readonly(
          "is_over_normals", &Family::is_over_normals,
          "The parameters are s = n1 / (1 + n3), t = n2 / (1 + n3) of the unit normal of sheet 0.")
      .def("spheres", &spheres_at, py::arg("p"), py::arg("q"),
           "Centres and radii (n, 4) in mm at parameters (n,), (n,). ")
      .def("skin", &skin, py::arg("sheet"), py::arg("bounds"),
           "The PNSurface of sheet 0 or 1 over the rectangle bounds = ((p0, p1), (q0, q1)): its "
           "points are m + r n. Sheet 1 is the reflection of sheet 0 in the tangent planes of the "
           "centres. Raises GeometryError.");

  module.def(
      "sphere_family_from_surface",
      [](const Array& spheres, const std::optional<Array>& weight) {
        const auto numerators = vector_of(spheres);
        const pn::Coefficients denominator =
            weight ? polynomial_of(*weight) : pn::Coefficients{{1}};
        const py::gil_scoped_release release;
        return pn::family_from_surface(numerators, denominator);
      },
      py::arg("spheres"), py::arg("weight") = py::none(),
      "The family with centre (x, y, z) and radius r in mm, each a polynomial sum c[i, j] u^i v^j: "
      "(4, m, n), divided by a weight (m, n). Raises GeometryError where the envelope is not "
      "rational.");
  module.def(
      "sphere_family_from_net",
      [](const Array& c, const Array& d, const Array& a, const Array& b) {
        const auto first = vector_of(c), second = vector_of(d);
        const pn::Coefficients first_support = polynomial_of(a), second_support = polynomial_of(b);
        const py::gil_scoped_release release;
        return pn::family_from_net(first, second, first_support, second_support);
      },
      py::arg("c"), py::arg("d"), py::arg("a"), py::arg("b"),
      "The family f = (m, -r) whose tangent planes are polar to the lines joining c(u, v) and d(u, "
      "v) at infinity, with support functions <c, f> = a, <d, f> = b, where <x, y> = x1 y1 + x2 y2 "
      "+ x3 y3 - x4 y4. Polynomials: c, d (4, m, n), a, b (m, n), the coefficient [i, j] that of "
      "u^i v^j. Raises GeometryError where the support functions do not fit or the envelope is not "
      "rational.");
}
