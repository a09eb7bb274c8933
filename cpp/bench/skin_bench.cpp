// SPDX-License-Identifier: LGPL-2.1-or-later
// Six spheres, from the designer's numbers to certified poles.
#include <benchmark/benchmark.h>

#include "pn/algebra/parallel.hpp"
#include "pn/bezier/pn_surface.hpp"
#include "pn/bezier/rounded_solid.hpp"
#include "pn/bezier/skin.hpp"
#include "pn/shapes/sphere_family.hpp"

namespace pn::bench {
namespace {

/// A bent plate of 100 mm and varying thickness.
constexpr std::array<std::array<double, 4>, 6> kPlate = {{{100, 0, 0, 3},
                                                          {55, 45, 6.5, 4},
                                                          {20, 90, 1, 3.25},
                                                          {50, 2, 5, 3.5},
                                                          {10, 45, 5.5, 3.75},
                                                          {0, 0, 0, 3}}};

std::array<PNSurface, 2> skins() {
  const SphereFamily family = sphere_family(kPlate);
  std::array<std::shared_ptr<const Skin>, 2> sheets;
  for_each_index(2, [&](std::size_t i) {
    sheets[i] = std::make_shared<const Skin>(family.family, i == 0 ? Sheet::kOuter : Sheet::kInner,
                                             family.notes);
  });
  return {PNSurface(sheets[0]), PNSurface(sheets[1])};
}

/// Both skins with poles, edges and certificate.
void both_skins(benchmark::State& state) {
  for (auto _ : state) {
    for (const PNSurface& skin : skins()) benchmark::DoNotOptimize(skin.faces(Lines::kEven));
  }
}
BENCHMARK(both_skins)->UseRealTime()->Unit(benchmark::kMillisecond);

/// Both skins at another distance.
void another_offset(benchmark::State& state) {
  const auto both = skins();
  for (const PNSurface& skin : both) benchmark::DoNotOptimize(skin.faces(Lines::kEven));
  double distance = 0;
  for (auto _ : state) {
    distance += 1e-3;
    for (const PNSurface& skin : both) {
      benchmark::DoNotOptimize(skin.offset(distance).faces(Lines::kEven));
    }
  }
}
BENCHMARK(another_offset)->UseRealTime()->Unit(benchmark::kMillisecond);

/// The faces of the closed solid.
void closed_solid(benchmark::State& state) {
  for (auto _ : state) {
    const SphereFamily family = sphere_family(kPlate);
    const PNSurface solid(std::make_shared<const RoundedSolid>(family.family, family.notes));
    benchmark::DoNotOptimize(solid.faces(Lines::kEven));
  }
}
BENCHMARK(closed_solid)->UseRealTime()->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace pn::bench
