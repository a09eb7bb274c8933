// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/conics/conic_family.hpp"

#include <algorithm>
#include <cstdio>
#include <string>

#include "pn/algebra/roots.hpp"
#include "pn/geometry_error.hpp"

namespace pn {
namespace {

using Polynomial = RationalPolynomial;

bool is_symmetric(const Matrix3<Polynomial>& m) {
  return m[0][1] == m[1][0] && m[0][2] == m[2][0] && m[1][2] == m[2][1];
}

/// The multiplicity of infinity as a zero of a form of this formal degree.
int zeros_at_infinity(const Polynomial& p, int formal_degree) { return formal_degree - p.degree(); }

/// The parts of a squarefree polynomial whose roots have the same multiplicity in another one, from
/// multiplicity 0 on. Every root of the squarefree one has a finite multiplicity there.
std::vector<Polynomial> by_multiplicity(Polynomial squarefree, Polynomial other) {
  std::vector<Polynomial> parts;
  while (squarefree.degree() > 0) {
    const Polynomial common = gcd(squarefree, other);
    parts.push_back(exact_quotient(squarefree, common));
    other = exact_quotient(other, common);
    squarefree = common;
  }
  return parts;
}

/// Of the real quadratic form C(t), with its determinant, which is not zero: both signs occur.
bool has_real_points(const ConicFamily& family, const Polynomial& det, const Rational& t) {
  const auto at = [&](int i, int j) {
    return family.matrix[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)](t);
  };
  const Rational first = at(0, 0);
  const Rational second = at(0, 0) * at(1, 1) - at(0, 1) * at(0, 1);
  const Rational third = det(t);
  return second.sign() <= 0 || first.sign() * third.sign() <= 0;
}

/// The interval around a number that is no root.
OpenInterval interval_around(const Rational& t, const std::vector<RealRoot>& roots) {
  OpenInterval interval;
  for (const RealRoot& root : roots) {
    const bool below = (root.value - RealBall(t, root.value.precision())).is_negative();
    if (below) interval.begin = root.value.midpoint();
    if (!below && !interval.end) interval.end = root.value.midpoint();
  }
  return interval;
}

std::string shown(double x) {
  char text[32];
  std::snprintf(text, sizeof text, "%.6g", x);
  return text;
}

std::optional<OpenInterval> without_real_points(const ConicFamily& family, const Polynomial& det,
                                                const std::vector<Rational>& samples) {
  const auto bad = std::find_if(samples.begin(), samples.end(), [&](const Rational& t) {
    return !has_real_points(family, det, t);
  });
  if (bad == samples.end()) return std::nullopt;
  return interval_around(*bad, isolate_roots(det, 128).real);
}

}  // namespace

Polynomial determinant(const Matrix3<Polynomial>& m) {
  return m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) -
         m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
         m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
}

Matrix3<Polynomial> adjugate(const Matrix3<Polynomial>& m) {
  Matrix3<Polynomial> result;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t i1 = (i + 1) % 3, i2 = (i + 2) % 3;
    for (std::size_t j = 0; j < 3; ++j) {
      const std::size_t j1 = (j + 1) % 3, j2 = (j + 2) % 3;
      result[j][i] = m[i1][j1] * m[i2][j2] - m[i1][j2] * m[i2][j1];
    }
  }
  return result;
}

ConicFamily conic_family(Matrix3<Polynomial> matrix, const Vector3<int>& degree) {
  if (!is_symmetric(matrix)) {
    throw GeometryError(ErrorCode::kWrongShape, "The matrix of the conics is not symmetric.");
  }
  if (determinant(matrix).is_zero()) {
    throw GeometryError(ErrorCode::kSingularConics,
                        "All conics of the family are pairs of lines: their determinant is zero.");
  }
  Polynomial common;
  for (const auto& row : matrix) {
    for (const Polynomial& entry : row) common = gcd(common, entry);
  }
  ConicFamily family{std::move(matrix), degree, 0};
  std::optional<int> twist;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      Polynomial& entry = family.matrix[i][j];
      if (entry.is_zero()) continue;
      entry = exact_quotient(entry, common);
      const int needed = entry.degree() - degree[i] - degree[j];
      twist = std::max(twist.value_or(needed), needed);
    }
  }
  family.twist = *twist;
  return family;
}

SingularConics singular_conics(const ConicFamily& family) {
  const Vector3<int>& f = family.degree;
  const int sum = f[0] + f[1] + f[2];
  const Polynomial det = determinant(family.matrix);
  const Matrix3<Polynomial> minors = adjugate(family.matrix);
  Polynomial common;
  std::optional<int> common_at_infinity;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      if (minors[i][j].is_zero()) continue;
      common = gcd(common, minors[i][j]);
      const int zeros = zeros_at_infinity(minors[i][j], 2 * sum - f[i] - f[j] + 2 * family.twist);
      common_at_infinity = std::min(common_at_infinity.value_or(zeros), zeros);
    }
  }
  SingularConics singular;
  for (const SquarefreeFactor& part : squarefree_factorization(det)) {
    const std::vector<Polynomial> by_a = by_multiplicity(part.factor, common);
    for (std::size_t a = 0; a < by_a.size(); ++a) {
      if (by_a[a].degree() < 1) continue;
      singular.finite.push_back(
          {by_a[a], {static_cast<int>(a), part.multiplicity - static_cast<int>(a)}});
    }
  }
  const int a = *common_at_infinity;
  singular.at_infinity = {a, zeros_at_infinity(det, 2 * sum + 3 * family.twist) - a};
  return singular;
}

int least_degree(const ConicFamily& family, const SingularConics& singular) {
  const auto divisions = [](const SmithType& type) { return type.b + type.a % 2; };
  int sum = divisions(singular.at_infinity);
  for (const SingularFactor& part : singular.finite) {
    sum += divisions(part.type) * part.factor.degree();
  }
  return (sum - family.twist) / 2;
}

std::optional<OpenInterval> interval_without_real_points(const ConicFamily& family,
                                                         const Rational& begin,
                                                         const Rational& end) {
  const Polynomial det = determinant(family.matrix);
  // The roots of det C in (begin, end), seen from [0, 1]; samples between them and the ends.
  const Polynomial ends({begin * end, -begin - end, Rational(1)});
  std::vector<Rational> samples;
  for (const Rational& t : numbers_between_real_roots(det * ends)) {
    if (begin < t && t < end) samples.push_back(t);
  }
  return without_real_points(family, det, samples);
}

std::optional<OpenInterval> interval_without_real_points(const ConicFamily& family) {
  const Polynomial det = determinant(family.matrix);
  return without_real_points(family, det, numbers_between_real_roots(det));
}

std::string description(const OpenInterval& interval) {
  return interval.begin && interval.end
             ? "between t = " + shown(*interval.begin) + " and " + shown(*interval.end)
         : interval.begin ? "for t > " + shown(*interval.begin)
         : interval.end   ? "for t < " + shown(*interval.end)
                          : std::string("for all t");
}

void refuse_without_real_points(const OpenInterval& interval) {
  throw GeometryError(ErrorCode::kNoRealPoints,
                      "The conics have no real points " + description(interval) + ".");
}

}  // namespace pn
