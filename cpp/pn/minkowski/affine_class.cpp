// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/minkowski/affine_class.hpp"

#include <algorithm>

#include "pn/algebra/rational_matrix.hpp"
#include "pn/algebra/rational_polynomial.hpp"

namespace pn {

namespace {

/// p u + q v
using LinearForm = std::array<Rational, 2>;

/// Homogeneous in (p, q): the coefficient i is that of p^(n - i) q^i.
template <int Degree>
using BinaryForm = std::array<Rational, Degree + 1>;

template <std::size_t N>
Rational value(const std::array<Rational, N>& form, const LinearForm& l) {
  Rational sum;
  for (std::size_t i = 0; i < N; ++i) {
    Rational term = form[i];
    for (std::size_t k = i; k + 1 < N; ++k) term *= l[0];
    for (std::size_t k = 0; k < i; ++k) term *= l[1];
    sum += term;
  }
  return sum;
}

template <std::size_t N>
bool is_zero(const std::array<Rational, N>& form) {
  return std::all_of(form.begin(), form.end(), [](const Rational& x) { return x.is_zero(); });
}

/// With multiplicities, over the complex numbers; the first form is not zero.
template <std::size_t A, std::size_t B>
int common_roots(const std::array<Rational, A>& a, const std::array<Rational, B>& b) {
  const RationalPolynomial p(std::vector<Rational>(a.begin(), a.end()));
  if (is_zero(b)) return static_cast<int>(A) - 1;
  const RationalPolynomial q(std::vector<Rational>(b.begin(), b.end()));
  const int at_infinity =
      std::min(static_cast<int>(A) - 1 - p.degree(), static_cast<int>(B) - 1 - q.degree());
  return gcd(p, q).degree() + at_infinity;
}

/// V by the rows of its echelon form.
struct Decomposition {
  std::vector<QuadraticCoordinate> quadratic;  ///< q + phi(q), for a basis of W
  std::vector<LinearForm> linear;              ///< a basis of M
};

Decomposition decomposition(const std::vector<QuadraticCoordinate>& coordinates) {
  RationalMatrix rows;
  for (const auto& c : coordinates) rows.emplace_back(c.begin(), c.end());
  Decomposition result;
  for (const auto& row : row_echelon_form(rows)) {
    if (row[0].is_zero() && row[1].is_zero() && row[2].is_zero())
      result.linear.push_back({row[3], row[4]});
    else
      result.quadratic.push_back({row[0], row[1], row[2], row[3], row[4]});
  }
  return result;
}

/// c(l) = phi(l^2) ^ l. The coefficient of a row of the echelon form in l^2 is that of its leading
/// monomial; phi is taken to be zero on the monomials that lead no row.
BinaryForm<3> contact_cubic(const std::vector<QuadraticCoordinate>& rows) {
  const std::array<Rational, 3> square = {1L, 2L, 1L};  // p^2 u^2 + 2 p q u v + q^2 v^2
  BinaryForm<3> cubic;
  for (const auto& row : rows) {
    std::size_t lead = 0;
    while (row[lead].is_zero()) ++lead;
    cubic[lead + 1] += square[lead] * row[3];
    cubic[lead] -= square[lead] * row[4];
  }
  return cubic;
}

/// Zero where l^2 belongs to the span of the two forms.
BinaryForm<2> square_condition(const std::vector<QuadraticCoordinate>& rows) {
  const QuadraticCoordinate &a = rows[0], &b = rows[1];
  const auto minor = [&](std::size_t i, std::size_t k) { return a[i] * b[k] - a[k] * b[i]; };
  return {minor(1, 2), Rational(2L) * minor(2, 0), minor(0, 1)};
}

/// b^2 - 4 a c
Rational discriminant(const Rational& a, const Rational& b, const Rational& c) {
  return b * b - Rational(4L) * a * c;
}

/// a p^3 + b p^2 q + c p q^2 + d q^3
Rational discriminant(const BinaryForm<3>& cubic) {
  const auto& [a, b, c, d] = cubic;
  return b * b * c * c - Rational(4L) * (a * c * c * c + b * b * b * d) -
         Rational(27L) * a * a * d * d + Rational(18L) * a * b * c * d;
}

/// Its Hessian vanishes.
bool is_cube(const BinaryForm<3>& cubic) {
  const auto& [a, b, c, d] = cubic;
  const Rational three(3L);
  return b * b == three * a * c && c * c == three * b * d && b * c == Rational(9L) * a * d;
}

bool parallel(const LinearForm& l, const LinearForm& m) { return l[0] * m[1] == l[1] * m[0]; }

std::string with_one_square_form(const Decomposition& v) {
  const auto& row = v.quadratic.front();
  const auto& [a, b, c, d, e] = row;
  const LinearForm root = a.is_zero() ? LinearForm{0L, 1L} : LinearForm{Rational(2L) * a, b};
  const bool removable = value(contact_cubic(v.quadratic), root).is_zero();
  if (v.linear.empty()) return removable ? "1-1-3b" : "1-1-3a";
  if (!parallel(v.linear.front(), root)) return "2-1-3a";
  return removable ? "2-1-3b" : "2-1-3c";
}

std::string with_one_quadratic_form(const Decomposition& v) {
  const auto& [a, b, c, d, e] = v.quadratic.front();
  const int sign = discriminant(a, b, c).sign();
  const char* const type = sign < 0 ? "1" : sign > 0 ? "2" : "3";
  if (v.linear.size() == 2) return std::string("3-1-") + type;
  if (sign == 0) return with_one_square_form(v);
  if (v.linear.empty()) return std::string("1-1-") + type;
  if (sign < 0) return "2-1-1";
  // The form contains a linear one as a factor where it vanishes with it.
  const LinearForm& m = v.linear.front();
  return value(BinaryForm<2>{a, b, c}, {m[1], -m[0]}).is_zero() ? "2-1-2b" : "2-1-2a";
}

std::string with_two_quadratic_forms(const Decomposition& v) {
  const BinaryForm<2> squares = square_condition(v.quadratic);
  const int sign = discriminant(squares[0], squares[1], squares[2]).sign();
  const std::string type = sign > 0 ? "1" : sign == 0 ? "2" : "3";
  if (v.linear.size() == 2) return "4-2-" + type;
  const BinaryForm<3> cubic = contact_cubic(v.quadratic);
  if (v.linear.empty()) {
    const std::array<const char*, 3> variant = {"b", "c", "a"};
    return "2-2-" + type + variant[static_cast<std::size_t>(common_roots(squares, cubic))];
  }
  if (sign < 0) return "3-2-3";
  const LinearForm& m = v.linear.front();
  if (!value(squares, m).is_zero()) return "3-2-" + type + "a";
  // The table calls (u^2, v^2, u) b and (u^2, u v, u) c.
  const bool removable = value(cubic, m).is_zero();
  if (sign > 0) return removable ? "3-2-1b" : "3-2-1c";
  return removable ? "3-2-2c" : "3-2-2b";
}

std::string with_all_quadratic_forms(const Decomposition& v) {
  if (v.linear.size() == 2) return "5-1-1";
  const BinaryForm<3> cubic = contact_cubic(v.quadratic);
  if (v.linear.size() == 1) return value(cubic, v.linear.front()).is_zero() ? "4-3-1a" : "4-3-1b";
  if (is_zero(cubic)) return "3-3-1a";
  const int sign = discriminant(cubic).sign();
  if (sign == 0) return is_cube(cubic) ? "3-3-2a" : "3-3-1b";
  return sign > 0 ? "3-3-1c" : "3-3-2b";
}

}  // namespace

std::string affine_class(const std::vector<QuadraticCoordinate>& coordinates) {
  const Decomposition v = decomposition(coordinates);
  switch (v.quadratic.size()) {
    case 0:
      return std::to_string(v.linear.size()) + "-0";
    case 1:
      return with_one_quadratic_form(v);
    case 2:
      return with_two_quadratic_forms(v);
    default:
      return with_all_quadratic_forms(v);
  }
}

}  // namespace pn
