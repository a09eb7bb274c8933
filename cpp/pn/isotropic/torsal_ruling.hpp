// SPDX-License-Identifier: LGPL-2.1-or-later
// Torsal rulings: lines of a ruled surface along which the tangent plane does not turn.
//
// At a torsal ruling t* a', g and g' are dependent, so all points of the ruling but one have the
// same isotropic normal w0. In the parameters (t, u) of the spinor factorization this ruling
// shrinks to the point (t*, u0), n(A(t*) u0) = w0: every curve v = const passes through it.
//
// LEMMA. Let e0 = u0 and e1 be a basis of R^2. With A E, E = ((t - t*) e1, e0), in place of A the
// normal at t* is w0 for all u, <w, a'> and <w, g'> vanish there, and (t - t*) divides numerator
// and denominator of every section. Then the curves v = const cross the ruling at different u, and
// the surface is regular there as elsewhere. The degree of A grows by 1, that of every section
// by 3.
//
// Proof: A E u = (t - t*) u_0 A e1 + u_1 A e0, so at t* the vector w is u_1^2 w0. Near t* the form
// <w, a' + v g'> is (t - t*) times a form in u whose zero moves with v, as long as t* is a simple
// root of the torsion. QED
#pragma once

#include "pn/isotropic/isotropic_hypersurface.hpp"

namespace pn {

/// A E for all torsal rulings of the family, taken one after the other. Throws Undecided when the
/// precision does not suffice.
SpinorMatrix<ComplexBall> pinched_at_torsal_rulings(SpinorMatrix<ComplexBall> spinor,
                                                    const RulingForms<RealBall>& rulings);

}  // namespace pn
