// SPDX-License-Identifier: LGPL-2.1-or-later
#include "rational_envelope.hpp"

#include <pybind11/stl.h>

#include <memory>

#include "pn/bezier/pn_surface.hpp"
#include "pn/bezier/rational_source.hpp"
#include "pn/geometry_error.hpp"
#include "pn/input_numbers.hpp"
#include "pn/isotropic/rational_envelope.hpp"
#include "pn/isotropic/supported_fibration.hpp"
#include "rational_functions.hpp"

namespace py = pybind11;

namespace {

using Interval = std::array<double, 2>;

pn::MinkowskiVector<pn::BivariateFunction> vector_of(const std::array<py::object, 4>& x) {
  return {function_of(x[0]), function_of(x[1]), function_of(x[2]), function_of(x[3])};
}

/// The values of functions, (n, count), at parameters (n,), (n,).
Array values_at(const std::vector<pn::BivariateFunction>& functions, const Array& p,
                const Array& q) {
  if (p.ndim() != 1 || q.ndim() != 1 || p.size() != q.size()) {
    throw wrong_shape("The parameters must be two lists of numbers of the same length.");
  }
  Array result({p.size(), static_cast<py::ssize_t>(functions.size())});
  double* value = result.mutable_data();
  for (py::ssize_t i = 0; i < p.size(); ++i) {
    const std::array parameters = {p.data()[i], q.data()[i]};
    pn::require_input_numbers(parameters, "A parameter");
    const auto at =
        std::array{pn::Rational::exactly(parameters[0]), pn::Rational::exactly(parameters[1])};
    for (const pn::BivariateFunction& f : functions) *value++ = f.at(at).to_double();
  }
  return result;
}

Array spheres_at(const pn::RationalEnvelope& envelope, const Array& p, const Array& q) {
  const auto& f = envelope.spheres;
  return values_at({f[0], f[1], f[2], -f[3]}, p, q);
}

Array parameters_at(const pn::RationalEnvelope& envelope, const Array& p, const Array& q) {
  const pn::Reparametrization own = {pn::BivariatePolynomial(pn::Variable::kU),
                                     pn::BivariatePolynomial(pn::Variable::kV)};
  const auto& [u, v] = envelope.contact.value_or(own);
  return values_at({u, v}, p, q);
}

pn::RationalSections part_over(const pn::OrientedSurface& sheet,
                               const std::array<Interval, 2>& bounds) {
  std::array<pn::Rational, 2> low, high;
  for (std::size_t i = 0; i < 2; ++i) {
    const auto [from, to] = bounds[i];
    pn::require_input_numbers(std::array{from, to}, "A bound");
    if (from >= to) {
      throw pn::GeometryError(pn::ErrorCode::kBadBounds, "The bounds of the parameters are empty.");
    }
    low[i] = pn::Rational::exactly(from);
    high[i] = pn::Rational::exactly(to);
  }
  return part_of(rational_sections(sheet), low, high);
}

pn::PNSurface skin(const pn::RationalEnvelope& envelope, std::size_t sheet,
                   const std::array<Interval, 2>& bounds) {
  if (sheet > 1) throw py::value_error("sheet must be 0 or 1");
  const py::gil_scoped_release release;
  return pn::PNSurface(std::make_shared<const pn::RationalSource>(
      std::vector<pn::RationalSections>{part_over(envelope.sheets[sheet], bounds)}, 0,
      std::vector<std::string>{}));
}

}  // namespace

void define_rational_envelope(py::module_& module) {
  using Envelope = pn::RationalEnvelope;
  py::class_<Envelope>(module, "RationalEnvelope",
                       "Both sheets of the envelope of a two-parameter family of spheres, over the "
                       "same parameters (p, q): those of the family where its normals are rational "
                       "in them, else the stereographic ones of the normals.")
      .def_property_readonly(
          "is_over_normals", [](const Envelope& envelope) { return envelope.contact.has_value(); },
          "(p, q) are n1 / (1 + n3), n2 / (1 + n3) of the unit normal of sheet 0.")
      .def("spheres", &spheres_at, py::arg("p"), py::arg("q"),
           "Centres and radii (n, 4) in mm of the spheres at parameters (n,), (n,).")
      .def("parameters", &parameters_at, py::arg("p"), py::arg("q"),
           "(u, v) of these spheres in the family, (n, 2).")
      .def(
          "skin", &skin, py::arg("sheet"), py::arg("bounds"),
          "The PNSurface m + r n of sheet 0 or 1 over the rectangle bounds = ((p0, p1), (q0, q1)). "
          "Sheet 1 is the reflection of sheet 0 in the tangent planes of the centres. Raises "
          "GeometryError.");

  module.def(
      "sphere_family_from_surface",
      [](const std::array<py::object, 3>& centre, const py::object& radius) {
        const pn::SphereSurface f = {function_of(centre[0]), function_of(centre[1]),
                                     function_of(centre[2]), -function_of(radius)};
        const py::gil_scoped_release release;
        return pn::rational_envelope(f);
      },
      py::arg("centre"), py::arg("radius"),
      "The envelope of the spheres with this centre, three rational functions, and radius; "
      "functions are given as in pn_surface. Raises GeometryError, \"not_rational\" where neither "
      "the normals are rational functions of (u, v) nor (u, v) of the normals.");

  module.def(
      "sphere_family_from_net",
      [](const std::array<py::object, 4>& c, const std::array<py::object, 4>& d,
         const py::object& a, const py::object& b) {
        const pn::SupportedFibration net = {vector_of(c), vector_of(d), function_of(a),
                                            function_of(b)};
        const py::gil_scoped_release release;
        return pn::rational_envelope(pn::supported_surface(net));
      },
      py::arg("c"), py::arg("d"), py::arg("a"), py::arg("b"),
      "The envelope of the spheres f = (m, -r) whose tangent planes are polar to the lines from "
      "c(u, v) to d(u, v) at infinity, with support functions <c, f> = a, <d, f> = b, where <x, y> "
      "= x1 y1 + x2 y2 + x3 y3 - x4 y4. c and d are four rational functions each, a and b one, "
      "given as in pn_surface. Raises GeometryError, \"not_rational\" where the support functions "
      "do not fit or the envelope is not rational.");
}
