// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/bezier/skin_patch.hpp"

#include <catch2/catch.hpp>

using namespace pn;

TEST_CASE("The edges run around the triangle", "[skin_patch]") {
  for (std::size_t k = 0; k < 3; ++k) CHECK(on_edge(k, 1) == on_edge((k + 1) % 3, 0));
  CHECK(on_edge(0, 0.25) == std::array{0.25, 0.0});
  CHECK(on_edge(1, 0.25) == std::array{0.75, 0.25});
  CHECK(on_edge(2, 0.25) == std::array{0.0, 0.75});
}

TEST_CASE("A box holds its points with a margin on all sides", "[skin_patch]") {
  const ImageBox box = box_around({{0, 1}, {2, 5}, {1, 3}});
  CHECK((box.low[0] < 0 && box.low[1] < 1 && box.high[0] > 2 && box.high[1] > 5));
  CHECK(box.high[0] - box.low[0] < 2.2);
}

TEST_CASE("The boundary has the inside on its left in both orientations", "[skin_patch]") {
  SkinPatch patch{{1, 1}, {}, {}, Sheet::kOuter, 1};
  patch.place_of = [](const std::array<double, 2>& uv) { return uv; };
  CHECK(boundary(patch)[0](0.25) == std::array{0.25, 0.0});
  patch.sheet = Sheet::kInner;
  patch.place_of = [](const std::array<double, 2>& uv) { return std::array{uv[1], uv[0]}; };
  const auto mirrored = boundary(patch);
  double area = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const auto a = mirrored[k](0), b = mirrored[k](1);
    CHECK(b == mirrored[(k + 1) % 3](0));
    area += (a[0] * b[1] - a[1] * b[0]) / 2;
  }
  CHECK(area == 0.5);
}
