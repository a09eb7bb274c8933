// SPDX-License-Identifier: LGPL-2.1-or-later
// Both skins of a family of each of the thirteen types of nets.
#include <benchmark/benchmark.h>

#include <array>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

#include "pn/bezier/pn_surface.hpp"
#include "pn/bezier/skin.hpp"
#include "pn/shapes/sphere_family.hpp"

namespace pn::bench {
namespace {

using Spheres = std::array<std::array<double, 4>, 6>;

/// From six spheres to poles, edges and certificate.
void skins_of_net(benchmark::State& state, const Spheres& spheres) {
  std::size_t poles = 0;
  std::array<int, 2> degree = {};
  for (auto _ : state) {
    const SphereFamily family = sphere_family(spheres);
    poles = 0;
    for (const Sheet sheet : {Sheet::kOuter, Sheet::kInner}) {
      const PNSurface skin(std::make_shared<const Skin>(family.family, sheet, family.notes));
      for (const auto& face : skin.faces(Lines::kEven)) poles += face.poles.size();
      degree = skin.degree();
    }
  }
  state.counters["poles"] = static_cast<double>(poles);
  state.counters["degree_u"] = degree[0];
  state.counters["degree_v"] = degree[1];
}

bool register_all() {
  const auto cases = nlohmann::json::parse(std::ifstream(PN_TEST_DATA "/minkowski_space.json"));
  std::size_t count = 0;
  for (const auto& [net, spheres] : cases["plates"].items()) {
    const std::string name = "net_type/" + std::to_string(count++);
    benchmark::RegisterBenchmark(
        name.c_str(),
        [net = net, spheres = spheres.get<Spheres>()](benchmark::State& state) {
          state.SetLabel(net);
          skins_of_net(state, spheres);
        })
        ->UseRealTime()
        ->Unit(benchmark::kMillisecond);
  }
  return true;
}

const bool kRegistered = register_all();

}  // namespace
}  // namespace pn::bench
