// SPDX-License-Identifier: LGPL-2.1-or-later
// The worked examples of Minkowski space in the literature, misprints corrected, each with its
// source: data/minkowski_space.json. Points of families are (m, r) there as in the sources.
#pragma once

#include <array>
#include <fstream>
#include <nlohmann/json.hpp>
#include <random>

#include "expression.hpp"
#include "pn/minkowski/line_coordinates.hpp"

namespace pn::test {

inline const nlohmann::json& minkowski_cases() {
  static const nlohmann::json cases =
      nlohmann::json::parse(std::ifstream(PN_TEST_DATA "/minkowski_space.json"));
  return cases;
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
