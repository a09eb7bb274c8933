// SPDX-License-Identifier: LGPL-2.1-or-later
// Lattices of points of a family of conics over Q[t], exactly.
//
// A lattice is spanned by three columns P of degrees e; Q = P^T C P divided by the steps done so
// far, a matrix of forms of degrees e_i + e_j + twist. A step replaces it by the points w = P y
// whose y lies on a line l.y = 0, or at the double point of both lines, of the conic Q(c) at a
// place c: an irreducible polynomial or infinity. Every polynomial point of the conics does so for
// some choice of lines, since y^T Q(c) y = 0 there.
//
// The Smith type diag(1, tau^a, tau^b) at c falls: by a line of a double line (rank 1) from
// (0, a, b), divided twice, to (a - 2, b - 2), or from (1, b), divided once, to (1, b - 1), which
// ends at (0, 1); by one of two lines from (0, p) to (0, p - 1); by both from (0, p) to (0, p - 2).
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "pn/algebra/residue_field.hpp"
#include "pn/conics/column_reduction.hpp"
#include "pn/conics/conic_family.hpp"

namespace pn {

/// Nothing: the place at infinity.
using Place = std::optional<RationalPolynomial>;

class RationalLattice {
 public:
  /// All points; P = 1.
  explicit RationalLattice(const ConicFamily& family);

  /// P_ij, of formal degree degree(j) - f_i.
  const Matrix3<RationalPolynomial>& basis() const { return basis_; }
  const Matrix3<RationalPolynomial>& conic() const { return conic_; }
  const Vector3<int>& degree() const { return degree_; }
  const Vector3<int>& row_degree() const { return row_degree_; }  ///< f
  int twist() const { return twist_; }

  /// Q at a place: elements of its residue field.
  Matrix3<RationalPolynomial> at(const Place& place) const;

  /// Onto a line over the residue field; Q is divided `divisions` times. Places at infinity come
  /// last.
  void step_onto_line(const Place& place, const Vector3<RationalPolynomial>& line, int divisions);
  /// Onto the double point of Q(c), which has rank 2; Q is divided twice.
  void step_onto_double_point(const Place& place);

 private:
  void add_multiple(std::size_t column, const RationalPolynomial& factor, std::size_t of);
  void multiply(std::size_t column, const RationalPolynomial& factor);
  void divide(const RationalPolynomial& factor, int times);
  void reduce();
  void make_primitive();
  LeadingTerm leading_term(std::size_t column) const;

  Vector3<int> row_degree_;
  Matrix3<RationalPolynomial> basis_, conic_;
  Vector3<int> degree_;
  int twist_;
};

/// A point of the conics as P y, y without common zeros.
struct LatticePoint {
  Vector3<RationalPolynomial> coordinate;  ///< y_j, of formal degree `degree` - degree(j)
  int degree;                              ///< of P y
};

/// The multiple of a point, polynomial and not zero, that belongs to the lattice.
LatticePoint in_lattice(const RationalLattice& lattice, const Vector3<RationalPolynomial>& point);

/// The two lines of a conic of rank 2 over the residue field, if they are defined there.
std::optional<std::array<Vector3<RationalPolynomial>, 2>> rational_lines(
    const Matrix3<RationalPolynomial>& conic, const ResidueField& field);

/// A place of type (0, p).
struct PlaceLeft {
  Place place;
  int multiplicity;  ///< p
};

/// What the steps over Q lead to.
struct RationalSteps {
  RationalLattice lattice;
  std::vector<PlaceLeft> left;
  int choices = 0;        ///< of one of two rational lines
  int double_points = 0;  ///< steps onto the double point of two irrational lines
};

/// What the steps leave: one condition where two lines are irrational and p is odd, since both at
/// once are rational; or all p conditions of each place, for a choice at each of its zeros.
enum class Leave { kOddIrrational, kEveryChoice };

/// `choose` gets both lattices that rational lines lead to and returns 0 or 1.
using ChooseLattice = std::function<int(const RationalLattice&, const RationalLattice&)>;

/// All steps over Q.
RationalSteps rational_steps(const ConicFamily& family, const SingularConics& singular,
                             const ChooseLattice& choose, Leave leave);

}  // namespace pn
