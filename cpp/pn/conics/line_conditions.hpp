// SPDX-License-Identifier: LGPL-2.1-or-later
// Points of a family of conics that lie on chosen lines of its singular conics, in balls.
//
// After the steps over Q there are places c of type diag(1, 1, tau^p) left, with two lines each
// that are defined modulo tau^p. Of these, i conditions are put on the first line and p - i on the
// second: the vector y lies on them modulo tau^i and tau^(p - i). At conj(c) the conditions are
// conjugate. At a real place with conjugate lines i = p / 2. The vectors of forms y of degrees d -
// e_i with all conditions are the kernel of one real linear system of k rows, 2 p for a pair of
// places and p for a real one. It decides the splitting a of the lattice without any test for zero:
// with m = (e_0 + e_1 + e_2 + k) / 3,
//
//     k rows of full rank in degree m        <=>   a <= 1,  the kernel has dimension 3;
//     Q / g on it is then constant,                g the product of all (t - c)^p:
//         of rank 3                          <=>   a = 0.
//
// THEOREM. If all places left are simple and there is one, a suitable choice of lines has a = 0, or
// a = 1 where there is no real one and the parity of the family forbids a = 0
// (nappe_transport.hpp).
//
// Proof. A column with 2 e + twist < 0 would be isotropic, a rational point of the conic over Q(t),
// and all lines were rational; so e >= m - k/2, and no point w of the conics has a lower degree. In
// the lattice of a choice a point w of degree d is a section of a ruled surface, of
// self-intersection d - m plus 1 for each real place and 2 for each pair where w lies on the other
// line; sections of negative self-intersection have -a, all others a or more, and all are of the
// parity of a. Take w of least degree, d < m, and turn the choice from its lines to the others one
// after the other, pairs first: from d - m >= -k/2 to d - m + k >= 0 it passes 0, or 1 if there are
// only pairs; then a = 0 or a = 1. If d >= m, every a > 0 would give a point of degree m - a < d.
#pragma once

#include <complex>
#include <optional>
#include <vector>

#include "pn/algebra/form.hpp"
#include "pn/conics/rational_lattice.hpp"

namespace pn {

/// A polynomial in tau, of fixed length.
using Jet = std::vector<ComplexBall>;

/// A place that the steps left and the two lines of Q there. Of a pair of places the upper one.
struct LinePair {
  enum class Kind { kComplexPlace, kRealLines, kConjugateLines };

  std::optional<ComplexBall> place;  ///< nothing: infinity
  Kind kind;
  int multiplicity;
  std::array<Vector3<Jet>, 2> line;  ///< modulo tau^p

  bool is_real() const { return kind != Kind::kComplexPlace; }
};

/// At all places that the steps left, at this precision. Throws Undecided.
std::vector<LinePair> line_pairs(const RationalSteps& steps, long precision);

/// For each LinePair the number of conditions on its first line.
using LineChoice = std::vector<int>;

/// A choice made at one precision, to be recognised at another by the places of the lines.
struct ChosenLine {
  std::optional<std::complex<double>> place;
  Vector3<std::complex<double>> first_line;
  int conditions;
};
std::vector<ChosenLine> places_of(const std::vector<LinePair>& pairs, const LineChoice& choice);
LineChoice recognized(const std::vector<LinePair>& pairs, const std::vector<ChosenLine>& chosen);

/// The points P y of degree `degree` in t; [i][k] belongs to coordinate i and u0^(2-k) u1^k.
struct QuadraticPoints {
  Matrix3<Form<RealBall>> coordinate;
  int degree;
};

/// The linear systems of all choices.
class LineConditions {
 public:
  LineConditions(const RationalSteps& steps, std::vector<LinePair> pairs, long precision);

  const std::vector<LinePair>& pairs() const { return pairs_; }
  /// The least degree m.
  int least_degree() const { return m_; }
  bool has_real_places() const;

  /// For a = 0, proved; nothing otherwise.
  std::optional<QuadraticPoints> balanced_points(const LineChoice& choice) const;
  /// For a known to be odd and a <= 1, proved; nothing otherwise.
  std::optional<QuadraticPoints> unbalanced_points(const LineChoice& choice) const;

 private:
  using Vector = Vector3<Form<RealBall>>;

  std::optional<std::vector<Vector>> on_lines(const LineChoice& choice, int degree,
                                              int rank_defect) const;
  RealBall quotient(const Vector& a, const Vector& b, long t) const;
  Vector point(const Vector& y) const;

  std::vector<LinePair> pairs_;
  Vector3<int> column_degree_;
  Matrix3<Form<RealBall>> basis_, conic_;
  int rows_ = 0, m_ = 0;
};

}  // namespace pn
