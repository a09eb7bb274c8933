// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/conics/nappe_transport.hpp"

#include <algorithm>
#include <cstddef>
#include <optional>

#include "pn/algebra/sign_at_real_roots.hpp"

namespace pn {
namespace {

using Polynomial = RationalPolynomial;
using Vector = Vector3<Polynomial>;
using Matrix = Matrix3<Polynomial>;

Polynomial dot(const Vector& v, const Vector& w) { return v[0] * w[0] + v[1] * w[1] + v[2] * w[2]; }

Vector cross(const Vector& v, const Vector& w) {
  return {v[1] * w[2] - v[2] * w[1], v[2] * w[0] - v[0] * w[2], v[0] * w[1] - v[1] * w[0]};
}

Vector times(const Polynomial& factor, const Vector& v) {
  return {factor * v[0], factor * v[1], factor * v[2]};
}

Vector difference(const Vector& v, const Vector& w) {
  return {v[0] - w[0], v[1] - w[1], v[2] - w[2]};
}

Vector product(const Matrix& m, const Vector& v) {
  return {dot(m[0], v), dot(m[1], v), dot(m[2], v)};
}

/// The form or its negative, of signature (2, 1).
Matrix with_double_cones(const Matrix& form) {
  Matrix at_zero, negative;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      at_zero[i][j] = form[i][j].coefficient(0);
      negative[i][j] = -form[i][j];
    }
  }
  return determinant(at_zero).coefficient(0).sign() < 0 ? form : negative;
}

/// The v and d of the theorem, and its product of signs.
struct OrthogonalVectors {
  Vector3<Vector> vector;
  std::array<Polynomial, 2> minor;
  int carried;
};

/// Nothing where d1 and p.Qq have a common real zero or a minor is zero for all t.
std::optional<OrthogonalVectors> orthogonal_vectors(const Matrix& form, const Vector& p,
                                                    const Vector& q) {
  const Vector form_p = product(form, p), form_q = product(form, q);
  const Polynomial pp = dot(p, form_p), pq = dot(q, form_p), qq = dot(q, form_q);
  const Polynomial second = pp * qq - pq * pq;
  if (pp.is_zero() || second.is_zero()) return std::nullopt;
  const Vector v2 = difference(times(pp, q), times(pq, p));
  const Vector v3 = cross(form_p, form_q);
  const auto at_first = sign_at_real_roots(pp, -pq);
  if (!at_first) return std::nullopt;
  const Vector q_across_p = difference(times(dot(p, p), q), times(dot(p, q), p));
  const auto at_second = sign_at_real_roots(second, dot(v3, q_across_p));
  return OrthogonalVectors{{p, v2, v3}, {pp, second}, *at_first * at_second.value()};
}

/// For all p of a cubic curve but finitely many d1 is not zero identically: no cone contains it.
/// The zeros of d1 and the planes that touch all cones then exclude finitely many q of a line. The
/// first p and q are in the lowest columns, whose entries are shortest.
OrthogonalVectors orthogonal_vectors(const Matrix& form, const Vector3<std::size_t>& ascending) {
  const auto vector = [&](const Vector3<long>& entries) {
    Vector v;
    for (std::size_t i = 0; i < 3; ++i) v[ascending[i]] = entries[i];
    return v;
  };
  for (long sum = 0;; ++sum) {
    for (long k = 0; k <= sum; ++k) {
      const Vector p = vector({1, k, k * k * k}), q = vector({0, 1, sum - k});
      if (auto found = orthogonal_vectors(form, p, q)) return *found;
    }
  }
}

/// The sign for large t, or large -t: end = 1, -1.
int sign_towards_infinity(const Polynomial& p, int end) {
  const int sign = p.coefficient(p.degree()).sign();
  return p.degree() % 2 == 0 ? sign : sign * end;
}

const Vector& negative_vector(const OrthogonalVectors& basis, int end) {
  const auto& [first, second] = basis.minor;
  return sign_towards_infinity(first, end) < 0    ? basis.vector[0]
         : sign_towards_infinity(second, end) < 0 ? basis.vector[1]
                                                  : basis.vector[2];
}

Matrix at_infinity(const Matrix& conic, const RationalLattice& lattice) {
  const Vector3<int>& e = lattice.degree();
  Matrix result;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      const int degree = e[i] + e[j] + lattice.twist();
      if (degree >= 0) result[i][j] = conic[i][j].coefficient(degree);
    }
  }
  return result;
}

/// A section of O(m - e_0) + O(m - e_1) + O(m - e_2) with this value at infinity, times an even
/// power of t.
Vector section(const Vector& value, const Vector3<int>& e, int m) {
  const int highest = *std::max_element(e.begin(), e.end());
  const int even = 2 * std::max(highest - m, 0);
  Vector result;
  for (std::size_t i = 0; i < 3; ++i) result[i] = value[i] * power_of_t(m - e[i] + even);
  return result;
}

}  // namespace

int parity_of_splitting(const RationalLattice& lattice, int m) {
  const Matrix conic = with_double_cones(lattice.conic());
  Vector3<std::size_t> ascending = {0, 1, 2};
  std::stable_sort(ascending.begin(), ascending.end(), [&](std::size_t i, std::size_t j) {
    return lattice.degree()[i] < lattice.degree()[j];
  });
  const OrthogonalVectors finite = orthogonal_vectors(conic, ascending);
  const OrthogonalVectors infinite = orthogonal_vectors(at_infinity(conic, lattice), ascending);
  const Vector back = product(conic, section(negative_vector(infinite, 1), lattice.degree(), m));
  // One nappe in which two products with `back` are negative, hence the same sign at both ends.
  const int at_end = sign_towards_infinity(dot(negative_vector(finite, 1), back), 1);
  const int at_begin = sign_towards_infinity(dot(negative_vector(finite, -1), back), -1);
  return finite.carried * at_end * at_begin == 1 ? 0 : 1;
}

}  // namespace pn
