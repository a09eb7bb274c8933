// SPDX-License-Identifier: LGPL-2.1-or-later
// The Python module pnocct: B-spline faces as shapes of OpenCASCADE, passed as BREP text.
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>
#include <BRep_Builder.hxx>
#include <TopoDS_Compound.hxx>

#include "pn/occt/brep.hpp"
#include "pn/occt/bspline_geometry.hpp"
#include "pn/occt/caps.hpp"
#include "pn/occt/curve_on_surface.hpp"
#include "pn/occt/mass.hpp"
#include "pn/occt/occt_error.hpp"
#include "pn/occt/shape_check.hpp"
#include "pn/occt/shell.hpp"
#include "pn/occt/spherical_caps.hpp"
#include "pn/occt/step.hpp"
#include "pn/occt/thick_solid.hpp"
#include "pn/occt/triangulation.hpp"

namespace py = pybind11;

namespace {

using DoubleArray = py::array_t<double, py::array::c_style | py::array::forcecast>;

pn::ParameterCurve parameter_curve_from(const py::handle& object) {
  pn::ParameterCurve curve;
  curve.degree = object.attr("degree").cast<int>();
  curve.knots = object.attr("knots").cast<std::vector<double>>();
  curve.multiplicities = object.attr("multiplicities").cast<std::vector<int>>();
  const auto poles = object.attr("poles").cast<DoubleArray>();
  if (poles.ndim() != 2 || poles.shape(1) != 2) {
    throw std::invalid_argument("The poles of a trim have the shape (n, 2).");
  }
  for (py::ssize_t i = 0; i < poles.shape(0); ++i) {
    curve.poles.push_back({poles.at(i, 0), poles.at(i, 1)});
  }
  return curve;
}

pn::TrimLoop trim_loop_from(const py::iterable& curves) {
  pn::TrimLoop loop;
  for (const py::handle curve : curves) loop.push_back(parameter_curve_from(curve));
  return loop;
}

// Any object with the attributes of pnkernel.BSplineSurface.
pn::BSplineSurface surface_from(const py::handle& face) {
  pn::BSplineSurface surface;
  surface.u_degree = face.attr("u_degree").cast<int>();
  surface.v_degree = face.attr("v_degree").cast<int>();
  surface.u_knots = face.attr("u_knots").cast<std::vector<double>>();
  surface.v_knots = face.attr("v_knots").cast<std::vector<double>>();
  surface.u_multiplicities = face.attr("u_multiplicities").cast<std::vector<int>>();
  surface.v_multiplicities = face.attr("v_multiplicities").cast<std::vector<int>>();
  const auto poles = face.attr("poles").cast<DoubleArray>();
  const auto weights = face.attr("weights").cast<DoubleArray>();
  if (poles.ndim() != 3 || poles.shape(2) != 3) {
    throw std::invalid_argument("The poles of a face have the shape (nu, nv, 3).");
  }
  if (weights.ndim() != 2 || weights.shape(0) != poles.shape(0) ||
      weights.shape(1) != poles.shape(1)) {
    throw std::invalid_argument("The weights of a face have the shape (nu, nv) of its poles.");
  }
  for (py::ssize_t i = 0; i < poles.shape(0); ++i) {
    for (py::ssize_t j = 0; j < poles.shape(1); ++j) {
      surface.poles.push_back({poles.at(i, j, 0), poles.at(i, j, 1), poles.at(i, j, 2)});
      surface.weights.push_back(weights.at(i, j));
    }
  }
  for (const py::handle loop : face.attr("trims")) {
    surface.trims.push_back(trim_loop_from(py::cast<py::iterable>(loop)));
  }
  return surface;
}

py::object face_from(const pn::BSplineSurface& surface) {
  using py::literals::operator""_a;
  const auto nu = static_cast<py::ssize_t>(surface.u_count());
  const auto nv = static_cast<py::ssize_t>(surface.v_count());
  const auto array = [](const auto& values) { return py::array(values.size(), values.data()); };
  return py::module_::import("types").attr("SimpleNamespace")(
      "u_degree"_a = surface.u_degree, "v_degree"_a = surface.v_degree,
      "u_knots"_a = array(surface.u_knots), "v_knots"_a = array(surface.v_knots),
      "u_multiplicities"_a = array(surface.u_multiplicities),
      "v_multiplicities"_a = array(surface.v_multiplicities),
      "poles"_a = DoubleArray({nu, nv, py::ssize_t{3}}, surface.poles.front().data()),
      "weights"_a = DoubleArray({nu, nv}, surface.weights.data()), "trims"_a = py::list());
}

std::vector<pn::BSplineSurface> surfaces_from(const py::iterable& faces) {
  std::vector<pn::BSplineSurface> surfaces;
  for (const py::handle face : faces) surfaces.push_back(surface_from(face));
  return surfaces;
}

// A single shape as it is, several as a compound.
template <typename Shape>
TopoDS_Shape together(const std::vector<Shape>& shapes) {
  if (shapes.size() == 1) return shapes.front();
  const BRep_Builder builder;
  TopoDS_Compound compound;
  builder.MakeCompound(compound);
  for (const Shape& shape : shapes) builder.Add(compound, shape);
  return compound;
}

// FreeCAD draws the triangulations that it finds; to make them it would hold up its window.
std::string drawable_brep(const TopoDS_Shape& shape) {
  return pn::to_brep(pn::triangulated(shape));
}

std::string shell(const py::iterable& faces) {
  const auto surfaces = surfaces_from(faces);
  const py::gil_scoped_release release;
  return drawable_brep(together(pn::make_shells(surfaces)));
}

std::string capped_solid(const py::iterable& faces) {
  const auto surfaces = surfaces_from(faces);
  const py::gil_scoped_release release;
  std::vector<TopoDS_Solid> solids;
  for (const TopoDS_Shell& part : pn::make_shells(surfaces)) {
    solids.push_back(pn::make_capped_solid(part));
  }
  return drawable_brep(together(solids));
}

std::string domed_solid(const py::iterable& faces) {
  const auto surfaces = surfaces_from(faces);
  const py::gil_scoped_release release;
  std::vector<TopoDS_Solid> solids;
  for (const TopoDS_Shell& part : pn::make_shells(surfaces)) {
    solids.push_back(pn::make_domed_solid(part));
  }
  return drawable_brep(together(solids));
}

std::string thick_solid(const py::iterable& inner_faces, const py::iterable& outer_faces) {
  const auto inner = surfaces_from(inner_faces), outer = surfaces_from(outer_faces);
  const py::gil_scoped_release release;
  return drawable_brep(together(pn::make_thick_solids(inner, outer)));
}

std::string domed_thick_solid(const py::iterable& inner_faces, const py::iterable& outer_faces) {
  const auto inner = surfaces_from(inner_faces), outer = surfaces_from(outer_faces);
  const py::gil_scoped_release release;
  return drawable_brep(pn::make_thick_solid(pn::make_domed_shell(pn::make_shell(inner)),
                                            pn::make_domed_shell(pn::make_shell(outer))));
}

std::vector<std::string> check(const std::string& brep, bool boolean) {
  const TopoDS_Shape shape = pn::from_brep(brep);
  const auto faults = pn::faults(shape);
  return faults.empty() && boolean ? pn::boolean_faults(shape) : faults;
}

pn::StepSchema schema_named(const std::string& name) {
  if (name == "AP203") return pn::StepSchema::kAp203;
  if (name == "AP214") return pn::StepSchema::kAp214;
  if (name == "AP242") return pn::StepSchema::kAp242;
  throw std::invalid_argument("The STEP schema is AP203, AP214 or AP242, not " + name + ".");
}

py::dict report_from(const pn::StepReport& report) {
  using py::literals::operator""_a;
  const pn::RoundTrip& found = report.round_trip;
  return py::dict("faces"_a = found.faces, "bspline_faces"_a = found.bspline_faces,
                  "poles"_a = found.poles, "volume"_a = found.volume, "bytes"_a = report.bytes);
}

// What `progress`, a function of Python or None, raises is kept for the caller: it may not pass
// through OpenCASCADE.
class PythonProgress {
 public:
  explicit PythonProgress(py::object progress) : progress_(std::move(progress)) {}

  bool operator()(double fraction) {
    if (progress_.is_none()) return true;
    try {
      progress_(fraction);
      return true;
    } catch (const py::error_already_set&) {
      raised_ = std::current_exception();
      return false;
    }
  }

  void rethrow() const {
    if (raised_) std::rethrow_exception(raised_);
  }

 private:
  py::object progress_;
  std::exception_ptr raised_;
};

py::dict write_step(const std::filesystem::path& path, const std::vector<std::string>& shapes,
                    const std::vector<std::string>& names, const std::string& schema, bool pcurves,
                    py::object progress) {
  if (shapes.size() != names.size()) {
    throw std::invalid_argument("Every shape of a STEP file needs one name.");
  }
  std::vector<pn::NamedShape> named;
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    named.push_back({pn::from_brep(shapes[i]), names[i]});
  }
  PythonProgress shown(std::move(progress));
  try {
    return report_from(
        pn::write_verified_step(path, named, {schema_named(schema), pcurves}, std::ref(shown)));
  } catch (const pn::Cancelled&) {
    shown.rethrow();
    throw;
  }
}

std::vector<std::string> read_step(const std::filesystem::path& path) {
  std::vector<std::string> shapes;
  for (const TopoDS_Shape& shape : pn::read_step(path)) shapes.push_back(pn::to_brep(shape));
  return shapes;
}

std::vector<py::object> faces(const std::string& brep) {
  std::vector<py::object> result;
  for (const pn::BSplineSurface& surface : pn::bspline_surfaces(pn::from_brep(brep))) {
    result.push_back(face_from(surface));
  }
  return result;
}

std::pair<double, double> pair_of(const pn::Measure& measure) {
  return {measure.value, measure.error};
}

double volume(const std::string& brep) { return pn::volume(pn::from_brep(brep)); }
double area(const std::string& brep) { return pn::area(pn::from_brep(brep)); }
double trim_deviation(const std::string& brep) { return pn::trim_deviation(pn::from_brep(brep)); }

// Files that cannot be opened or written are OSErrors, with the file's name and the system's
// reason.
void translate_file_error(std::exception_ptr error) {
  try {
    if (error) std::rethrow_exception(error);
  } catch (const std::filesystem::filesystem_error& file_error) {
    errno = file_error.code().value();
    PyErr_SetFromErrnoWithFilename(PyExc_OSError, file_error.path1().c_str());
  }
}

}  // namespace

PYBIND11_MODULE(pnocct, m) {
  using py::literals::operator""_a;
  m.doc() =
      "B-spline faces as shapes of OpenCASCADE: shells, solids, checks, measures and STEP.\n\n"
      "Shapes are BREP texts (str), which FreeCAD reads with Part.Shape.importBrepFromString.\n"
      "Lengths are millimetres. A face is any object with the attributes of\n"
      "pnkernel.BSplineSurface; its trims are closed loops, lists of curves with the attributes\n"
      "degree, knots, multiplicities and poles (n, 2), the face to the left. Input that cannot be "
      "a\n"
      "shape raises ValueError, a failure inside OpenCASCADE raises OcctError.";
  py::register_exception<pn::OcctError>(m, "OcctError", PyExc_RuntimeError).doc() =
      "A failure inside OpenCASCADE, with OpenCASCADE's message.";
  py::register_exception<pn::RoundTripError>(m, "RoundTripError", PyExc_RuntimeError).doc() =
      "A file does not hold what was written: a sentence on each difference.";
  py::register_local_exception_translator(translate_file_error);

  m.def("shell", &shell, "faces"_a,
        "Return the shell of the faces, or a compound of a shell for each part that hangs "
        "together.\n\n"
        "Sides of faces that have the same poles, bit for bit and in either direction, are one\n"
        "edge, and so are pieces of such sides between the same points, and trims with the same\n"
        "points. Edges along trims inside a surface lie within 1e-9 mm of it. Raises ValueError "
        "when there is no face or a loop of\n"
        "trims is not closed.");
  m.def("capped_solid", &capped_solid, "faces"_a,
        "Return the solid inside the shell of the faces, its open ends closed by planar faces.\n\n"
        "Faces of several parts give a compound of solids. Raises ValueError when an open end is\n"
        "not planar or not closed.\n\n"
        ">>> spine = pn.Curve.bezier([[0, 0, 0], [0, 0, 10]])\n"
        ">>> pipe = pn.canal_surface(spine, pn.Law.constant(2))\n"
        ">>> solid = pnocct.capped_solid(pipe.bsplines())\n"
        ">>> round(pnocct.volume(solid), 9)\n"
        "125.663706144");
  m.def(
      "domed_solid", &domed_solid, "faces"_a,
      "Return the solid inside the shell of the faces, its open ends closed by parts of "
      "spheres.\n\n"
      "A canal surface ends along a circle of the sphere of its last parameter; the cap is the\n"
      "part of that sphere beyond it, tangent to the surface. Faces of several parts give a\n"
      "compound of solids. Raises ValueError when no sphere touches the faces along an open end.");
  m.def(
      "thick_solid", &thick_solid, "inner_faces"_a, "outer_faces"_a,
      "Return the solid between two offsets of one surface, or two pipes around one spine.\n\n"
      "Closed shells, the first inside the second, make a solid with a void; open ones are joined\n"
      "by ruled walls along their free edges. Faces of several parts give a compound of solids.\n"
      "That they do not touch is not examined. Raises ValueError when only one shell is closed,\n"
      "when the first does not lie inside the second, and when the free edges of open shells do\n"
      "not correspond.");
  m.def(
      "domed_thick_solid", &domed_thick_solid, "inner_faces"_a, "outer_faces"_a,
      "Return the solid between two surfaces, one inside the other, with a void: the open ends of\n"
      "both are closed by parts of spheres as in domed_solid, and need not correspond.");
  m.def("check", &check, "brep"_a, "boolean"_a = false,
        "Return the faults of a shape as sentences; none when it is valid.\n\n"
        "With boolean=True a valid shape is also examined as an argument of Boolean operations,\n"
        "as FreeCAD's Shape.check(True) does; this takes some 40 ms a face.");
  m.def("volume", &volume, "brep"_a,
        "Return the volume (mm^3) inside the closed shells of a shape, by adaptive quadrature.\n\n"
        "Raises ValueError when no shell is closed.");
  m.def("area", &area, "brep"_a,
        "Return the area (mm^2) of the faces of a shape, by adaptive quadrature.");
  m.def("trim_deviation", &trim_deviation, "brep"_a,
        "Return the greatest distance (mm) between an edge and its curve on a face.\n\n"
        "Exact edges contribute their rounding, those along trims the error of their fit. It is\n"
        "measured at many points, not proved.");
  m.def(
      "measured_volume",
      [](const std::string& brep) { return pair_of(pn::measured_volume(pn::from_brep(brep))); },
      "brep"_a, py::call_guard<py::gil_scoped_release>(),
      "Return the volume (mm^3) and an estimate of its error, as `volume`.");
  m.def(
      "measured_area",
      [](const std::string& brep) { return pair_of(pn::measured_area(pn::from_brep(brep))); },
      "brep"_a, py::call_guard<py::gil_scoped_release>(),
      "Return the area (mm^2) and an estimate of its error, as `area`.");
  m.def(
      "write_step", &write_step, "path"_a, "shapes"_a, "names"_a, "schema"_a = "AP214",
      "pcurves"_a = true, "progress"_a = py::none(),
      "Write shapes to a STEP file, one product each, with every double kept, and read it back.\n\n"
      "names has one name for each shape; schema is AP203, AP214 or AP242; pcurves=False leaves\n"
      "out the p-curves of the edges. progress is called with the part that is done, from 0 to 1;\n"
      "what it raises breaks the export off. The file appears, and replaces an old one, only when\n"
      "it is complete and holds what was written: faces, poles, weights and knots bit for bit,\n"
      "areas, volume, validity. Returns what was compared: a dict with faces, bspline_faces,\n"
      "poles, volume and bytes. Raises OSError when the file cannot be written,\n"
      "RoundTripError when it does not hold what was written.");
  m.def("read_step", &read_step, "path"_a,
        "Return the shapes of a STEP file, one for each root product.\n\n"
        "Raises OSError when the file cannot be opened, OcctError when nothing can be read.");
  m.def("faces", &faces, "brep"_a,
        "Return the surfaces under the faces of a shape, whole even where a face is trimmed.\n\n"
        "They are plain objects with the attributes of pnkernel.BSplineSurface; periodic surfaces\n"
        "come back clamped. Raises ValueError when a face does not lie on a B-spline surface.");
}
