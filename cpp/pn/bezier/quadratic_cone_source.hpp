// SPDX-License-Identifier: LGPL-2.1-or-later
// Envelopes of quadratic cones as faces.
//
// The envelope is infinite in general: a contact curve reaches infinity where the weight of Z(t, u)
// of quadratic_cone_envelope.hpp vanishes, a polynomial of degree 4 in u. So a part of every
// contact curve is taken, between two generators u = const. Its patches are halved until their
// weights are positive; where they never are, a contact curve of the part reaches infinity and the
// part is refused.
//
// Unit normals are not rational in general, so there are no sections but the one at distance zero.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "pn/bezier/exact_patch.hpp"
#include "pn/conics/quadratic_cones.hpp"

namespace pn {

/// Points [mm] near the contact curve of the cone at t = 1/2: the part begins at the generator that
/// touches the envelope nearest to the first, passes the second and ends at the third. Generators
/// are rounded to 24 bits, so the surface may end a trifle before a point or behind it.
using ContactArc = std::array<std::array<double, 3>, 3>;

class QuadraticConeSource : public PatchSource {
 public:
  /// Of the cones for t in [0, 1], along the arc, or once around all generators. Throws
  /// GeometryError: kNoRealPoints with the interval where cones have no real generators,
  /// kZeroLength for one common vertex, kDevelopable when the envelope is a curve, kDegreeTooHigh,
  /// kRegionUnbounded where a contact curve reaches infinity.
  explicit QuadraticConeSource(const QuadraticCones& cones,
                               const std::optional<ContactArc>& arc = std::nullopt,
                               std::vector<std::string> notes = {});

  bool has_offsets() const override { return false; }
  OffsetRange regular_range() const override { return {0, 0, {}, {}}; }
};

}  // namespace pn
