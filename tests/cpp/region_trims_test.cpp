// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/bezier/region_trims.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "pn/bezier/evaluation.hpp"
#include "pn/shapes/quadric.hpp"

using namespace pn;

namespace {

using Point = std::array<double, 2>;

struct Faces {
  EnvelopeChain chain;
  ChainNet net{chain, Lines::kEven, 128};
  std::vector<TrimmedFace> trimmed = region_faces(chain, net);
};

QuadricBounds box(const Interval& x, const Interval& y, const Interval& z) {
  return {{x, y, z}, std::nullopt};
}

Faces ellipsoid(const QuadricBounds& bounds) {
  return {quadric(QuadricKind::kEllipsoid, {3, 2, 1}, bounds)};
}

/// The regions: beside the poles, around one, between both, with corners, in parts, with holes.
std::vector<QuadricBounds> regions() {
  QuadricBounds sector;
  sector.angle = Interval{0.25, 2};
  return {box({}, {}, {0.25, 2}),      box({0.5, 1.5}, {-0.5, 0.5}, {0, 1}),
          box({-0.5, 0.75}, {}, {}),   box({0, 1}, {-0.5, 0.5}, {}),
          box({-4, 1}, {}, {-2, 0.5}), sector};
}

std::vector<Point> polygon(const TrimEdgeLoop& loop) {
  constexpr int kPoints = 50;
  std::vector<Point> corners;
  for (const TrimEdge& edge : loop) {
    for (int i = 0; i < kPoints; ++i) {
      corners.push_back(evaluate(edge.curve, static_cast<double>(i) / kPoints));
    }
  }
  return corners;
}

double area(const std::vector<Point>& corners) {
  double sum = 0;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Point &a = corners[i], &b = corners[(i + 1) % corners.size()];
    sum += a[0] * b[1] - a[1] * b[0];
  }
  return sum / 2;
}

std::array<double, 3> point(const BSplineSurface& surface, const Point& at) {
  return evaluate(surface, at[0], at[1]);
}

}  // namespace

TEST_CASE("Loops are closed bit for bit, outer ones run counterclockwise", "[region_trims]") {
  for (const QuadricBounds& bounds : regions()) {
    const Faces faces = ellipsoid(bounds);
    REQUIRE_FALSE(faces.trimmed.empty());
    for (const TrimmedFace& face : faces.trimmed) {
      for (std::size_t k = 0; k < face.loops.size(); ++k) {
        const TrimEdgeLoop& loop = face.loops[k];
        for (std::size_t i = 0; i < loop.size(); ++i) {
          CHECK(loop[i].curve.poles.back() == loop[(i + 1) % loop.size()].curve.poles.front());
        }
        CHECK((area(polygon(loop)) > 0) == (k == 0));
      }
    }
  }
}

TEST_CASE("Edges with a path lie on the bounds", "[region_trims]") {
  for (const QuadricBounds& bounds : regions()) {
    const Faces faces = ellipsoid(bounds);
    const std::vector<RoundedFace> sections = faces.net.section(0);
    for (const TrimmedFace& face : faces.trimmed) {
      for (const TrimEdgeLoop& loop : face.loops) {
        for (const TrimEdge& edge : loop) {
          if (!edge.path) continue;
          for (const double s : {0.0, 0.2, 0.55, 0.9}) {
            const auto p = point(sections[face.net_face].surface, evaluate(edge.curve, s));
            double off = HUGE_VAL;
            for (std::size_t axis = 0; axis < 3; ++axis) {
              off = std::min({off, std::abs(p[axis] - bounds.box[axis].low),
                              std::abs(p[axis] - bounds.box[axis].high)});
            }
            if (bounds.angle) {
              for (const double angle : {bounds.angle->low, bounds.angle->high}) {
                off = std::min(off, std::abs(p[1] * std::cos(angle) - p[0] * std::sin(angle)));
              }
            }
            CHECK(off < 1e-8);
          }
        }
      }
    }
  }
}

TEST_CASE("Neighbouring faces share the corners on their common line", "[region_trims]") {
  // Two halves around a pole meet in two lines; each corner on one face is one on the other.
  const Faces faces = ellipsoid(box({-4, 1}, {}, {}));
  REQUIRE(faces.trimmed.size() == 2);
  const auto ends_on = [&](const TrimmedFace& face, double v) {
    std::vector<double> result;
    for (const TrimEdgeLoop& loop : face.loops) {
      for (const TrimEdge& edge : loop) {
        const Point& p = edge.curve.poles.front();
        if (p[1] == v) result.push_back(p[0]);
      }
    }
    std::sort(result.begin(), result.end());
    return result;
  };
  CHECK(ends_on(faces.trimmed[0], 2) == ends_on(faces.trimmed[1], 2));
  CHECK(ends_on(faces.trimmed[0], 0) == ends_on(faces.trimmed[1], 4));
}

TEST_CASE("A region of two parts is two faces of one net", "[region_trims]") {
  const Faces faces = ellipsoid(box({0, 1}, {-0.5, 0.5}, {}));
  CHECK(faces.trimmed.size() == 2);
  CHECK(faces.net.faces().size() <= 2);
}

TEST_CASE("The whole surface needs no trims", "[region_trims]") {
  for (const TrimmedFace& face : ellipsoid({}).trimmed) CHECK(face.loops.empty());
}
