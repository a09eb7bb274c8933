// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/isotropic/envelope_chain.hpp"

#include <catch2/catch.hpp>

#include "circle_families.hpp"
#include "pn/isotropic/along_curve.hpp"

using namespace pn;
using pn::test::polynomial;

TEST_CASE("A link stands still when its spheres do", "[envelope_chain]") {
  const SphereCurve line{{polynomial({0, 1}), 0L, 0L}, 1L, 1L}, sphere{{1L, 0L, 0L}, 1L, 1L};
  const CircleFamily across{{1L, 0L, 0L}, 0L}, turning{{1L, polynomial({0, 1}), 0L}, 0L};
  EnvelopeChain chain;
  const auto link = [](const SphereCurve& curve, const CircleFamily& circles) {
    return ChainLink{along_curve(curve, circles),
                     CurveOfSpheres{curve, circles, tangent_direction(curve).content}, 0, 1,
                     Joint::kNone};
  };
  chain.links = {link(line, across), link(sphere, turning)};
  CHECK_FALSE(chain.links[0].stands_still());
  CHECK(chain.links[1].stands_still());
  ChainLink without_spheres = chain.links[1];
  without_spheres.spheres.reset();
  CHECK_FALSE(without_spheres.stands_still());
  CHECK_FALSE(chain.closed);
  CHECK(std::holds_alternative<WholeCircle>(chain.extent));
  CHECK(chain.notes.empty());
}
