// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/algebra/directed_edges.hpp"

#include <catch2/catch.hpp>

using namespace pn;

TEST_CASE("Neighbours run their common edge in opposite directions", "[directed_edges]") {
  // A square of two triangles around the diagonal from 0 to 2.
  const DirectedEdges edges({{0, 1, 2}, {0, 2, 3}});
  const auto found = edges.opposite({0, 2});
  REQUIRE(found);
  CHECK(found->triangle == 1);
  CHECK(found->edge == 0);
  const auto back = edges.opposite(*found);
  REQUIRE(back);
  CHECK(back->triangle == 0);
  CHECK(back->edge == 2);
}

TEST_CASE("An edge of the border has no neighbour", "[directed_edges]") {
  const DirectedEdges edges({{0, 1, 2}, {0, 2, 3}});
  CHECK_FALSE(edges.opposite({0, 0}));
  CHECK_FALSE(edges.opposite({0, 1}));
  CHECK_FALSE(edges.opposite({1, 1}));
  CHECK_FALSE(edges.opposite({1, 2}));
}
