// SPDX-License-Identifier: LGPL-2.1-or-later
// Families of conics, from their matrices to all their points, and surfaces to certified poles.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <memory>

#include "pn/bezier/conic_source.hpp"
#include "pn/bezier/pn_surface.hpp"
#include "pn/conics/rational_conic_family.hpp"

namespace pn::bench {
namespace {

RationalPolynomial polynomial(const std::vector<long>& ascending) {
  return RationalPolynomial(std::vector<Rational>(ascending.begin(), ascending.end()));
}

/// Without real zeros, of this even degree; different numbers give coprime polynomials.
RationalPolynomial positive(int degree, long number) {
  RationalPolynomial p(number);
  for (long i = 0; 2 * i < degree; ++i) {
    const long a = (3 * i + 2 * number) % 7 - 3, b = 1 + 4 * i + number;
    p *= polynomial({a * a + b, -2 * a, 1});
  }
  return p;
}

Matrix3<RationalPolynomial> diagonal(const RationalPolynomial& l, const RationalPolynomial& m,
                                     const RationalPolynomial& n) {
  const RationalPolynomial zero;
  return {{{l, zero, zero}, {zero, m, zero}, {zero, zero, n}}};
}

/// L x^2 + M y^2 = N z^2 to points at 128 bits; L, M, N of the degrees 2 l, 2 m, 2 n, without
/// common zeros. The ansatz for one point has the degrees m + n, l + n, l + m, and the
/// stereographic projection from it adds the largest degree of the matrix.
void points_of_conics(benchmark::State& state) {
  const auto l = static_cast<int>(state.range(0)), m = static_cast<int>(state.range(1)),
             n = static_cast<int>(state.range(2));
  const auto matrix = diagonal(positive(2 * l, 1), positive(2 * m, 2), -positive(2 * n, 3));
  for (auto _ : state) {
    const RationalConicFamily conics(conic_family(matrix));
    benchmark::DoNotOptimize(conics.points(128));
    state.counters["degree"] = conics.degree();
    state.counters["bound"] = conics.least_degree();
  }
  const int ansatz = std::max({m + n, l + n, l + m});
  state.counters["projected"] = ansatz + 2 * std::max({l, m, n});
}
BENCHMARK(points_of_conics)
    ->ArgNames({"l", "m", "n"})
    ->Args({2, 2, 2})
    ->Args({6, 6, 6})
    ->Args({2, 1, 2})
    ->Args({1, 2, 3})
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);

/// Upright ellipses with squared half-axes of degree 2: a matrix of degree 4.
void conic_surface(benchmark::State& state) {
  const RationalPolynomial aa = polynomial({2, 1, 3}), bb = polynomial({5, -2, 1}), zero;
  MovingConic conic;
  conic.frame = {
      {{zero, 1L, zero}, {zero, zero, 1L}, {polynomial({0, 10}), zero, zero}, {1L, zero, zero}}};
  conic.conic = diagonal(-(aa * bb), bb, aa);
  for (auto _ : state) {
    const std::vector<ConicSpan> spans = {{conic, {}}};
    const PNSurface surface(std::make_shared<const ConicSource>(spans));
    benchmark::DoNotOptimize(surface.certificate(Lines::kEven));
    state.counters["degree"] = surface.degree()[0];
  }
}
BENCHMARK(conic_surface)->UseRealTime()->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace pn::bench
