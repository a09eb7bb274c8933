// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/conics/nappe_transport.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "pn/algebra/bernstein.hpp"

namespace pn {
namespace {

using Polynomial = RationalPolynomial;
using Vector = Vector3<Rational>;

/// sum of v_i w_j Q_ij
Polynomial bilinear(const Matrix3<Polynomial>& conic, const Vector& v, const Vector& w) {
  Polynomial sum;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) sum += Polynomial(v[i] * w[j]) * conic[i][j];
  }
  return sum;
}

Matrix3<Rational> product(const Matrix3<Rational>& a, const Matrix3<Rational>& b) {
  Matrix3<Rational> result;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      for (std::size_t k = 0; k < 3; ++k) result[i][j] += a[i][k] * b[k][j];
    }
  }
  return result;
}

Matrix3<Rational> transposed(const Matrix3<Rational>& m) {
  Matrix3<Rational> result;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) result[i][j] = m[j][i];
  }
  return result;
}

/// In doubles, of entries up to 1.
Eigen::Matrix3d rounded(const Matrix3<Rational>& m) {
  Rational largest(0);
  for (const auto& row : m) {
    for (const Rational& x : row) largest = std::max(largest, x.sign() < 0 ? -x : x);
  }
  Eigen::Matrix3d result;
  for (std::size_t i = 0; i < 9; ++i) {
    result(static_cast<int>(i / 3), static_cast<int>(i % 3)) =
        (m[i / 3][i % 3] / largest).to_double();
  }
  return result;
}

/// Columns in the directions of the axes of a form, the negative one first, on which its values are
/// about even.
Matrix3<Rational> axes(const Matrix3<Rational>& form) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen(rounded(form));
  Matrix3<Rational> columns;
  for (int j = 0; j < 3; ++j) {
    // Smaller values are not known to doubles.
    const double value = std::max(std::abs(eigen.eigenvalues()[j]), 1e-16);
    const Eigen::Vector3d axis = eigen.eigenvectors().col(j) / std::sqrt(value);
    for (int i = 0; i < 3; ++i) {
      columns[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)] =
          Rational::exactly(axis[i]);
    }
  }
  return columns;
}

/// A vector near the axis of the double cone of Q(t). Where Q is near to a singular conic, or
/// unevenly scaled, it takes some rounds until doubles see the cone.
Vector inside_cone(const Matrix3<Polynomial>& family, const Rational& t) {
  Matrix3<Rational> conic;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) conic[i][j] = family[i][j](t);
  }
  Matrix3<Rational> basis = axes(conic);
  for (;;) {
    const Matrix3<Rational> form = product(transposed(basis), product(conic, basis));
    if (form[0][0].sign() < 0) return {basis[0][0], basis[1][0], basis[2][0]};
    basis = product(basis, axes(form));
  }
}

bool is_negative_on(const Polynomial& p, const Rational& begin, const Rational& length) {
  const Polynomial here = p.on_interval(begin, length);
  const std::vector<Rational> b = to_bernstein(coefficients(here, std::max(here.degree(), 0)));
  return std::all_of(b.begin(), b.end(), [](const Rational& x) { return x.sign() < 0; });
}

/// The first and last vector inside the cone along an interval, and whether they are in the same
/// nappe: +1, or not: -1.
struct Transport {
  Vector first, last;
  int sign;
};

Transport joined(const Matrix3<Polynomial>& conic, const Rational& t, const Transport& a,
                 const Transport& b) {
  const int same_nappe = -bilinear(conic, a.last, b.first)(t).sign();
  return {a.first, b.last, a.sign * same_nappe * b.sign};
}

Transport transport(const Matrix3<Polynomial>& conic, const Rational& begin,
                    const Rational& length) {
  const Rational half = length / Rational(2), middle = begin + half;
  const Vector v = inside_cone(conic, middle);
  if (is_negative_on(bilinear(conic, v, v), begin, length)) return {v, v, 1};
  return joined(conic, middle, transport(conic, begin, half), transport(conic, middle, half));
}

Polynomial reversed(const Polynomial& p, int formal_degree) {
  std::vector<Rational> c = coefficients(p, formal_degree);
  std::reverse(c.begin(), c.end());
  return Polynomial(c);
}

}  // namespace

int parity_of_splitting(const RationalLattice& lattice, int m) {
  const Vector3<int>& e = lattice.degree();
  Matrix3<Polynomial> conic = lattice.conic(), at_infinity;
  const int sign = determinant(conic)(Rational(0)).sign();
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      conic[i][j] *= Polynomial(Rational(-sign));
      const int degree = e[i] + e[j] + lattice.twist();
      if (degree >= 0) at_infinity[i][j] = reversed(conic[i][j], degree);
    }
  }
  const Rational one(1), length(2);
  const Transport finite = transport(conic, -one, length);
  const Transport beyond = transport(at_infinity, -one, length);
  // At t = 1 the coordinates of both charts agree; at t = -1 they differ by (-1)^(m - e_i).
  Vector back = beyond.first;
  for (std::size_t i = 0; i < 3; ++i) {
    if ((m - e[i]) % 2 != 0) back[i] = -back[i];
  }
  const int at_one = -bilinear(conic, finite.last, beyond.last)(one).sign();
  const int at_minus_one = -bilinear(conic, back, finite.first)(-one).sign();
  return finite.sign * at_one * beyond.sign * at_minus_one == 1 ? 0 : 1;
}

}  // namespace pn
