// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/bezier/conic_source.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <memory>

#include "error_code.hpp"
#include "moving_ellipses.hpp"
#include "pn/bezier/evaluation.hpp"
#include "pn/bezier/pn_surface.hpp"

using namespace pn;
using namespace pn::test;

namespace {

RationalPolynomial poly(const std::vector<long>& c) { return conic_polynomial(c); }

PNSurface surface_of(const std::vector<ConicSpan>& spans) {
  return PNSurface(std::make_shared<const ConicSource>(spans));
}

PNSurface surface_of(const MovingConic& conic) { return surface_of({ConicSpan{conic, {}}}); }

/// Every point is on the ellipse of its height, with half-axes of these squares, and the lines of
/// constant t go around once.
void check_upright(const PNSurface& surface, const RationalPolynomial& aa,
                   const RationalPolynomial& bb) {
  const auto faces = surface.faces(Lines::kEven);
  REQUIRE(faces.size() == 1);
  const SurfaceEvaluation face(faces.front());
  for (int i = 0; i <= 12; ++i) {
    double turn = 0, before = 0;
    for (int k = 0; k <= 60; ++k) {
      const auto x = face(i / 12.0, k / 15.0);
      const Rational t = Rational::exactly(x[2] / 10);
      const double a2 = aa(t).to_double(), b2 = bb(t).to_double();
      CHECK(x[0] * x[0] / a2 + x[1] * x[1] / b2 == Approx(1).epsilon(1e-11));
      const double angle = std::atan2(x[1] / std::sqrt(b2), x[0] / std::sqrt(a2));
      if (k > 0) turn += std::remainder(angle - before, 2 * M_PI);
      before = angle;
    }
    CHECK(std::abs(turn) == Approx(2 * M_PI));
    if (i == 0 || i == 12) CHECK(face(i / 12.0, 1.3)[2] == Approx(10 * i / 12.0).margin(1e-11));
  }
  CHECK(surface.certificate(Lines::kEven).deviation < 1e-13);
}

}  // namespace

TEST_CASE("Ellipses whose squared half-axes are polynomials", "[conic_source]") {
  const RationalPolynomial aa = poly({2, 1, 3}), bb = poly({5, -2, 1});
  const PNSurface surface = surface_of(upright(ellipse(aa, bb)));
  check_upright(surface, aa, bb);
  CHECK(surface.degree()[1] == 2);
}

TEST_CASE("Half-axes that are real on the interval only", "[conic_source]") {
  const RationalPolynomial aa = poly({1, 3}), bb = poly({3, -2});
  check_upright(surface_of(upright(ellipse(aa, bb))), aa, bb);
}

TEST_CASE("A cylinder is found in its least degree", "[conic_source]") {
  const PNSurface surface = surface_of(upright(ellipse(4L, 1L)));
  check_upright(surface, 4L, 1L);
  CHECK(surface.degree() == std::array<int, 2>{1, 2});
}

TEST_CASE("Ellipses in turning planes lie in their planes and on their quadrics",
          "[conic_source]") {
  // Along a parabola in its normal planes, p = (2 t, -1, 0), within its radius of curvature.
  const RationalPolynomial t = poly({0, 1});
  const RationalPolynomial aa = poly({1, 1}), bb = poly({2, 0, 1});
  const PNSurface surface = surface_of(moving({t, t * t, 0L}, {poly({0, 2}), -1L, 0L}, {0L, 0L, 1L},
                                              diagonal(-(aa * bb), 64L * bb, 64L * aa)));
  const auto faces = surface.faces(Lines::kEven);
  REQUIRE(faces.size() == 1);
  const SurfaceEvaluation face(faces.front());
  for (int i = 0; i <= 10; ++i) {
    // s runs through t monotonically: t is found from the plane of one point.
    const auto first = face(i / 10.0, 0.8);
    double low = -0.01, high = 1.01;
    const auto plane = [](const std::array<double, 3>& x, double at) {
      return (x[0] - at) + 2 * at * (x[1] - at * at);
    };
    for (int step = 0; step < 60; ++step) {
      const double middle = (low + high) / 2;
      (plane(first, low) * plane(first, middle) <= 0 ? high : low) = middle;
    }
    for (int k = 0; k <= 20; ++k) {
      const auto x = face(i / 10.0, k / 5.0);
      CHECK(plane(x, low) == Approx(0).margin(1e-9));
      const double xi = 2 * low * (x[0] - low) - (x[1] - low * low);
      const double p2 = 4 * low * low + 1;
      CHECK(64 * (xi * xi / (p2 * p2) / (1 + low) + x[2] * x[2] / (2 + low * low)) ==
            Approx(1).epsilon(1e-8));
    }
  }
}

TEST_CASE("Ellipses that become thin one way and then the other take several faces",
          "[conic_source]") {
  // Half-axes 1/32 to 32 and back: the squares are exact, so each end is an ellipse of the next
  // face.
  const RationalPolynomial aa = poly({1, 1023}), bb = poly({1024, -1023});
  const PNSurface surface = surface_of(upright(ellipse(aa, bb)));
  double end = 0;
  for (const BSplineSurface& part : surface.faces(Lines::kEven)) {
    CHECK(part.u_knots.front() == end);
    end = part.u_knots.back();
    const SurfaceEvaluation face(part);
    for (const double u : {part.u_knots.front(), (part.u_knots.front() + end) / 2, end}) {
      for (int k = 0; k < 8; ++k) {
        const auto x = face(u, k / 2.0);
        const double t = x[2] / 10;
        const double a2 = 1 + 1023 * t, b2 = 1024 - 1023 * t;
        CHECK(x[0] * x[0] / a2 + x[1] * x[1] / b2 == Approx(1).epsilon(1e-9));
      }
    }
  }
  CHECK(end == 1);
}

namespace {

/// Points of a face inside its trims near their edges and in the middle.
std::vector<std::array<double, 3>> points_of_edges(const BSplineSurface& face) {
  const SurfaceEvaluation evaluation(face);
  std::vector<std::array<double, 3>> points;
  for (const ParameterCurve& edge : face.trims.front()) {
    for (int k = 0; k <= 10; ++k) {
      const auto [u, v] = evaluate(edge, k / 10.0);
      points.push_back(evaluation(u, v));
    }
  }
  return points;
}

}  // namespace

TEST_CASE("Arcs of ellipses, parabolas and hyperbolas are one surface with exact conics",
          "[conic_source]") {
  // x^2 + (1/2 - t) y^2 = y below y = 1.
  Conic conic = diagonal(0L, 2L, poly({1, -2}));
  conic[0][2] = conic[2][0] = -1L;
  for (const Lines lines : {Lines::kEven, Lines::kLowestDegree}) {
    const PNSurface surface =
        surface_of({ConicSpan{upright(conic), Vector3<RationalPolynomial>{1L, 0L, -1L}}});
    for (const BSplineSurface& face : surface.faces(lines)) {
      REQUIRE(face.trims.size() == 1);
      for (const auto& [x, y, z] : points_of_edges(face)) {
        CHECK(x * x + (0.5 - z / 10) * y * y == Approx(y).margin(1e-12));
        CHECK(y < 1 + 1e-12);
        // Edges are the ends of arcs or the first and the last arc.
        CHECK(std::min({std::abs(y - 1), std::abs(z), std::abs(z - 10)}) < 1e-11);
      }
    }
    CHECK(surface.certificate(lines).trim_deviation < 1e-12);
    CHECK(surface.certificate(lines).deviation < 1e-13);
  }
}

TEST_CASE("Ends that are rational become sides of the face", "[conic_source]") {
  // Arcs with given tangents at both ends: the points b0 y0 + b1 y1 + b2 y2 with 4 y1^2 = k y0 y2
  // and the cut y1 > 0, from the curve b0 to the curve b2; of ellipses and at last a parabola.
  const RationalPolynomial zero, one(1L), t = poly({0, 1}), k = poly({1, 3}) * poly({1, 3});
  MovingConic conic;
  conic.frame = {{{-4L + t, t, poly({5}) + t * t},
                  {zero, poly({4, 2}), t},
                  {10L * t, 10L * t, 10L * t},
                  {one, one, one}}};
  conic.conic = diagonal(zero, one, zero);
  conic.conic[0][2] = conic.conic[2][0] = -(RationalPolynomial(Rational(1) / Rational(8)) * k);
  const PNSurface surface =
      surface_of({ConicSpan{conic, Vector3<RationalPolynomial>{zero, one, zero}}});
  for (const Lines lines : {Lines::kEven, Lines::kLowestDegree}) {
    const auto faces = surface.faces(lines);
    REQUIRE(faces.size() == 1);
    CHECK(faces.front().trims.empty());
    CHECK(surface.certificate(lines).trim_deviation == 0);
    const SurfaceEvaluation face(faces.front());
    for (const double at : {0.0, 0.3, 0.8, 1.0}) {
      const auto a = face(at, 0), b = face(at, 1);
      const bool in_order = a[0] < b[0];
      const auto &low = in_order ? a : b, &high = in_order ? b : a;
      const double s = low[2] / 10;
      CHECK(low[0] == Approx(s - 4).epsilon(1e-12));
      CHECK(low[1] == Approx(0).margin(1e-12));
      CHECK(high[0] == Approx(5 + s * s).epsilon(1e-12));
      CHECK(high[1] == Approx(s).margin(1e-12));
    }
  }
}

TEST_CASE("Cuts that take no finite arc are refused, and the place is named", "[conic_source]") {
  const Conic circle = diagonal(-1L, 1L, 1L);
  Conic parabola = diagonal(0L, 1L, 0L);
  parabola[0][2] = parabola[2][0] = -1L;
  const auto refusal = [](const Conic& c, const Vector3<RationalPolynomial>& cut) {
    try {
      ConicSource({{upright(c), cut}});
    } catch (const GeometryError& error) {
      return to_string(error.code()) + ": " + error.what();
    }
    return std::string("none");
  };
  // The line leaves the circle at t = 1/2.
  CHECK_THAT(refusal(circle, {poly({0, 2}), 0L, 1L}),
             Catch::StartsWith("region_empty") && Catch::Contains("t = 0.5"));
  // The other side of the parabola, from the start.
  CHECK_THAT(refusal(parabola, {-1L, 0L, 1L}),
             Catch::StartsWith("region_unbounded") && Catch::Contains("t = 0 "));
  // x^2 + (1/4 - t) y^2 = y above y = 1: the ellipses open at t = 1/4.
  Conic opening = diagonal(0L, 4L, poly({1, -4}));
  opening[0][2] = opening[2][0] = -2L;
  CHECK_THAT(refusal(opening, {-1L, 0L, 1L}),
             Catch::StartsWith("region_unbounded") && Catch::Contains("t = 0.25"));
  // x^2 - y^2 = 1, and the line turns until it is parallel to an asymptote.
  CHECK_THAT(refusal(diagonal(1L, -1L, 1L), {2L, -1L, poly({0, 2})}),
             Catch::StartsWith("region_unbounded") && Catch::Contains("t = 0.5"));
  // A hyperbola whose arc becomes a corner of its asymptotes.
  CHECK_THAT(refusal(diagonal(poly({1, -2}), -1L, 1L), {2L, -1L, 0L}),
             Catch::StartsWith("region_unbounded") && Catch::Contains("t = 0.5"));
  CHECK(code_of([&] {
          ConicSource({{upright(circle), Vector3<RationalPolynomial>{0L, 0L, 1L}},
                       {upright(circle, 1), {}}});
        }) == ErrorCode::kWrongShape);
}

TEST_CASE("Conics that are no ellipses and ellipses without points are refused", "[conic_source]") {
  const auto code = [](const Conic& c) {
    return code_of([&] { ConicSource({{upright(c), {}}}); });
  };
  CHECK(code(ellipse(poly({1, -2}), 1L)) == ErrorCode::kRegionUnbounded);
  CHECK(code(ellipse(-1L, poly({1, 1}))) == ErrorCode::kRegionUnbounded);
  CHECK(code(ellipse(poly({1, -2}), poly({1, -2}))) == ErrorCode::kNoRealPoints);
  CHECK(code(diagonal(0L, 1L, 1L)) == ErrorCode::kSingularConics);
}

TEST_CASE("Spans that meet but for rounding are joined, and the gap is counted", "[conic_source]") {
  const auto lifted = [](const Rational& height, const Rational& radius) {
    ConicSpan span{upright(ellipse(RationalPolynomial(radius * radius), 4L)), {}};
    span.conic.frame[2][0] += RationalPolynomial(height);
    return span;
  };
  const ConicSpan first = lifted(0L, 3L);
  const double rounding = 0x1p-48;
  const PNSurface joined = surface_of({first, lifted(10L, 3L + Rational::exactly(rounding))});
  CHECK(joined.certificate(Lines::kEven).deviation > rounding / 2);
  CHECK(joined.certificate(Lines::kEven).deviation < 1e-13);
  const auto apart = [&] { surface_of({first, lifted(10L, 3L + Rational::exactly(1e-9))}); };
  CHECK(code_of(apart) == ErrorCode::kGap);
}

TEST_CASE("Arcs that meet but for rounding are joined, of parabolas too", "[conic_source]") {
  // x^2 = 2 y - (1 + K) y^2 in planes at rising heights, below y = 2.
  const auto lifted = [](const Rational& height, const Rational& constant, double off) {
    const RationalPolynomial one_and_constant(Rational(1L) + constant);
    ConicSpan span{upright({{{0L, 0L, -1L}, {0L, 1L, 0L}, {-1L, 0L, one_and_constant}}}),
                   Vector3<RationalPolynomial>{2L, 0L, -1L}};
    span.conic.frame[2][0] += RationalPolynomial(height);
    span.conic.frame[1][0] += RationalPolynomial(Rational::exactly(off));
    return span;
  };
  for (const Rational& constant : {Rational(-2L), Rational(-1L), Rational(-1L) / Rational(2L)}) {
    const ConicSpan first = lifted(0L, constant, 0);
    const PNSurface joined = surface_of({first, lifted(10L, constant, 0x1p-48)});
    CHECK(joined.certificate(Lines::kEven).deviation < 1e-13);
    const auto apart = [&] { surface_of({first, lifted(10L, constant, 1e-9)}); };
    CHECK(code_of(apart) == ErrorCode::kGap);
    ConicSpan lower = lifted(10L, constant, 0);
    lower.cut = Vector3<RationalPolynomial>{1L, 0L, -1L};
    CHECK(code_of([&] { surface_of({first, lower}); }) == ErrorCode::kGap);
  }
}
