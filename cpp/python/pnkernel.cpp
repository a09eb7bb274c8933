// SPDX-License-Identifier: LGPL-2.1-or-later
// The Python module pnkernel: plain NumPy arrays in and out, no OpenCASCADE, no FreeCAD.
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <cmath>
#include <cstdint>
#include <map>

#include "arrays.hpp"
#include "conic_surfaces.hpp"
#include "moebius_canal_surface.hpp"
#include "moving_conic_section.hpp"
#include "pn/algebra/bernstein.hpp"
#include "pn/algebra/cancellation.hpp"
#include "pn/algebra/parallel.hpp"
#include "pn/bezier/pn_surface.hpp"
#include "pn/geometry_error.hpp"
#include "pn/shapes/canal_surface.hpp"
#include "pn/shapes/quadric.hpp"
#include "pn/shapes/ruled_surface.hpp"
#include "quadratic_cones.hpp"
#include "rational_conics.hpp"
#include "rational_envelope.hpp"
#include "sphere_families.hpp"
#include "surfaces_from_functions.hpp"

namespace py = pybind11;

namespace {

std::vector<std::array<double, 1>> values_of(const Array& array) {
  std::vector<std::array<double, 1>> values;
  for (const double value : vector_of(array, "coefficients")) values.push_back({value});
  return values;
}

std::vector<double> weights_of(const std::optional<Array>& array) {
  return array ? vector_of(*array, "weights") : std::vector<double>{};
}

Array array_of(const std::vector<std::array<double, 3>>& points, std::vector<py::ssize_t> shape) {
  Array result(shape);
  double* data = result.mutable_data();
  for (const auto& point : points) data = std::copy(point.begin(), point.end(), data);
  return result;
}

Array array_of(const std::vector<double>& values, std::vector<py::ssize_t> shape) {
  Array result(shape);
  std::copy(values.begin(), values.end(), result.mutable_data());
  return result;
}

Array array_of(const std::vector<double>& values) {
  return array_of(values, {static_cast<py::ssize_t>(values.size())});
}

// Bernstein coefficients of the numerators and the denominator of a span.
template <std::size_t Dimension>
Array homogeneous_of(const pn::RationalSpan<Dimension>& span) {
  std::vector<pn::RationalPolynomial> components(span.numerator.begin(), span.numerator.end());
  components.push_back(span.denominator);
  int degree = 0;
  for (const auto& component : components) degree = std::max(degree, component.degree());
  Array result({py::ssize_t{degree} + 1, static_cast<py::ssize_t>(components.size())});
  auto entries = result.mutable_unchecked<2>();
  for (std::size_t c = 0; c < components.size(); ++c) {
    std::vector<pn::Rational> power;
    for (int i = 0; i <= degree; ++i) power.push_back(components[c].coefficient(i));
    const std::vector<pn::Rational> bernstein = pn::to_bernstein(std::move(power));
    for (std::size_t i = 0; i < bernstein.size(); ++i) {
      entries(static_cast<py::ssize_t>(i), static_cast<py::ssize_t>(c)) = bernstein[i].to_double();
    }
  }
  return result;
}

template <std::size_t Dimension>
py::list spans_of(const pn::PiecewiseRational<Dimension>& function) {
  py::list spans;
  for (std::size_t i = 0; i < function.spans.size(); ++i) {
    spans.append(py::make_tuple(function.breaks[i].to_double(), function.breaks[i + 1].to_double(),
                                homogeneous_of(function.spans[i])));
  }
  return spans;
}

Array array_of(const std::array<double, 3>& point) {
  return array_of(std::vector<double>(point.begin(), point.end()));
}

py::tuple tuple_of(const std::array<int, 2>& pair) { return py::make_tuple(pair[0], pair[1]); }

pn::Lines lines_of(const std::string& name) {
  if (name == "even") return pn::Lines::kEven;
  if (name == "lowest_degree") return pn::Lines::kLowestDegree;
  throw py::value_error("lines must be \"even\" or \"lowest_degree\"");
}

py::tuple evaluate(const pn::PNSurface& surface, const Array& t, const Array& u) {
  const std::vector<double> along = vector_of(t, "parameters t"),
                            around = vector_of(u, "parameters u");
  if (along.size() != around.size())
    throw wrong_shape("The arrays t and u must have the same length.");
  std::vector<std::array<double, 3>> points, normals;
  for (const pn::SurfacePoint& sample : surface.evaluate(along, around)) {
    points.push_back(sample.point);
    normals.push_back(sample.normal);
  }
  const auto count = static_cast<py::ssize_t>(along.size());
  return py::make_tuple(array_of(points, {count, 3}), array_of(normals, {count, 3}));
}

/// Without the interpreter's lock, since it takes time.
pn::OffsetRange regular_range(const pn::PNSurface& surface) {
  const py::gil_scoped_release release;
  return surface.regular_range();
}

pn::QuadricKind kind_of(const std::string& name) {
  static const std::map<std::string, pn::QuadricKind> kinds = {
      {"ellipsoid", pn::QuadricKind::kEllipsoid},
      {"one_sheet_hyperboloid", pn::QuadricKind::kOneSheetHyperboloid},
      {"two_sheet_hyperboloid", pn::QuadricKind::kTwoSheetHyperboloid},
      {"elliptic_paraboloid", pn::QuadricKind::kEllipticParaboloid},
      {"hyperbolic_paraboloid", pn::QuadricKind::kHyperbolicParaboloid},
      {"elliptic_cylinder", pn::QuadricKind::kEllipticCylinder},
      {"elliptic_cone", pn::QuadricKind::kEllipticCone},
      {"parabolic_cylinder", pn::QuadricKind::kParabolicCylinder},
  };
  const auto kind = kinds.find(name);
  if (kind == kinds.end()) throw py::value_error("\"" + name + "\" is no kind of quadric");
  return kind->second;
}

using Bounds = std::map<std::string, std::array<double, 2>>;

pn::QuadricBounds bounds_of(const std::optional<Bounds>& bounds) {
  pn::QuadricBounds result;
  if (!bounds) return result;
  for (const auto& [name, interval] : *bounds) {
    const pn::Interval value{interval[0], interval[1]};
    if (name == "angle") {
      result.angle = value;
    } else if (name == "x" || name == "y" || name == "z") {
      result.box[static_cast<std::size_t>(name[0] - 'x')] = value;
    } else {
      throw py::value_error("\"" + name + "\" is no bound: x, y, z or angle");
    }
  }
  return result;
}

void define_error(py::module_& module) {
  // GeometryError is made in Python so that it can carry its code as an attribute.
  static PyObject* type =
      PyErr_NewExceptionWithDoc("pnkernel.GeometryError",
                                "Input that admits no exact surface. The text is a sentence for "
                                "the user; .code names the reason.",
                                PyExc_ValueError, nullptr);
  module.attr("GeometryError") = py::handle(type);
  py::register_exception_translator([](std::exception_ptr pointer) {
    try {
      if (pointer) std::rethrow_exception(pointer);
    } catch (const pn::GeometryError& error) {
      py::object instance = py::reinterpret_borrow<py::object>(type)(error.what());
      instance.attr("code") = pn::to_string(error.code());
      PyErr_SetObject(type, instance.ptr());
    }
  });
}

void define_cancellation(py::module_& module) {
  py::register_exception<pn::Cancelled>(module, "Cancelled").doc() =
      "A computation was asked to stop.";
  py::class_<pn::Cancellation>(module, "Cancellation",
                               "One request to stop a computation, from any thread.")
      .def(py::init<>())
      .def("request", &pn::Cancellation::request, "Has the work stop soon.")
      .def_property_readonly("is_requested", &pn::Cancellation::is_requested,
                             "Whether the work has been asked to stop.")
      .def(
          "run",
          [](pn::Cancellation& cancellation, const py::function& work) {
            py::object result;
            cancellation.run([&] { result = work(); });
            return result;
          },
          py::arg("work"),
          "The result of work(), in this thread. Raises Cancelled after a request: whatever the "
          "kernel is doing in work() then ends within milliseconds.");
}

void define_inputs(py::module_& module) {
  py::class_<pn::Curve>(module, "Curve", "A spine: a piecewise rational curve, in millimetres.")
      .def_static(
          "bezier",
          [](const Array& poles, const std::optional<Array>& weights) {
            return pn::Curve::bezier(points_of(poles), weights_of(weights));
          },
          py::arg("poles"), py::arg("weights") = py::none(),
          "A Bezier curve over [0, 1]. poles: (k + 1, 3); weights: (k + 1,), positive.")
      .def_static(
          "bspline",
          [](int degree, const Array& knots, const std::vector<int>& multiplicities,
             const Array& poles, const std::optional<Array>& weights) {
            return pn::Curve::bspline({degree, vector_of(knots, "knots"), multiplicities,
                                       points_of(poles), weights_of(weights)});
          },
          py::arg("degree"), py::arg("knots"), py::arg("multiplicities"), py::arg("poles"),
          py::arg("weights") = py::none(),
          "A clamped B-spline: strictly increasing knots with multiplicities, the first and last "
          "degree + 1. poles: (n, 3); weights: (n,), positive.")
      .def_static("chain", &pn::Curve::chain, py::arg("curves"),
                  "The curves end to end, each over an interval of its own length. Each must begin "
                  "exactly where the one before ends.")
      .def_property_readonly(
          "domain",
          [](const pn::Curve& curve) {
            const auto& breaks = curve.function().breaks;
            return py::make_tuple(breaks.front().to_double(), breaks.back().to_double());
          },
          "First and last parameter.")
      .def_property_readonly(
          "breaks",
          [](const pn::Curve& curve) {
            std::vector<double> breaks;
            for (const pn::Rational& t : curve.function().breaks) breaks.push_back(t.to_double());
            return array_of(breaks);
          },
          "The parameters at which spans begin and end.")
      .def_property_readonly("degree", &pn::Curve::degree, "The largest degree of a span.")
      .def_property_readonly(
          "spans", [](const pn::Curve& curve) { return spans_of(curve.function()); },
          "For each span its first and last parameter and, rounded, the Bernstein coefficients of "
          "(x w, y w, z w, w), (k + 1, 4).");

  py::class_<pn::Law>(module, "Law", "A radius law: a piecewise rational function, in millimetres.")
      .def_static("constant", &pn::Law::constant, py::arg("value"),
                  "The same radius everywhere; fits a spine of any domain.")
      .def_static(
          "bezier",
          [](const Array& coefficients, const std::optional<Array>& weights) {
            return pn::Law::bezier(vector_of(coefficients, "coefficients"), weights_of(weights));
          },
          py::arg("coefficients"), py::arg("weights") = py::none(),
          "A Bezier function over [0, 1]. coefficients: (k + 1,).")
      .def_static(
          "bspline",
          [](int degree, const Array& knots, const std::vector<int>& multiplicities,
             const Array& coefficients, const std::optional<Array>& weights) {
            return pn::Law::bspline({degree, vector_of(knots, "knots"), multiplicities,
                                     values_of(coefficients), weights_of(weights)});
          },
          py::arg("degree"), py::arg("knots"), py::arg("multiplicities"), py::arg("coefficients"),
          py::arg("weights") = py::none(), "A clamped B-spline function, like Curve.bspline.")
      .def(
          "spans_over",
          [](const pn::Law& law, const pn::Curve& spine) {
            const auto& breaks = spine.function().breaks;
            return spans_of(law.over(breaks.front(), breaks.back()));
          },
          py::arg("spine"),
          "The law over the domain of a spine, as Curve.spans gives it: (r w, w), (k + 1, 2).");
}

void define_outputs(py::module_& module) {
  using Surface = pn::BSplineSurface;
  const auto count = [](std::size_t n) { return static_cast<py::ssize_t>(n); };
  using ParameterCurve = pn::ParameterCurve;
  py::class_<ParameterCurve>(module, "ParameterCurve",
                             "A clamped B-spline curve in the parameter plane of a face.")
      .def_readonly("degree", &ParameterCurve::degree, "That of its polynomials.")
      .def_readonly("multiplicities", &ParameterCurve::multiplicities, "One for each knot.")
      .def_property_readonly(
          "knots", [](const ParameterCurve& c) { return array_of(c.knots); },
          "Strictly increasing.")
      .def_property_readonly(
          "poles",
          [count](const ParameterCurve& c) {
            Array result({count(c.poles.size()), py::ssize_t{2}});
            double* data = result.mutable_data();
            for (const auto& pole : c.poles) data = std::copy(pole.begin(), pole.end(), data);
            return result;
          },
          "(n, 2): u and v.");

  py::class_<Surface>(
      module, "BSplineSurface",
      "A face: a clamped rational B-spline surface. u runs along the spine, v around "
      "it; S_u x S_v points along the normal, on elliptic paraboloids against it.")
      .def_readonly("u_degree", &Surface::u_degree, "Along u.")
      .def_readonly("v_degree", &Surface::v_degree, "Along v.")
      .def_readonly("u_multiplicities", &Surface::u_multiplicities, "One for each u-knot.")
      .def_readonly("v_multiplicities", &Surface::v_multiplicities, "One for each v-knot.")
      .def_property_readonly(
          "u_knots", [](const Surface& s) { return array_of(s.u_knots); }, "Strictly increasing.")
      .def_property_readonly(
          "v_knots", [](const Surface& s) { return array_of(s.v_knots); }, "Strictly increasing.")
      .def_property_readonly(
          "poles",
          [count](const Surface& s) {
            return array_of(s.poles, {count(s.u_count()), count(s.v_count()), 3});
          },
          "(nu, nv, 3), millimetres.")
      .def_property_readonly(
          "weights",
          [count](const Surface& s) {
            return array_of(s.weights, {count(s.u_count()), count(s.v_count())});
          },
          "(nu, nv), positive.")
      .def_property_readonly(
          "trims", [](const Surface& s) { return s.trims; },
          "Closed loops of curves in (u, v), the region on their left, that bound the face; empty "
          "when it is the whole surface.");

  using FocalPoint = pn::FocalPoint;
  py::class_<FocalPoint>(module, "FocalPoint",
                         "A centre of curvature of the surface at distance zero: the offsets that "
                         "reach it are singular there.")
      .def_property_readonly(
          "base", [](const FocalPoint& f) { return array_of(f.base); },
          "The point (3,) of the surface at distance zero, in mm.")
      .def_property_readonly(
          "point", [](const FocalPoint& f) { return array_of(f.point); },
          "The singular point (3,), in mm.")
      .def_readonly("distance", &FocalPoint::distance,
                    "Of the singular offset, in mm: |distance| = |point - base|.");

  using SelfIntersection = pn::SelfIntersection;
  py::class_<SelfIntersection>(module, "SelfIntersection", "Where a surface crosses itself.")
      .def_property_readonly(
          "point", [](const SelfIntersection& s) { return array_of(s.point); }, "(3,), in mm.")
      .def_property_readonly(
          "faces",
          [](const SelfIntersection& s) {
            return py::make_tuple(s.places[0].face, s.places[1].face);
          },
          "Which two of bsplines() meet there, perhaps twice the same.")
      .def_property_readonly(
          "parameters",
          [](const SelfIntersection& s) {
            const auto& [a, b] = s.places;
            return py::make_tuple(py::make_tuple(a.u, a.v), py::make_tuple(b.u, b.v));
          },
          "((u, v), (u, v)) of the point on both faces.")
      .def_readonly("angle", &SelfIntersection::angle,
                    "Of the tangent planes, in radians, at most a right angle.");

  py::class_<pn::Certificate>(module, "Certificate", "What is proved of the exported faces.")
      .def_readonly("deviation", &pn::Certificate::deviation,
                    "Proven bound on the distance of the faces to the true envelope, in mm.")
      .def_readonly("precision_bits", &pn::Certificate::precision_bits,
                    "Of the balls that were needed.")
      .def_readonly("exact", &pn::Certificate::exact,
                    "Nothing of the input was fitted or closed up.")
      .def_property_readonly(
          "bidegree", [](const pn::Certificate& c) { return tuple_of(c.bidegree); },
          "The largest (degree in u, degree in v) of a face.")
      .def_readonly("poles", &pn::Certificate::poles, "Number of poles of all faces.")
      .def_readonly("notes", &pn::Certificate::notes, "What else was done, in sentences.")
      .def_readonly("trim_deviation", &pn::Certificate::trim_deviation,
                    "Distance of the edges of trimmed faces from the true boundary, in mm: "
                    "measured, not proven. Zero for whole faces.");
}

void define_surface(py::module_& module) {
  using Release = py::call_guard<py::gil_scoped_release>;
  py::class_<pn::PNSurface>(module, "PNSurface", "An exact surface with rational unit normals.")
      .def("offset", &pn::PNSurface::offset, py::arg("d"),
           "The surface at distance + d, in mm, on the side of the normal for d > 0. Cheap.")
      .def_property_readonly("distance", &pn::PNSurface::distance,
                             "From the surface that was made first, in mm.")
      .def_property_readonly("has_offsets", &pn::PNSurface::has_offsets,
                             "Surfaces at other distances than zero are rational.")
      .def_property_readonly(
          "degree", [](const pn::PNSurface& s) { return tuple_of(s.degree()); },
          "(degree along, degree around) of what the algebra delivers.")
      .def("evaluate", &evaluate, py::arg("t"), py::arg("u"),
           "Points and unit normals, each (n, 3), of the even faces at their parameters: t (n,) "
           "along "
           "the spine, over its domain, and u (n,) in [0, 4] around it.")
      .def_property_readonly(
          "regular_range",
          [](const pn::PNSurface& surface) {
            const pn::OffsetRange range = regular_range(surface);
            return py::make_tuple(range.lower, range.upper);
          },
          "Certified interval of distances, counted from distance zero, without a singular point; "
          "empty when the first number is not less than the second.")
      .def_property_readonly(
          "focal_points",
          [](const pn::PNSurface& surface) {
            const pn::OffsetRange range = regular_range(surface);
            return py::make_tuple(range.at_lower, range.at_upper);
          },
          "The first singular points below and above the regular range, each None where it has no "
          "end or nothing is proved. Estimates.")
      .def(
          "bsplines",
          [](const pn::PNSurface& surface, const std::string& lines) {
            const pn::Lines choice = lines_of(lines);
            const py::gil_scoped_release release;
            return surface.faces(choice);
          },
          py::arg("lines") = "even",
          "The faces: \"even\" gives smooth faces with even parameter lines, \"lowest_degree\" a "
          "face "
          "for every arc.")
      .def(
          "self_intersection",
          [](const pn::PNSurface& surface) {
            const py::gil_scoped_release release;
            return surface.self_intersection();
          },
          "Where this surface crosses itself at the widest angle, or None. Each one is confirmed; "
          "parts that cross at less than 1/64 rad count as touching.")
      .def_property_readonly(
          "certificate",
          [](const pn::PNSurface& surface) {
            const py::gil_scoped_release release;
            return surface.certificate(pn::Lines::kEven);
          },
          "The certificate of the even faces.")
      .def(
          "certificate_of",
          [](const pn::PNSurface& surface, const std::string& lines) {
            const pn::Lines choice = lines_of(lines);
            const py::gil_scoped_release release;
            return surface.certificate(choice);
          },
          py::arg("lines"), "The certificate of the faces that bsplines(lines) gives.");

  module.def(
      "canal_surface",
      [](const pn::Curve& spine, const pn::Law& radius) {
        return pn::PNSurface(pn::canal_surface(spine, radius));
      },
      py::arg("spine"), py::arg("radius"), Release(),
      "The envelope of spheres of radius r(t) along the spine m(t): x = m + r n with n.m' + r' = "
      "0. "
      "Its normal points away from the spine. Raises GeometryError.\n\n"
      ">>> spine = pn.Curve.bezier([[0, 0, 0], [10, 0, 0], [10, 10, 0]])\n"
      ">>> pipe = pn.canal_surface(spine, pn.Law.bezier([1, 2, 1]))\n"
      ">>> pipe.certificate.bidegree, pipe.certificate.deviation < 1e-13\n"
      "((8, 4), True)");

  module.def(
      "ruled_surface",
      [](const pn::Curve& a, const pn::Curve& b) { return pn::PNSurface(pn::ruled_surface(a, b)); },
      py::arg("curve_a"), py::arg("curve_b"), Release(),
      "The surface whose rulings join points of equal parameter, between the curves; the domain of "
      "the second is mapped to that of the first. With c(t, v) from curve_a (v = 0) to curve_b (v "
      "= "
      "1) its normal is on the side of c_t x c_v. Raises GeometryError.\n\n"
      ">>> a = pn.Curve.bezier([[0, 0, 0], [10, 0, 0]])\n"
      ">>> b = pn.Curve.bezier([[0, 10, 0], [10, 10, 10]])\n"
      ">>> pn.ruled_surface(a, b).offset(1).degree\n"
      "(5, 4)");

  module.def(
      "cone_envelope",
      [](const pn::Curve& centres_a, const pn::Law& radii_a, const pn::Curve& centres_b,
         const pn::Law& radii_b) {
        return pn::PNSurface(pn::cone_envelope(centres_a, radii_a, centres_b, radii_b));
      },
      py::arg("centres_a"), py::arg("radii_a"), py::arg("centres_b"), py::arg("radii_b"), Release(),
      "The envelope of the cones of revolution that touch the spheres of equal parameter, between "
      "both: the sheet whose normal is on the side of c_t x c_v. Raises GeometryError.\n\n"
      ">>> a = pn.Curve.bezier([[0, 0, 0], [10, 0, 0]])\n"
      ">>> b = pn.Curve.bezier([[0, 10, 0], [10, 10, 10]])\n"
      ">>> pn.cone_envelope(a, pn.Law.constant(1), b, pn.Law.constant(2)).degree\n"
      "(5, 4)");

  module.def(
      "quadric",
      [](const std::string& kind, double a, double b, double c,
         const std::optional<Bounds>& bounds) {
        const pn::QuadricKind which = kind_of(kind);
        const pn::QuadricBounds region = bounds_of(bounds);
        const py::gil_scoped_release release;
        return pn::PNSurface(pn::quadric(which, {a, b, c}, region));
      },
      py::arg("kind"), py::arg("a"), py::arg("b"), py::arg("c"), py::arg("bounds") = py::none(),
      "A quadric in standard position with half-axes in mm: \"ellipsoid\" (d > 0 outwards), "
      "\"one_sheet_hyperboloid\", \"two_sheet_hyperboloid\" (the sheet z > 0), "
      "\"elliptic_paraboloid\" z = c (x^2/a^2 + y^2/b^2), \"elliptic_cylinder\", \"elliptic_cone\" "
      "(d > 0 away from the axis), \"hyperbolic_paraboloid\" z = c (x^2/a^2 - y^2/b^2) (d > 0 "
      "upwards). bounds of the base surface: {\"x\": (lo, hi), \"y\": ..., \"z\": ..., \"angle\": "
      "...}, "
      "each optional, in mm and radians about z. Raises GeometryError.\n\n"
      ">>> lower, upper = pn.quadric(\"ellipsoid\", 3, 2, 1).regular_range\n"
      ">>> round(lower, 6), upper\n"
      "(-0.333333, inf)");
}

}  // namespace

PYBIND11_MODULE(pnkernel, module) {
  module.doc() = "Exact offset surfaces with rational unit normals. Millimetres, NumPy arrays.";
  module.attr("__version__") = PN_VERSION;
  define_error(module);
  define_cancellation(module);
  define_inputs(module);
  define_outputs(module);
  define_surface(module);
  define_sphere_families(module);
  define_surfaces_from_functions(module);
  define_rational_envelope(module);
  define_moebius_canal_surface(module);
  define_moving_conic_section(module);
  define_conic_surfaces(module);
  define_rational_conics(module);
  define_quadratic_cones(module);
}
