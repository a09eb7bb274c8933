// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/conics/interval_substitution.hpp"

#include <algorithm>
#include <optional>
#include <string>

#include "pn/geometry_error.hpp"

namespace pn {
namespace {

/// Parameters (p : q) at both ends.
struct ProjectiveEnds {
  std::array<Rational, 2> begin, end;
};

struct Enclosure {
  Rational r1, r2;
  ProjectiveEnds ends;
};

/// r1 and r2 such that the ends of the interval have these parameters.
Enclosure enclosure(const Rational& begin, const Rational& end, const ProjectiveEnds& ends) {
  const auto square = [](const Rational& x) { return x * x; };
  const Rational p0 = square(ends.begin[0]), q0 = square(ends.begin[1]);
  const Rational p1 = square(ends.end[0]), q1 = square(ends.end[1]);
  const Rational left = begin * (p0 + q0), right = end * (p1 + q1), det = p0 * q1 - p1 * q0;
  return {(left * q1 - right * q0) / det, (p0 * right - p1 * left) / det, ends};
}

IntervalSubstitution substitution(const Enclosure& e) {
  const auto linear = [&](std::size_t i) {
    return RationalPolynomial({e.ends.begin[i], e.ends.end[i] - e.ends.begin[i]});
  };
  const RationalPolynomial p = linear(0) * linear(0), q = linear(1) * linear(1);
  return {RationalPolynomial(e.r1) * p + RationalPolynomial(e.r2) * q, p + q, 2};
}

/// The widest of some that have real points throughout. Where dt/ds would vanish, at an end that is
/// r1 or r2 itself, only if the conics end there.
std::optional<Enclosure> regular_enclosure(const ConicFamily& family, const Rational& begin,
                                           const Rational& end) {
  // r1 and r2 lie beyond the interval by about 1 / beta^2 of it, at last by less than its rounding.
  constexpr long kBetas[] = {2, 4, 16, 256, 1L << 16, 1L << 32};
  const Rational zero(0), one(1);
  const RationalPolynomial det = determinant(family.matrix);
  for (const bool ends_at_end : {false, true}) {
    for (const bool ends_at_begin : {false, true}) {
      if (ends_at_begin && !det(begin).is_zero()) continue;
      if (ends_at_end && !det(end).is_zero()) continue;
      for (const long b : kBetas) {
        const Rational beta(b);
        const std::array<Rational, 2> start = {ends_at_begin ? one : beta,
                                               ends_at_begin ? zero : one};
        const std::array<Rational, 2> stop = {ends_at_end ? zero : one, ends_at_end ? one : beta};
        Enclosure found = enclosure(begin, end, {start, stop});
        if (!interval_without_real_points(family, found.r1, found.r2)) return found;
        if (ends_at_begin && ends_at_end) break;
      }
    }
  }
  return std::nullopt;
}

}  // namespace

RationalPolynomial IntervalSubstitution::operator()(const RationalPolynomial& p,
                                                    int formal_degree) const {
  RationalPolynomial sum, power(1L);
  for (int i = formal_degree; i >= 0; --i) {
    sum = sum * numerator + RationalPolynomial(p.coefficient(i)) * power;
    power *= denominator;
  }
  return sum;
}

IntervalSubstitution interval_substitution(const ConicFamily& family, const Rational& begin,
                                           const Rational& end) {
  if (const auto bad = interval_without_real_points(family, begin, end)) {
    refuse_without_real_points(*bad);
  }
  if (!interval_without_real_points(family)) {
    return {RationalPolynomial({begin, end - begin}), RationalPolynomial(1L), 1};
  }
  const std::optional<Enclosure> found = regular_enclosure(family, begin, end);
  if (!found) {
    throw GeometryError(ErrorCode::kNoRealPoints,
                        "The conics have no real points too close to an end of the interval.");
  }
  return substitution(*found);
}

ConicFamily substituted(const ConicFamily& family, const IntervalSubstitution& substitution) {
  const Vector3<int>& f = family.degree;
  Matrix3<RationalPolynomial> matrix;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      if (family.matrix[i][j].is_zero()) continue;
      matrix[i][j] = substitution(family.matrix[i][j], f[i] + f[j] + family.twist);
    }
  }
  const int d = substitution.degree;
  return conic_family(std::move(matrix), {d * f[0], d * f[1], d * f[2]});
}

}  // namespace pn
