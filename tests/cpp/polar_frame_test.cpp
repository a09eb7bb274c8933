// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/conics/polar_frame.hpp"

#include <catch2/catch.hpp>

#include "cone_families.hpp"
#include "error_code.hpp"
#include "pn/conics/stereographic_projection.hpp"

using namespace pn;
using namespace pn::test;

namespace {

using Polynomial = RationalPolynomial;

/// All incidences and conjugacies of the frame.
void check_frame(const QuadraticCones& cones) {
  const PolarFrame frame = polar_frame(cones);
  CHECK(contraction(frame.eta, frame.p).is_zero());
  CHECK(contraction(frame.g, frame.q).is_zero());
  CHECK(contraction(frame.zeta, frame.q).is_zero());
  CHECK(contraction(frame.eta, frame.r).is_zero());
  CHECK(contraction(frame.is_parabolic ? frame.zeta : frame.g, frame.r).is_zero());
  CHECK_FALSE(determinant({frame.g, frame.eta, frame.zeta}).is_zero());
  CHECK(frame.form[0][1].is_zero());
  CHECK(frame.form[1][2].is_zero());
  CHECK_FALSE(frame.form[1][1].is_zero());
  CHECK(frame.form[0][2].is_zero() != frame.is_parabolic);
  CHECK(frame.form[0][0].is_zero() == frame.is_parabolic);
  CHECK(frame.form[2][2].is_zero() == frame.is_parabolic);
  // p is the common point of contact of the pencil, in space: C' v.
  const auto p = in_space(cones, frame.p);
  const auto contact = polar_of(derivative(cones.matrix), cones.vertex);
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = 0; j < i; ++j) CHECK((p[i] * contact[j] - p[j] * contact[i]).is_zero());
  }
}

}  // namespace

TEST_CASE("Polar frames of random families are conjugate", "[polar_frame]") {
  RandomConics random(31);
  for (const Vector3<int>& f : {Vector3<int>{0, 0, 1}, {0, 1, 1}, {1, 1, 1}}) {
    for (int repeat = 0; repeat < 3; ++repeat) {
      const QuadraticCones cones = quadratic_cones(random_cone_matrix(random, f, 2));
      CHECK_FALSE(polar_frame(cones).is_parabolic);
      check_frame(cones);
    }
  }
}

TEST_CASE("The frame of the example of the dissertation", "[polar_frame]") {
  check_frame(quadratic_cones(conics_of_the_dissertation()));
}

TEST_CASE("Frames of cones that move along their generators are parabolic", "[polar_frame]") {
  const Polynomial t = power_of_t(1), one(1L), zero;
  const QuadraticCones cones =
      quadratic_cones({t, zero, t, one}, diagonal(one + t * t, one, -(one + t * t)));
  CHECK(polar_frame(cones).is_parabolic);
  check_frame(cones);
}

TEST_CASE("Where a coordinate line through p is a tangent another one is taken", "[polar_frame]") {
  // Tangents l0 l2 = l1^2 of a conic in a turning plane through p: corner lines are tangents.
  const Polynomial zero, one(1L), t = power_of_t(1);
  const Conic conic = {{{zero, zero, one}, {zero, -(one + one), zero}, {one, zero, zero}}};
  for (const auto& frame :
       {std::array<Vector3<Polynomial>, 4>{
            {{one, zero, zero}, {zero, one, zero}, {zero, zero, one}, {t, zero, one}}},
        {{{one, zero, zero}, {zero, one, zero}, {zero, zero, one}, {zero, t, zero}}}}) {
    check_frame(quadratic_cones(cone_matrix(frame, conic)));
  }
}

TEST_CASE("A fixed vertex has no frame", "[polar_frame]") {
  const QuadraticCones cones =
      quadratic_cones({0L, 0L, 0L, 1L}, diagonal(1L, 1L, -conic_polynomial({1, 0, 1})));
  CHECK(code_of([&] { polar_frame(cones); }) == ErrorCode::kZeroLength);
}
