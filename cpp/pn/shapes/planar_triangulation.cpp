// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/shapes/planar_triangulation.hpp"

#include <algorithm>
#include <map>
#include <string>

#include "pn/algebra/parallel.hpp"
#include "pn/geometry_error.hpp"
#include "pn/input_numbers.hpp"

namespace pn {
namespace {

std::string number(std::size_t i) { return std::to_string(i); }

PlanePoint exact_point(const std::array<double, 2>& point) {
  require_input_numbers(point, "A parameter of the triangulation");
  return {Rational::exactly(point[0]), Rational::exactly(point[1])};
}

/// The bounds of a triangle along an axis.
std::array<Rational, 2> bounds(const std::array<PlanePoint, 3>& corners, std::size_t axis) {
  const auto less = [axis](const PlanePoint& a, const PlanePoint& b) { return a[axis] < b[axis]; };
  const auto [low, high] = std::minmax_element(corners.begin(), corners.end(), less);
  return {(*low)[axis], (*high)[axis]};
}

/// The line through an edge of the first triangle has the second one on its outer side.
bool is_beyond_an_edge(const std::array<PlanePoint, 3>& triangle,
                       const std::array<PlanePoint, 3>& other) {
  for (std::size_t k = 0; k < 3; ++k) {
    if (std::all_of(other.begin(), other.end(), [&](const PlanePoint& point) {
          return orientation(triangle[k], triangle[(k + 1) % 3], point).sign() <= 0;
        })) {
      return true;
    }
  }
  return false;
}

bool is_inside_edge(const PlanePoint& point, const PlanePoint& from, const PlanePoint& to) {
  if (!orientation(from, to, point).is_zero()) return false;
  const Rational along = (point[0] - from[0]) * (to[0] - from[0]) +
                         (point[1] - from[1]) * (to[1] - from[1]),
                 back = (point[0] - to[0]) * (from[0] - to[0]) +
                        (point[1] - to[1]) * (from[1] - to[1]);
  return along.sign() > 0 && back.sign() > 0;
}

}  // namespace

PlanarTriangulation::PlanarTriangulation(const std::vector<std::array<double, 2>>& points,
                                         std::vector<Triangle> triangles)
    : triangles_(std::move(triangles)) {
  for (const auto& point : points) points_.push_back(exact_point(point));
  check_triangles();
  check_edges();
  check_pairs();
}

std::array<PlanePoint, 3> PlanarTriangulation::corners(std::size_t triangle) const {
  const auto& [a, b, c] = triangles_[triangle];
  return {points_[a], points_[b], points_[c]};
}

void PlanarTriangulation::check_triangles() const {
  if (triangles_.empty()) {
    throw GeometryError(ErrorCode::kWrongShape, "A triangulation needs a triangle at least.");
  }
  for (std::size_t t = 0; t < triangles_.size(); ++t) {
    for (const std::size_t corner : triangles_[t]) {
      if (corner < points_.size()) continue;
      throw GeometryError(ErrorCode::kWrongShape, "Triangle " + number(t) + " has the corner " +
                                                      number(corner) + ", but there are only " +
                                                      number(points_.size()) + " points.");
    }
    const auto [a, b, c] = corners(t);
    const int sign = orientation(a, b, c).sign();
    if (sign == 0) {
      throw GeometryError(ErrorCode::kZeroLength,
                          "The corners of triangle " + number(t) +
                              " lie on one line in the parameter plane: it has no area.");
    }
    if (sign < 0) {
      throw GeometryError(ErrorCode::kNotATriangulation,
                          "Triangle " + number(t) +
                              " runs clockwise in the parameter plane. All triangles must run "
                              "counterclockwise; exchange two of its corners.");
    }
  }
}

void PlanarTriangulation::check_edges() const {
  std::map<std::array<std::size_t, 2>, std::size_t> users;
  for (const Triangle& triangle : triangles_) {
    for (std::size_t k = 0; k < 3; ++k) {
      const auto [low, high] = std::minmax(triangle[k], triangle[(k + 1) % 3]);
      if (++users[{low, high}] <= 2) continue;
      throw GeometryError(ErrorCode::kNotATriangulation,
                          "The edge between the points " + number(low) + " and " + number(high) +
                              " belongs to more than two triangles.");
    }
  }
}

void PlanarTriangulation::check_pairs() const {
  // Sorted by their left ends, only those that begin before a triangle ends can touch it.
  std::vector<std::array<std::array<Rational, 2>, 2>> boxes(triangles_.size());
  std::vector<std::size_t> order(triangles_.size());
  for (std::size_t t = 0; t < order.size(); ++t) {
    order[t] = t;
    boxes[t] = {bounds(corners(t), 0), bounds(corners(t), 1)};
  }
  std::sort(order.begin(), order.end(),
            [&](std::size_t a, std::size_t b) { return boxes[a][0][0] < boxes[b][0][0]; });
  for_each_index(order.size(), [&](std::size_t i) {
    const auto& [x, y] = boxes[order[i]];
    for (std::size_t j = i + 1; j < order.size(); ++j) {
      const auto& [other_x, other_y] = boxes[order[j]];
      if (other_x[0] > x[1]) return;
      if (other_y[0] > y[1] || y[0] > other_y[1]) continue;
      check_pair(std::min(order[i], order[j]), std::max(order[i], order[j]));
    }
  });
}

void PlanarTriangulation::check_pair(std::size_t a, std::size_t b) const {
  const auto first = corners(a), second = corners(b);
  if (!is_beyond_an_edge(first, second) && !is_beyond_an_edge(second, first)) {
    throw GeometryError(
        ErrorCode::kNotATriangulation,
        "The triangles " + number(a) + " and " + number(b) + " overlap in the parameter plane.");
  }
  const auto check_corners = [&](const std::array<PlanePoint, 3>& triangle, std::size_t of,
                                 const std::array<PlanePoint, 3>& other, std::size_t on) {
    for (const PlanePoint& point : triangle) {
      for (std::size_t k = 0; k < 3; ++k) {
        if (!is_inside_edge(point, other[k], other[(k + 1) % 3])) continue;
        throw GeometryError(ErrorCode::kNotATriangulation,
                            "A corner of triangle " + number(of) + " lies on an edge of triangle " +
                                number(on) + ". Triangles may meet in whole edges only.");
      }
    }
  };
  check_corners(first, a, second, b);
  check_corners(second, b, first, a);
}

}  // namespace pn
