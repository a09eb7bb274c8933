// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/isotropic/envelope_chain.hpp"

#include <catch2/catch.hpp>

#include "circle_families.hpp"

using namespace pn;
using pn::test::polynomial;

TEST_CASE("A link stands still when its spheres do", "[envelope_chain]") {
  const SphereCurve line{{polynomial({0, 1}), 0L, 0L}, 1L, 1L}, sphere{{1L, 0L, 0L}, 1L, 1L};
  const CircleFamily across{{1L, 0L, 0L}, 0L}, turning{{1L, polynomial({0, 1}), 0L}, 0L};
  EnvelopeChain chain;
  chain.links.push_back(
      {AlongCurve(line, across), tangent_direction(line).content, 0, 1, Joint::kNone});
  chain.links.push_back(
      {AlongCurve(sphere, turning), tangent_direction(sphere).content, 1, 1, Joint::kTangent});
  CHECK_FALSE(chain.links[0].stands_still());
  CHECK(chain.links[1].stands_still());
  CHECK_FALSE(chain.closed);
  CHECK(chain.notes.empty());
}
