// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/isotropic/sections.hpp"

#include <catch2/catch.hpp>

#include "enclosures.hpp"
#include "rulings_between.hpp"
#include "surface_concept.hpp"

using namespace pn;
using namespace pn::test;

namespace {

/// w of the unit normals (2 u0 u1, (u0^2 - u1^2) 2 t / (1 + t^2), ...) of the unit sphere: the
/// squares of a spinor (u0 + i t u1, t u0 + u1).
IsotropicVector<RealBall> some_w() {
  SpinorMatrix<ComplexBall> a;
  const ComplexBall zero(0.0), one(1.0), i(RealBall(0), RealBall(1));
  a.entry[0][0] = Form<ComplexBall>({one, zero});
  a.entry[0][1] = Form<ComplexBall>({zero, i});
  a.entry[1][0] = Form<ComplexBall>({zero, one});
  a.entry[1][1] = Form<ComplexBall>({one, zero});
  a.degree = {1, 1};
  return isotropic_vector<RealBall>(a);
}

Form<RealBall> constant(double x) { return Form<RealBall>::constant(RealBall(x)); }

/// Torsal, rational, and with a substituted parameter: every factor that is divided out.
std::vector<Directrices> awkward_rulings() {
  RandomDirectrices random(21);
  const SphereCurve line{{polynomial({0, 5}), 0L, 0L}, 0L, 1L};
  Directrices torsal = {line, {{polynomial({1, 7, 1}), 4L, polynomial({1, -1, 1})}, 0L, 1L}};
  SphereCurve first{{0L, polynomial({0, 8}), polynomial({1, 0, 1})}, 1L, 1L}, second = first;
  second.centre[0] += RationalPolynomial(4L);
  second.centre[2] += polynomial({0, 3});
  second.radius = polynomial({4, -2});
  Directrices rational = random.lines(2, 2, polynomial({2, -1, 1}), polynomial({3, 1, 1})),
              cones = rational;
  cones[0].radius = polynomial({9, 1, 2});
  cones[1].radius = polynomial({8, -2, 1});
  // D has a root on each side of [0, 1]: the denominator of the substitution is no constant.
  SphereCurve between = first;
  between.centre[0] += RationalPolynomial(4L);
  between.centre[2] += polynomial({1, 2});
  between.radius = polynomial({1, 4});
  return {random.lines(2, 3), rational, cones, torsal, {first, second}, {first, between}};
}

}  // namespace

TEST_CASE("A curve of spheres: the point is centre + radius n, and d moves it by d n",
          "[sections]") {
  const auto form = [](double a, double b, double c) {
    return Form<RealBall>({RealBall(a), RealBall(b), RealBall(c)});
  };
  const SphereCurveForms<RealBall> curve{
      {form(0, 3, 1), form(2, 0, -1), form(1, 1, 4)}, form(2, -1, 3), form(1, 0, 1)};
  const auto w = some_w();
  const auto forms = sections(curve, w);
  const RealBall u0(0.8), u1(0.6);
  for (const double place : {0.25, 0.75}) {
    const RealBall t(place);
    const auto at = contact(forms, t, u0, u1);
    for (std::size_t i = 0; i < 3; ++i) {
      const RealBall n = jet(w[i], t, u0, u1).value / jet(w[3], t, u0, u1).value;
      CHECK(encloses_zero(at.normal[i] - n, 1e-15));
      const RealBall point = (curve.centre[i](t) + curve.radius(t) * n) / curve.denominator(t);
      CHECK(encloses_zero(at.point[i] - point, 1e-15));
    }
  }
}

TEST_CASE("Rulings: n is orthogonal to the sections, and d moves them by d n", "[sections]") {
  for (const Directrices& curves : awkward_rulings()) {
    const auto gamma = along(curves).enclosure(192);
    const auto w = isotropic_vector<RealBall>(gamma.spinor);
    const auto forms = sections(rulings_of(gamma), w);
    const RealBall t = RealBall(0.375).at_precision(192);
    for (const double angle : {0.2, 0.9, 1.7}) {
      const RealBall u0(std::cos(angle)), u1(std::sin(angle));
      check_identities(forms, t, u0, u1);
      const auto at = contact(forms, t, u0, u1);
      for (std::size_t i = 0; i < 3; ++i) {
        const RealBall n = jet(w[i], t, u0, u1).value / jet(w[3], t, u0, u1).value;
        CHECK(encloses_zero(at.normal[i] - n, 1e-12));
      }
    }
  }
}

TEST_CASE("Rulings: the plane n.x = <f, w> / w4 touches in every point of f that w meets",
          "[sections]") {
  for (const Directrices& curves : awkward_rulings()) {
    const auto gamma = along(curves).enclosure(192);
    const auto& f = rulings_of(gamma);
    const auto forms = sections(f, isotropic_vector<RealBall>(gamma.spinor));
    const RealBall t = RealBall(0.75).at_precision(192);
    const auto at = contact(forms, t, RealBall(0.8), RealBall(0.6));
    RealBall support = f.radius(t) / f.denominator(t), distance = support;
    for (std::size_t i = 0; i < 3; ++i) {
      support += f.point[i](t) / f.denominator(t) * at.normal[i];
    }
    for (std::size_t i = 0; i < 3; ++i) support -= at.normal[i] * at.point[i];
    CHECK(encloses_zero(support, 1e-9 * (1 + distance.magnitude_upper())));
  }
}

TEST_CASE("Sections on an interval are those of the whole, at their scale", "[sections]") {
  for (const Directrices& curves : awkward_rulings()) {
    const auto gamma = along(curves).enclosure(192);
    const RealBall origin = RealBall(0.25).at_precision(192), length(0.5), local(0.375);
    SpinorMatrix<ComplexBall> spinor = gamma.spinor;
    for (auto& row : spinor.entry) {
      for (auto& entry : row) entry = entry.on_interval(ComplexBall(origin), ComplexBall(length));
    }
    const auto whole = sections(gamma.carrier, isotropic_vector<RealBall>(gamma.spinor));
    const auto part =
        sections(on_interval(gamma.carrier, origin, length), isotropic_vector<RealBall>(spinor));
    const RealBall t = origin + length * local, u0(0.8), u1(0.6);
    const auto check = [&](const FormInU<RealBall>& a, const FormInU<RealBall>& b) {
      const RealBall value = jet(a, t, u0, u1).value;
      CHECK(
          encloses_zero(value - jet(b, local, u0, u1).value, 1e-9 * (1 + value.magnitude_upper())));
    };
    check(whole.weight, part.weight);
    for (std::size_t i = 0; i < 3; ++i) {
      check(whole.point[i], part.point[i]);
      check(whole.direction[i], part.direction[i]);
    }
  }
}

TEST_CASE("A sphere by its planes of contact, and its offsets", "[sections]") {
  constexpr double kRadius = 3;
  QuadricForms<RealBall> sphere{
      {constant(0), constant(0), constant(0), constant(kRadius)}, {}, constant(1), {}};
  for (std::size_t i = 0; i < 3; ++i) sphere.dual[i][i] = RealBall(kRadius * kRadius);
  sphere.dual[3][3] = RealBall(1);
  const auto forms = sections(sphere, some_w());
  CHECK(section_degree(Carrier<RealBall>(sphere), 1) == forms.weight.coefficient[0].degree());
  CHECK(section_degree_around(Carrier<RealBall>(sphere)) == forms.weight.degree());
  for (const double t : {-0.5, 0.25}) {
    const auto at = contact(forms, RealBall(t), RealBall(0.8), RealBall(0.6));
    for (std::size_t i = 0; i < 3; ++i) {
      CHECK(encloses_zero(at.point[i] - RealBall(kRadius) * at.normal[i], 1e-15));
    }
    check_identities(forms, RealBall(t), RealBall(0.8), RealBall(0.6));
  }
}

TEST_CASE("Coefficients that vanish are cut off, linear factors divided out", "[sections]") {
  FormInU<double> form;
  for (int j = 0; j < 3; ++j) form.coefficient.emplace_back(std::vector<double>{6, -5, 1, 0});
  CHECK(truncated(form, 2).coefficient[1].degree() == 2);
  const auto quotient = divided_by_roots(truncated(form, 2), {2.0});  // (t - 2)(t - 3)
  CHECK(quotient.coefficient[2](0) == Approx(-3));
  CHECK(quotient.coefficient[2](3) == Approx(0).margin(1e-15));
}
