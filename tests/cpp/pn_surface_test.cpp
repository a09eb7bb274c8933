// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/bezier/pn_surface.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <thread>

#include "circle_spine.hpp"
#include "error_code.hpp"
#include "pn/algebra/precision.hpp"
#include "pn/bezier/evaluation.hpp"
#include "pn/shapes/canal_surface.hpp"
#include "pn/shapes/ruled_surface.hpp"

using namespace pn;
using namespace pn::test;

namespace {

using Point = std::array<double, 3>;

const Curve kLine = Curve::bezier({{0, 0, 0}, {4, 0, 0}});
const Curve kCubic = Curve::bezier({{0, 0, 0}, {1, 0, 0}, {2, 1, 0}, {2, 2, 1}});

/// Parameters over the spine's domain [0, end] and once around.
std::vector<SurfacePoint> samples(const PNSurface& surface, double end) {
  std::vector<double> t, v;
  for (int i = 0; i <= 12; ++i) {
    for (int j = 0; j <= 12; ++j) {
      t.push_back(end * i / 12);
      v.push_back(4.0 * j / 12);
    }
  }
  return surface.evaluate(t, v);
}

double distance(const Point& a, const Point& b) {
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

/// Evaluation in doubles rounds by some hundred units in the last place.
constexpr double kRounding = 1e-13;

}  // namespace

TEST_CASE("A cylinder and its offsets satisfy their equation", "[pn_surface]") {
  const PNSurface surface(canal_surface(kLine, Law::constant(1)));
  for (const double d : {0.0, 0.5, -0.75}) {
    for (const auto& [x, n] : samples(surface.offset(d), 1)) {
      CHECK(std::hypot(x[1], x[2]) == Approx(1 + d).epsilon(kRounding));
      CHECK(std::abs(n[0]) < kRounding);
      CHECK(n[1] == Approx(x[1] / (1 + d)).margin(kRounding));
    }
  }
}

TEST_CASE("A cone and its offsets satisfy their equation", "[pn_surface]") {
  // r' / |m'| = 3/5, so the normal has slope -3/5 along the axis and the radius at x is (r + d) 4/5
  // there.
  const PNSurface surface(
      canal_surface(Curve::bezier({{0, 0, 0}, {5, 0, 0}}), Law::bezier({1, 4})));
  for (const double d : {0.0, 0.5, -0.5}) {
    for (const auto& [x, n] : samples(surface.offset(d), 1)) {
      CHECK(n[0] == Approx(-0.6).epsilon(kRounding));
      // The plane through the touching points: n.x = <f, w> / w4 + d, with support 1 at the apex
      // side.
      CHECK(-0.6 * x[0] + 0.8 * std::hypot(x[1], x[2]) == Approx(1 + d).epsilon(kRounding));
    }
  }
}

TEST_CASE("A torus and its offsets satisfy their equation", "[pn_surface]") {
  const PNSurface surface(canal_surface(circle(4), Law::constant(1)));
  for (const double d : {0.0, 1.5, -0.5}) {
    for (const auto& [x, n] : samples(surface.offset(d), 4)) {
      CHECK(std::hypot(std::hypot(x[0], x[1]) - 4, x[2]) == Approx(1 + d).epsilon(kRounding));
    }
  }
  CHECK(surface.degree() == std::array<int, 2>{4, 2});
}

TEST_CASE("The zone at a corner lies on its sphere", "[pn_surface]") {
  const Curve corner =
      Curve::bspline({1, {0, 1, 2}, {2, 1, 2}, {{0, 0, 0}, {3, 0, 0}, {3, 4, 0}}, {}});
  const auto faces = PNSurface(canal_surface(corner, Law::constant(0.5))).faces(Lines::kEven);
  REQUIRE(faces.size() == 3);
  for (int i = 0; i <= 10; ++i) {
    for (int j = 0; j <= 10; ++j) {
      CHECK(distance(evaluate(faces[1], i / 10.0, 0.4 * j), {3, 0, 0}) ==
            Approx(0.5).epsilon(kRounding));
    }
  }
}

TEST_CASE("Offsets add up and move every point along its normal", "[pn_surface]") {
  const PNSurface surface(canal_surface(kCubic, Law::bezier({0.25, 0.5, 0.25, 0.125})));
  const PNSurface moved = surface.offset(0.25).offset(0.5);
  CHECK(moved.distance() == 0.75);
  const auto before = samples(surface, 1), after = samples(moved, 1),
             at_once = samples(surface.offset(0.75), 1);
  for (std::size_t i = 0; i < before.size(); ++i) {
    CHECK(after[i].point == at_once[i].point);
    CHECK(std::hypot(before[i].normal[0], before[i].normal[1], before[i].normal[2]) ==
          Approx(1).epsilon(kRounding));
    for (std::size_t c = 0; c < 3; ++c) {
      CHECK(after[i].point[c] ==
            Approx(before[i].point[c] + 0.75 * before[i].normal[c]).margin(kRounding));
    }
  }
  CHECK(surface.distance() == 0);
}

TEST_CASE("The offset of a spine is its pipe: radius and distance exchange", "[pn_surface]") {
  const auto pipe =
      PNSurface(canal_surface(kCubic, Law::constant(0.25))).faces(Lines::kEven).front();
  const auto offset =
      PNSurface(canal_surface(kCubic, Law::constant(0))).offset(0.25).faces(Lines::kEven).front();
  REQUIRE(pipe.poles.size() == offset.poles.size());
  for (std::size_t i = 0; i < pipe.poles.size(); ++i)
    CHECK(distance(pipe.poles[i], offset.poles[i]) < kRounding);
}

TEST_CASE("Normals point away from the spine", "[pn_surface]") {
  const PNSurface surface(canal_surface(kCubic, Law::constant(0.25)));
  const auto centre = samples(surface.offset(-0.25), 1);
  const auto points = samples(surface, 1);
  for (std::size_t i = 0; i < points.size(); ++i) {
    double outward = 0;
    for (std::size_t c = 0; c < 3; ++c)
      outward += (points[i].point[c] - centre[i].point[c]) * points[i].normal[c];
    CHECK(outward == Approx(0.25));
  }
}

TEST_CASE("S_u x S_v points along the normal", "[pn_surface]") {
  for (const auto& [spine, radius] :
       {std::pair{kCubic, Law::constant(0.25)}, std::pair{circle(4), Law::constant(1)}}) {
    const PNSurface surface(canal_surface(spine, radius));
    for (const BSplineSurface& face : surface.faces(Lines::kEven)) {
      constexpr double kStep = 1e-6;
      const double u = (face.u_knots[0] + face.u_knots[1]) / 2;
      for (const double v : {0.3, 1.7, 3.1}) {
        const Point x = evaluate(face, u, v), xu = evaluate(face, u + kStep, v),
                    xv = evaluate(face, u, v + kStep);
        const Point n = surface.evaluate({u}, {v})[0].normal;
        Point a, b;
        for (std::size_t c = 0; c < 3; ++c) a[c] = xu[c] - x[c], b[c] = xv[c] - x[c];
        const double triple = n[0] * (a[1] * b[2] - a[2] * b[1]) +
                              n[1] * (a[2] * b[0] - a[0] * b[2]) +
                              n[2] * (a[0] * b[1] - a[1] * b[0]);
        CHECK(triple > 0);
      }
    }
  }
}

TEST_CASE("The certificate describes the faces", "[pn_surface]") {
  const PNSurface surface(canal_surface(kCubic, Law::bezier({0.25, 0.5, 0.25, 0.125})));
  CHECK(surface.degree() == std::array<int, 2>{5, 2});
  for (const Lines lines : {Lines::kEven, Lines::kLowestDegree}) {
    std::size_t poles = 0;
    for (const BSplineSurface& face : surface.faces(lines)) poles += face.poles.size();
    const Certificate certificate = surface.certificate(lines);
    CHECK(certificate.poles == poles);
    CHECK(certificate.bidegree[0] == surface.faces(lines).front().u_degree);
    CHECK(certificate.bidegree[1] == (lines == Lines::kEven ? 4 : 2));
    CHECK(certificate.exact);
    CHECK(certificate.deviation > 0);
    CHECK(certificate.deviation < 1e-13);
    CHECK(certificate.precision_bits >= kLeastPrecision);
  }
  const Curve bent =
      Curve::bspline({1, {0, 1, 2}, {2, 1, 2}, {{0, 0, 0}, {1, 0, 0}, {2, 1e-9, 0}}, {}});
  const Certificate mended =
      PNSurface(canal_surface(bent, Law::constant(0.1))).certificate(Lines::kEven);
  CHECK_FALSE(mended.exact);
  CHECK(mended.notes.size() == 1);
}

TEST_CASE("Only trimmed faces have edges that are measured", "[pn_surface]") {
  CHECK(PNSurface(canal_surface(kCubic, Law::constant(0.25)))
            .certificate(Lines::kEven)
            .trim_deviation == 0);
  const PNSurface band(
      ruled_surface(kCubic, Curve::bezier({{0, 3, 0}, {1, 3, 1}, {2, 4, 0}, {3, 4, 2}})));
  for (const double d : {0.0, 0.5}) {
    const Certificate certificate = band.offset(d).certificate(Lines::kEven);
    CHECK(certificate.trim_deviation > 0);
    CHECK(certificate.trim_deviation < 1e-9);
    for (const BSplineSurface& face : band.offset(d).faces(Lines::kEven))
      CHECK(face.trims.size() == 1);
  }
}

TEST_CASE("A precision that does not suffice is raised", "[pn_surface]") {
  const Curve nearly_flat =
      Curve::bezier({{0, 0, 0}, {1, 0.5, 1e-17}, {2, 0, -1e-17}, {3, 1, 1e-17}});
  const Certificate certificate = PNSurface(canal_surface(nearly_flat, Law::constant(0.2)))
                                      .offset(-0.2)
                                      .certificate(Lines::kEven);
  CHECK(certificate.precision_bits > kLeastPrecision);
  CHECK(certificate.deviation < 1e-13);
}

TEST_CASE("A distance must be finite, and the sum of several within the limits", "[pn_surface]") {
  const PNSurface surface(canal_surface(kLine, Law::constant(1)));
  CHECK(code_of([&] { surface.offset(std::nan("")); }) == ErrorCode::kNotFinite);
  CHECK(code_of([&] { surface.offset(-INFINITY); }) == ErrorCode::kNotFinite);
  CHECK(code_of([&] { surface.offset(7e99).offset(7e99); }) == ErrorCode::kOutOfRange);
}

TEST_CASE("The regular range is counted from distance zero", "[pn_surface]") {
  const PNSurface surface(canal_surface(circle(4), Law::constant(1)));
  const OffsetRange range = surface.offset(0.5).regular_range();
  CHECK(range.lower == Approx(-1).epsilon(1e-6));
  CHECK(range.upper == Approx(3).epsilon(1e-6));
}

TEST_CASE("Threads may share a surface and get the same faces", "[pn_surface]") {
  const PNSurface surface(canal_surface(kCubic, Law::constant(0.25)));
  std::vector<std::vector<BSplineSurface>> found(4);
  std::vector<std::thread> threads;
  for (auto& faces : found) threads.emplace_back([&] { faces = surface.faces(Lines::kEven); });
  for (std::thread& thread : threads) thread.join();
  for (const auto& faces : found) CHECK(faces[0].poles == found[0][0].poles);
}
