// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/isotropic/isotropic_hypersurface.hpp"

#include <catch2/catch.hpp>

#include "enclosures.hpp"

using pn::Form;
using pn::FormInU;
using pn::Rational;
using pn::RealBall;
using namespace pn::test;

namespace {

using RealForm = Form<RealBall>;

RealForm real_form(std::initializer_list<int> c) {
  return RealForm(std::vector<RealBall>(c.begin(), c.end()));
}

Form<pn::ComplexBall> complex_form(std::initializer_list<std::array<int, 2>> coefficients) {
  std::vector<pn::ComplexBall> result;
  for (const auto& [re, im] : coefficients) result.emplace_back(RealBall(re), RealBall(im));
  return Form<pn::ComplexBall>(std::move(result));
}

/// Gaussian integers, so that every identity is exact; columns of different degrees.
pn::SpinorMatrix<pn::ComplexBall> spinor() {
  pn::SpinorMatrix<pn::ComplexBall> a;
  a.entry[0][0] = complex_form({{1, 2}, {-3, 0}, {2, 1}});
  a.entry[1][0] = complex_form({{0, 1}, {4, -1}, {1, 1}});
  a.entry[0][1] = complex_form({{2, 0}, {1, -2}});
  a.entry[1][1] = complex_form({{-1, 3}, {0, 2}});
  a.degree = {2, 1};
  return a;
}

}  // namespace

TEST_CASE("The vector of a spinor is isotropic: <w, w> = 0 identically",
          "[isotropic_hypersurface]") {
  const auto w = pn::isotropic_vector<RealBall>(spinor());
  const FormInU<RealBall> square = w[0] * w[0] + w[1] * w[1] + w[2] * w[2] - w[3] * w[3];
  CHECK(square.degree() == 4);
  for (const RealForm& form : square.coefficient) {
    for (const RealBall& c : form.coefficients()) CHECK(encloses_zero(c, 1e-15));
  }
  CHECK(w[3].coefficient[0].degree() == 4);
  CHECK(w[3].coefficient[2].degree() == 4);
}

TEST_CASE("w is that of the spinor A u at every point", "[isotropic_hypersurface]") {
  const auto a = spinor();
  const auto w = pn::isotropic_vector<RealBall>(a);
  const RealBall t(0.75), u0(3), u1(-2);
  const auto component = [&](int row) {
    return a.entry[row][0](pn::ComplexBall(t)) * pn::ComplexBall(u0) +
           a.entry[row][1](pn::ComplexBall(t)) * pn::ComplexBall(u1);
  };
  const auto a0 = component(0), a1 = component(1);
  const auto mixed = conj(a0) * a1;
  const RealBall upper = (conj(a0) * a0).real(), lower = (conj(a1) * a1).real();
  CHECK((jet(w[0], t, u0, u1).value - RealBall(2) * mixed.real()).is_zero());
  CHECK((jet(w[1], t, u0, u1).value - RealBall(2) * mixed.imag()).is_zero());
  CHECK((jet(w[2], t, u0, u1).value - (upper - lower)).is_zero());
  CHECK((jet(w[3], t, u0, u1).value - (upper + lower)).is_zero());
}

TEST_CASE("Sections are x_d = centre + (radius + d) n", "[isotropic_hypersurface]") {
  const pn::SphereCurveForms<RealBall> curve{
      {real_form({1, 2, 3}), real_form({0, -1, 2}), real_form({5, 0, 1})},
      real_form({2, 1, 1}),
      real_form({1, 1, 1})};
  const auto w = pn::isotropic_vector<RealBall>(spinor());
  const auto forms = sections(curve, w);
  const RealBall t(0.25), u0(3), u1(-2), d(7);
  const RealBall q = curve.denominator(t), w4 = jet(w[3], t, u0, u1).value;
  const RealBall weight = jet(forms.weight, t, u0, u1).value;
  CHECK((weight - q * w4).is_zero());
  for (std::size_t i = 0; i < 3; ++i) {
    const RealBall section =
        jet(forms.point[i], t, u0, u1).value + d * jet(forms.direction[i], t, u0, u1).value;
    // Multiplied by the denominator q w4 all numbers are exact.
    const RealBall expected =
        curve.centre[i](t) * w4 + (curve.radius(t) + d * q) * jet(w[i], t, u0, u1).value;
    CHECK((section - expected).is_zero());
  }
}
