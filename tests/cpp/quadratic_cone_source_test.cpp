// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/bezier/quadratic_cone_source.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "cone_families.hpp"
#include "error_code.hpp"
#include "pn/bezier/pn_surface.hpp"

using namespace pn;
using namespace pn::test;

namespace {

using Polynomial = RationalPolynomial;

Polynomial poly(const std::vector<long>& c) { return conic_polynomial(c); }

PNSurface surface_of(const QuadraticCones& cones, const std::optional<ContactArc>& arc = {}) {
  return PNSurface(std::make_shared<QuadraticConeSource>(cones, arc));
}

/// The cones that touch the spheres around (4 t, t^2, 0) with the squared radius 2 + t + t^2 along
/// their characteristic circles: the envelope is the canal surface.
QuadraticCones cones_of_canal() {
  const std::array<Polynomial, 3> m = {poly({0, 4}), poly({0, 0, 1}), Polynomial()};
  const Polynomial rr = poly({2, 1, 1}), half(Rational(1L) / Rational(2L));
  Vector4OfPolynomials plane;
  Matrix4OfPolynomials cone;
  plane[3] = half * rr.derivative();
  Polynomial mm = -rr, speed;
  for (std::size_t i = 0; i < 3; ++i) {
    plane[i] = m[i].derivative();
    plane[3] -= m[i] * plane[i];
    mm += m[i] * m[i];
    speed += plane[i] * plane[i];
  }
  const Polynomial factor = rr * speed - half * half * rr.derivative() * rr.derivative();
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = 0; j < 4; ++j) {
      const Polynomial sphere = i == 3 && j == 3 ? mm
                                : i == j         ? Polynomial(1L)
                                : i == 3         ? -m[j]
                                : j == 3         ? -m[i]
                                                 : Polynomial();
      cone[i][j] = factor * sphere - rr * plane[i] * plane[j];
    }
  }
  return quadratic_cones(cone);
}

/// The parameter t of the sphere through a point of the canal surface, by its characteristic plane.
double sphere_of(const std::array<double, 3>& x) {
  // (x - m).m' + (r^2)' / 2 = 4 (x0 - 4 t) + 2 t (x1 - t^2) + 1/2 + t
  double low = -0.5, high = 1.5;
  for (int i = 0; i < 60; ++i) {
    const double t = (low + high) / 2;
    (4 * (x[0] - 4 * t) + 2 * t * (x[1] - t * t) + 0.5 + t > 0 ? low : high) = t;
  }
  return (low + high) / 2;
}

}  // namespace

TEST_CASE("The whole envelope of cones that touch spheres is the canal surface",
          "[quadratic_cone_source]") {
  const PNSurface surface = surface_of(cones_of_canal());
  const std::vector<BSplineSurface> faces = surface.faces(Lines::kEven);
  REQUIRE(faces.size() >= 4);
  // That of canal surfaces with a spine of degree 2, whether r or only r^2 is rational.
  CHECK(surface.degree() == std::array<int, 2>{4, 2});
  CHECK(surface.certificate(Lines::kEven).deviation < 1e-12);
  double least = 2, most = -1;
  std::vector<double> t, v;
  for (std::size_t face = 0; face < faces.size(); ++face) {
    for (const double weight : faces[face].weights) CHECK(weight > 0);
    for (const double along : {0.0, 0.3, 0.99999}) {
      for (const double around : {0.0, 0.6, 1.0}) {
        t.push_back(static_cast<double>(face) + along);
        v.push_back(around);
      }
    }
  }
  for (const SurfacePoint& p : surface.evaluate(t, v)) {
    const double at = sphere_of(p.point);
    least = std::min(least, at), most = std::max(most, at);
    const std::array<double, 3> d = {p.point[0] - 4 * at, p.point[1] - at * at, p.point[2]};
    CHECK(d[0] * d[0] + d[1] * d[1] + d[2] * d[2] == Approx(2 + at + at * at));
    // The normals are radial.
    const double along = d[0] * p.normal[0] + d[1] * p.normal[1] + d[2] * p.normal[2];
    CHECK(std::abs(along) == Approx(std::sqrt(2 + at + at * at)));
  }
  CHECK(least == Approx(0).margin(1e-9));
  CHECK(most == Approx(1).epsilon(1e-4));
}

TEST_CASE("An arc passes its second point and ends at the others", "[quadratic_cone_source]") {
  // At t = 1/2 the circle is around (2, 1/4, 0), nearly in a plane x = const.
  const auto ends = [](const std::array<double, 3>& through) {
    const std::array<double, 3> up = {2, 0.25, 2}, left = {2, 2.25, 0};
    const PNSurface surface = surface_of(cones_of_canal(), ContactArc{up, through, left});
    const auto count = static_cast<double>(surface.faces(Lines::kEven).size());
    return std::pair{surface.evaluate({0.5, count - 0.5}, {0.0, 1.0}), count};
  };
  const auto [short_way, few] = ends({2, 1.5, 1.5});
  const auto [long_way, many] = ends({2, -1.5, -1.5});
  CHECK(few < many);
  for (const auto& points : {short_way, long_way}) {
    CHECK(std::abs(points[0].point[1] - 0.25) < 0.2);
    CHECK(points[0].point[2] > 1.4);
    CHECK(points[1].point[1] > 1.6);
    CHECK(std::abs(points[1].point[2]) < 0.2);
  }
}

TEST_CASE("Bad cones are refused with their reasons", "[quadratic_cone_source]") {
  const Polynomial t = power_of_t(1), one(1L), minus = poly({-1});
  const auto code = [](const Vector4OfPolynomials& v, const Conic& directions) {
    return code_of([&] { surface_of(quadratic_cones(v, directions)); });
  };
  CHECK(code({t, t * t, 0L, one}, diagonal(one, one, minus)) == ErrorCode::kDevelopable);
  CHECK(code({1L, 2L, 3L, one}, diagonal(one + t * t, one, minus)) == ErrorCode::kZeroLength);
  // Generators exist beyond t = 1/2 only.
  CHECK_THROWS_WITH(
      surface_of(quadratic_cones({t, t * t, 0L, one}, diagonal(one, one, poly({1, -2})))),
      Catch::Contains("no real generators for t < 0.5"));
  // On cones that open the contact curves reach infinity; here all of the first one is there.
  CHECK_THROWS_WITH(surface_of(quadratic_cones({t, 0L, 0L, one},
                                               diagonal(one, one, -(one + t * t) * (one + t * t)))),
                    Catch::Contains("cone at 0 of the way"));
  CHECK(code({0L, 0L, t, one}, diagonal(one + t, one, poly({-5}))) == ErrorCode::kRegionUnbounded);
}

TEST_CASE("A high degree is refused", "[quadratic_cone_source]") {
  RandomConics random(51);
  CHECK(code_of([&] {
          surface_of(quadratic_cones(random_cone_matrix(random, {1, 1, 1}, 12)));
        }) == ErrorCode::kDegreeTooHigh);
}
