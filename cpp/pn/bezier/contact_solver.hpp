// SPDX-License-Identifier: LGPL-2.1-or-later
// Contact solver: the parameters of a chart at which a / e = u and b / e = v, by Newton's method.
//
// In doubles: it locates edges in the parameter plane. On the unit square polynomials are written
// around its middle, where the rounding of their terms is least.
#pragma once

#include <array>

#include "pn/isotropic/along_surface.hpp"

namespace pn {

class ContactSolver {
 public:
  /// Polynomials up to a common factor, on the unit square.
  explicit ContactSolver(const Contact<Rational>& contact);
  explicit ContactSolver(const Contact<RealBall>& contact);

  /// The solution near `start`; not finite where none is near.
  std::array<double, 2> solution(const std::array<double, 2>& uv,
                                 const std::array<double, 2>& start) const;

 private:
  struct Jet {
    TensorPolynomial<double> value, by_u, by_v;
    explicit Jet(const TensorPolynomial<double>& p)
        : value(p), by_u(p.derivative(Variable::kU)), by_v(p.derivative(Variable::kV)) {}
  };
  explicit ContactSolver(const Contact<double>& centred);

  Jet a_, b_, e_;  ///< in 2 p - 1, 2 q - 1
};

}  // namespace pn
