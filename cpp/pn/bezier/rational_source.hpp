// SPDX-License-Identifier: LGPL-2.1-or-later
// Surfaces of rational sections: PN surfaces over Q up to one square root, as faces.
//
// Every patch is a face where its weights are even enough, else it is halved until they are: the
// halves meet along a parameter line of the whole.
//
// THEOREM. Let x_d = (X + d V) / W have the normal V, primitive up to the factor c, and
//
//     N(X) = W X_u x X_v + W_u X_v x X + W_v X x X_u.
//
// Then N(X + d V) = (l0 + l1 d + l2 d^2) V / c with polynomials l, and for l0 > 0 no section from 0
// to d > 0 is singular exactly where l0 + l1 d + l2 d^2 > 0 and 2 l0 + l1 d > 0. Proof: N / W^3 is
// x_u x x_v, all sections have the normal V, and N is quadratic in X. So l0 + l1 d + l2 d^2 = l0 (1
// - d k1) (1 - d k2) with the principal curvatures k1, k2 of the section 0, and by theorem 1 of
// curvature_limits.hpp both factors are positive up to d exactly when their product and sum are.
// QED. Their degrees are (2 m - 2, 2 n - 2) for sections of bidegree (m, n), far below those of the
// theorem that holds for all surfaces.
#pragma once

#include <string>
#include <vector>

#include "pn/bezier/exact_patch.hpp"
#include "pn/isotropic/rational_sections.hpp"

namespace pn {

/// Parts of the patches with positive weights that differ by a moderate factor. Throws
/// GeometryError (kDegreeTooHigh, kWeightsNotPositive).
std::vector<RationalSections> evenly_weighted(const std::vector<RationalSections>& patches);

class RationalSource : public PatchSource {
 public:
  /// The limits of regular offsets are looked for on both sides of `base` [mm]. Throws
  /// GeometryError as evenly_weighted does.
  RationalSource(const std::vector<RationalSections>& patches, double base,
                 std::vector<std::string> notes);

  bool has_offsets() const override { return has_offsets_; }
  /// The certified range around the base, which need not contain zero: {base, base} where the
  /// section at the base is singular; {0, 0} where there are no offsets.
  OffsetRange regular_range() const override;

 private:
  RationalSource(std::vector<RationalSections> parts, double base, std::vector<std::string> notes,
                 bool has_offsets);

  std::vector<RationalSections> parts_;
  double base_;
  bool has_offsets_;
};

}  // namespace pn
