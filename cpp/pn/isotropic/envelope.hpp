// SPDX-License-Identifier: LGPL-2.1-or-later
// Envelopes: the isotropic hypersurface over one span of a family, as a function of the precision.
//
// Whatever carries w, it is found in the same way: a family of circles on the unit sphere, n.axis +
// level = 0, with the roots of its D; of each pair of roots one is chosen (root_choice.hpp), and
// the spinor factorization gives w. The choice is made once and found again at every precision.
#pragma once

#include <complex>
#include <functional>
#include <string>
#include <vector>

#include "pn/isotropic/isotropic_hypersurface.hpp"
#include "pn/isotropic/odd_root_substitution.hpp"

namespace pn {

/// OpenCASCADE's largest degree of a B-spline; most other systems stop earlier.
inline constexpr int kLargestDegree = 25;

/// A family over one span in its local parameter on [0, 1].
struct LocalForms {
  Carrier<RealBall> carrier;
  CircleForms<RealBall> circles;
  DoubleRoots roots;
  bool is_substituted;  ///< the local parameter is not an affine one
};

/// A family over Q in the local parameter.
CircleForms<RealBall> circle_forms(const CircleFamily& circles, const LocalParameter& parameter);

class Envelope {
 public:
  /// `forms` may throw Undecided at a precision that does not suffice. `advice` says what the
  /// user can lower when the degree is too high. Throws GeometryError when
  /// every section exceeds the largest degree.
  Envelope(std::function<LocalForms(long precision)> forms, std::string advice);

  /// The local parameter is not t itself but the s of the substitution, moved to [0, 1].
  bool is_substituted() const { return substituted_; }
  /// The degrees in the local parameter and in u of every section, before lines are chosen.
  int degree() const { return degree_; }
  int degree_around() const { return degree_around_; }
  /// By so much the degree of every section grows with that of the lines: twice for every factor w.
  int degree_per_line() const { return degree_around_; }

  /// Gamma in balls at this working precision. Throws Undecided when it does not suffice.
  IsotropicHypersurface<RealBall> enclosure(long precision) const;

 private:
  void choose_roots(long precision);
  void require_degree(int degree) const;

  std::function<LocalForms(long)> forms_;
  std::string advice_;
  bool substituted_ = false;
  int degree_ = 0, degree_around_ = 0;
  long first_precision_ = 0;  ///< the one at which the roots were chosen
  IsotropicHypersurface<RealBall> first_enclosure_;
  std::vector<std::complex<double>> chosen_roots_;  ///< the upper ones, every copy
};

}  // namespace pn
