// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/occt/step.hpp"

#include <BRepBuilderAPI_MakeFace.hxx>
#include <Geom_OffsetSurface.hxx>
#include <Interface_Static.hxx>
#include <Precision.hxx>
#include <STEPCAFControl_Controller.hxx>
#include <algorithm>
#include <catch2/catch.hpp>
#include <fstream>
#include <sstream>

#include "pn/occt/bspline_geometry.hpp"
#include "pn/occt/caps.hpp"
#include "pn/occt/mass.hpp"
#include "pn/occt/occt_error.hpp"
#include "pn/occt/shape_check.hpp"
#include "pn/occt/shell.hpp"
#include "pn/occt/thick_solid.hpp"
#include "trimmed_surfaces.hpp"

namespace fs = std::filesystem;
using pn::read_step;
using pn::StepOptions;
using pn::StepSchema;
using pn::write_step;
using pn::write_verified_step;

namespace {

// An empty folder for the life of this object.
class TemporaryFolder {
 public:
  TemporaryFolder() : path_(fs::temp_directory_path() / "pn_step_test") {
    fs::remove_all(path_);
    fs::create_directory(path_);
  }
  ~TemporaryFolder() { fs::remove_all(path_); }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  fs::path operator/(const std::string& name) const { return path_ / name; }
  bool is_empty() const { return fs::is_empty(path_); }

 private:
  fs::path path_;
};

std::string text_of(const fs::path& path) {
  std::ostringstream text;
  text << std::ifstream(path).rdbuf();
  return text.str();
}

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

// A setting of the process that a host program has made, until the end of the test.
class HostSetting {
 public:
  HostSetting(const char* name, const char* value) : name_(name) {
    STEPCAFControl_Controller::Init();
    previous_ = Interface_Static::CVal(name);
    REQUIRE(Interface_Static::SetCVal(name, value));
  }
  ~HostSetting() { Interface_Static::SetCVal(name_, previous_.c_str()); }
  HostSetting(const HostSetting&) = delete;
  HostSetting& operator=(const HostSetting&) = delete;

  std::string value() const { return Interface_Static::CVal(name_); }

 private:
  const char* name_;
  std::string previous_;
};

const std::vector<pn::BSplineSurface> kTubes = {pn::test::tube(1. / 3, 0.1, 2. / 3, 0.7),
                                                pn::test::tube(2. / 3, 0.7, 1. / 7, 0.9)};

}  // namespace

TEST_CASE("Every surface comes back from STEP bit for bit") {
  const TemporaryFolder folder;
  const std::vector<pn::BSplineSurface> torus = {pn::test::torus(10 / 3., 1e-3)};
  const auto halves = pn::test::sphere_halves();
  const auto schema = GENERATE(StepSchema::kAp203, StepSchema::kAp214, StepSchema::kAp242);
  const bool p_curves = GENERATE(true, false);
  write_step(folder / "three.step",
             {{pn::make_shell(kTubes), "tubes"},
              {pn::make_capped_solid(pn::make_shell(torus)), "torus"},
              {pn::make_capped_solid(pn::make_shell(halves)), "sphere"}},
             {schema, p_curves});
  const auto shapes = read_step(folder / "three.step");
  REQUIRE(shapes.size() == 3);
  const std::vector<std::vector<pn::BSplineSurface>> originals = {kTubes, torus, halves};
  for (int i = 0; i < 3; ++i) {
    CHECK(pn::faults(shapes[i]).empty());
    CHECK(pn::boolean_faults(shapes[i]).empty());
    const auto surfaces = pn::bspline_surfaces(shapes[i]);
    REQUIRE(surfaces.size() == originals[i].size());
    for (std::size_t k = 0; k < surfaces.size(); ++k) {
      CHECK(pn::test::same_surface(surfaces[k], originals[i][k]));
    }
  }
}

TEST_CASE("A capped solid keeps its volume, surfaces stay B-splines") {
  const TemporaryFolder folder;
  const auto solid = pn::make_capped_solid(pn::make_shell(pn::test::three_tubes()));
  write_step(folder / "solid.step", {{solid, "solid"}});
  const auto shapes = read_step(folder / "solid.step");
  REQUIRE(shapes.size() == 1);
  CHECK(shapes[0].ShapeType() == TopAbs_SOLID);
  CHECK(pn::volume(shapes[0]) == Approx(pn::test::three_tubes_volume()).epsilon(1e-12));
  const std::string text = text_of(folder / "solid.step");
  CHECK(contains(text, "RATIONAL_B_SPLINE_SURFACE"));
  CHECK_FALSE(contains(text, "CYLINDRICAL_SURFACE"));
  CHECK_FALSE(contains(text, "CONICAL_SURFACE"));
}

TEST_CASE("Trimmed faces, poles and voids come back from STEP") {
  const TemporaryFolder folder;
  const auto neighbours = pn::test::trimmed_neighbours();
  const std::vector patch = {pn::test::within(
      pn::test::paraboloid(), {pn::test::oval({0.1, 0}, 0.8, 0.9),
                               pn::test::reversed(pn::test::oval({0.2, 0.1}, 0.3, 0.2))})};
  const std::vector seamed = {pn::test::tube_with_hole_across_seam()};
  const auto cap = pn::test::up_to(pn::test::sphere_halves(), 0.7);
  auto ellipsoids = pn::test::ellipsoid_halves(4, 3, 2);
  const auto inner = pn::test::ellipsoid_halves(3, 2, 1);
  const std::vector<TopoDS_Shape> originals = {
      pn::make_shell(neighbours), pn::make_shell(patch), pn::make_shell(seamed),
      pn::make_shell(cap), pn::make_thick_solid(pn::make_shell(inner), pn::make_shell(ellipsoids))};
  ellipsoids.insert(ellipsoids.end(), inner.begin(), inner.end());
  const std::vector surfaces = {neighbours, patch, seamed, cap, ellipsoids};
  std::vector<pn::NamedShape> named;
  for (const TopoDS_Shape& shape : originals) named.push_back({shape, "shape"});
  const bool p_curves = GENERATE(true, false);
  write_step(folder / "trimmed.step", named, {StepSchema::kAp214, p_curves});
  const auto shapes = read_step(folder / "trimmed.step");
  REQUIRE(shapes.size() == originals.size());
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    CAPTURE(i, p_curves);
    CHECK(pn::faults(shapes[i]) == std::vector<std::string>());
    CHECK(pn::boolean_faults(shapes[i]) == std::vector<std::string>());
    CHECK(pn::area(shapes[i]) == Approx(pn::area(originals[i])).epsilon(1e-9));
    const auto found = pn::bspline_surfaces(shapes[i]);
    REQUIRE(found.size() == surfaces[i].size());
    for (std::size_t k = 0; k < found.size(); ++k) {
      CHECK(pn::test::same_surface(found[k], surfaces[i][k]));
    }
  }
  CHECK(pn::volume(shapes.back()) == Approx(pn::volume(originals.back())).epsilon(1e-12));
}

TEST_CASE("Names, schema and p-curves are as asked") {
  const TemporaryFolder folder;
  const auto shell = pn::make_shell(kTubes);
  write_step(folder / "with.step", {{shell, "Tr\u00fcmpi"}}, {StepSchema::kAp203, true});
  write_step(folder / "without.step", {{shell, "horn"}}, {StepSchema::kAp214, false});
  CHECK(contains(text_of(folder / "with.step"), "PRODUCT('Tr\u00fcmpi'"));
  CHECK(contains(text_of(folder / "with.step"), "CONFIG_CONTROL_DESIGN"));
  CHECK(contains(text_of(folder / "with.step"), "PCURVE"));
  CHECK(contains(text_of(folder / "without.step"), "PRODUCT('horn'"));
  CHECK(contains(text_of(folder / "without.step"), "AUTOMOTIVE_DESIGN"));
  CHECK_FALSE(contains(text_of(folder / "without.step"), "PCURVE"));
}

TEST_CASE("The settings of the host program neither matter nor change") {
  const TemporaryFolder folder;
  const HostSetting lengths("xstep.cascade.unit", "M");
  const HostSetting file_unit("write.step.unit", "INCH");
  const HostSetting schema("write.step.schema", "AP203");
  write_step(folder / "tubes.step", {{pn::make_shell(kTubes), "tubes"}});
  CHECK(contains(text_of(folder / "tubes.step"), "AUTOMOTIVE_DESIGN"));
  const auto surfaces = pn::bspline_surfaces(read_step(folder / "tubes.step").at(0));
  CHECK(pn::test::same_surface(surfaces.at(0), kTubes[0]));
  CHECK(lengths.value() == "M");
  CHECK(file_unit.value() == "INCH");
  CHECK(schema.value() == "AP203");
}

TEST_CASE("A file that cannot be written leaves nothing behind") {
  const TemporaryFolder folder;
  CHECK_THROWS_AS(write_step(folder / "missing/x.step", {{pn::make_shell(kTubes), "x"}}),
                  fs::filesystem_error);
  CHECK(folder.is_empty());
  fs::create_directories(folder / "folder/inside");
  CHECK_THROWS_AS(write_step(folder / "folder", {{pn::make_shell(kTubes), "x"}}),
                  fs::filesystem_error);
  CHECK_FALSE(fs::exists(folder / "folder.partial"));
}

TEST_CASE("A failed export leaves the old file as it is") {
  const TemporaryFolder folder;
  std::ofstream(folder / "old.step") << "old";
  CHECK_THROWS_AS(write_step(folder / "old.step", {{TopoDS_Shape(), "null"}}), pn::OcctError);
  CHECK(text_of(folder / "old.step") == "old");
  CHECK_FALSE(fs::exists(folder / "old.step.partial"));
}

TEST_CASE("What does not come back is not kept") {
  const TemporaryFolder folder;
  std::ofstream(folder / "old.step") << "old";
  const Handle(Geom_OffsetSurface) offset =
      new Geom_OffsetSurface(pn::to_geometry(pn::test::paraboloid()), 0.1);
  const TopoDS_Shape face = BRepBuilderAPI_MakeFace(offset, Precision::Confusion()).Shape();
  CHECK_THROWS_WITH(write_verified_step(folder / "old.step", {{face, "offset"}}),
                    Catch::Contains("Face 1 is an offset surface"));
  CHECK(text_of(folder / "old.step") == "old");
  CHECK_FALSE(fs::exists(folder / "old.step.partial"));
}

TEST_CASE("The report counts what was read back") {
  const TemporaryFolder folder;
  const auto solid = pn::make_capped_solid(pn::make_shell(kTubes));
  const auto report = write_verified_step(folder / "solid.step", {{solid, "solid"}});
  CHECK(report.bytes == fs::file_size(folder / "solid.step"));
  CHECK(report.round_trip.faces == 4);
  CHECK(report.round_trip.poles == kTubes[0].poles.size() + kTubes[1].poles.size());
  CHECK(report.round_trip.volume == Approx(pn::volume(solid)).epsilon(1e-14));
}

TEST_CASE("Progress goes from the start to the end, and may break off at any time") {
  const TemporaryFolder folder;
  const auto shell = pn::make_shell(kTubes);
  std::vector<double> steps;
  write_verified_step(folder / "a.step", {{shell, "a"}}, {}, [&](double part) {
    steps.push_back(part);
    return true;
  });
  CHECK(std::is_sorted(steps.begin(), steps.end()));
  CHECK(steps.size() > 10);
  CHECK(steps.back() == Approx(1));
  for (std::size_t last = 0; last + 1 < steps.size(); last += 5) {
    std::size_t step = 0;
    CHECK_THROWS_AS(write_verified_step(folder / "b.step", {{shell, "b"}}, {},
                                        [&](double) { return step++ < last; }),
                    pn::Cancelled);
    CHECK_FALSE(fs::exists(folder / "b.step"));
    CHECK_FALSE(fs::exists(folder / "b.step.partial"));
  }
}

TEST_CASE("What is no STEP file is refused") {
  const TemporaryFolder folder;
  CHECK_THROWS_AS(read_step(folder / "missing.step"), fs::filesystem_error);
  std::ofstream(folder / "other.step") << "no exchange structure";
  CHECK_THROWS_AS(read_step(folder / "other.step"), pn::OcctError);
}
