// SPDX-License-Identifier: LGPL-2.1-or-later
// Forms in u = (u0 : u1) whose coefficients are forms in t.
//
// A form of degree n is written with binomials, sum C(n, j) c_j u0^(n - j) u1^j, so that its c_j
// are Bernstein coefficients on the arc u = (1 - s : s). The product has
//
//     c_k = sum_{i + j = k} C(n, i) C(m, j) a_i b_j / C(n + m, k).
//
// T is the real number type: RealBall, which encloses, or double, which estimates.
#pragma once

#include <algorithm>
#include <vector>

#include "pn/algebra/form.hpp"

namespace pn {

/// sum C(n, j) c_j u0^(n - j) u1^j with forms c_j in t.
template <class T>
struct FormInU {
  std::vector<Form<T>> coefficient;

  int degree() const { return static_cast<int>(coefficient.size()) - 1; }
};

template <class T>
FormInU<T> operator*(const Form<T>& a, const FormInU<T>& b) {
  FormInU<T> product;
  for (const Form<T>& c : b.coefficient) product.coefficient.push_back(a * c);
  return product;
}

/// The sum of two forms of the same degree in u; in t the smaller formal degree is raised.
template <class T>
FormInU<T> operator+(const FormInU<T>& a, const FormInU<T>& b) {
  FormInU<T> sum;
  for (std::size_t j = 0; j < a.coefficient.size(); ++j) {
    const Form<T>&x = a.coefficient[j], &y = b.coefficient[j];
    sum.coefficient.push_back(x.elevated(std::max(x.degree(), y.degree())));
    for (int i = 0; i <= y.degree(); ++i) sum.coefficient.back()[i] += y[i];
  }
  return sum;
}

template <class T>
FormInU<T> operator-(FormInU<T> a) {
  for (Form<T>& c : a.coefficient) {
    for (int i = 0; i <= c.degree(); ++i) c[i] = -c[i];
  }
  return a;
}

template <class T>
FormInU<T> operator-(const FormInU<T>& a, const FormInU<T>& b) {
  return a + -b;
}

/// C(n, j) for the small degrees in u.
constexpr double small_binomial(int n, int j) {
  double binomial = 1;
  for (int i = 0; i < j; ++i) binomial = binomial * (n - i) / (i + 1);
  return binomial;
}

/// The coefficients C(n, j) c_j.
template <class T>
std::vector<Form<T>> with_binomials(const FormInU<T>& a) {
  std::vector<Form<T>> result;
  for (int j = 0; j <= a.degree(); ++j) {
    result.push_back(a.coefficient[j] * T(small_binomial(a.degree(), j)));
  }
  return result;
}

template <class T>
FormInU<T> operator*(const FormInU<T>& a, const FormInU<T>& b) {
  const int n = a.degree(), m = b.degree();
  const std::vector<Form<T>> left = with_binomials(a), right = with_binomials(b);
  FormInU<T> product;
  for (int k = 0; k <= n + m; ++k) {
    Form<T> sum;
    for (int i = std::max(0, k - m); i <= std::min(n, k); ++i) {
      sum.add_product(left[i], right[k - i]);
    }
    // The quotient of two exact balls would carry the least precision; that of the sum does not.
    for (int i = 0; i <= sum.degree(); ++i) sum[i] /= T(small_binomial(n + m, k));
    product.coefficient.push_back(std::move(sum));
  }
  return product;
}

/// The value at t and u = (u0 : u1).
template <class T>
T value(const FormInU<T>& form, const T& t, const T& u0, const T& u1) {
  // Horner's scheme in u0, with the powers of u1 kept beside it.
  T sum(0.0), power(1.0);
  for (int j = 0; j <= form.degree(); ++j) {
    sum = sum * u0 + T(small_binomial(form.degree(), j)) * form.coefficient[j](t) * power;
    power = power * u1;
  }
  return sum;
}

}  // namespace pn
