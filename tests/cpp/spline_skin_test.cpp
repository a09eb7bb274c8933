// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/bezier/spline_skin.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "pn/bezier/evaluation.hpp"
#include "pn/bezier/pn_surface.hpp"
#include "pn/bezier/skin.hpp"
#include "pn/geometry_error.hpp"
#include "random_sphere_families.hpp"
#include "random_triangulations.hpp"

using namespace pn;
using namespace pn::test;

namespace {

FamilySpline dome(std::size_t count, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  return grid(count, 0.25, random, Dome()).family().spline;
}

PNSurface skin(const FamilySpline& spline, Sheet sheet) {
  return PNSurface(
      std::make_shared<const SplineSkin>(spline, sheet, std::vector<std::string>{"note"}));
}

/// Points and normals along an edge of a face.
struct EdgeImage {
  std::vector<Eigen::Matrix<double, 6, 1>> places;

  EdgeImage(const PNSurface& surface, const ParameterCurve& curve) {
    for (const double at : {0.0, 0.2, 0.5, 0.8, 1.0}) {
      const auto [u, v] = evaluate(curve, at);
      const SurfacePoint point = surface.evaluate({u}, {v}).front();
      places.emplace_back();
      places.back() << point.point[0], point.point[1], point.point[2], point.normal[0],
          point.normal[1], point.normal[2];
    }
  }

  bool is_opposite(const EdgeImage& other) const {
    for (std::size_t i = 0; i < places.size(); ++i) {
      if (!((places[i] - other.places[places.size() - 1 - i]).norm() < 1e-8)) return false;
    }
    return true;
  }
};

/// How many edges of all faces are those of a neighbour, run in the opposite direction.
std::size_t shared_edges(const PNSurface& surface, std::size_t& all) {
  std::vector<EdgeImage> images;
  for (const BSplineSurface& face : surface.faces(Lines::kEven)) {
    for (const ParameterCurve& curve : face.trims[0]) images.emplace_back(surface, curve);
  }
  all = images.size();
  return static_cast<std::size_t>(
      std::count_if(images.begin(), images.end(), [&](const EdgeImage& image) {
        return std::any_of(images.begin(), images.end(),
                           [&](const EdgeImage& other) { return image.is_opposite(other); });
      }));
}

/// A vault with lines of vanishing curvature near its corners.
std::array<std::array<double, 4>, 3> vault(double s, double t) {
  const double height = 15, bend = 1.96, a = bend * (s - 0.5), b = bend * (t - 0.5);
  const double radius = 3 + 4 * (s - 0.5) * (s - 0.5) + 2 * (t - 0.5) * (t - 0.5);
  return {{{100 * s, 100 * t, height * std::cos(a) * std::cos(b), radius},
           {100, 0, -height * bend * std::sin(a) * std::cos(b), 8 * (s - 0.5)},
           {0, 100, -height * bend * std::cos(a) * std::sin(b), 4 * (t - 0.5)}}};
}

/// The edges of faces at the border of a spline.
std::size_t border_edges(const FamilySpline& spline, Sheet sheet) {
  const DirectedEdges edges = spline.edges();
  std::size_t count = 0;
  for (std::size_t i = 0; i < spline.pieces.size(); ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      if (edges.opposite({i, k})) continue;
      count += 1 + ends_along(skin_patches(spline.pieces[i].family, sheet), k).size();
    }
  }
  return count;
}

}  // namespace

TEST_CASE("Neighbouring faces have the same points and normals", "[spline_skin]") {
  const FamilySpline spline = dome(2, 1);
  for (const Sheet sheet : {Sheet::kOuter, Sheet::kInner}) {
    const PNSurface surface = skin(spline, sheet).offset(0.5);
    CHECK(surface.faces(Lines::kEven).size() >= spline.pieces.size());
    const Certificate certificate = surface.certificate(Lines::kEven);
    CHECK(certificate.exact);
    CHECK(certificate.deviation < 1e-11);
    CHECK(certificate.trim_deviation < 1e-9);
    CHECK(certificate.notes == std::vector<std::string>{"note"});
    std::size_t all = 0;
    const std::size_t shared = shared_edges(surface, all);
    // Eight edges of the border, in halves, have no neighbour.
    CHECK(all - shared == 16);
  }
}

TEST_CASE("Edges end where those of a divided neighbour end", "[spline_skin]") {
  std::mt19937_64 random(0);
  bool was_divided = false;
  for (int tries = 0; tries < 20 && !was_divided; ++tries) {
    const FamilySpline spline = grid(2, 0.2, random, vault).family().spline;
    for (const Sheet sheet : {Sheet::kOuter, Sheet::kInner}) {
      const PNSurface surface = skin(spline, sheet);
      if (surface.faces(Lines::kEven).size() == spline.pieces.size()) continue;
      was_divided = true;
      std::size_t all = 0;
      const std::size_t shared = shared_edges(surface, all);
      CHECK(all - shared == border_edges(spline, sheet));
    }
  }
  CHECK(was_divided);
}

TEST_CASE("The regular range of a spline is that of all its pieces", "[spline_skin]") {
  const FamilySpline spline = dome(1, 3);
  const OffsetRange range = SplineSkin(spline, Sheet::kOuter, {}).regular_range();
  double lower = -INFINITY, upper = INFINITY;
  for (const FamilyPiece& piece : spline.pieces) {
    const OffsetRange own = Skin(piece.family, Sheet::kOuter, {}).regular_range();
    lower = std::max(lower, own.lower);
    upper = std::min(upper, own.upper);
  }
  CHECK(range.lower == lower);
  CHECK(range.upper == upper);
  CHECK(lower < upper);
}

TEST_CASE("A piece without patches is named by the designer's triangle", "[spline_skin]") {
  // Nearly a cylinder, and the radius is constant.
  const QuadraticFamily family = family_of({{{20, 0, 0, 1},
                                             {20, 5, 0, 1},
                                             {18, 10, 0, 1},
                                             {20, 7, 4, 1},
                                             {17, 11, 4, 1},
                                             {15, 13, 7, 1}}});
  FamilySpline spline;
  spline.pieces.push_back({family, {0, 1, 2}, 17});
  std::size_t refused = 0;
  for (const Sheet sheet : {Sheet::kOuter, Sheet::kInner}) {
    try {
      const SplineSkin surface(spline, sheet, {});
    } catch (const GeometryError& error) {
      ++refused;
      CHECK(std::string(error.what()).find("Over triangle 17: ") == 0);
    }
  }
  CHECK(refused > 0);
}
