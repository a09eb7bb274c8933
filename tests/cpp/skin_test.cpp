// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/bezier/skin.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "minkowski_cases.hpp"
#include "pn/bezier/evaluation.hpp"
#include "pn/bezier/pn_surface.hpp"
#include "pn/isotropic/family_type.hpp"
#include "pn/shapes/sphere_family.hpp"
#include "random_sphere_families.hpp"

using namespace pn;
using namespace pn::test;

namespace {

PNSurface skin(const QuadraticFamily& family, Sheet sheet) {
  return PNSurface(std::make_shared<const Skin>(family, sheet, std::vector<std::string>{"note"}));
}

}  // namespace

TEST_CASE("A skin is a PN surface of degree ten, in one face", "[skin]") {
  const QuadraticFamily family = family_of(RandomSphereFamily(1).spheres());
  for (const Sheet sheet : {Sheet::kOuter, Sheet::kInner}) {
    const PNSurface surface = skin(family, sheet);
    CHECK(surface.degree() == std::array{10, 10});
    const Certificate certificate = surface.certificate(Lines::kEven);
    CHECK(certificate.exact);
    CHECK(certificate.notes == std::vector<std::string>{"note"});
    CHECK(certificate.bidegree == std::array{10, 10});
    REQUIRE(surface.faces(Lines::kEven).size() == 1);
    CHECK_FALSE(surface.self_intersection());
  }
}

TEST_CASE("Skins of all thirteen types of nets have their least degree and positive weights",
          "[skin][minkowski]") {
  const auto& plates = minkowski_cases()["plates"];
  CHECK(plates.size() == 13);
  for (const auto& [net, spheres] : plates.items()) {
    INFO(net);
    const QuadraticFamily family = quadratic_family(spheres.get<ControlSpheres>());
    CHECK(name(family_type(family).net.value()) == net);
    // Families of parabolic nets are ruled, and their sections have a common factor that is
    // negative on one sheet.
    const int degree = net.rfind("parabolic", 0) == 0 ? 8 : 10;
    for (const Sheet sheet : {Sheet::kOuter, Sheet::kInner}) {
      const PNSurface surface = skin(family, sheet);
      CHECK(surface.degree() == std::array{degree, degree});
      for (const auto& face : surface.faces(Lines::kEven)) {
        for (const double weight : face.weights) CHECK(weight > 0);
      }
    }
  }
}

TEST_CASE("S_u x S_v points along the normal, on both sheets", "[skin]") {
  const QuadraticFamily family = family_of(RandomSphereFamily(1).spheres());
  for (const Sheet sheet : {Sheet::kOuter, Sheet::kInner}) {
    const PNSurface surface = skin(family, sheet);
    const double h = 1e-5;
    const auto points = surface.evaluate({0.4, 0.4 + h, 0.4}, {0.4, 0.4, 0.4 + h});
    const auto at = [&](std::size_t i) {
      return Eigen::Vector3d(points[i].point[0], points[i].point[1], points[i].point[2]);
    };
    const Eigen::Vector3d n(points[0].normal[0], points[0].normal[1], points[0].normal[2]);
    CHECK((at(1) - at(0)).cross(at(2) - at(0)).normalized().dot(n) > 0.99);
  }
}

TEST_CASE("The regular range holds r + d within the regular radius", "[skin]") {
  const QuadraticFamily family = family_of(RandomSphereFamily(1).spheres());
  const OffsetRange range = Skin(family, Sheet::kOuter, {}).regular_range();
  const double radius = regular_radius(family);
  double least = INFINITY, largest = 0;
  for (const auto& sphere : family.control()) {
    least = std::min(least, -sphere[3].to_double());
    largest = std::max(largest, -sphere[3].to_double());
  }
  CHECK(range.lower == Approx(-radius - least).epsilon(1e-14));
  CHECK(range.upper == Approx(radius - largest).epsilon(1e-14));
}
