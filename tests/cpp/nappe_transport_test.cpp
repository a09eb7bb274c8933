// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/conics/nappe_transport.hpp"

#include <algorithm>
#include <catch2/catch.hpp>

#include "conic_families.hpp"

using namespace pn;
using namespace pn::test;

namespace {

/// The parity after the steps at infinity; det C has no real zeros, and no real lines at infinity.
int parity(const ConicFamily& family) {
  const SingularConics singular = singular_conics(family);
  const auto first = [](const RationalLattice&, const RationalLattice&) { return 0; };
  const RationalSteps steps =
      rational_steps(family, {{}, singular.at_infinity}, first, Leave::kOddIrrational);
  return parity_of_splitting(steps.lattice, least_degree(family, singular));
}

/// At infinity the two terms of larger degrees are left; their lines are real if the signs differ.
bool has_real_lines_at_infinity(int l, int m, int n) {
  return n > std::min(l, m) && l != m && std::max(l, m) > std::min({l, m, n});
}

/// The cone of the angle to an axis, by the squared cosine.
ConicFamily cone_around(const Vector3<RationalPolynomial>& axis, const Rational& cosine_squared) {
  RationalPolynomial norm;
  for (const RationalPolynomial& x : axis) norm += x * x;
  Conic c;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) c[i][j] = -axis[i] * axis[j];
    c[i][i] += RationalPolynomial(cosine_squared) * norm;
  }
  return conic_family(c);
}

/// Of cones around a polynomial axis of degree d that nowhere vanishes: that of d + m.
int parity_of_axis(const ConicFamily& family, int d) {
  return (d + least_degree(family, singular_conics(family))) % 2;
}

}  // namespace

TEST_CASE("L x^2 + M y^2 - N z^2 of degrees 2l, 2m, 2n has parity l + m", "[nappe_transport]") {
  RandomConics random(3);
  int odd = 0;
  for (int l = 0; l <= 3; ++l) {
    for (int m = 0; m <= 3; ++m) {
      for (int n = 0; n <= 3; ++n) {
        if (has_real_lines_at_infinity(l, m, n)) continue;
        INFO(l << ", " << m << ", " << n);
        const Conic c = diagonal(random.positive(l), random.positive(m), -random.positive(n));
        CHECK(parity(conic_family(c)) == (l + m) % 2);
        odd += (l + m) % 2;
      }
    }
  }
  CHECK(odd > 0);
}

TEST_CASE("A double cone that turns half around with t returns as its other nappe",
          "[nappe_transport]") {
  // The axis is (1 - t^2, 2 t, 0), the half angle of which runs once around; and (1, t, 0).
  const RationalPolynomial zero, one(1L), t = conic_polynomial({0, 1});
  const Rational half = Rational(1L) / Rational(2L);
  const ConicFamily once = cone_around({one - t * t, t * 2L, zero}, half);
  CHECK(parity(cone_around({one, t, zero}, half)) != parity(once));
}

TEST_CASE("A thin cone around an axis of degree d has parity d + m", "[nappe_transport]") {
  const Rational cosine_squared = Rational(1L) - Rational(1L) / Rational(1000000000000L);
  RandomConics random(5);
  for (int i = 0; i < 60; ++i) {
    const int d = 1 + i % 6;
    Vector3<RationalPolynomial> axis;
    for (RationalPolynomial& x : axis) x = random.any(d) + power_of_t(d) * 10L;
    axis[0] *= 1000L;
    INFO(i);
    const ConicFamily family = cone_around(axis, cosine_squared);
    CHECK(parity(family) == parity_of_axis(family, d));
  }
}

TEST_CASE("The parity of cones that touch a coordinate axis or plane at infinity",
          "[nappe_transport]") {
  const Rational half = Rational(1L) / Rational(2L);
  RandomConics random(6);
  for (int i = 0; i < 60; ++i) {
    const int d = 1 + i % 6;
    Vector3<RationalPolynomial> axis;
    for (RationalPolynomial& x : axis) x = random.any(d - 1);
    const std::size_t x = random.below(2) == 0 ? 0 : 2;
    axis[x] += power_of_t(d);
    axis[1] += power_of_t(d);
    INFO(i);
    const ConicFamily family = cone_around(axis, half);
    CHECK(parity(family) == parity_of_axis(family, d));
  }
}
