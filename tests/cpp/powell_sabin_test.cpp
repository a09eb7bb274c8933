// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/shapes/powell_sabin.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "pn/geometry_error.hpp"
#include "random_sphere_families.hpp"
#include "random_triangulations.hpp"

using namespace pn;
using namespace pn::test;

namespace {

using Vector = MinkowskiVector<Rational>;

/// (m, -r) and its derivatives by the parameters of the plane, over Q, at barycentric coordinates
/// of a piece: by its family's own derivatives and the corners of the piece.
std::array<Vector, 3> plane_jet(const FamilySpline& spline, const FamilyPiece& piece,
                                const Rational& u, const Rational& v) {
  const auto& [w_corner, u_corner, v_corner] = piece.corners;
  const PlanePoint &w = spline.corners[w_corner], &at_u = spline.corners[u_corner],
                   &at_v = spline.corners[v_corner];
  const Rational a = at_u[0] - w[0], b = at_u[1] - w[1], c = at_v[0] - w[0], d = at_v[1] - w[1];
  const Rational area = a * d - b * c;
  const pn::test::SphereJet at = jet(piece.family, u, v);
  std::array<Vector, 3> result = {at.value, Vector(), Vector()};
  for (std::size_t k = 0; k < 4; ++k) {
    result[1][k] = (d * at.by_u[k] - b * at.by_v[k]) / area;
    result[2][k] = (a * at.by_v[k] - c * at.by_u[k]) / area;
  }
  return result;
}

/// The point of an edge of a piece, by its barycentric coordinates u and v.
std::array<Rational, 2> on_edge(std::size_t edge, const Rational& at) {
  const std::array<std::array<long, 2>, 3> corners = {{{0, 0}, {1, 0}, {0, 1}}};
  const auto &from = corners[edge], &to = corners[(edge + 1) % 3];
  const Rational rest = Rational(1L) - at;
  return {rest * Rational(from[0]) + at * Rational(to[0]),
          rest * Rational(from[1]) + at * Rational(to[1])};
}

std::string refusal(const SpheresOnTriangles& input, ErrorCode code) {
  try {
    input.family();
  } catch (const GeometryError& error) {
    CHECK(to_string(error.code()) == to_string(code));
    return error.what();
  }
  FAIL("it was not refused");
  return "";
}

SpheresOnTriangles dome(std::size_t count, double moved, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  return grid(count, moved, random, Dome());
}

}  // namespace

TEST_CASE("The spline is C1 across every edge, over Q", "[powell_sabin]") {
  for (std::uint64_t seed = 0; seed < 4; ++seed) {
    const FamilySpline spline = dome(3, 0.3, seed).family().spline;
    const DirectedEdges edges = spline.edges();
    std::size_t inner = 0;
    for (std::size_t i = 0; i < spline.pieces.size(); ++i) {
      for (std::size_t k = 0; k < 3; ++k) {
        const auto neighbour = edges.opposite({i, k});
        if (!neighbour) continue;
        ++inner;
        // All are of degree two along an edge: three places decide.
        for (const Rational& at : {Rational(0L), Rational(1L) / Rational(3L), Rational(1L)}) {
          const auto own = on_edge(k, at), other = on_edge(neighbour->edge, Rational(1L) - at);
          REQUIRE(plane_jet(spline, spline.pieces[i], own[0], own[1]) ==
                  plane_jet(spline, spline.pieces[neighbour->triangle], other[0], other[1]));
        }
      }
    }
    // Of 18 triangles six edges each are inside, three are halved: 12 edges of the square in halves
    // are the border.
    CHECK(inner == 18 * 18 - 24);
  }
}

TEST_CASE("The spline has the spheres and derivatives that are given", "[powell_sabin]") {
  const SpheresOnTriangles input = dome(3, 0.3, 7);
  const FamilySpline spline = input.family().spline;
  const std::array<std::array<Rational, 2>, 3> at = {
      {{Rational(0L), Rational(0L)}, {Rational(1L), Rational(0L)}, {Rational(0L), Rational(1L)}}};
  std::vector<int> met(input.spheres.size());
  for (const FamilyPiece& piece : spline.pieces) {
    for (std::size_t k = 0; k < 3; ++k) {
      if (piece.corners[k] >= input.spheres.size()) continue;
      const PlacedSphere& given = input.spheres[piece.corners[k]];
      const auto found = plane_jet(spline, piece, at[k][0], at[k][1]);
      ++met[piece.corners[k]];
      for (std::size_t c = 0; c < 4; ++c) {
        const Rational sign(c == 3 ? -1L : 1L);
        CHECK(found[0][c] == sign * Rational::exactly(given.sphere[c]));
        CHECK(found[1][c] == sign * Rational::exactly(given.derivatives[0][c]));
        CHECK(found[2][c] == sign * Rational::exactly(given.derivatives[1][c]));
      }
    }
  }
  for (const int times : met) CHECK(times >= 2);
}

TEST_CASE("What is quadratic in the plane is kept", "[powell_sabin]") {
  // All numbers are short, so that its derivatives are doubles.
  const auto quadratic = [](double s, double t) {
    return std::array<std::array<double, 4>, 3>{
        {{s + s * t, t - s * s / 2, s * s + t * t / 4 - s * t, 0.5 + s * s / 8 + t / 16},
         {1 + t, -s, 2 * s - t, s / 4},
         {s, 1, t / 2 - s, 0.0625}}};
  };
  std::mt19937_64 random(1);
  const SpheresOnTriangles input = grid(4, 0, random, quadratic);
  const FamilySpline spline = powell_sabin_family(input.spheres, input.triangles).spline;
  const Rational one(1L), third = one / Rational(3L);
  for (const FamilyPiece& piece : spline.pieces) {
    PlanePoint middle;
    for (const std::size_t corner : piece.corners) {
      for (std::size_t c = 0; c < 2; ++c) middle[c] += third * spline.corners[corner][c];
    }
    const auto& [s, t] = middle;
    const auto half = one / Rational(2L);
    const Vector value = jet(piece.family, third, third).value;
    CHECK(value[0] == s + s * t);
    CHECK(value[1] == t - half * s * s);
    CHECK(value[2] == s * s + half * half * t * t - s * t);
    CHECK(value[3] == -(half + s * s / Rational(8L) + t / Rational(16L)));
  }
}

TEST_CASE("The six parts of a triangle fill it, counterclockwise", "[powell_sabin]") {
  const SpheresOnTriangles input = dome(3, 0.3, 3);
  const FamilySpline spline = input.family().spline;
  REQUIRE(spline.pieces.size() == 6 * input.triangles.size());
  for (std::size_t t = 0; t < input.triangles.size(); ++t) {
    Rational area;
    for (std::size_t i = 6 * t; i < 6 * (t + 1); ++i) {
      const FamilyPiece& piece = spline.pieces[i];
      CHECK(piece.designers_triangle == t);
      const auto [a, b, c] = piece.corners;
      const Rational part = orientation(spline.corners[a], spline.corners[b], spline.corners[c]);
      CHECK(part.sign() > 0);
      area += part;
    }
    const auto [a, b, c] = input.triangles[t];
    CHECK(area == orientation(spline.corners[a], spline.corners[b], spline.corners[c]));
  }
}

TEST_CASE("Triangles may be thin", "[powell_sabin]") {
  for (const double height : {1e-1, 1e-2, 1e-3}) {
    const auto at = [](double s, double t) { return placed({s, t}, Dome()); };
    const SpheresOnTriangles input = {{at(0, 0), at(1, 0), at(0.3, height), at(0.6, -1)},
                                      {{0, 1, 2}, {1, 0, 3}}};
    CHECK(input.family().spline.pieces.size() == 12);
  }
}

TEST_CASE("Equal radii are said to be an offset of a mid-surface", "[powell_sabin]") {
  SpheresOnTriangles input = dome(2, 0.2, 1);
  CHECK(input.family().notes.empty());
  for (PlacedSphere& placed : input.spheres) {
    placed.sphere[3] = 2;
    for (auto& derivative : placed.derivatives) derivative[3] = 0;
  }
  REQUIRE(input.family().notes.size() == 1);
  CHECK(input.family().notes[0].find("offsets of the mid-surface") != std::string::npos);
}

TEST_CASE("Where there is no envelope the triangle is named", "[powell_sabin]") {
  SpheresOnTriangles steep = dome(2, 0, 1);
  // Only the triangles at this corner of the square change.
  steep.spheres.back().derivatives[0][3] = 200;
  const std::string sentence = refusal(steep, ErrorCode::kRadiusTooSteep);
  const std::size_t last = steep.triangles.size() - 1;
  CHECK((sentence.find("triangle " + std::to_string(last)) != std::string::npos ||
         sentence.find("triangle " + std::to_string(last - 1)) != std::string::npos));
  SpheresOnTriangles still = dome(2, 0, 1);
  still.spheres[4].derivatives[1] = still.spheres[4].derivatives[0];
  CHECK(refusal(still, ErrorCode::kRadiusTooSteep).find("no tangent plane") != std::string::npos);
}

TEST_CASE("Numbers that are not finite are refused", "[powell_sabin]") {
  for (const double bad : {double(NAN), double(INFINITY)}) {
    SpheresOnTriangles sphere = dome(1, 0, 1), derivative = sphere, parameter = sphere;
    sphere.spheres[2].sphere[3] = bad;
    derivative.spheres[1].derivatives[1][0] = bad;
    parameter.spheres[0].parameter[1] = bad;
    for (const auto& input : {sphere, derivative, parameter}) {
      CHECK(refusal(input, ErrorCode::kNotFinite).find("not a finite number") != std::string::npos);
    }
  }
}
