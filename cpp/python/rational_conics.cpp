// SPDX-License-Identifier: LGPL-2.1-or-later
#include "rational_conics.hpp"

#include <pybind11/numpy.h>

#include "arrays.hpp"
#include "pn/algebra/precision.hpp"
#include "pn/conics/rational_conic_family.hpp"

namespace py = pybind11;

namespace {

/// B, [j, i, k] the coefficient of t^j in B_ik.
py::array_t<double> coefficients_of(const pn::RationalConicFamily& conics) {
  const pn::QuadraticPoints points = [&] {
    const py::gil_scoped_release release;
    return pn::at_sufficient_precision([&](long bits) { return conics.points(bits); });
  }();
  py::array_t<double> result({points.degree + 1, 3, 3});
  auto entries = result.mutable_unchecked<3>();
  for (int j = 0; j <= points.degree; ++j) {
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t k = 0; k < 3; ++k) {
        entries(j, static_cast<py::ssize_t>(i), static_cast<py::ssize_t>(k)) =
            points.coordinate[i][k][j].midpoint();
      }
    }
  }
  return result;
}

}  // namespace

void define_rational_conics(py::module_& module) {
  using Conics = pn::RationalConicFamily;
  py::class_<Conics>(module, "RationalConics",
                     "All points x(t, u) = B(t) (u0^2, u0 u1, u1^2) of a family of conics.")
      .def_property_readonly("degree", &Conics::degree, "n, the degree of B in t: the least.")
      .def_property_readonly("bound", &Conics::least_degree,
                             "m <= n, from the types of the singular conics.")
      .def_property_readonly(
          "is_rational", [](const Conics& c) { return c.rational_points().has_value(); },
          "Whether B was found over Q.")
      .def_property_readonly("coefficients", &coefficients_of,
                             "(n + 1, 3, 3): [j, i, k] belongs to t^j x_i u0^(2 - k) u1^k.");

  module.def(
      "rational_conics",
      [](const Array& conic) {
        const auto matrix = polynomials_of<3, 3>(conic, "conic");
        const py::gil_scoped_release release;
        return Conics(pn::conic_family(matrix));
      },
      py::arg("conic"),
      "All points of the conics x^T C(t) x = 0 for all real t. conic: (h + 1, 3, 3), Bernstein "
      "coefficients over [0, 1] of the symmetric matrix C. Raises GeometryError: no_real_points, "
      "with the interval, singular_conics, wrong_shape, not_finite, out_of_range.\n\n"
      ">>> circle = [[1, 0, 0], [0, 1, 0], [0, 0, -1]]\n"
      ">>> points = pn.rational_conics([circle, circle])\n"
      ">>> points.degree, points.is_rational\n"
      "(0, True)");
}
