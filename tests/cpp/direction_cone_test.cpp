// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/bezier/direction_cone.hpp"

#include <catch2/catch.hpp>
#include <random>

using namespace pn;
using Eigen::Vector3d;

namespace {

class Directions {
 public:
  Vector3d direction() {
    return Vector3d(normal_(generator_), normal_(generator_), normal_(generator_)).normalized();
  }
  DirectionCone cone(double widest) { return {direction(), widest * uniform_(generator_)}; }
  /// In the cone, as often on its edge as not.
  Vector3d in(const DirectionCone& cone) {
    const double part = uniform_(generator_) < 0.5 ? 1 : uniform_(generator_);
    const Vector3d aside = cone.axis.cross(direction()).normalized();
    return Eigen::AngleAxisd(part * cone.half_angle, aside) * cone.axis;
  }

 private:
  std::mt19937 generator_{7};
  std::normal_distribution<double> normal_;
  std::uniform_real_distribution<double> uniform_{0, 1};
};

}  // namespace

TEST_CASE("Angles keep their digits where they are small", "[direction_cone]") {
  const Vector3d x(1, 0, 0);
  for (const double angle : {1e-14, 1e-7, 0.3, 2.9}) {
    const Vector3d y(std::cos(angle), std::sin(angle), 0);
    CHECK(angle_between(x, y) == Approx(angle).epsilon(1e-12));
    CHECK(unoriented_angle(x, -y) == Approx(std::min(angle, M_PI - angle)).epsilon(1e-12));
  }
}

TEST_CASE("The joined cone contains both", "[direction_cone]") {
  Directions random;
  for (int round = 0; round < 200; ++round) {
    const DirectionCone a = random.cone(1), b = random.cone(1), both = joined(a, b);
    for (const DirectionCone& cone : {a, b}) {
      for (int i = 0; i < 10; ++i) {
        CHECK(angle_between(random.in(cone), both.axis) <= both.half_angle + 1e-12);
      }
    }
  }
  CHECK(joined({{1, 0, 0}, 0.1}, {{-1, 0, 0}, 0.1}).half_angle == M_PI);
}

TEST_CASE("Independent cones have no parallel directions, and others have", "[direction_cone]") {
  Directions random;
  int independent = 0;
  for (int round = 0; round < 400; ++round) {
    const DirectionCone a = random.cone(1), b = random.cone(1);
    double least = M_PI;
    for (int i = 0; i < 50; ++i) {
      least = std::min(least, unoriented_angle(random.in(a), random.in(b)));
    }
    if (are_independent(a, b)) {
      ++independent;
      CHECK(least > 0);
    }
  }
  CHECK(independent > 50);
  CHECK(are_independent({{1, 0, 0}, 0.7}, {{0, 1, 0}, 0.8}));
  CHECK_FALSE(are_independent({{1, 0, 0}, 0.8}, {{0, 1, 0}, 0.8}));
  CHECK_FALSE(are_independent({{1, 0, 0}, 0.3}, {{-1, 0.2, 0}, 0.3}));
  CHECK_FALSE(are_independent({{1, 0, 0}, 1.6}, {{0, 1, 0}, -0.1}));
}

TEST_CASE("The cone of cross products contains them", "[direction_cone]") {
  Directions random;
  int found = 0;
  for (int round = 0; round < 400; ++round) {
    const DirectionCone a = random.cone(0.5), b = random.cone(0.5);
    const auto cone = cross_cone(a, b);
    if (!cone) continue;
    ++found;
    CHECK(are_independent(a, b));
    for (int i = 0; i < 50; ++i) {
      const Vector3d normal = random.in(a).cross(random.in(b));
      CHECK(angle_between(normal, cone->axis) <= cone->half_angle + 1e-12);
    }
  }
  CHECK(found > 50);
  // It is no larger than needed: for one of the directions fixed the bound is reached.
  const auto thin = cross_cone({{1, 0, 0}, 0.3}, {{0, 1, 0}, 0});
  CHECK(thin->half_angle == Approx(0.3));
  CHECK(angle_between(thin->axis, Vector3d(0, 0, 1)) < 1e-15);
  CHECK_FALSE(cross_cone({{1, 0, 0}, 0.8}, {{0, 1, 0}, 0.8}));
}
