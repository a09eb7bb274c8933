// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/conics/nappe_transport.hpp"

#include <Eigen/Dense>
#include <algorithm>
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

/// A vector near the axis of the double cone of Q(t).
Vector inside_cone(const Matrix3<Polynomial>& conic, const Rational& t) {
  Eigen::Matrix3d m;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      m(i, j) = conic[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)](t).to_double();
    }
  }
  const Eigen::Vector3d axis =
      Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(m).eigenvectors().col(0);
  return {Rational::exactly(axis[0]), Rational::exactly(axis[1]), Rational::exactly(axis[2])};
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
