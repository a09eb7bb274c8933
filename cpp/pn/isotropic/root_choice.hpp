// SPDX-License-Identifier: LGPL-2.1-or-later
// The choice of roots: which root of each conjugate pair of D the spinor factorization takes.
//
// Replacing a root by its conjugate multiplies A by a real linear factor of u over t - c: the
// circles stay, the lines u = const and the degree change. A suitable choice reaches the least
// degree, larger column ceil(h/2) when D has no real zero (spinor_factorization.hpp). The search
// compares all choices in doubles when there are few, else descends from neighbour to neighbour:
// lowest degree first, then the least twist of the lines (seam.hpp). Any choice gives an exact
// surface, so nothing here needs proof.
#pragma once

#include <complex>
#include <vector>

#include "pn/isotropic/isotropic_hypersurface.hpp"
#include "pn/isotropic/odd_root_substitution.hpp"

namespace pn {

/// For every pair of DoubleRoots the number of copies of the upper root; the rest are of the lower
/// one.
using RootChoice = std::vector<int>;

/// H = R + M.sigma for a circle family.
HermitianMatrix<ComplexBall> hermitian_matrix(const CircleForms<RealBall>& circles);

/// The half of the roots of D that a choice stands for.
HalfRoots<ComplexBall> half_roots(const DoubleRoots& roots, const RootChoice& choice);

/// The best choice that the search finds.
RootChoice best_root_choice(const CircleForms<RealBall>& circles, const DoubleRoots& roots);

/// A choice remembered by the places of its complex roots: the pairs, isolated anew at another
/// precision, are recognised by them.
RootChoice recognized(const DoubleRoots& roots, const std::vector<std::complex<double>>& chosen);

}  // namespace pn
