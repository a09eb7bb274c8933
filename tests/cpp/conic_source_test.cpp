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

TEST_CASE("Conics that are no ellipses and ellipses without points are refused", "[conic_source]") {
  const auto code = [](const Conic& c) {
    return code_of([&] { ConicSource({{upright(c), {}}}); });
  };
  CHECK(code(ellipse(poly({1, -2}), 1L)) == ErrorCode::kRegionUnbounded);
  CHECK(code(ellipse(-1L, poly({1, 1}))) == ErrorCode::kRegionUnbounded);
  CHECK(code(ellipse(poly({1, -2}), poly({1, -2}))) == ErrorCode::kNoRealPoints);
  CHECK(code(diagonal(0L, 1L, 1L)) == ErrorCode::kSingularConics);
}
