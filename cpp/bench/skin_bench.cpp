// SPDX-License-Identifier: LGPL-2.1-or-later
// Six spheres, or two curves of spheres, from the designer's numbers to certified poles.
#include <benchmark/benchmark.h>

#include "pn/algebra/parallel.hpp"
#include "pn/bezier/pn_surface.hpp"
#include "pn/bezier/rounded_solid.hpp"
#include "pn/bezier/skin.hpp"
#include "pn/bezier/translational_skin.hpp"
#include "pn/shapes/sphere_family.hpp"
#include "pn/shapes/translational_spheres.hpp"

namespace pn::bench {
namespace {

/// A bent plate of 100 mm and varying thickness.
constexpr std::array<std::array<double, 4>, 6> kPlate = {{{100, 0, 0, 3},
                                                          {55, 45, 6.5, 4},
                                                          {20, 90, 1, 3.25},
                                                          {50, 2, 5, 3.5},
                                                          {10, 45, 5.5, 3.75},
                                                          {0, 0, 0, 3}}};

template <class Skin, class Family>
std::array<PNSurface, 2> skins_of(const Family& family, const std::vector<std::string>& notes) {
  std::array<std::shared_ptr<const Skin>, 2> sheets;
  for_each_index(2, [&](std::size_t i) {
    sheets[i] = std::make_shared<const Skin>(family, i == 0 ? Sheet::kOuter : Sheet::kInner, notes);
  });
  return {PNSurface(sheets[0]), PNSurface(sheets[1])};
}

std::array<PNSurface, 2> skins() {
  const SphereFamily family = sphere_family(kPlate);
  return skins_of<Skin>(family.family, family.notes);
}

/// A plate of 100 by 80 mm, of 4 times 3 spans.
std::array<PNSurface, 2> translational_skins() {
  const SphereSpline
      along = SphereSpline::bspline({2,
                                     {0, 1, 2, 3, 4},
                                     {3, 1, 1, 1, 3},
                                     {{0, 0, 0, 2},
                                      {12.5, 0, 3, 2.5},
                                      {37.5, 0, 5, 2.25},
                                      {62.5, 0, 5.5, 2},
                                      {87.5, 0, 3, 1.75},
                                      {100, 0, 0, 1.5}},
                                     {}}),
      across = SphereSpline::bspline(
          {2,
           {0, 1, 2, 3},
           {3, 1, 1, 3},
           {{0, 0, 0, 1}, {0, 13, 4, 1.25}, {0, 40, 6, 1.5}, {0, 67, 4, 1.25}, {0, 80, 0, 1}},
           {}});
  const TranslationalSpheres spheres = translational_spheres(along, across);
  return skins_of<TranslationalSkin>(spheres.spline, spheres.notes);
}

/// Both skins with poles, edges and certificate.
void both_skins(benchmark::State& state) {
  for (auto _ : state) {
    for (const PNSurface& skin : skins()) benchmark::DoNotOptimize(skin.faces(Lines::kEven));
  }
}
BENCHMARK(both_skins)->UseRealTime()->Unit(benchmark::kMillisecond);

/// Both skins of two splines of spheres, of twelve faces each.
void both_translational_skins(benchmark::State& state) {
  for (auto _ : state) {
    for (const PNSurface& skin : translational_skins()) {
      benchmark::DoNotOptimize(skin.faces(Lines::kEven));
    }
  }
}
BENCHMARK(both_translational_skins)->UseRealTime()->Unit(benchmark::kMillisecond);

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
