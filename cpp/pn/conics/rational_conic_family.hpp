// SPDX-License-Identifier: LGPL-2.1-or-later
// All points of a family of conics as rational functions of two parameters.
//
// THEOREM. Let C(t) be a symmetric 3x3 matrix over Q[t], det C != 0, whose conics have real points
// for all real t but finitely many. There are forms B_ik over R, all of degree n in t, with
//
//     x(t, u) = B(t) (u0^2, u0 u1, u1^2)^T,      x^T C(t) x = 0 identically,
//
// and for every t where C(t) is regular u runs once through all real points of the conic. The least
// degree is n = m + a, m of conic_family.hpp and a the least splitting of all choices of lines of
// the singular conics (line_conditions.hpp), which is found. If a singular conic of odd multiplicity
// has irrational lines, a = 0, or a = 1 where the parity of the family is odd and no singular conic
// has real lines (nappe_transport.hpp). So it is where the plane is fixed, all types are (0, b) and
// no real singular conic has conjugate lines.
//
// Sources: M. Peternell, dissertation TU Wien 1997, 1.2 to 1.4, for diagonal C by an ansatz of
// degree twice as high as a rule. The method here, without diagonalization: the points form a
// lattice that is determined by its conditions at the zeros of det C, exactly over Q where the
// lines of a singular conic are rational (rational_lattice.hpp) and as a linear system over R
// elsewhere (line_conditions.hpp).
#pragma once

#include <memory>
#include <optional>

#include "pn/algebra/form.hpp"
#include "pn/conics/conic_family.hpp"
#include "pn/conics/line_conditions.hpp"

namespace pn {

class RationalConicFamily {
 public:
  /// Throws GeometryError kNoRealPoints, with the interval, when the conics between two zeros of
  /// det C have no real points.
  explicit RationalConicFamily(const ConicFamily& family);

  /// n.
  int degree() const { return degree_; }
  /// m; degree() is no less.
  int least_degree() const { return least_degree_; }

  /// B_ik, of formal degree n - f_i, enclosed at about this precision. Throws Undecided.
  QuadraticPoints points(long precision) const;
  /// B over Q, if there is one of this degree: no root of an equation was needed, and a constant
  /// conic at the end has a rational point that was found (rational_point_on_conic.hpp).
  const std::optional<Matrix3<Form<Rational>>>& rational_points() const { return rational_points_; }

 private:
  /// Points at the precision that proved the degree, and the lines on which they lie.
  struct PointsInBalls {
    QuadraticPoints points;
    long precision;
    std::vector<ChosenLine> chosen;
  };

  QuadraticPoints points_of_choice(long precision) const;
  QuadraticPoints points_of_constant(long precision) const;
  void choose_irrational_lines(const ConicFamily& family, const SingularConics& singular,
                               RationalSteps steps);
  bool choose_lines_for_lower_degree(const ConicFamily& family, const SingularConics& singular,
                                     const RationalSteps& rational);
  void set_rational_steps(RationalSteps steps);

  std::shared_ptr<const RationalSteps> steps_;
  std::optional<PointsInBalls> in_balls_;
  std::optional<Matrix3<Form<Rational>>> rational_points_;
  int least_degree_, degree_;
};

}  // namespace pn
