// SPDX-License-Identifier: LGPL-2.1-or-later
// Ternary forms: homogeneous polynomials of barycentric coordinates u + v + w = 1, and their sign
// on the triangle.
//
// A form sum c_ij u^i v^j w^(n - i - j) has the Bernstein coefficients c_ij i! j! k! / n!, so the
// signs are the same: a form whose coefficients are positive is positive on the triangle u, v, w
// >= 0. (G. Farin, Triangular Bernstein-Bezier patches, CAGD 3, 1986.) Products are plain products
// of these coefficients.
#pragma once

#include <cstddef>
#include <vector>

#include "pn/algebra/rational.hpp"

namespace pn {

template <class T>
class TernaryForm {
 public:
  /// Zero, of this degree.
  explicit TernaryForm(int degree)
      : degree_(degree), coefficients_(static_cast<std::size_t>((degree + 1) * (degree + 2) / 2)) {}
  /// The linear form with these values at u = 1, v = 1, w = 1.
  static TernaryForm linear(const T& at_u, const T& at_v, const T& at_w) {
    TernaryForm result(1);
    result(1, 0) = at_u;
    result(0, 1) = at_v;
    result(0, 0) = at_w;
    return result;
  }

  int degree() const { return degree_; }
  /// That of u^i v^j w^(n - i - j).
  const T& operator()(int i, int j) const { return coefficients_[place(i, j)]; }
  T& operator()(int i, int j) { return coefficients_[place(i, j)]; }
  /// Ordered by i, then by j.
  const std::vector<T>& coefficients() const { return coefficients_; }

  TernaryForm& operator+=(const TernaryForm& other) {
    for (std::size_t k = 0; k < coefficients_.size(); ++k)
      coefficients_[k] += other.coefficients_[k];
    return *this;
  }
  TernaryForm& operator-=(const TernaryForm& other) {
    for (std::size_t k = 0; k < coefficients_.size(); ++k)
      coefficients_[k] -= other.coefficients_[k];
    return *this;
  }
  TernaryForm& operator*=(const T& factor) {
    for (T& c : coefficients_) c *= factor;
    return *this;
  }
  friend TernaryForm operator+(TernaryForm a, const TernaryForm& b) { return a += b; }
  friend TernaryForm operator-(TernaryForm a, const TernaryForm& b) { return a -= b; }
  friend TernaryForm operator*(TernaryForm a, const T& factor) { return a *= factor; }
  friend TernaryForm operator*(const TernaryForm& a, const TernaryForm& b) {
    TernaryForm product(a.degree_ + b.degree_);
    for (int i = 0; i <= a.degree_; ++i) {
      for (int j = 0; i + j <= a.degree_; ++j) {
        for (int k = 0; k <= b.degree_; ++k) {
          for (int l = 0; k + l <= b.degree_; ++l) product(i + k, j + l) += a(i, j) * b(k, l);
        }
      }
    }
    return product;
  }

 private:
  std::size_t place(int i, int j) const {
    return static_cast<std::size_t>(i * (2 * degree_ + 3 - i) / 2 + j);
  }

  int degree_;
  std::vector<T> coefficients_;
};

/// The coefficients are positive: so is the form on the triangle.
bool has_positive_coefficients(const TernaryForm<Rational>& form);

}  // namespace pn
