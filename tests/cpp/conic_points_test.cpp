// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/bezier/conic_points.hpp"

#include <catch2/catch.hpp>
#include <optional>

#include "moving_ellipses.hpp"

using namespace pn;
using namespace pn::test;

namespace {

RationalPolynomial poly(const std::vector<long>& c) { return conic_polynomial(c); }

/// [p, q] of two forms at t.
RealBall polar_determinant(const FormInU<RealBall>& p, const FormInU<RealBall>& q,
                           const RealBall& t) {
  const auto &a = p.coefficient, &b = q.coefficient;
  return (a[0](t) * b[2](t) + a[2](t) * b[0](t)) / RealBall(2) - a[1](t) * b[1](t);
}

/// A half-axis that is zero at t = 0, where the Smith type is (0, 2, 2): the ellipse is flat there.
MovingConic flat_at_start() { return upright(ellipse(poly({0, 0, 1}), poly({3, 1}))); }

const Rational kHalf = Rational(1) / Rational(2);

/// What decides over Q whether the positive part of a conic is a finite arc, against its points.
bool is_finite_arc(const Conic& conic, const Vector3<RationalPolynomial>& cut) {
  const auto [infinity, mixed, own] = ConicPoints({upright(conic), cut}).invariants();
  const auto at = [](const RationalPolynomial& p) { return p(kHalf).sign(); };
  return at(own) < 0 && at(mixed * mixed - infinity * own) > 0 &&
         (at(infinity) > 0 || at(mixed) < 0);
}

}  // namespace

TEST_CASE("Lines and their invariants agree up to one positive constant", "[conic_points]") {
  const Vector3<RationalPolynomial> cut = {poly({1, 2}), poly({-1}), poly({0, 3})};
  const std::vector<MovingConic> conics = {upright(ellipse(poly({2, 1, 3}), poly({5, -2, 1}))),
                                           flat_at_start(),
                                           // Hyperbolas for t > 1/2.
                                           upright(diagonal(-1L, 1L, poly({1, -2}))),
                                           // Real on a part only: s in place of t.
                                           upright(ellipse(poly({1, 3}), poly({3, -2})))};
  for (const MovingConic& conic : conics) {
    const ConicPoints points({conic, cut});
    const LineInvariants invariants = points.invariants();
    const ConicForms<RealBall> forms = points(192);
    std::optional<RealBall> scale;
    for (const Rational& s : {Rational(1) / Rational(7), Rational(2) / Rational(3)}) {
      const RealBall at(s, 192);
      const auto check = [&](const FormInU<RealBall>& p, const FormInU<RealBall>& q,
                             const RationalPolynomial& invariant) {
        const RealBall value = polar_determinant(p, q, at), exact(invariant(s), 192);
        if (!scale) scale = value / exact;
        CHECK(scale->is_positive());
        CHECK((value - *scale * exact).contains_zero());
        CHECK((value - *scale * exact).magnitude_upper() < 1e-40);
      };
      const FormInU<RealBall>& weight = forms.point[3];
      check(weight, weight, invariants.infinity);
      check(forms.cut, weight, invariants.mixed);
      check(forms.cut, forms.cut, invariants.cut);
    }
  }
}

TEST_CASE("An ellipse that is flat at one end is finite there", "[conic_points]") {
  CHECK(ConicPoints({flat_at_start(), {}}).invariants().infinity(Rational(0)).sign() > 0);
}

TEST_CASE("Finite arcs of all kinds of conics are told from infinite parts", "[conic_points]") {
  const Conic circle = diagonal(-1L, 1L, 1L), hyperbola = diagonal(1L, -1L, 1L);  // x^2 - y^2 = 1
  Conic parabola = diagonal(0L, 1L, 0L);                                          // x^2 = 2 y
  parabola[0][2] = parabola[2][0] = -1L;
  CHECK(is_finite_arc(circle, {0L, 0L, 1L}));
  CHECK_FALSE(is_finite_arc(circle, {2L, 0L, 1L}));
  CHECK(is_finite_arc(parabola, {1L, 0L, -1L}));
  CHECK_FALSE(is_finite_arc(parabola, {-1L, 0L, 1L}));
  // Along the axis: one of its points is at infinity.
  CHECK_FALSE(is_finite_arc(parabola, {0L, 1L, 0L}));
  CHECK(is_finite_arc(hyperbola, {2L, -1L, 0L}) != is_finite_arc(hyperbola, {-2L, 1L, 0L}));
  CHECK(is_finite_arc(hyperbola, {-2L, 1L, 0L}) == false);
  // Across both branches.
  CHECK_FALSE(is_finite_arc(hyperbola, {0L, 0L, 1L}));
}

TEST_CASE("The parameter runs from 0 to 1 where conics are real on a part only", "[conic_points]") {
  const ConicPoints points({upright(ellipse(poly({1, 3}), poly({3, -2}))), {}});
  CHECK(points.t_at(0) == 0);
  CHECK(points.t_at(1) == 1);
  CHECK(points.t_at(0.3) < points.t_at(0.6));
}
