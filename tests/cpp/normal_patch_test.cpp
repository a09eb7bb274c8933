// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/bezier/normal_patch.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "pn/bezier/chain_net.hpp"
#include "pn/bezier/evaluation.hpp"
#include "pn/shapes/canal_surface.hpp"

using namespace pn;
using Eigen::Vector3d;

namespace {

struct Face {
  BSplineSurface surface, normal;
};

/// A horn of two C2 spans: knots along and around, uneven weights.
Face horn() {
  const Curve spine = Curve::bspline(
      {3, {0, 1, 2}, {4, 1, 4}, {{0, 0, 0}, {2, 0, 0}, {4, 2, 1}, {5, 5, 0}, {5, 8, -1}}, {}});
  const Law radius = Law::bspline({3, {0, 1, 2}, {4, 1, 4}, {{1}, {1.2}, {0.8}, {1}, {1.5}}, {}});
  const ChainNet net(canal_surface(spine, radius), Lines::kEven, 128);
  return {net.section(0.25).front().surface, net.normals().front()};
}

Vector3d point(const BSplineSurface& s, double u, double v) {
  return Vector3d(evaluate(s, u, v).data());
}

/// Parameters in [0, 1]^2, corners among them.
std::vector<std::array<double, 2>> grid(int count) {
  std::vector<std::array<double, 2>> result;
  for (int i = 0; i <= count; ++i) {
    for (int j = 0; j <= count; ++j) {
      result.push_back({static_cast<double>(i) / count, static_cast<double>(j) / count});
    }
  }
  return result;
}

const NormalPatch kPatch = [] {
  const Face face = horn();
  return normal_patches(face.surface, face.normal).front();
}();

}  // namespace

TEST_CASE("The pieces are the surface and its normals between the knots", "[normal_patch]") {
  const auto [surface, normal] = horn();
  const auto patches = normal_patches(surface, normal);
  const std::size_t rows = surface.u_knots.size() - 1, columns = surface.v_knots.size() - 1;
  REQUIRE(patches.size() == rows * columns);
  for (std::size_t k = 0; k < patches.size(); ++k) {
    const double u = surface.u_knots[k / columns], v = surface.v_knots[k % columns];
    const double du = surface.u_knots[k / columns + 1] - u,
                 dv = surface.v_knots[k % columns + 1] - v;
    for (const auto& [s, t] : grid(4)) {
      const SurfaceJet jet = patches[k].at(s, t);
      CHECK((jet.point - point(surface, u + s * du, v + t * dv)).norm() < 1e-12);
      CHECK((jet.normal - point(normal, u + s * du, v + t * dv)).norm() < 1e-12);
      CHECK(std::abs(jet.normal.dot(jet.u)) < 1e-11);
      CHECK(std::abs(jet.normal.dot(jet.v)) < 1e-11);
    }
  }
}

TEST_CASE("Derivatives are those of differences", "[normal_patch]") {
  constexpr double h = 1e-6;
  for (const auto& [s, t] : grid(4)) {
    const SurfaceJet jet = kPatch.at(s, t);
    const Vector3d u = (kPatch.at(s + h, t).point - kPatch.at(s - h, t).point) / (2 * h);
    const Vector3d v = (kPatch.at(s, t + h).point - kPatch.at(s, t - h).point) / (2 * h);
    CHECK((jet.u - u).norm() < 1e-7);
    CHECK((jet.v - v).norm() < 1e-7);
  }
}

TEST_CASE("Halves are halves", "[normal_patch]") {
  const auto [low, high] = kPatch.halved(Variable::kU);
  const auto [left, right] = kPatch.halved(Variable::kV);
  for (const auto& [s, t] : grid(4)) {
    CHECK((low.at(s, t).point - kPatch.at(s / 2, t).point).norm() < 1e-13);
    CHECK((high.at(s, t).normal - kPatch.at((1 + s) / 2, t).normal).norm() < 1e-13);
    CHECK((left.at(s, t).normal - kPatch.at(s, t / 2).normal).norm() < 1e-13);
    CHECK((right.at(s, t).point - kPatch.at(s, (1 + t) / 2).point).norm() < 1e-13);
  }
}

TEST_CASE("The cones contain normals and derivatives, and narrow when a piece is halved",
          "[normal_patch]") {
  std::vector<NormalPatch> patches = {kPatch};
  double before = HUGE_VAL;
  for (int level = 0; level < 4; ++level) {
    const NormalPatch& patch = patches.back();
    const auto normals = patch.normal_cone();
    REQUIRE(normals);
    for (const Variable variable : {Variable::kU, Variable::kV}) {
      const auto tangents = patch.tangent_cone(variable);
      if (level > 1) REQUIRE(tangents);
      for (const auto& [s, t] : grid(8)) {
        const SurfaceJet jet = patch.at(s, t);
        CHECK(angle_between(jet.normal, normals->axis) <= normals->half_angle + 1e-9);
        if (!tangents) continue;
        const Vector3d& tangent = variable == Variable::kU ? jet.u : jet.v;
        CHECK(angle_between(tangent, tangents->axis) <= tangents->half_angle + 1e-9);
      }
    }
    if (level > 1) CHECK(normals->half_angle < 0.7 * before);
    before = normals->half_angle;
    const NormalPatch half = patch.halved(Variable::kU)[0].halved(Variable::kV)[1];
    patches.push_back(half);
  }
}

TEST_CASE("Lengths and turns are at least those of the lines", "[normal_patch]") {
  constexpr int kSteps = 64;
  for (const Variable variable : {Variable::kU, Variable::kV}) {
    double length = 0, turn = 0;
    for (int i = 0; i < kSteps; ++i) {
      const auto at = [&](double t) {
        return variable == Variable::kU ? kPatch.at(t, 0.5) : kPatch.at(0.5, t);
      };
      const SurfaceJet a = at(static_cast<double>(i) / kSteps), b = at((i + 1.0) / kSteps);
      length += (a.point - b.point).norm();
      turn += (a.normal - b.normal).norm();
    }
    CHECK(kPatch.length(variable) >= length);
    CHECK(kPatch.length(variable) < 2 * length);
    CHECK(kPatch.turn(variable) >= turn);
    CHECK(kPatch.turn(variable) < 2 * turn);
  }
}

TEST_CASE("Normals of derivatives are the rational ones, and in their cones", "[normal_patch]") {
  const auto [surface, normal] = horn();
  const auto rational = normal_patches(surface, normal), own = normal_patches(surface);
  REQUIRE(own.size() == rational.size());
  int cones = 0;
  for (std::size_t k = 0; k < own.size(); ++k) {
    for (const auto& [s, t] : grid(4)) {
      const Vector3d n = own[k].at(s, t).normal;
      CHECK((n - rational[k].at(s, t).normal).norm() < 1e-10);
    }
    // A small part, whose tangents are in narrow cones.
    NormalPatch part = own[k];
    for (int i = 0; i < 4; ++i) part = part.halved(Variable::kU)[0].halved(Variable::kV)[1];
    const auto cone = part.normal_cone();
    if (!cone) continue;
    ++cones;
    for (const auto& [s, t] : grid(4)) {
      CHECK(std::acos(std::min(1.0, cone->axis.dot(part.at(s, t).normal))) <=
            cone->half_angle + 1e-12);
    }
  }
  CHECK(cones == static_cast<int>(own.size()));
}
