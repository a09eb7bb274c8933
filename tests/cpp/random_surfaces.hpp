// SPDX-License-Identifier: LGPL-2.1-or-later
// Random surfaces of spheres with small integer coefficients.
#pragma once

#include <random>

#include "pn/isotropic/along_surface.hpp"
#include "pn/isotropic/reparametrization.hpp"

namespace pn::test {

class RandomSurfaces {
 public:
  explicit RandomSurfaces(unsigned seed) : random_(seed) {}

  Rational number() { return Rational(static_cast<long>(random_() % 19) - 9); }

  PowerForm<Rational> power_form() {
    PowerForm<Rational> form;
    for (auto& vector : form) {
      for (Rational& x : vector) x = number();
    }
    return form;
  }

  /// A polynomial of these degrees in u and in v.
  BivariateFunction polynomial(std::size_t m, std::size_t n) {
    std::vector<std::vector<Rational>> coefficients(m + 1, std::vector<Rational>(n + 1));
    for (auto& row : coefficients) {
      for (Rational& c : row) c = number();
    }
    return BivariatePolynomial(coefficients);
  }

  /// The isotropic vector of a spinor with entries linear in u and v.
  IsotropicField isotropic_field() {
    const BivariateFunction a = polynomial(1, 1), b = polynomial(1, 1), c = polynomial(1, 1),
                            d = polynomial(1, 1), two(2L);
    const BivariateFunction upper = a * a + b * b, lower = c * c + d * d;
    return {two * (a * c + b * d), two * (a * d - b * c), upper - lower, upper + lower};
  }

 private:
  std::mt19937 random_;
};

/// a1 u^2/2 + a2 u v + a3 v^2/2 + a4 u + a5 v + a6
inline SphereSurface surface_of(const PowerForm<Rational>& a) {
  const Rational half = Rational(1L) / Rational(2L);
  SphereSurface f;
  for (std::size_t c = 0; c < 4; ++c) {
    f[c] = BivariatePolynomial(std::vector<std::vector<Rational>>{
        {a[5][c], a[4][c], half * a[2][c]}, {a[3][c], a[1][c]}, {half * a[0][c]}});
  }
  return f;
}

}  // namespace pn::test
