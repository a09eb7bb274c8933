// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/isotropic/separated_sheets.hpp"

#include <catch2/catch.hpp>

#include "special_sphere_families.hpp"

using namespace pn;
using namespace pn::test;

namespace {

using Vector = std::array<Rational, 3>;

Rational dot(const Vector& x, const Vector& y) { return x[0] * y[0] + x[1] * y[1] + x[2] * y[2]; }

/// At a point: n = (a + sqrt(c) b) / weight.
struct NormalAt {
  Vector a, b;
  Rational weight;

  NormalAt(const RationalNormal& n, const Rational& u, const Rational& v)
      : weight(n.weight.at(u, v)) {
    for (std::size_t i = 0; i < 3; ++i) {
      a[i] = n.rational[i].at(u, v);
      b[i] = n.irrational[i].at(u, v);
    }
  }
};

/// n.n = 1 and n.x = p for a vector (x, p), in both parts of Q(sqrt(c)).
void check_unit(const NormalAt& n, const Rational& radicand) {
  CHECK(dot(n.a, n.a) + radicand * dot(n.b, n.b) == n.weight * n.weight);
  CHECK(dot(n.a, n.b).is_zero());
}
void check_product(const NormalAt& n, const MinkowskiVector<Rational>& x) {
  const Vector m = {x[0], x[1], x[2]};
  CHECK(dot(n.a, m) == x[3] * n.weight);
  CHECK(dot(n.b, m).is_zero());
}

bool is_constant(const TensorPolynomial<Rational>& p) {
  return p.degree(Variable::kU) == 0 && p.degree(Variable::kV) == 0;
}

}  // namespace

TEST_CASE("Separated sheets have the normals of their spheres, exactly", "[separated_sheets]") {
  for (const auto& [name, spheres] : separated_spheres()) {
    INFO(name);
    const QuadraticFamily family = family_of(spheres);
    const FamilyInDoubles doubles(family);
    for (const Sheet sheet : {Sheet::kOuter, Sheet::kInner}) {
      const auto normal = rational_normal(family, sheet);
      REQUIRE(normal);
      for (const auto& [u, v] : {std::array{Rational(0L), Rational(0L)},
                                 {Rational(1L) / Rational(3L), Rational(1L) / Rational(5L)},
                                 {Rational(2L) / Rational(7L), Rational(3L) / Rational(7L)}}) {
        const NormalAt n(*normal, u, v);
        CHECK(n.weight.sign() > 0);
        check_unit(n, normal->radicand);
        const SphereJet f = jet(family, u, v);
        check_product(n, f.by_u);
        check_product(n, f.by_v);
        const double root = std::sqrt(normal->radicand.to_double());
        const Eigen::Vector3d expected = doubles.normal(sheet, u.to_double(), v.to_double());
        for (std::size_t i = 0; i < 3; ++i) {
          CHECK((n.a[i].to_double() + root * n.b[i].to_double()) / n.weight.to_double() ==
                Approx(expected(static_cast<Eigen::Index>(i))).margin(1e-12));
        }
      }
    }
  }
}

TEST_CASE("Planes have one normal, over a field with one root", "[separated_sheets]") {
  const auto all = separated_spheres();
  const auto flat = [&](std::size_t i, Sheet sheet) {
    return is_constant(rational_normal(family_of(all[i].spheres), sheet)->weight);
  };
  for (const std::size_t i : {0, 1, 2}) {
    CHECK(flat(i, Sheet::kOuter));
    CHECK(flat(i, Sheet::kInner));
  }
  // r = 4 + x / 4: the normals are (-1/4, 0, +-sqrt(15)/4).
  const auto normal = rational_normal(family_of(all[1].spheres), Sheet::kOuter);
  CHECK_FALSE(square_root(normal->radicand));
  CHECK(square_root(normal->radicand / Rational(15L)));
  // z + r = 16 and r - z = 16: the planes z = 16 and z = -16.
  CHECK(flat(3, Sheet::kInner));
  CHECK_FALSE(flat(3, Sheet::kOuter));
  CHECK(flat(4, Sheet::kOuter));
  CHECK_FALSE(flat(4, Sheet::kInner));
}

TEST_CASE("The spheres through a line have the line for one sheet", "[separated_sheets]") {
  // They touch it where their centres are nearest to it: x = (0, 0, z).
  const QuadraticFamily family = family_of(separated_spheres().back().spheres);
  const auto x = sections(family, *rational_normal(family, Sheet::kInner), 128);
  const auto y = sections(family, *rational_normal(family, Sheet::kOuter), 128);
  const RealBall u(0.25), v(0.5);
  const auto is_on_line = [&](const SurfaceSections<RealBall>& s) {
    return s.point[0].at(u, v).contains_zero() && s.point[1].at(u, v).contains_zero();
  };
  CHECK(is_on_line(x) != is_on_line(y));
}

TEST_CASE("Sheets of other families are not separated", "[separated_sheets]") {
  for (std::uint64_t seed = 0; seed < 8; ++seed) {
    const QuadraticFamily family = family_of(RandomSphereFamily(seed).spheres());
    CHECK_FALSE(rational_normal(family, Sheet::kOuter));
  }
  for (const auto& [name, spheres] : developable_spheres()) {
    INFO(name);
    CHECK_FALSE(rational_normal(family_of(spheres), Sheet::kInner));
  }
}
