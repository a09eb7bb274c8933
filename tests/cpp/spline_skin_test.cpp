// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/bezier/spline_skin.hpp"

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

/// A square whose first half needs more than one patch on the outer sheet, and its other half: the
/// same family, continued beyond the edge v w.
FamilySpline divided_square(const QuadraticFamily& family) {
  const auto a = family.power();
  const auto at = [&](long u, long v) { return jet(family, Rational(u), Rational(v)).value; };
  // By the blossom: the control point between two corners is (4 f(middle) - f(p) - f(q)) / 2.
  const auto between = [&](std::array<long, 2> p, std::array<long, 2> q) {
    const Rational half = Rational(1L) / Rational(2L);
    const auto middle =
        jet(family, half * Rational(p[0] + q[0]), half * Rational(p[1] + q[1])).value;
    const auto from = at(p[0], p[1]), to = at(q[0], q[1]);
    MinkowskiVector<Rational> result;
    for (std::size_t c = 0; c < 4; ++c) {
      result[c] = Rational(2L) * middle[c] - half * (from[c] + to[c]);
    }
    return result;
  };
  // The second half has the corners (0, 0), (0, 1) and (-1, 1).
  const QuadraticFamily other({at(0, 1), between({0, 1}, {-1, 1}), at(-1, 1),
                               between({0, 0}, {0, 1}), between({0, 0}, {-1, 1}), at(0, 0)});
  const auto point = [](long s, long t) { return PlanePoint{Rational(s), Rational(t)}; };
  return {{point(0, 0), point(1, 0), point(0, 1), point(-1, 1)},
          {{family, {0, 1, 2}, 0}, {other, {0, 2, 3}, 1}}};
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
  bool was_divided = false;
  for (std::uint64_t seed = 0; seed < 60 && !was_divided; ++seed) {
    const FamilySpline spline = divided_square(family_of(RandomSphereFamily(seed).spheres()));
    const auto& [first, second] = std::array{spline.pieces[0].family, spline.pieces[1].family};
    if (unreal_place(first) || unreal_place(second)) continue;
    for (const Sheet sheet : {Sheet::kOuter, Sheet::kInner}) {
      const std::size_t ends = ends_along(skin_patches(first, sheet), 2).size(),
                        other = ends_along(skin_patches(second, sheet), 0).size();
      if (ends == other) continue;
      was_divided = true;
      std::size_t all = 0;
      const std::size_t shared = shared_edges(skin(spline, sheet), all);
      const auto border = [&](const QuadraticFamily& family, std::size_t common) {
        std::size_t count = 0;
        for (std::size_t k = 0; k < 3; ++k) {
          if (k != common) count += 1 + ends_along(skin_patches(family, sheet), k).size();
        }
        return count;
      };
      CHECK(all - shared == border(first, 2) + border(second, 0));
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
  // A flat plate of constant thickness has no normals of two parameters.
  QuadraticFamily::Control control;
  const std::array<std::array<long, 2>, 6> places = {
      {{2, 0}, {1, 1}, {0, 2}, {1, 0}, {0, 1}, {0, 0}}};
  for (std::size_t i = 0; i < 6; ++i) {
    control[i] = {Rational(places[i][0]), Rational(places[i][1]), Rational(0L), Rational(-1L)};
  }
  FamilySpline flat;
  flat.pieces.push_back({QuadraticFamily(control), {0, 1, 2}, 17});
  try {
    const SplineSkin surface(flat, Sheet::kOuter, {});
    FAIL("it was not refused");
  } catch (const GeometryError& error) {
    CHECK(std::string(error.what()).find("Over triangle 17") == 0);
  }
}
