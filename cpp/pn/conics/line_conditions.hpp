// SPDX-License-Identifier: LGPL-2.1-or-later
// Points of a family of conics that lie on chosen lines of its singular conics, in balls.
//
// After the steps over Q there are places c of type diag(1, 1, tau^p) left, with two lines each
// that are defined modulo tau^p. Of these, i conditions are put on the first line and p - i on the
// second: the vector y lies on them modulo tau^i and tau^(p - i). At conj(c) the conditions are
// conjugate. At a real place with conjugate lines i = p / 2. The vectors of forms y of degrees d -
// e_i with all conditions are the kernel of one real linear system of k rows, 2 p for a pair of
// places and p for a real one. It decides the splitting a of the lattice, the columns of which have
// the degrees m - a, m, m + a, without any test for zero: with m = (e_0 + e_1 + e_2 + k) / 3,
//
//     k rows of full rank in degree m        <=>   a <= 1,  the kernel has dimension 3;
//     Q / g on it is then constant,                g the product of all (t - c)^p:
//         of rank 3                          <=>   a = 0.
//
// TURNING A CHOICE. For each choice a point w of the conics is a section of a ruled surface, of
// self-intersection sigma = d - m, d the degree of the least multiple of w in the lattice. The
// section of least self-intersection has -a, every other one a or more. If w has j conditions on
// the first line of c in the undivided lattice, sigma grows with |i - j|, by one for a real place
// and by two for a pair.
//
// THEOREM. Let w have sigma = -a < 0 for some choice. Turn the choice away from w, step by step,
// until sigma is 0, or -1 when no real place is left to be turned, or all places are turned as far
// as possible. Then a = -sigma is the least splitting of all choices.
//
// Proof. With sigma = 0 or -1, a = 0 or 1. If no real place has two real lines, a keeps its parity.
// If all places are turned away and sigma < 0, then w has no larger sigma for any choice, so -sigma
// is the least a.
//
// COROLLARY. If a place of odd p has irrational lines, a = 0 or a = 1 can be reached. Proof.
// Otherwise w were the only section with sigma < 0 for every choice. Then it is rational, and the
// automorphism that exchanges the two lines gives j = p - j.
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

/// A point P y, y_j of formal degree `degree` - e_j.
struct PointInBalls {
  Vector3<Form<RealBall>> coordinate;
  int degree;
};

/// A choice, and the -sigma that is left.
struct TurnedChoice {
  LineChoice choice;
  int splitting;
};

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
  bool has_real_lines() const;

  /// For a = 0, proved; nothing otherwise.
  std::optional<QuadraticPoints> balanced_points(const LineChoice& choice) const;
  /// For a choice that is known to have this a > 0; nothing when the ranks are not proved.
  std::optional<QuadraticPoints> unbalanced_points(const LineChoice& choice, int splitting) const;

  /// The lowest column of the lattice of a choice with a > 0. The dimension of its kernel, 1, is
  /// not proved, so it may guide a choice only. Throws Undecided.
  PointInBalls lowest_column(const LineChoice& choice) const;

  PointInBalls in_balls(const LatticePoint& point) const;
  /// The choice for which a point without common zeros lies in the lattice. Throws Undecided.
  LineChoice choice_through(const PointInBalls& w) const;
  /// Away from the least multiple w in the lattice of the choice.
  TurnedChoice turned_away(LineChoice choice, const PointInBalls& w) const;

 private:
  using Vector = Vector3<Form<RealBall>>;

  std::optional<std::vector<Vector>> on_lines(const LineChoice& choice, int degree,
                                              std::size_t dimension) const;
  RealBall quotient(const Vector& a, const Vector& b, long t) const;
  Vector point(const Vector& y) const;

  std::vector<LinePair> pairs_;
  long precision_;
  Vector3<int> column_degree_;
  Matrix3<Form<RealBall>> basis_, conic_;
  int rows_ = 0, m_ = 0;
};

}  // namespace pn
