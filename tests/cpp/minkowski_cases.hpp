// SPDX-License-Identifier: LGPL-2.1-or-later
// The worked examples of Minkowski space in the literature, misprints corrected, each with its
// source: data/minkowski_space.json. Points of families are (m, r) there as in the sources.
#pragma once

#include <array>
#include <random>

#include "expression.hpp"
#include "pn/isotropic/quadratic_family.hpp"
#include "pn/minkowski/affine_class.hpp"
#include "pn/minkowski/laguerre_map.hpp"
#include "pn/minkowski/line_coordinates.hpp"
#include "test_data.hpp"

namespace pn::test {

inline const nlohmann::json& minkowski_cases() {
  static const nlohmann::json cases = test_data("minkowski_space.json");
  return cases;
}

/// A polynomial of degree two in u and v.
inline QuadraticCoordinate quadratic_coordinate(const std::string& text) {
  const auto f = [&](long u, long v) {
    return value<Rational>(text, {{"u", Rational(u)}, {"v", Rational(v)}});
  };
  const Rational half = Rational(1L) / Rational(2L);
  const Rational at = f(0, 0);
  const Rational u2 = (f(1, 0) + f(-1, 0)) * half - at, v2 = (f(0, 1) + f(0, -1)) * half - at;
  const Rational u = (f(1, 0) - f(-1, 0)) * half, v = (f(0, 1) - f(0, -1)) * half;
  return {u2, f(1, 1) - at - u2 - v2 - u - v, v2, u, v};
}

/// From polynomials of degree two in u and v, which vanish at u = v = 0.
inline QuadraticFamily quadratic_family(const nlohmann::json& texts) {
  QuadraticFamily::Control b;
  const Rational half = Rational(1L) / Rational(2L);
  for (std::size_t c = 0; c < 4; ++c) {
    const auto [uu, uv, vv, u, v] = quadratic_coordinate(texts[c]);
    b[0][c] = uu + u;
    b[1][c] = half * (uv + u + v);
    b[2][c] = vv + v;
    b[3][c] = half * u;
    b[4][c] = half * v;
  }
  return QuadraticFamily(b);
}

/// Small rational numbers.
class RandomRationals {
 public:
  explicit RandomRationals(std::uint64_t seed) : random_(seed) {}
  Rational operator()() {
    return Rational(std::uniform_int_distribution<long>(-30, 30)(random_)) /
           Rational(std::uniform_int_distribution<long>(1, 12)(random_));
  }
  MinkowskiVector<Rational> vector() {
    auto& next = *this;
    return {next(), next(), next(), next()};
  }
  /// w(s, t), stereographic.
  static MinkowskiVector<Rational> isotropic(const Rational& s, const Rational& t) {
    const Rational one(1L), two(2L), square = s * s + t * t;
    return {two * s, two * t, one - square, one + square};
  }

 private:
  std::mt19937_64 random_;
};

/// Reflections, a dilation and a translation.
inline LaguerreMap random_laguerre_map(RandomRationals& random) {
  LaguerreMap map =
      LaguerreMap::translation(random.vector()) * LaguerreMap::dilation(random() + Rational(40L));
  for (int i = 0; i < 3; ++i) map = map * LaguerreMap::reflection(random.vector());
  return map;
}

/// a x b = 0 and neither is zero: the same point of projective space.
template <std::size_t N>
bool proportional(const std::array<Rational, N>& a, const std::array<Rational, N>& b) {
  bool a_vanishes = true, b_vanishes = true;
  for (std::size_t i = 0; i < N; ++i) {
    a_vanishes = a_vanishes && a[i].is_zero();
    b_vanishes = b_vanishes && b[i].is_zero();
    for (std::size_t k = 0; k < i; ++k) {
      if (a[i] * b[k] != a[k] * b[i]) return false;
    }
  }
  return !a_vanishes && !b_vanishes;
}

}  // namespace pn::test
