// SPDX-License-Identifier: LGPL-2.1-or-later
// Both skins of six spheres, and the solid between them.
#include "pn/bezier/rounded_solid.hpp"
#include "pn/bezier/skin.hpp"
#include "pn/shapes/sphere_family.hpp"
#include "surface_or_error.hpp"

namespace {

using namespace pn;

// Small spheres over a plane triangle: near them there is an envelope.
constexpr std::array<std::array<double, 4>, 6> kPlane = {
    {{0, 0, 0, 1}, {8, 0, 0, 1}, {16, 0, 0, 1}, {0, 8, 0, 1}, {8, 8, 0, 1}, {0, 16, 0, 1}}};

std::shared_ptr<const SectionSource> source_of(const SphereFamily& spheres, int choice) {
  const auto& [family, notes] = spheres;
  if (choice == 2) return std::make_shared<const RoundedSolid>(family, notes);
  return std::make_shared<const Skin>(family, choice == 0 ? Sheet::kOuter : Sheet::kInner, notes);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzz::FuzzInput input(data, size);
  return fuzz::expect_result_or_error([&] {
    const int choice = input.choice(3);
    auto spheres = kPlane;
    for (auto& sphere : spheres) sphere = input.point_near(sphere);
    fuzz::check_surface(PNSurface(source_of(sphere_family(spheres), choice)), input);
  });
}
