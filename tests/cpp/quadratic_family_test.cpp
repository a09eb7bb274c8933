// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/isotropic/quadratic_family.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "pn/isotropic/sheet.hpp"
#include "random_sphere_families.hpp"

using namespace pn;
using namespace pn::test;
using Eigen::Matrix2d;
using Eigen::Vector4d;

namespace {

Rational part(long numerator, long denominator) {
  return Rational(numerator) / Rational(denominator);
}

Rational value(const TernaryForm<Rational>& form, const Rational& u, const Rational& v) {
  const Rational w = Rational(1L) - u - v;
  const auto power = [](const Rational& x, int n) {
    Rational result(1L);
    for (int i = 0; i < n; ++i) result *= x;
    return result;
  };
  Rational sum;
  for (int i = 0; i <= form.degree(); ++i) {
    for (int j = 0; i + j <= form.degree(); ++j) {
      sum += form(i, j) * power(u, i) * power(v, j) * power(w, form.degree() - i - j);
    }
  }
  return sum;
}

}  // namespace

TEST_CASE("The power form, derivatives and metric are those of de Casteljau's algorithm",
          "[quadratic_family]") {
  const QuadraticFamily family = family_of(RandomSphereFamily(5).spheres());
  const Rational u = part(2, 7), v = part(3, 11);
  const SphereJet sphere = test::jet(family, u, v);
  const auto a = family.power();
  const auto [fu, fv] = family.derivatives();
  const Rational half = part(1, 2);
  for (std::size_t c = 0; c < 4; ++c) {
    CHECK(a[0][c] * u * u * half + a[1][c] * u * v + a[2][c] * v * v * half + a[3][c] * u +
              a[4][c] * v + a[5][c] ==
          sphere.value[c]);
    CHECK(value(fu[c], u, v) == sphere.by_u[c]);
    CHECK(value(fv[c], u, v) == sphere.by_v[c]);
  }
  const FamilyMetric g = metric(family);
  const Rational g11 = minkowski(sphere.by_u, sphere.by_u),
                 g12 = minkowski(sphere.by_u, sphere.by_v),
                 g22 = minkowski(sphere.by_v, sphere.by_v);
  CHECK(value(g.g11, u, v) == g11);
  CHECK(value(g.g12, u, v) == g12);
  CHECK(value(g.g22, u, v) == g22);
  CHECK(value(g.determinant, u, v) == g11 * g22 - g12 * g12);
}

TEST_CASE("Quarters are the same family on their triangles", "[quadratic_family]") {
  const QuadraticFamily family = family_of(RandomSphereFamily(6).spheres());
  const auto quarters = family.quartered();
  const Rational u = part(1, 5), v = part(1, 3), half = part(1, 2);
  const std::array<std::array<Rational, 2>, 4> place = {{{half + u * half, v * half},
                                                         {u * half, half + v * half},
                                                         {u * half, v * half},
                                                         {half - u * half, half - v * half}}};
  // The middle triangle has its corners at (0, 1/2), (1/2, 0), (1/2, 1/2).
  for (std::size_t q = 0; q < 3; ++q) {
    CHECK(test::jet(quarters[q], u, v).value == test::jet(family, place[q][0], place[q][1]).value);
  }
  CHECK(test::jet(quarters[3], u, v).value ==
        test::jet(family, half - half * u, half - half * v).value);
}

TEST_CASE("A family without a real envelope somewhere is found out, with the place",
          "[quadratic_family]") {
  ControlSpheres spheres = RandomSphereFamily(2).spheres();
  CHECK_FALSE(unreal_place(family_of(spheres)));
  const double side = std::hypot(spheres[0][0] - spheres[5][0], spheres[0][1] - spheres[5][1],
                                 spheres[0][2] - spheres[5][2]);
  spheres[5][3] += side;  // the third corner swallows the rest
  const auto place = unreal_place(family_of(spheres));
  REQUIRE(place);
  const auto [u, v] = *place;
  const FamilyMetric g = metric(family_of(spheres));
  CHECK(value(g.determinant, Rational::exactly(u), Rational::exactly(v)).sign() <= 0);
}

TEST_CASE("The region with an envelope is found, and that without", "[quadratic_family]") {
  ControlSpheres spheres = RandomSphereFamily(2).spheres();
  const double side = std::hypot(spheres[0][0] - spheres[5][0], spheres[0][1] - spheres[5][1],
                                 spheres[0][2] - spheres[5][2]);
  spheres[5][3] += side;
  const QuadraticFamily family = family_of(spheres);
  const TernaryForm<Rational> delta = metric(family).determinant;
  const RealRegion region = real_region(family, 4);
  CHECK_FALSE(region.real.empty());
  CHECK_FALSE(region.unreal.empty());
  double area = 0;
  const auto check_parts = [&](const std::vector<FamilyPart>& parts, int sign) {
    for (const FamilyPart& part : parts) {
      const auto& [a, b, c] = part.corners;
      area += std::abs((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]));
      for (const auto& [u, v] : part.corners) {
        const Rational x = Rational::exactly(u), y = Rational::exactly(v);
        CHECK((sign == 0 || value(delta, x, y).sign() == sign));
      }
      CHECK(test::jet(part.family, 1L, 0L).value ==
            test::jet(family, Rational::exactly(a[0]), Rational::exactly(a[1])).value);
    }
  };
  check_parts(region.real, 1);
  check_parts(region.unreal, -1);
  check_parts(region.border, 0);
  CHECK(area == 1);
  CHECK(real_region(family_of(RandomSphereFamily(2).spheres()), 4).real.size() == 1);
}

TEST_CASE("Up to the regular radius no point of either sheet is singular, beyond the focal points",
          "[quadratic_family]") {
  for (std::uint64_t seed = 0; seed < 30; ++seed) {
    const ControlSpheres spheres = RandomSphereFamily(seed).spheres();
    const QuadraticFamily family = family_of(spheres);
    if (unreal_place(family)) continue;
    const double radius = regular_radius(family);
    CHECK(radius > 0);
    const FamilyInDoubles doubles(family);
    const auto a = family.power();
    double focal = INFINITY;
    for (const Sheet sheet : {Sheet::kOuter, Sheet::kInner}) {
      for (int i = 0; i <= 8; ++i) {
        for (int j = 0; i + j <= 8; ++j) {
          const double u = i / 8.0, v = j / 8.0;
          const Vector4d fu = doubles.by_u(u, v), fv = doubles.by_v(u, v);
          const auto product = [](const Vector4d& x, const Vector4d& y) {
            return x.head<3>().dot(y.head<3>()) - x(3) * y(3);
          };
          const Eigen::Vector3d n = doubles.normal(sheet, u, v);
          const auto bend = [&](std::size_t k) {
            return n.x() * a[k][0].to_double() + n.y() * a[k][1].to_double() +
                   n.z() * a[k][2].to_double() - a[k][3].to_double();
          };
          Matrix2d g, h;
          g << product(fu, fu), product(fu, fv), product(fv, fu), product(fv, fv);
          h << bend(0), bend(1), bend(1), bend(2);
          const Eigen::Vector2cd curvatures = (g.inverse() * h).eigenvalues();
          for (int k = 0; k < 2; ++k) focal = std::min(focal, 1 / std::abs(curvatures(k).real()));
        }
      }
    }
    CAPTURE(seed, radius, focal);
    CHECK(radius < focal);
    CHECK(radius > focal / 100);
  }
}
