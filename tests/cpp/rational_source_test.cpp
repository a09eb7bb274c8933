// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/bezier/rational_source.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "error_code.hpp"
#include "parabolic_mirror.hpp"
#include "pn/bezier/pn_surface.hpp"
#include "pn/isotropic/from_planes.hpp"
#include "pn/shapes/mirror.hpp"

using namespace pn;
using test::code_of;
using test::parabolic_mirror;

namespace {

PNSurface surface_of(const Wavefronts& wavefronts) {
  return PNSurface(std::make_shared<const RationalSource>(wavefronts.patches, wavefronts.leaving,
                                                          wavefronts.notes));
}

/// A PN surface around the origin of the parameters, by four polynomials.
PNSurface from_polynomials() {
  const BivariatePolynomial u(Variable::kU), v(Variable::kV), one(1L);
  const auto w = universal_isotropic_vector({u, v, one, BivariatePolynomial()});
  const OrientedSurface x = from_planes(w, BivariateFunction(u * u - v * v + u * v * v));
  return PNSurface(std::make_shared<const RationalSource>(
      std::vector<RationalSections>{rational_sections(x)}, 0, std::vector<std::string>{}));
}

}  // namespace

TEST_CASE("Light along the axis of a paraboloid is regular up to its focus", "[rational_source]") {
  // From z = 5 it has a path of 6 to the focus.
  const PNSurface wavefront =
      surface_of(mirror_wavefronts(parabolic_mirror(), ParallelLight{{0, 0, -1}, {0, 0, 5}}));
  const OffsetRange range = wavefront.regular_range();
  CHECK(range.upper <= 6);
  CHECK(range.upper == Approx(6).epsilon(1e-5));
  CHECK(range.lower == -INFINITY);
  REQUIRE(range.at_upper.has_value());
  CHECK(range.at_upper->point[2] == Approx(1).margin(1e-9));
}

TEST_CASE("A wavefront is exported with its certificate", "[rational_source]") {
  const PNSurface wavefront =
      surface_of(mirror_wavefronts(parabolic_mirror(), ParallelLight{{0, 0, -1}, {0, 0, 5}}))
          .offset(5.75);
  const Certificate certificate = wavefront.certificate(Lines::kEven);
  CHECK(certificate.exact);
  CHECK(certificate.deviation < 1e-14);
  CHECK(certificate.trim_deviation == 0);
  for (const double t : {0.0, 0.3, 0.8}) {
    const SurfacePoint at = wavefront.evaluate({t}, {0.6}).front();
    CHECK(std::hypot(at.point[0], at.point[1], at.point[2] - 1) == Approx(0.25).epsilon(1e-12));
    CHECK(std::hypot(at.normal[0], at.normal[1], at.normal[2]) == Approx(1).epsilon(1e-14));
  }
}

TEST_CASE("A wavefront without rational offsets says so", "[rational_source]") {
  const PNSurface wavefront =
      surface_of(mirror_wavefronts(parabolic_mirror(), PointLight{{0.5, 0.25, 3}}));
  CHECK(code_of([&] { wavefront.offset(1); }) == ErrorCode::kNotRational);
  CHECK_FALSE(wavefront.has_offsets());
  CHECK_FALSE(wavefront.faces(Lines::kEven).empty());
  CHECK(wavefront.certificate(Lines::kEven).notes.size() == 1);
  const auto normal = wavefront.evaluate({0.3}, {0.6}).front().normal;
  CHECK(std::hypot(normal[0], normal[1], normal[2]) == Approx(1).epsilon(1e-14));
}

TEST_CASE("Parts meet, and have even weights", "[rational_source]") {
  const SplineSurfaceData steep = [] {
    SplineSurfaceData data = parabolic_mirror();
    for (auto& pole : data.poles) pole[2] *= 40;
    return data;
  }();
  const Wavefronts wavefronts = mirror_wavefronts(steep, ParallelLight{{0, 0.25, -1}, {0, 0, 30}});
  const std::vector<RationalSections> parts = evenly_weighted(wavefronts.patches);
  CHECK(parts.size() > 1);
  for (const BSplineSurface& face : surface_of(wavefronts).faces(Lines::kEven)) {
    const auto [least, largest] = std::minmax_element(face.weights.begin(), face.weights.end());
    CHECK(*least > 0.009 * *largest);
  }
}

TEST_CASE("The certified range of a surface from planes is that of its curvature",
          "[rational_source]") {
  const PNSurface surface = from_polynomials();
  const OffsetRange range = surface.regular_range();
  CHECK(range.lower < 0);
  CHECK(range.upper > 0);
  // Principal curvatures by differences of normals along the surface, on a grid.
  double nearest_above = INFINITY, nearest_below = -INFINITY;
  constexpr double kStep = 1e-5;
  for (double t = 0.02; t < 1; t += 0.08) {
    for (double v = 0.02; v < 1; v += 0.08) {
      const auto p = surface.evaluate({t, t + kStep, t}, {v, v, v + kStep});
      const auto difference = [](const auto& a, const auto& b) {
        return std::array{b[0] - a[0], b[1] - a[1], b[2] - a[2]};
      };
      const auto dot = [](const auto& a, const auto& b) {
        return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
      };
      const auto xu = difference(p[0].point, p[1].point), xv = difference(p[0].point, p[2].point),
                 nu = difference(p[0].normal, p[1].normal),
                 nv = difference(p[0].normal, p[2].normal);
      const double e = dot(xu, xu), f = dot(xu, xv), g = dot(xv, xv), det = e * g - f * f;
      // n_i = -k x_i along lines of curvature
      const double l = -dot(xu, nu), m = -dot(xu, nv), n = -dot(xv, nv);
      const double mean = (e * n - 2 * f * m + g * l) / (2 * det), gauss = (l * n - m * m) / det,
                   root = std::sqrt(std::max(mean * mean - gauss, 0.0));
      for (const double k : {mean + root, mean - root}) {
        if (k > 0) nearest_above = std::min(nearest_above, 1 / k);
        if (k < 0) nearest_below = std::max(nearest_below, 1 / k);
      }
    }
  }
  CHECK(range.upper < nearest_above * (1 + 1e-3));
  CHECK(range.lower > nearest_below * (1 + 1e-3));
  CHECK(range.upper > 0.8 * nearest_above);
  CHECK((range.lower == -INFINITY || range.lower < 0.8 * nearest_below));
}

TEST_CASE("A focal point is found wherever it lies", "[rational_source]") {
  // z = 2 x^2 + y^2 / 2 by its planes: they touch it where x = -A / 4 C, y = -B / C. Its largest
  // curvature is 4, at the vertex, where the normal points downwards.
  const BivariatePolynomial one(1L), two(2L), four(4L);
  const BivariatePolynomial s =
      BivariatePolynomial(Variable::kU) - BivariatePolynomial(Rational::exactly(0.3737));
  const BivariatePolynomial t =
      BivariatePolynomial(Variable::kV) - BivariatePolynomial(Rational::exactly(0.5111));
  const auto w = universal_isotropic_vector({s, t, one, BivariatePolynomial()});
  const BivariateFunction h(-(w[0] * w[0] + four * w[1] * w[1]), BivariatePolynomial(8L) * w[2]);
  const OffsetRange range =
      RationalSource({rational_sections(from_planes(w, h))}, 0, {}).regular_range();
  CHECK(range.upper == INFINITY);
  CHECK(range.lower >= -0.25);
  CHECK(range.lower == Approx(-0.25).epsilon(1e-5));
}

TEST_CASE("A degree above 25 is refused", "[rational_source]") {
  SplineSurfaceData data{{6, 1}, {{{0, 1}, {0, 1}}}, {{{7, 7}, {2, 2}}}, {}, {}};
  for (int i = 0; i <= 6; ++i) {
    for (int j = 0; j < 2; ++j) {
      data.poles.push_back({i + 0.1 * j, 5.0 * j, 0.3 * ((i * i + j) % 3)});
    }
  }
  const auto wavefronts = mirror_wavefronts(data, ParallelLight{{0, 0, -1}, {0, 0, 5}});
  CHECK(code_of([&] { evenly_weighted(wavefronts.patches); }) == ErrorCode::kDegreeTooHigh);
}
