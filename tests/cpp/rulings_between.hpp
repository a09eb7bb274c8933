// SPDX-License-Identifier: LGPL-2.1-or-later
// Families of rulings between two curves of spheres with small integer coefficients.
#pragma once

#include <array>
#include <random>

#include "circle_families.hpp"
#include "pn/algebra/roots.hpp"
#include "pn/isotropic/along_rulings.hpp"

namespace pn::test {

using Directrices = std::array<SphereCurve, 2>;

/// A span over [0, 1] without neighbours, and one between two.
inline const SpanPlace kAlone{1L, false, false}, kBetween{1L, true, true};

inline Envelope along(const Directrices& curves, const SpanPlace& place = kAlone) {
  return along_rulings(with_least_denominator(joined(curves[0], curves[1]).rulings), curves, place);
}

inline const RulingForms<RealBall>& rulings_of(const IsotropicHypersurface<RealBall>& gamma) {
  return std::get<RulingForms<RealBall>>(gamma.carrier);
}

/// Curves that run along x, the second one beside the first, without a torsal ruling in [0, 1]
/// or a little beyond.
class RandomDirectrices {
 public:
  explicit RandomDirectrices(std::uint64_t seed) : generator_(seed) {}

  /// Of these degrees over these denominators; the radii are those of points.
  Directrices lines(int p, int q, const RationalPolynomial& first_denominator = 1L,
                    const RationalPolynomial& second_denominator = 1L) {
    for (;;) {
      const Directrices curves = {curve(p, {0, 0, 0}, first_denominator),
                                  curve(q, {0, 40, 7}, second_denominator)};
      const RationalPolynomial turn = ruling_normal(joined(curves[0], curves[1]).rulings).torsion;
      if (turn.is_zero()) continue;
      const Rational beyond = Rational(1L) / Rational(8L);
      const auto wider = turn.on_interval(-beyond, Rational(1L) + beyond + beyond);
      if (roots_in_unit_interval(wider).empty()) return curves;
    }
  }

  RationalPolynomial next(int degree, int most) {
    std::vector<long> c;
    for (int i = 0; i <= degree; ++i) {
      c.push_back(static_cast<long>(generator_() % (2 * static_cast<unsigned>(most) + 1)) - most);
    }
    c.back() = c.back() == 0 ? 1 : c.back();
    return polynomial(c);
  }

 private:
  SphereCurve curve(int degree, const std::array<long, 3>& start,
                    const RationalPolynomial& denominator) {
    SphereCurve result{{}, 0L, denominator};
    for (std::size_t i = 0; i < 3; ++i) {
      result.centre[i] = next(degree, 5) + RationalPolynomial(start[i]) * denominator;
    }
    result.centre[0] += polynomial({0, 30});
    return result;
  }

  std::mt19937_64 generator_;
};

}  // namespace pn::test
