// SPDX-License-Identifier: LGPL-2.1-or-later
// Line factors: the real polynomial matrix F(t) on one segment, and how it meets its neighbours.
//
// A F has the circles of A and other lines u = const. F is a polynomial with matrix coefficients,
// given by its values, and for a cubic its slopes, at the ends of the segment.
//
// LEMMA 1 (joints). Where two segments share their circle, the spinors B- of the left one and A+ of
// the right one satisfy A+ F = e^{i phi} B- for a real matrix F, so the lines u = const run on.
// Where both continue each other up to the second derivative, there are moreover a real F' and a
// real psi with
//
//     A+ F' = e^{i phi} (B-' + i psi B-) - A+' F;
//
// then w, and with it every section as a homogeneous function, is C1 across the joint. (n_t differs
// by a projective vector field on the circle, three numbers, and w_t by one: the four entries of F'
// match them, and psi is the rate of the phase.) Since F' is real, it is the real part of A+^{-1}
// (e^{i phi} B-' - A+' F): the term i psi F drops out.
//
// T is RealBall or double, as in isotropic_hypersurface.hpp.
#pragma once

#include <Eigen/Dense>
#include <array>
#include <cmath>
#include <initializer_list>
#include <utility>
#include <vector>

#include "pn/isotropic/isotropic_hypersurface.hpp"

namespace pn::lines {

template <class T>
using Matrix = std::array<std::array<T, 2>, 2>;

template <class T>
Matrix<T> operator*(const Matrix<T>& a, const Matrix<T>& b) {
  Matrix<T> c;
  for (int i = 0; i < 2; ++i) {
    for (int j = 0; j < 2; ++j) c[i][j] = a[i][0] * b[0][j] + a[i][1] * b[1][j];
  }
  return c;
}

template <class T>
Matrix<T> operator+(const Matrix<T>& a, const Matrix<T>& b) {
  Matrix<T> c;
  for (int i = 0; i < 2; ++i) {
    for (int j = 0; j < 2; ++j) c[i][j] = a[i][j] + b[i][j];
  }
  return c;
}

template <class T>
Matrix<T> scaled(const Matrix<T>& a, const T& factor) {
  Matrix<T> c;
  for (int i = 0; i < 2; ++i) {
    for (int j = 0; j < 2; ++j) c[i][j] = a[i][j] * factor;
  }
  return c;
}

template <class T>
Matrix<T> inverse(const Matrix<T>& a) {
  const T inverse_determinant = T(1.0) / (a[0][0] * a[1][1] - a[0][1] * a[1][0]);
  return scaled(Matrix<T>{{{a[1][1], -a[0][1]}, {-a[1][0], a[0][0]}}}, inverse_determinant);
}

// The real type of a segment's numbers and its complex companion.
template <class T>
Matrix<ComplexOf<T>> complexified(const Matrix<T>& a) {
  return {{{ComplexOf<T>(a[0][0]), ComplexOf<T>(a[0][1])},
           {ComplexOf<T>(a[1][0]), ComplexOf<T>(a[1][1])}}};
}

template <class T>
Matrix<T> real_part(const Matrix<ComplexOf<T>>& a) {
  using spinor::re;
  return {{{re(a[0][0]), re(a[0][1])}, {re(a[1][0]), re(a[1][1])}}};
}

inline bool is_zero(double x) { return x == 0; }
inline bool is_zero(const RealBall& x) { return x.is_zero(); }

inline double midpoint(double x) { return x; }
inline double midpoint(const RealBall& x) { return x.midpoint(); }

template <class T>
Eigen::Matrix2d midpoint(const Matrix<T>& a) {
  Eigen::Matrix2d result;
  result << midpoint(a[0][0]), midpoint(a[0][1]), midpoint(a[1][0]), midpoint(a[1][1]);
  return result;
}

/// A number of 24 bits near x, of any size.
inline double short_double(double x) {
  int exponent = 0;
  const auto mantissa = static_cast<float>(std::frexp(x, &exponent));
  return std::ldexp(static_cast<double>(mantissa), exponent);
}

/// A free choice: entries of 24 bits, exact in every number type.
template <class T>
Matrix<T> short_doubles(const Eigen::Matrix2d& a) {
  const auto entry = [&](int i, int j) { return T(short_double(a(i, j))); };
  return {{{entry(0, 0), entry(0, 1)}, {entry(1, 0), entry(1, 1)}}};
}

/// Value and derivative of a matrix of forms at an end of a segment.
template <class C>
struct EndValue {
  Matrix<C> value, derivative;
};

template <class C>
EndValue<C> end_value(const SpinorMatrix<C>& a, int end) {
  EndValue<C> result;
  for (int i = 0; i < 2; ++i) {
    for (int j = 0; j < 2; ++j) {
      result.value[i][j] = a.entry[i][j](C(static_cast<double>(end)));
      result.derivative[i][j] = a.entry[i][j].derivative()(C(static_cast<double>(end)));
    }
  }
  return result;
}

/// Value and derivative of F at an end of a segment.
template <class T>
struct LineEnd {
  Matrix<T> value, slope;
};

/// F on a segment. The ends are kept beside the coefficients: as sums of coefficients they would
/// carry the errors of one end of a segment to the other, and so along the whole chain.
template <class T>
struct LineFactor {
  std::vector<Matrix<T>> coefficients;  ///< ascending powers
  std::array<LineEnd<T>, 2> ends;
};

template <class T>
Matrix<T> combination(std::initializer_list<std::pair<double, const Matrix<T>*>> terms) {
  Matrix<T> sum = scaled(*terms.begin()->second, T(terms.begin()->first));
  for (auto term = terms.begin() + 1; term != terms.end(); ++term) {
    sum = sum + scaled(*term->second, T(term->first));
  }
  return sum;
}

/// F at a parameter of the segment, nearly.
template <class T>
Eigen::Matrix2d value_at(const LineFactor<T>& factor, double t) {
  Eigen::Matrix2d sum = Eigen::Matrix2d::Zero();
  for (std::size_t i = factor.coefficients.size(); i-- > 0;) {
    sum = sum * t + midpoint(factor.coefficients[i]);
  }
  return sum;
}

template <class T>
LineFactor<T> constant_line(const Matrix<T>& value) {
  const LineEnd<T> end{value, scaled(value, T(0.0))};
  return {{value}, {end, end}};
}

template <class T>
LineFactor<T> line_through(const Matrix<T>& left, const Matrix<T>& right) {
  const Matrix<T> slope = combination<T>({{1, &right}, {-1, &left}});
  return {{left, slope}, {LineEnd<T>{left, slope}, LineEnd<T>{right, slope}}};
}

template <class T>
LineFactor<T> parabola_through(const Matrix<T>& left, const Matrix<T>& middle,
                               const Matrix<T>& right) {
  const Matrix<T> left_slope = combination<T>({{-3, &left}, {4, &middle}, {-1, &right}});
  const Matrix<T> right_slope = combination<T>({{1, &left}, {-4, &middle}, {3, &right}});
  return {{left, left_slope, combination<T>({{2, &left}, {-4, &middle}, {2, &right}})},
          {LineEnd<T>{left, left_slope}, LineEnd<T>{right, right_slope}}};
}

template <class T>
LineFactor<T> hermite_cubic(const LineEnd<T>& left, const LineEnd<T>& right) {
  return {
      {left.value, left.slope,
       combination<T>(
           {{-3, &left.value}, {-2, &left.slope}, {3, &right.value}, {-1, &right.slope}}),
       combination<T>({{2, &left.value}, {1, &left.slope}, {-2, &right.value}, {1, &right.slope}})},
      {left, right}};
}

/// Lemma 1: the real factor at an end of a segment with which its lines meet those of a neighbour.
/// `own` is A at the joint, `neighbour` the finished A F of the other side there, `stretch` the
/// length of the own segment over the neighbour's; `near` picks one of the two signs.
template <class T>
LineEnd<T> matched(const EndValue<ComplexOf<T>>& own, const EndValue<ComplexOf<T>>& neighbour,
                   const T& stretch, const Eigen::Matrix2d& near) {
  using C = ComplexOf<T>;
  using spinor::size;
  const Matrix<C> own_inverse = inverse(own.value);
  const Matrix<C> ratio = own_inverse * neighbour.value;
  C largest = ratio[0][0];
  for (const auto& row : ratio) {
    for (const C& entry : row) {
      if (size(entry) > size(largest)) largest = entry;
    }
  }
  C phase = conj(largest) / spinor::root(largest * conj(largest));
  if ((near.inverse() * midpoint(real_part<T>(scaled(ratio, phase)))).trace() < 0) phase = -phase;
  LineEnd<T> result;
  result.value = real_part<T>(scaled(ratio, phase));
  const Matrix<C> wanted = scaled(neighbour.derivative, phase * C(stretch));
  const Matrix<C> drift = own.derivative * complexified<T>(result.value);
  result.slope = real_part<T>(own_inverse * (wanted + scaled(drift, C(-1.0))));
  return result;
}

/// A F with both columns at the same formal degree.
template <class T>
SpinorMatrix<ComplexOf<T>> lined(const SpinorMatrix<ComplexOf<T>>& a, const LineFactor<T>& factor) {
  using C = ComplexOf<T>;
  const int lines_degree = static_cast<int>(factor.coefficients.size()) - 1;
  SpinorMatrix<C> b;
  b.degree = {a.degree[0] + lines_degree, a.degree[0] + lines_degree};
  for (int j = 0; j < 2; ++j) {
    std::array<Form<C>, 2> column;
    for (int k = 0; k < 2; ++k) {
      column[k] = Form<C>::zero(lines_degree);
      for (int i = 0; i <= lines_degree; ++i) column[k][i] = C(factor.coefficients[i][k][j]);
    }
    for (int i = 0; i < 2; ++i) {
      b.entry[i][j] = a.entry[i][0] * column[0] +
                      (a.entry[i][1] * column[1]).elevated(a.entry[i][0].degree() + lines_degree);
    }
  }
  return b;
}

}  // namespace pn::lines
