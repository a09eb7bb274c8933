// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/minkowski/affine_class.hpp"

#include <catch2/catch.hpp>
#include <set>

#include "minkowski_cases.hpp"

using namespace pn;
using namespace pn::test;

namespace {

using Coordinates = std::vector<QuadraticCoordinate>;

Coordinates coordinates(const nlohmann::json& texts) {
  Coordinates result;
  for (const auto& text : texts) result.push_back(quadratic_coordinate(text));
  return result;
}

/// q(a u + b v + e, c u + d v + f), without its constant.
QuadraticCoordinate substituted(const QuadraticCoordinate& q, const std::array<Rational, 6>& map) {
  const auto& [a, b, c, d, e, f] = map;
  const auto& [uu, uv, vv, u, v] = q;
  const Rational two(2L);
  const Rational by_u = two * uu * e + uv * f + u, by_v = uv * e + two * vv * f + v;
  return {uu * a * a + uv * a * c + vv * c * c,
          two * uu * a * b + uv * (a * d + b * c) + two * vv * c * d,
          uu * b * b + uv * b * d + vv * d * d, by_u * a + by_v * c, by_u * b + by_v * d};
}

/// Other parameters, and as many coordinates more that are combinations of these.
Coordinates in_other_coordinates(const Coordinates& surface, RandomRationals& random) {
  const std::array<Rational, 6> map = {random() + Rational(40L), random(), random(),
                                       random() + Rational(40L), random(), random()};
  Coordinates result;
  for (std::size_t i = 0; i < 2 * surface.size(); ++i) {
    QuadraticCoordinate sum;
    for (const auto& q : surface) {
      const Rational weight = random();
      const auto part = substituted(q, map);
      for (std::size_t k = 0; k < 5; ++k) sum[k] += weight * part[k];
    }
    result.push_back(sum);
  }
  return result;
}

}  // namespace

TEST_CASE("The 42 normal forms are of 42 classes, in all coordinates", "[minkowski]") {
  RandomRationals random(22);
  std::set<std::string> classes;
  for (const auto& [name, texts] : minkowski_cases()["affine_classes"].items()) {
    INFO(name);
    const Coordinates form = coordinates(texts);
    CHECK(affine_class(form) == name);
    classes.insert(affine_class(form));
    for (int i = 0; i < 5; ++i) CHECK(affine_class(in_other_coordinates(form, random)) == name);
  }
  CHECK(classes.size() == 42);
}

TEST_CASE("Classes are real also where the squares are irrational", "[minkowski]") {
  const auto type = [](const std::vector<std::string>& texts) {
    return affine_class(coordinates(nlohmann::json(texts)));
  };
  // u^2 + 2 v^2 and u v span the squares of u + sqrt(2) v and u - sqrt(2) v.
  CHECK(type({"u**2 + 2*v**2", "u*v"}) == "2-2-1a");
  CHECK(type({"u**2 + 2*v**2", "u*v + u"}) == "2-2-1b");
  CHECK(type({"u**2 + 2*v**2", "u*v", "u"}) == "3-2-1a");
  CHECK(type({"u**2 + 2*v**2", "u*v", "u", "v"}) == "4-2-1");
  // The cubic u (u^2 - 2 v^2) has three real roots, u (u^2 + 2 v^2) one.
  CHECK(type({"u**2", "v**2 + u", "u*v + v"}) == "3-3-1c");
  CHECK(type({"u**2", "v**2 + u", "u*v - v"}) == "3-3-2b");
}

TEST_CASE("A family of spheres of the literature has the classes told there", "[minkowski]") {
  for (const auto& example : minkowski_cases()["families"]) {
    if (!example.contains("family_class")) continue;
    INFO(example["id"]);
    const Coordinates all = coordinates(example["family"]);
    CHECK(affine_class(all) == example["family_class"]);
    CHECK(affine_class({all[0], all[1], all[2]}) == example["centres_class"]);
    CHECK(affine_class({all[3]}) == example["radius_class"]);
  }
}
