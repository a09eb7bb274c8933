// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/shapes/planar_triangulation.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "pn/geometry_error.hpp"

using namespace pn;

namespace {

using Points = std::vector<std::array<double, 2>>;

/// The code and the sentence with which triangles are refused; empty when they are not.
std::pair<std::string, std::string> refusal(const Points& points,
                                            const std::vector<Triangle>& triangles) {
  try {
    const PlanarTriangulation accepted(points, triangles);
    return {};
  } catch (const GeometryError& error) {
    return {to_string(error.code()), error.what()};
  }
}

void check_refused(const Points& points, const std::vector<Triangle>& triangles,
                   const std::string& code, const std::string& part) {
  const auto [name, sentence] = refusal(points, triangles);
  CAPTURE(sentence);
  CHECK(name == code);
  CHECK(sentence.find(part) != std::string::npos);
}

const Points kSquare = {{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0.5, 0.5}, {2, 0.5}, {0.25, 0.75}};
const std::string kNone = "not_a_triangulation";

}  // namespace

TEST_CASE("Triangles that meet in edges and corners are a triangulation",
          "[planar_triangulation]") {
  const std::vector<Triangle> fan = {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}};
  const PlanarTriangulation square(kSquare, fan);
  CHECK(square.triangles() == fan);
  CHECK(square.corners(2)[0] == PlanePoint{Rational(1L), Rational(1L)});
  // Two parts that meet in one corner.
  CHECK(refusal({{0, 0}, {-1, -1}, {0, -1}, {1, 1}, {0, 1}}, {{0, 1, 2}, {0, 3, 4}}).first.empty());
}

TEST_CASE("Triangles without area or the wrong way round are named", "[planar_triangulation]") {
  check_refused(kSquare, {{0, 1, 4}, {0, 4, 2}}, "zero_length", "triangle 1");
  check_refused(kSquare, {{0, 1, 4}, {1, 1, 2}}, "zero_length", "triangle 1");
  check_refused(kSquare, {{0, 1, 4}, {1, 4, 2}}, kNone, "Triangle 1 runs clockwise");
}

TEST_CASE("An edge has two triangles at most, which do not overlap", "[planar_triangulation]") {
  check_refused(kSquare, {{0, 1, 4}, {1, 2, 4}, {1, 5, 4}}, kNone, "between the points 1 and 4");
  check_refused(kSquare, {{0, 1, 2}, {0, 1, 3}}, kNone, "triangles 0 and 1 overlap");
  check_refused(kSquare, {{0, 1, 2}, {1, 2, 0}}, kNone, "overlap");
  // Two triangles like a star: neither has a corner in the other one.
  check_refused({{0, 0}, {4, 0}, {2, 3}, {2, -1}, {4, 2}, {0, 2}}, {{0, 1, 2}, {3, 4, 5}}, kNone,
                "overlap");
}

TEST_CASE("A corner on the edge of another triangle is refused", "[planar_triangulation]") {
  check_refused(kSquare, {{0, 1, 2}, {0, 4, 3}}, kNone, "A corner of triangle 1 lies on an edge");
  check_refused(kSquare, {{0, 4, 3}, {0, 1, 2}}, kNone, "A corner of triangle 0 lies on an edge");
}

TEST_CASE("Numbers that are no points, and points that are no numbers", "[planar_triangulation]") {
  check_refused(kSquare, {}, "wrong_shape", "triangle at least");
  check_refused(kSquare, {{0, 1, 7}}, "wrong_shape", "the corner 7");
  check_refused({{0, 0}, {1, NAN}, {0, 1}}, {{0, 1, 2}}, "not_finite", "not a finite number");
}

TEST_CASE("Whether three points lie on a line is decided over Q", "[planar_triangulation]") {
  // 1/3 in doubles: the third point is beside the line by 2^-55 or so.
  const double third = 1.0 / 3;
  CHECK(refusal({{0, 0}, {third, 1}, {1, std::nextafter(3.0, 0)}}, {{0, 1, 2}}).first !=
        "zero_length");
  CHECK(refusal({{0, 0}, {third, third}, {1, 1}}, {{0, 1, 2}}).first == "zero_length");
}
