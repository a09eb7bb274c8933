// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/isotropic/family_type.hpp"

#include <catch2/catch.hpp>
#include <set>

#include "minkowski_cases.hpp"

using namespace pn;
using namespace pn::test;

TEST_CASE("The families of nets in the literature are of the types told there", "[minkowski]") {
  std::set<std::string> nets;
  RandomRationals random(24);
  for (const auto& example : minkowski_cases()["families"]) {
    if (!example.contains("net")) continue;
    INFO(example["id"]);
    const QuadraticFamily family = quadratic_family(example["family"]);
    const FamilyType type = family_type(family);
    CHECK(type.family == example["family_class"]);
    CHECK(type.centres == example["centres_class"]);
    CHECK(type.radius == example["radius_class"]);
    REQUIRE(type.net);
    CHECK(name(*type.net) == example["net"]);
    nets.insert(name(*type.net));

    // Laguerre transformations keep both.
    const FamilyType image =
        family_type(QuadraticFamily(random_laguerre_map(random)(family.control())));
    CHECK(image.family == type.family);
    REQUIRE(image.net);
    CHECK(name(*image.net) == name(*type.net));
  }
  CHECK(nets.size() == 12);

  // The thirteenth. The axes join (1, i, 0, 0) with (0, 5, 4i, -3), two points of Omega, and
  // their conjugates; the family solves x1 + i x2 = -z^2, 5 x2 + 4i x3 + 3 x4 = 2 z, z = u + i v.
  const QuadraticFamily secant =
      quadratic_family(nlohmann::json{"v**2 - u**2", "-2*u*v", "v/2", "(2*u + 10*u*v)/3"});
  const FamilyType type = family_type(secant);
  CHECK(type.family == "4-2-3");
  REQUIRE(type.net);
  CHECK(name(*type.net) == "elliptic S/S");
}

TEST_CASE("The normal lines of a family lie in its net, and six general spheres have none",
          "[minkowski]") {
  RandomRationals random(25);
  for (const auto& example : minkowski_cases()["families"]) {
    const auto net = normal_net(quadratic_family(example["family"]));
    INFO(example["id"]);
    const LineCoordinates<Rational> line = values<6>(
        example["normal_lines"], std::map<std::string, Rational>{{"u", random()}, {"v", random()}});
    if (net) {
      CHECK(klein(net->a, line).is_zero());
      CHECK(klein(net->b, line).is_zero());
    } else {
      CHECK_FALSE(example.contains("net"));
    }
  }
  QuadraticFamily::Control control;
  for (auto& b : control) b = random.vector();
  CHECK_FALSE(normal_net(QuadraticFamily(control)));
}

TEST_CASE("The tangent plane is space-like where Delta is positive", "[minkowski]") {
  RandomRationals random(26);
  std::set<CausalType> seen;
  for (const auto& example : minkowski_cases()["families"]) {
    const QuadraticFamily family = quadratic_family(example["family"]);
    const std::map<std::string, Rational> at = {{"u", random()}, {"v", random()}};
    const CausalType type = tangent_plane_type(family, at.at("u"), at.at("v"));
    const LineCoordinates<Rational> line = values<6>(example["tangent_lines"], at);
    CHECK(type == causal_type(line));
    seen.insert(type);
  }
  CHECK(seen.size() >= 2);
}
