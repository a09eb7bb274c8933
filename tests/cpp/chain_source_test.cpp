// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/bezier/chain_source.hpp"

#include <catch2/catch.hpp>

#include "pn/bezier/chain_net.hpp"
#include "pn/bezier/trimming.hpp"
#include "pn/shapes/ruled_surface.hpp"

using namespace pn;

TEST_CASE("A source has the net, the edges and the limits of its chain", "[chain_source]") {
  const EnvelopeChain chain =
      ruled_surface(Curve::bezier({{0, 0, 0}, {1, 0.5, 0}, {2, 0, 0}}),
                    Curve::bezier({{0, 0, 1}, {1, -0.5, 1.25}, {2, 0.25, 1}}));
  std::optional<TrimmableNet> trimmable;
  OffsetRange range;
  {
    const ChainSource source(chain);
    CHECK(source.is_exact() == chain.exact);
    CHECK(source.notes() == chain.notes);
    CHECK(source.degree()[0] == chain.links[0].envelope.degree());
    range = source.regular_range();
    trimmable = source.net(Lines::kEven, 128);
  }
  // Nets outlive their source.
  const ChainNet net(chain, Lines::kEven, 128);
  CHECK(trimmable->net->section(0.1)[0].surface.poles == net.section(0.1)[0].surface.poles);
  const auto edges = trimmable->trimmed_faces(), expected = trimmed_faces(chain, net);
  REQUIRE(edges.size() == expected.size());
  CHECK(curves_of(edges[0])[0][0].poles == curves_of(expected[0])[0][0].poles);
  const OffsetRange direct = regular_range(chain, default_tolerance(chain));
  CHECK(range.lower == direct.lower);
  CHECK(range.upper == direct.upper);
}
