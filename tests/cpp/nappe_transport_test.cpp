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
  const auto cone = [](const RationalPolynomial& x, const RationalPolynomial& y) {
    const RationalPolynomial zero, norm = x * x + y * y, two(2L);
    return conic_family({{{norm - two * x * x, -two * x * y, zero},
                          {-two * x * y, norm - two * y * y, zero},
                          {zero, zero, norm}}});
  };
  const ConicFamily half = cone(1L, conic_polynomial({0, 1}));
  const ConicFamily whole = cone(conic_polynomial({1, 0, -1}), conic_polynomial({0, 2}));
  CHECK(parity(half) != parity(whole));
}

TEST_CASE("A thin cone around a polynomial axis of degree d has parity d + m",
          "[nappe_transport]") {
  // cos^2 of half the opening angle is 1 - 1e-12, and the axis is 1000 times longer sidewards.
  const RationalPolynomial cosine_squared(Rational(1L) - Rational(1L) / Rational(1000000000000L));
  RandomConics random(5);
  int parities[] = {0, 0};
  for (int i = 0; i < 60; ++i) {
    const int d = 1 + i % 6;
    Vector3<RationalPolynomial> axis;
    for (RationalPolynomial& x : axis) x = random.any(d) + power_of_t(d) * 10L;
    axis[0] *= 1000L;
    RationalPolynomial norm;
    for (const RationalPolynomial& x : axis) norm += x * x;
    Conic c;
    for (std::size_t j = 0; j < 3; ++j) {
      for (std::size_t k = 0; k < 3; ++k) c[j][k] = -axis[j] * axis[k];
      c[j][j] += cosine_squared * norm;
    }
    INFO(i);
    const ConicFamily family = conic_family(c);
    const int m = least_degree(family, singular_conics(family));
    CHECK(parity(family) == (d + m) % 2);
    ++parities[(d + m) % 2];
  }
  CHECK(std::min(parities[0], parities[1]) > 0);
}
