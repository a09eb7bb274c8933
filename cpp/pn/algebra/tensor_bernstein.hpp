// SPDX-License-Identifier: LGPL-2.1-or-later
// The tensor Bernstein basis B_i(u) B_j(v) on a rectangle: signs of polynomials in two variables.
//
// THEOREM. A polynomial whose coefficients in this basis are positive is positive on the rectangle,
// since the basis is. The coefficients on a half are means of neighbours (P. de Casteljau).
// (G. Farin, Curves and Surfaces for CAGD, 5th ed. 2002, chapter 15.)
//
// Enclosures are kept in balls, on the unit square. The many halvings of a proof run in doubles:
// a mean of two doubles is off by at most 2^-53 of the largest coefficient, so n rounds of them by
// n times that, whatever the polynomial. Near a zero that is not enough any more; then the
// enclosure is restricted to the rectangle at hand and rounded anew.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "pn/algebra/ball.hpp"
#include "pn/algebra/multivariate_polynomial.hpp"

namespace pn {

/// low < high, for u and for v. Halvings of the unit square have exact corners.
struct Rectangle {
  std::array<double, 2> low = {0, 0}, high = {1, 1};

  double length(Variable variable) const;
  double middle(Variable variable) const;
  std::array<Rectangle, 2> halved(Variable variable) const;
};

/// A polynomial on the unit square, its coefficients enclosed in balls.
class TensorBernstein {
 public:
  /// The polynomial written with these degrees, which are not below its own.
  TensorBernstein(const BivariatePolynomial& p, int degree_u, int degree_v, long bits);

  int degree(Variable variable) const;
  /// That of B_i(u) B_j(v).
  const RealBall& coefficient(int i, int j) const;
  const std::vector<RealBall>& coefficients() const { return coefficients_; }

  /// The same polynomial as a function on the unit square that is mapped onto a rectangle.
  TensorBernstein on(const Rectangle& rectangle) const;

  /// Polynomials of equal degrees.
  friend TensorBernstein operator+(TensorBernstein a, const TensorBernstein& b);
  friend TensorBernstein operator*(TensorBernstein a, const RealBall& factor);

 private:
  int degree_u_, degree_v_;
  std::vector<RealBall> coefficients_;
};

/// The coefficients on the unit square are non-negative, decided exactly: so is the polynomial.
bool has_non_negative_coefficients(const BivariatePolynomial& p);

/// The polynomial is positive on the unit square, proved by halving it. False where it is not, and
/// where the proof would take very small parts.
bool is_positive_on_square(const BivariatePolynomial& p);

/// Coefficients in doubles, every one within a common error of the true one.
class RoundedBernstein {
 public:
  /// Throws Undecided when the enclosure is wider than the rounding to doubles.
  explicit RoundedBernstein(const TensorBernstein& enclosure);

  double coefficient(int i, int j) const;
  double error() const { return error_; }

  bool is_positive() const;
  /// At a corner, where the polynomial has the value of the coefficient, it is not known to be
  /// positive.
  bool has_corner_not_positive() const;
  bool is_negative() const;
  /// 1 or -1 where no coefficient has certainly the other sign, 0 where the coefficients have both.
  int possible_sign() const;
  /// Only the error hides the sign, and coefficients that are rounded anew would have much less.
  bool lacks_digits() const;

  std::array<RoundedBernstein, 2> halved(Variable variable) const;
  /// The variable by which to halve until the coefficients have one sign: the bending one, or else
  /// the one by which they change more.
  Variable decisive_variable() const;
  /// On the lines through the coefficient that is farthest on the wrong side, the variable by which
  /// the coefficients bend more; none where bends are too small to be the reason for its sign.
  std::optional<Variable> bending_variable() const;
  /// The slope in the middle: mean differences of coefficients, times degrees.
  std::array<double, 2> slope() const;
  /// *this - factor p, for p of equal degrees.
  RoundedBernstein minus(double factor, const RoundedBernstein& p) const;

 private:
  double magnitude() const;
  std::size_t size(Variable variable) const;
  std::size_t stride(Variable variable) const;
  /// The place of the least or the largest coefficient, whichever is smaller in magnitude.
  std::size_t wrong_place() const;
  struct Change {
    double bend, difference;
  };
  /// The largest along the line of one variable through a coefficient.
  Change change_through(std::size_t place, Variable variable) const;

  std::size_t size_u_, size_v_;
  std::vector<double> coefficients_;
  double error_;
};

}  // namespace pn
