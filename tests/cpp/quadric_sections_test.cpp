// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/shapes/quadric_sections.hpp"

#include <catch2/catch.hpp>
#include <cmath>

using namespace pn;
using Eigen::Vector3d;

namespace {

const Interval kWide = {-3, 3};
const Box kReach = {kWide, kWide, kWide};

struct Named {
  const char* name;
  QuadricEquation equation;
};

std::vector<Named> quadrics() {
  return {{"ellipsoid", {{1.0 / 9, 1.0 / 4, 1}, 0, -1, false}},
          {"one-sheet hyperboloid", {{1.0 / 4, 1, -1.0 / 9}, 0, -1, false}},
          {"two-sheet hyperboloid", {{1.0 / 4, 1, -1}, 0, 1, true}},
          {"elliptic paraboloid", {{0.5, 2, 0}, -0.5, 0, false}},
          {"hyperbolic paraboloid", {{0.5, -2, 0}, -0.5, 0, false}},
          {"cylinder", {{0.25, 0.25, 0}, 0, -1, false}},
          {"cone", {{0.25, 0.25, -1}, 0, 0, false}}};
}

double value(const QuadricEquation& quadric, const Vector3d& p) {
  return p.dot(quadric.square.cwiseProduct(p)) + 2 * quadric.half_linear * p.z() + quadric.constant;
}

/// How far a point is from a plane; of a half-plane, from the whole of it.
double distance(const BoundingPlane& plane, const Vector3d& p) {
  if (const auto* own = std::get_if<CoordinatePlane>(&plane)) {
    return p(static_cast<Eigen::Index>(own->axis)) - own->value;
  }
  const double angle = std::get<HalfPlane>(plane).angle;
  return p.y() * std::cos(angle) - p.x() * std::sin(angle);
}

std::vector<BoundingPlane> planes() {
  return {CoordinatePlane{0, 0.75}, CoordinatePlane{0, 2.5},
          CoordinatePlane{1, -0.5}, CoordinatePlane{2, 0.5},
          CoordinatePlane{2, 1.5},  HalfPlane{0.5},
          HalfPlane{2.5},           HalfPlane{-2}};
}

bool has_point(const std::vector<BoundaryConic>& conics, const Vector3d& p) {
  return std::any_of(conics.begin(), conics.end(), [&](const BoundaryConic& conic) {
    return (conic.point(conic.parameter(p)) - p).norm() < 1e-12;
  });
}

}  // namespace

TEST_CASE("Conics lie on the quadric and in their planes", "[quadric_sections]") {
  for (const auto& [name, quadric] : quadrics()) {
    INFO(name);
    for (const BoundingPlane& plane : planes()) {
      for (const BoundaryConic& conic : section(quadric, plane, kReach)) {
        for (const double t : {0.0, 0.2, 0.5, 0.9}) {
          const Vector3d p = conic.point(t);
          CHECK(value(quadric, p) == Approx(0).margin(1e-12));
          CHECK(distance(plane, p) == Approx(0).margin(1e-12));
          CHECK((!quadric.is_upper_sheet || p.z() > 0));
          CHECK(conic.parameter(p) == Approx(t).margin(1e-9));
        }
        if (conic.is_closed) CHECK((conic.point(0) - conic.point(1)).norm() < 1e-12);
      }
    }
  }
}

TEST_CASE("Points common to two planes lie on the conics of both", "[quadric_sections]") {
  int found = 0;
  for (const auto& [name, quadric] : quadrics()) {
    INFO(name);
    for (const BoundingPlane& a : planes()) {
      for (const BoundingPlane& b : planes()) {
        for (const Vector3d& p : common_points(quadric, a, b, 3)) {
          ++found;
          CHECK(value(quadric, p) == Approx(0).margin(1e-12));
          CHECK(distance(a, p) == Approx(0).margin(1e-12));
          CHECK(distance(b, p) == Approx(0).margin(1e-12));
          if (p.cwiseAbs().maxCoeff() > 3) continue;
          CHECK(has_point(section(quadric, a, kReach), p));
          CHECK(has_point(section(quadric, b, kReach), p));
        }
      }
    }
  }
  CHECK(found > 100);
}

TEST_CASE("Branches by the signs of what a plane leaves", "[quadric_sections]") {
  const auto branches = [](std::size_t quadric, const BoundingPlane& plane) {
    return section(quadrics()[quadric].equation, plane, kReach).size();
  };
  CHECK(branches(0, CoordinatePlane{2, 0.5}) == 1);
  CHECK(branches(0, CoordinatePlane{2, 1}) == 0);
  CHECK(branches(0, CoordinatePlane{0, 3.5}) == 0);
  CHECK(branches(1, CoordinatePlane{0, 1}) == 2);
  // The lines through the waist, which cross where the plane touches.
  CHECK(branches(1, CoordinatePlane{0, 2}) == 2);
  CHECK(touching_point(quadrics()[1].equation, CoordinatePlane{0, 2}, kReach) == Vector3d(2, 0, 0));
  CHECK_FALSE(touching_point(quadrics()[1].equation, CoordinatePlane{0, 1.9}, kReach));
  CHECK(branches(2, CoordinatePlane{0, 1}) == 1);  // the other branch is on the other sheet
  CHECK(branches(4, CoordinatePlane{2, 0}) == 2);
  CHECK(branches(4, CoordinatePlane{2, 0.5}) == 2);
  CHECK(branches(5, CoordinatePlane{0, 1}) == 2);
  CHECK(branches(5, CoordinatePlane{0, 2.5}) == 0);
}

TEST_CASE("A line that touches the quadric has no points in common with it", "[quadric_sections]") {
  const QuadricEquation sphere = {{1, 1, 1}, 0, -1, false};
  const auto count = [&](double x, double z) {
    return common_points(sphere, CoordinatePlane{0, x}, CoordinatePlane{2, z}, 1).size();
  };
  CHECK(count(0.6, 0.8) == 0);
  CHECK(count(0.6, 0.8 - 1e-12) == 0);
  CHECK(count(0.6, 0.8 - 1e-6) == 2);
  CHECK(count(0.6, 0.8 + 1e-6) == 0);
}
