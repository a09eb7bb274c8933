// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/bezier/projective_change.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "enclosures.hpp"

using namespace pn;
using namespace pn::test;

namespace {

constexpr long kBits = 128;

TensorPolynomial<RealBall> polynomial(int m, int n, double seed) {
  TensorPolynomial<RealBall> p(m, n);
  for (int i = 0; i <= m; ++i) {
    for (int j = 0; j <= n; ++j)
      p(i, j) = RealBall(4 + std::sin(seed + 3 * i + 5 * j)).at_precision(kBits);
  }
  return p;
}

SurfaceSections<RealBall> patch() {
  return {{polynomial(3, 2, 1), polynomial(3, 2, 2), polynomial(3, 2, 3)},
          {polynomial(2, 2, 4), polynomial(2, 2, 5), polynomial(2, 2, 6)},
          polynomial(2, 1, 7)};
}

}  // namespace

TEST_CASE("The point of (t, s) is that of its place", "[projective_change]") {
  const ProjectiveChange change{0.25, 3};
  const SurfaceSections<RealBall> x = patch(), y = change.applied(x, {3, 2}, kBits);
  for (const auto& [t, s] : {std::array{0.0, 1.0}, {0.3, 0.6}, {1.0, 0.25}}) {
    const auto [tau, sigma] = change.place({t, s});
    for (std::size_t c = 0; c < 3; ++c) {
      const double expected =
          (x.point[c].at(RealBall(t), RealBall(s)) / x.weight.at(RealBall(t), RealBall(s)))
              .midpoint();
      const double found = (y.point[c].at(RealBall(tau), RealBall(sigma)) /
                            y.weight.at(RealBall(tau), RealBall(sigma)))
                               .midpoint();
      CHECK(found == Approx(expected).epsilon(1e-14));
    }
  }
}

TEST_CASE("Poles stay and weights are multiplied by powers", "[projective_change]") {
  const ProjectiveChange change{0.25, 3};
  const int m = 3, n = 2;
  const SurfaceSections<RealBall> x = patch(), y = change.applied(x, {m, n}, kBits);
  const auto coefficients = [&](TensorPolynomial<RealBall> p) {
    return to_bernstein(std::move(p += TensorPolynomial<RealBall>(m, n)));
  };
  const auto before = coefficients(x.weight), after = coefficients(y.weight);
  const auto point = coefficients(x.point[1]), moved = coefficients(y.point[1]);
  for (int i = 0; i <= m; ++i) {
    for (int j = 0; j <= n; ++j) {
      const auto k = static_cast<std::size_t>(i * (n + 1) + j);
      const double factor = std::pow(0.25, m - i) * std::pow(3, n - j);
      CHECK(encloses_zero(after[k] - before[k] * RealBall(factor), 1e-20));
      CHECK(encloses_zero(moved[k] / after[k] - point[k] / before[k], 1e-20));
    }
  }
}

TEST_CASE("Weights that are powers become even", "[projective_change]") {
  // (1 + t)^4 (3 - 2 s)^2 has the Bernstein coefficients 2^i 3^(2 - j).
  TensorPolynomial<RealBall> rising(1, 0), falling(0, 1), weight = rising;
  rising(0, 0) = rising(1, 0) = RealBall(1);
  falling(0, 0) = RealBall(3);
  falling(0, 1) = RealBall(-2);
  weight = rising * rising * rising * rising * falling * falling;
  const ProjectiveChange change = ProjectiveChange::evening(weight);
  CHECK(change.mu == Approx(2).epsilon(1e-6));
  CHECK(change.nu == Approx(1.0 / 3).epsilon(1e-6));
  const auto even = change.applied({{}, {}, weight}, {4, 2}, kBits).weight;
  for (const RealBall& w : to_bernstein(even)) CHECK(w.midpoint() == Approx(16).epsilon(1e-5));
}
