// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sphere_families.hpp"

#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <cstdint>

#include "arrays.hpp"
#include "pn/algebra/parallel.hpp"
#include "pn/bezier/pn_surface.hpp"
#include "pn/bezier/rounded_solid.hpp"
#include "pn/bezier/skin.hpp"
#include "pn/bezier/spline_skin.hpp"
#include "pn/bezier/translational_skin.hpp"
#include "pn/isotropic/family_type.hpp"
#include "pn/shapes/powell_sabin.hpp"
#include "pn/shapes/sphere_family.hpp"
#include "pn/shapes/translational_spheres.hpp"

namespace py = pybind11;

namespace {

std::vector<std::array<double, 4>> sphere_poles_of(const Array& array) {
  if (array.ndim() != 2 || array.shape(1) != 4) {
    throw wrong_shape("The spheres must be an array of shape (n, 4).");
  }
  std::vector<std::array<double, 4>> spheres(static_cast<std::size_t>(array.shape(0)));
  for (std::size_t i = 0; i < spheres.size(); ++i) {
    std::copy_n(array.data() + 4 * i, 4, spheres[i].begin());
  }
  return spheres;
}

std::array<std::array<double, 4>, 6> spheres_of(const Array& array) {
  if (array.ndim() != 2 || array.shape(0) != 6 || array.shape(1) != 4) {
    throw wrong_shape("The control spheres must be an array of shape (6, 4).");
  }
  std::array<std::array<double, 4>, 6> spheres;
  for (std::size_t i = 0; i < 6; ++i) std::copy_n(array.data() + 4 * i, 4, spheres[i].begin());
  return spheres;
}

using Integers = py::array_t<std::int64_t, py::array::c_style>;

std::vector<pn::Triangle> triangles_of(const Integers& array) {
  if (array.ndim() != 2 || array.shape(1) != 3) {
    throw wrong_shape("The triangles must be an array of shape (m, 3).");
  }
  std::vector<pn::Triangle> triangles(static_cast<std::size_t>(array.shape(0)));
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::int64_t corner = array.data()[3 * t + k];
      if (corner < 0) throw wrong_shape("The number of a point must not be negative.");
      triangles[t][k] = static_cast<std::size_t>(corner);
    }
  }
  return triangles;
}

std::vector<pn::PlacedSphere> placed_spheres_of(const Array& points, const Array& radii,
                                                const Array& derivatives,
                                                const std::optional<Array>& parameters) {
  const std::vector<std::array<double, 3>> centres = points_of(points);
  const std::vector<double> lengths = vector_of(radii, "radii");
  const auto count = static_cast<py::ssize_t>(centres.size());
  if (radii.shape(0) != count) throw wrong_shape("There must be as many radii as points.");
  if (derivatives.ndim() != 3 || derivatives.shape(0) != count || derivatives.shape(1) != 2 ||
      derivatives.shape(2) != 4) {
    throw wrong_shape("The derivatives must be an array of shape (n, 2, 4) for n points.");
  }
  if (parameters &&
      (parameters->ndim() != 2 || parameters->shape(0) != count || parameters->shape(1) != 2)) {
    throw wrong_shape("The parameters must be an array of shape (n, 2) for n points.");
  }
  std::vector<pn::PlacedSphere> spheres(centres.size());
  for (std::size_t i = 0; i < spheres.size(); ++i) {
    const auto& [x, y, z] = centres[i];
    spheres[i].sphere = {x, y, z, lengths[i]};
    spheres[i].parameter = {x, y};
    if (parameters) std::copy_n(parameters->data() + 2 * i, 2, spheres[i].parameter.begin());
    for (std::size_t k = 0; k < 2; ++k) {
      std::copy_n(derivatives.data() + 8 * i + 4 * k, 4, spheres[i].derivatives[k].begin());
    }
  }
  return spheres;
}

/// The outer and the inner skin. Without the interpreter's lock, since it takes time.
template <class Skin, class Family>
std::array<pn::PNSurface, 2> skins_of(const Family& family, const std::vector<std::string>& notes) {
  const py::gil_scoped_release release;
  std::array<std::shared_ptr<const Skin>, 2> skins;
  pn::for_each_index(2, [&](std::size_t i) {
    const pn::Sheet sheet = i == 0 ? pn::Sheet::kOuter : pn::Sheet::kInner;
    skins[i] = std::make_shared<const Skin>(family, sheet, notes);
  });
  return {pn::PNSurface(skins[0]), pn::PNSurface(skins[1])};
}

void define_sphere_family(py::module_& module) {
  using Family = pn::SphereFamily;
  py::class_<Family>(module, "SphereFamily",
                     "A two-parameter family of spheres f(u, v) = (m, r) over the triangle u, v >= "
                     "0, u + v <= 1: a mid-surface m with half thickness r.")
      .def_property_readonly(
          "skins",
          [](const Family& family) {
            const auto [outer, inner] = skins_of<pn::Skin>(family.family, family.notes);
            return py::make_tuple(outer, inner);
          },
          "The two PNSurfaces m + r n: the outer one, whose normal n is on the side of m_u x m_v, "
          "and the inner one. Both normals point away from the mid-surface, so offsets d > 0 "
          "thicken. Raises GeometryError.")
      .def(
          "solid",
          [](const Family& family, double distance) {
            const py::gil_scoped_release release;
            return pn::PNSurface(
                       std::make_shared<const pn::RoundedSolid>(family.family, family.notes))
                .offset(distance);
          },
          py::arg("distance") = 0.0,
          "The boundary of the union of all balls of radius r + distance, as one closed PNSurface: "
          "the faces of both skins, a strip along each edge, a part of the sphere at each corner. "
          "Raises GeometryError, also where a radius is not positive.")
      .def_readonly("notes", &Family::notes, "What to know of the family, in sentences.");

  module.def(
      "sphere_family",
      [](const Array& control_spheres) { return pn::sphere_family(spheres_of(control_spheres)); },
      py::arg("control_spheres"),
      "The family of six spheres (6, 4), centre and radius in mm, in the order b200, b110, b020, "
      "b101, b011, b002: the control points of a quadratic triangular Bezier surface. Raises "
      "GeometryError where it has no real envelope.");
}

/// (k, 3, 2)
Array corners_of(const std::vector<pn::FamilyPart>& parts) {
  Array corners({static_cast<py::ssize_t>(parts.size()), py::ssize_t{3}, py::ssize_t{2}});
  double* out = corners.mutable_data();
  for (const pn::FamilyPart& part : parts) {
    for (const auto& corner : part.corners) out = std::copy(corner.begin(), corner.end(), out);
  }
  return corners;
}

/// (k, 6, 4)
Array spheres_of_parts(const std::vector<pn::FamilyPart>& parts) {
  Array spheres({static_cast<py::ssize_t>(parts.size()), py::ssize_t{6}, py::ssize_t{4}});
  double* out = spheres.mutable_data();
  for (const pn::FamilyPart& part : parts) {
    for (const auto& [x, y, z, minus_r] : part.family.control()) {
      for (const pn::Rational& c : {x, y, z, -minus_r}) *out++ = c.to_double();
    }
  }
  return spheres;
}

void define_real_region(py::module_& module) {
  module.def(
      "real_region",
      [](const Array& control_spheres, int halvings) {
        const pn::RealRegion region =
            pn::real_region(pn::quadratic_family(spheres_of(control_spheres)), halvings);
        py::dict result;
        result["real"] = corners_of(region.real);
        result["unreal"] = corners_of(region.unreal);
        result["border"] = corners_of(region.border);
        result["families"] = spheres_of_parts(region.real);
        return result;
      },
      py::arg("control_spheres"), py::arg("halvings") = 5,
      "Where the family of six spheres (6, 4) has a real envelope, over triangles of (u, v) by "
      "their corners (k, 3, 2): 'real' and 'unreal', both proved, and the 'border' between, of "
      "triangles 2^-halvings as wide as the whole one. 'families' (k, 6, 4) are the control "
      "spheres "
      "over those of 'real', rounded, for sphere_family. Raises GeometryError for what is not "
      "finite.");
}

void define_translational_spheres(py::module_& module) {
  py::class_<pn::SphereSpline>(module, "SphereSpline",
                               "A curve of spheres: a spline of centre and radius, in millimetres.")
      .def_static(
          "bezier",
          [](const Array& spheres) { return pn::SphereSpline::bezier(sphere_poles_of(spheres)); },
          py::arg("spheres"), "A Bezier curve over [0, 1]. spheres: (k + 1, 4), (x, y, z, r).")
      .def_static(
          "bspline",
          [](int degree, const Array& knots, const std::vector<int>& multiplicities,
             const Array& spheres) {
            return pn::SphereSpline::bspline(
                {degree, vector_of(knots, "knots"), multiplicities, sphere_poles_of(spheres), {}});
          },
          py::arg("degree"), py::arg("knots"), py::arg("multiplicities"), py::arg("spheres"),
          "A clamped B-spline, like Curve.bspline. spheres: (n, 4), (x, y, z, r).");

  using Spheres = pn::TranslationalSpheres;
  py::class_<Spheres>(module, "TranslationalSpheres",
                      "A two-parameter family of spheres f(u, v) = c(u) + d(v): a curve of spheres "
                      "that is translated along another one.")
      .def_property_readonly(
          "skins",
          [](const Spheres& spheres) {
            const auto [outer, inner] =
                skins_of<pn::TranslationalSkin>(spheres.spline, spheres.notes);
            return py::make_tuple(outer, inner);
          },
          "The two PNSurfaces m + r n: the outer one, whose normal n is on the side of m_u x m_v, "
          "and the inner one. Both normals point away from the mid-surface, so offsets d > 0 "
          "thicken. Raises GeometryError.")
      .def_readonly("notes", &Spheres::notes, "What to know of the family, in sentences.");

  module.def("sphere_family_translational", &pn::translational_spheres, py::arg("curve_c"),
             py::arg("curve_d"), py::call_guard<py::gil_scoped_release>(),
             "The family whose spheres have the centres m_c(u) + m_d(v) and the radii r_c(u) + "
             "r_d(v), of two SphereSplines of degree 1 or 2. Raises GeometryError where it has no "
             "real envelope, and where a curve has a corner.\n\n"
             ">>> c = pn.SphereSpline.bezier([[0, 0, 0, 2], [10, 0, 5, 1], [20, 0, 0, 2]])\n"
             ">>> d = pn.SphereSpline.bezier([[0, 0, 0, 0], [0, 20, 0, 0]])\n"
             ">>> outer, inner = pn.sphere_family_translational(c, d).skins\n"
             ">>> outer.offset(0.5).degree\n"
             "(1, 6)");
}

void define_powell_sabin_family(py::module_& module) {
  using Family = pn::PowellSabinFamily;
  py::class_<Family>(
      module, "PowellSabinFamily",
      "A two-parameter family of spheres f(s, t) = (m, r) over a triangulation of the "
      "parameter plane: C1, and quadratic on six parts of every triangle.")
      .def_property_readonly(
          "skins",
          [](const Family& family) {
            const auto [outer, inner] = skins_of<pn::SplineSkin>(family.spline, family.notes);
            return py::make_tuple(outer, inner);
          },
          "The two PNSurfaces m + r n: the outer one, whose normal n is on the side of m_s x m_t, "
          "and the inner one. Both are G1, with at least six faces for every triangle, in the "
          "order "
          "of the triangles. Both normals point away from the mid-surface, so offsets d > 0 "
          "thicken. Raises GeometryError.")
      .def_property_readonly(
          "pieces",
          [](const Family& family) {
            const auto& pieces = family.spline.pieces;
            const auto count = static_cast<py::ssize_t>(pieces.size());
            Array corners({count, py::ssize_t{3}, py::ssize_t{2}}),
                spheres({count, py::ssize_t{6}, py::ssize_t{4}});
            double *corner = corners.mutable_data(), *sphere = spheres.mutable_data();
            for (const pn::FamilyPiece& piece : pieces) {
              const auto [at_w, at_u, at_v] = piece.corners;
              for (const std::size_t k : {at_u, at_v, at_w}) {
                for (const pn::Rational& x : family.spline.corners[k]) *corner++ = x.to_double();
              }
              for (const auto& control : piece.family.control()) {
                for (std::size_t c = 0; c < 3; ++c) *sphere++ = control[c].to_double();
                *sphere++ = -control[3].to_double();
              }
            }
            return py::make_tuple(corners, spheres);
          },
          "The quadratic pieces, six in a row for every triangle, rounded: their corners u = 1, v "
          "= "
          "1, w = 1 in the parameter plane, (6 m, 3, 2), and their control spheres in the order of "
          "sphere_family, (6 m, 6, 4).")
      .def_readonly("notes", &Family::notes, "What to know of the family, in sentences.");

  module.def(
      "sphere_family_powell_sabin",
      [](const Array& points, const Array& radii, const Array& derivatives,
         const Integers& triangles, const std::optional<Array>& parameters) {
        const auto spheres = placed_spheres_of(points, radii, derivatives, parameters);
        const auto corners = triangles_of(triangles);
        const py::gil_scoped_release release;
        return pn::powell_sabin_family(spheres, corners);
      },
      py::arg("points"), py::arg("radii"), py::arg("derivatives"), py::arg("triangles"),
      py::arg("parameters") = py::none(),
      "The C1 quadratic family on the Powell-Sabin split of a triangulation, with a sphere and a "
      "tangent plane at every point. points: (n, 3), radii: (n,), in mm; derivatives: (n, 2, 4), "
      "those of (x, y, z, r) by the parameters s and t; triangles: (m, 3), numbers of points, "
      "counterclockwise in the parameter plane; parameters: (n, 2), the (s, t) of every point. "
      "Without them s and t are x and y, as for a mid-surface over the plane z = 0. Raises "
      "GeometryError where it is no triangulation or has no real envelope, and names the "
      "triangle.");
}

void define_classifiers(py::module_& module) {
  module.def(
      "classify_family",
      [](const Array& control_spheres) {
        const pn::FamilyType type =
            pn::family_type(pn::quadratic_family(spheres_of(control_spheres)));
        py::dict result;
        result["family"] = type.family;
        result["centres"] = type.centres;
        result["radius"] = type.radius;
        result["net"] = type.net ? py::cast(pn::name(*type.net)) : py::none();
        return result;
      },
      py::arg("control_spheres"),
      "The kind of the family of six spheres (6, 4), with or without a real envelope, decided "
      "exactly: the affine classes of 'family', 'centres' and 'radius' by their names in D. "
      "Gruber's table, as '4-2-1', and the type of the 'net' of normal lines at infinity, as "
      "'hyperbolic S/P', or None when they lie in no net. Raises GeometryError.\n\n"
      ">>> flat = [[x, y, 0, 1] for x, y in [(0, 0), (5, 0), (10, 0), (0, 5), (5, 5), (0, 10)]]\n"
      ">>> pn.classify_family(flat)[\"radius\"]\n"
      "'0-0'");
}

}  // namespace

void define_sphere_families(py::module_& module) {
  define_sphere_family(module);
  define_real_region(module);
  define_translational_spheres(module);
  define_powell_sabin_family(module);
  define_classifiers(module);
}
