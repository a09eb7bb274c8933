// SPDX-License-Identifier: LGPL-2.1-or-later
// Contact circles: where the spheres of a curve touch their envelope, circle by circle.
//
// The circles have a rational spinor A(s) in a local parameter s over [0, 1], which is the
// parameter t of the curve itself unless D has real roots of odd multiplicity beyond the ends
// (odd_root_substitution.hpp): then s is a root of a rational function of t.
#pragma once

#include <memory>

#include "pn/isotropic/along_curve.hpp"

namespace pn {

class ContactCircles {
 public:
  /// D > 0 on [0, 1].
  explicit ContactCircles(const SphereCurve& curve);

  const Envelope& envelope() const { return envelope_; }
  /// A(s), enclosed at the least precision.
  const SpinorMatrix<ComplexBall>& spinor() const { return spinor_; }
  /// s of t.
  double parameter(double t) const;

 private:
  ContactCircles(const SphereCurve& curve, const CircleFamily& circles);

  Envelope envelope_;
  SpinorMatrix<ComplexBall> spinor_;
  std::shared_ptr<const LocalParameter> parameter_;
};

}  // namespace pn
