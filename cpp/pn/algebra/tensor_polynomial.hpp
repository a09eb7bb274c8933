// SPDX-License-Identifier: LGPL-2.1-or-later
// Tensor polynomials: sum a_ij u^i v^j by all coefficients up to fixed formal degrees in u and in
// v.
//
// The ring of BivariatePolynomial decides common factors; this dense form computes. Products take
// one multiplication for every pair of coefficients that do not vanish, without any search for like
// terms, and over Q none for denominators where all coefficients are integers.
//
// T is the coefficient type: Rational, RealBall, double.
#pragma once

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

#include "pn/algebra/ball.hpp"
#include "pn/algebra/bernstein.hpp"
#include "pn/algebra/form.hpp"
#include "pn/algebra/multivariate_polynomial.hpp"

namespace pn {

inline bool vanishes(double x) { return x == 0; }
inline bool vanishes(const Rational& x) { return x.is_zero(); }
inline bool vanishes(const RealBall& x) { return x.is_zero(); }

template <class T>
class TensorPolynomial {
 public:
  TensorPolynomial() : TensorPolynomial(0, 0) {}
  /// Zero, of these formal degrees.
  TensorPolynomial(int degree_u, int degree_v)
      : degree_u_(degree_u),
        degree_v_(degree_v),
        coefficients_(static_cast<std::size_t>((degree_u + 1) * (degree_v + 1))) {}
  static TensorPolynomial constant(const T& value) {
    TensorPolynomial result;
    result(0, 0) = value;
    return result;
  }
  /// c + a u + b v
  static TensorPolynomial linear(const T& c, const T& a, const T& b) {
    TensorPolynomial result(1, 1);
    result(0, 0) = c;
    result(1, 0) = a;
    result(0, 1) = b;
    return result;
  }

  int degree(Variable variable) const { return variable == Variable::kU ? degree_u_ : degree_v_; }
  /// That of u^i v^j.
  const T& operator()(int i, int j) const { return coefficients_[place(i, j)]; }
  T& operator()(int i, int j) { return coefficients_[place(i, j)]; }
  /// Row by row: all powers of v of one power of u.
  const std::vector<T>& coefficients() const { return coefficients_; }

  T at(const T& u, const T& v) const {
    T value{};
    for (int i = degree_u_; i >= 0; --i) {
      T row{};
      for (int j = degree_v_; j >= 0; --j) {
        row *= v;
        row += (*this)(i, j);
      }
      value *= u;
      value += row;
    }
    return value;
  }

  /// The coefficient of a power of one variable, a polynomial in the other.
  TensorPolynomial slice(Variable variable, int power) const {
    const bool is_u = variable == Variable::kU;
    TensorPolynomial result(is_u ? 0 : degree_u_, is_u ? degree_v_ : 0);
    for (int i = 0; i <= result.degree_u_; ++i) {
      for (int j = 0; j <= result.degree_v_; ++j) {
        result(i, j) = is_u ? (*this)(power, j) : (*this)(i, power);
      }
    }
    return result;
  }

  TensorPolynomial derivative(Variable variable) const {
    const int du = variable == Variable::kU ? 1 : 0, dv = 1 - du;
    TensorPolynomial result(std::max(degree_u_ - du, 0), std::max(degree_v_ - dv, 0));
    for (int i = du; i <= degree_u_; ++i) {
      for (int j = dv; j <= degree_v_; ++j) {
        result(i - du, j - dv) = (*this)(i, j) * T(static_cast<long>(du == 1 ? i : j));
      }
    }
    return result;
  }

  /// The polynomial with c + a x in place of one variable x.
  TensorPolynomial substituted(Variable variable, const T& c, const T& a) const {
    const TensorPolynomial x = variable == Variable::kU ? linear_in_u(c, a) : linear_in_v(c, a);
    const int n = degree(variable);
    TensorPolynomial result = slice(variable, n);
    for (int k = n - 1; k >= 0; --k) result = result * x + slice(variable, k);
    return result;
  }

  /// The polynomial divided by u, for one whose terms without u vanish.
  TensorPolynomial divided_by_u() const {
    TensorPolynomial result(degree_u_ - 1, degree_v_);
    for (int i = 1; i <= degree_u_; ++i) {
      for (int j = 0; j <= degree_v_; ++j) result(i - 1, j) = (*this)(i, j);
    }
    return result;
  }

  /// The same polynomial with coefficients f(a_ij).
  template <class Convert>
  auto mapped(Convert&& convert) const {
    using Result = std::decay_t<decltype(convert(coefficients_.front()))>;
    TensorPolynomial<Result> result(degree_u_, degree_v_);
    for (int i = 0; i <= degree_u_; ++i) {
      for (int j = 0; j <= degree_v_; ++j) result(i, j) = convert((*this)(i, j));
    }
    return result;
  }

  TensorPolynomial& operator+=(const TensorPolynomial& other) {
    raise_to(other);
    for (int i = 0; i <= other.degree_u_; ++i) {
      for (int j = 0; j <= other.degree_v_; ++j) (*this)(i, j) += other(i, j);
    }
    return *this;
  }
  TensorPolynomial& operator-=(const TensorPolynomial& other) {
    raise_to(other);
    for (int i = 0; i <= other.degree_u_; ++i) {
      for (int j = 0; j <= other.degree_v_; ++j) (*this)(i, j) -= other(i, j);
    }
    return *this;
  }
  TensorPolynomial& operator*=(const T& factor) {
    for (T& c : coefficients_) c *= factor;
    return *this;
  }
  friend TensorPolynomial operator+(TensorPolynomial a, const TensorPolynomial& b) {
    return std::move(a += b);
  }
  friend TensorPolynomial operator-(TensorPolynomial a, const TensorPolynomial& b) {
    return std::move(a -= b);
  }
  friend TensorPolynomial operator*(TensorPolynomial a, const T& factor) {
    return std::move(a *= factor);
  }
  friend TensorPolynomial operator*(const TensorPolynomial& a, const TensorPolynomial& b) {
    TensorPolynomial product(a.degree_u_ + b.degree_u_, a.degree_v_ + b.degree_v_);
    for (int i = 0; i <= a.degree_u_; ++i) {
      for (int j = 0; j <= a.degree_v_; ++j) {
        if (vanishes(a(i, j))) continue;
        for (int k = 0; k <= b.degree_u_; ++k) {
          for (int l = 0; l <= b.degree_v_; ++l) {
            if (!vanishes(b(k, l))) add_product(product(i + k, j + l), a(i, j), b(k, l));
          }
        }
      }
    }
    return product;
  }

 private:
  std::size_t place(int i, int j) const {
    return static_cast<std::size_t>(i * (degree_v_ + 1) + j);
  }

  static TensorPolynomial linear_in_u(const T& c, const T& a) {
    TensorPolynomial result(1, 0);
    result(0, 0) = c;
    result(1, 0) = a;
    return result;
  }
  static TensorPolynomial linear_in_v(const T& c, const T& a) {
    TensorPolynomial result(0, 1);
    result(0, 0) = c;
    result(0, 1) = a;
    return result;
  }
  void raise_to(const TensorPolynomial& other) {
    if (degree_u_ >= other.degree_u_ && degree_v_ >= other.degree_v_) return;
    TensorPolynomial raised(std::max(degree_u_, other.degree_u_),
                            std::max(degree_v_, other.degree_v_));
    for (int i = 0; i <= degree_u_; ++i) {
      for (int j = 0; j <= degree_v_; ++j) raised(i, j) = std::move((*this)(i, j));
    }
    *this = std::move(raised);
  }

  int degree_u_, degree_v_;
  std::vector<T> coefficients_;
};

/// The coefficients of B_i(u) B_j(v) on the unit square, row by row, in the formal degrees.
template <class T>
std::vector<T> to_bernstein(const TensorPolynomial<T>& p) {
  const int m = p.degree(Variable::kU), n = p.degree(Variable::kV);
  std::vector<T> result(p.coefficients().size());
  std::vector<std::vector<T>> rows;
  for (int i = 0; i <= m; ++i) {
    std::vector<T> row;
    for (int j = 0; j <= n; ++j) row.push_back(p(i, j));
    rows.push_back(to_bernstein(std::move(row)));
  }
  for (int j = 0; j <= n; ++j) {
    std::vector<T> column;
    for (auto& row : rows) column.push_back(std::move(row[static_cast<std::size_t>(j)]));
    column = to_bernstein(std::move(column));
    for (int i = 0; i <= m; ++i) {
      result[static_cast<std::size_t>(i * (n + 1) + j)] =
          std::move(column[static_cast<std::size_t>(i)]);
    }
  }
  return result;
}

/// In the ring of exact polynomials, and back with the degrees that the polynomial has.
BivariatePolynomial in_ring(const TensorPolynomial<Rational>& p);
TensorPolynomial<Rational> dense(const BivariatePolynomial& p);

}  // namespace pn
