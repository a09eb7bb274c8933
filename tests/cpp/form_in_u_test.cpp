// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/isotropic/form_in_u.hpp"

#include <catch2/catch.hpp>

#include "enclosures.hpp"

using namespace pn;
using namespace pn::test;

namespace {

FormInU<RealBall> form(const std::vector<std::vector<RealBall>>& coefficients) {
  FormInU<RealBall> result;
  for (const auto& c : coefficients) result.coefficient.emplace_back(c);
  return result;
}

const FormInU<RealBall> kQuadratic = form({{1, 2, -1}, {3, 0, 5}, {-2, 1, 1}});
const FormInU<RealBall> kCubic = form({{2, -1}, {0, 4}, {1, 1}, {-3, 2}});

RealBall at(const FormInU<RealBall>& f, double t, int u0, int u1) {
  return at_u(f, RealBall(u0), RealBall(u1))(RealBall(t));
}

}  // namespace

TEST_CASE("Binomials", "[form_in_u]") {
  for (int n = 1; n <= 8; ++n) {
    for (int j = 1; j < n; ++j) {
      CHECK(small_binomial(n, j) == small_binomial(n - 1, j - 1) + small_binomial(n - 1, j));
    }
    CHECK(small_binomial(n, 0) == 1);
    CHECK(small_binomial(n, n) == 1);
  }
}

TEST_CASE("A product has the product of the values", "[form_in_u]") {
  const FormInU<RealBall> product = kQuadratic * kCubic;
  CHECK(product.degree() == 5);
  for (const double t : {-0.5, 0.25, 2.0}) {
    for (const auto& [u0, u1] : {std::pair{1, 0}, {0, 1}, {2, -3}, {1, 1}}) {
      const RealBall expected = at(kQuadratic, t, u0, u1) * at(kCubic, t, u0, u1);
      CHECK(encloses_zero(at(product, t, u0, u1) - expected, 1e-13));
    }
  }
}

TEST_CASE("Coefficients are those of Bernstein on the arc u = (1 - s : s)", "[form_in_u]") {
  // At s = 0 and 1 the first and the last; the slope is the degree times the first difference.
  const RealBall t(0.5), s(0x1p-20);
  CHECK((at(kCubic, 0.5, 1, 0) - kCubic.coefficient.front()(t)).is_zero());
  CHECK((at(kCubic, 0.5, 0, 1) - kCubic.coefficient.back()(t)).is_zero());
  const RealBall near = at_u(kCubic, RealBall(1) - s, s)(t);
  const double slope = ((near - at(kCubic, 0.5, 1, 0)) / s).midpoint();
  CHECK(slope ==
        Approx((RealBall(3) * (kCubic.coefficient[1](t) - kCubic.coefficient[0](t))).midpoint())
            .epsilon(1e-4));
}

TEST_CASE("A sum raises the smaller degree in t, a form in t multiplies every coefficient",
          "[form_in_u]") {
  const FormInU<RealBall> linear = form({{1, 1}, {0, 2}, {4, 0}});
  const Form<RealBall> factor({3, -1});
  for (const double t : {-0.5, 0.25, 2.0}) {
    const RealBall a = at(kQuadratic, t, 2, -3), b = at(linear, t, 2, -3);
    CHECK((at(kQuadratic + linear, t, 2, -3) - (a + b)).is_zero());
    CHECK((at(linear - kQuadratic, t, 2, -3) - (b - a)).is_zero());
    CHECK((at(factor * linear, t, 2, -3) - factor(RealBall(t)) * b).is_zero());
  }
  CHECK((kQuadratic + linear).coefficient[1].degree() == 2);
}
