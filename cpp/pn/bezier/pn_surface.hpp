// SPDX-License-Identifier: LGPL-2.1-or-later
// PN surface: what every shape becomes, a section of an isotropic hypersurface with its faces,
// certificate and limits.
//
// A value: offsets share the hypersurface and its control net, so another distance costs only the
// rounding of its poles. All members may be called from several threads.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "pn/bezier/offset_limits.hpp"
#include "pn/bezier/section_source.hpp"
#include "pn/bezier/self_intersection.hpp"

namespace pn {

struct Certificate {
  double deviation;             ///< proven bound [mm] on the distance to the true envelope
  long precision_bits;          ///< working precision that sufficed
  bool exact;                   ///< nothing in the input was fitted or closed up
  std::array<int, 2> bidegree;  ///< of the faces, the largest along and around
  std::size_t poles;            ///< of all faces
  std::vector<std::string> notes;
  /// Distance [mm] of the edges of trimmed faces from the true boundary: measured, not proven; zero
  /// for whole faces.
  double trim_deviation;
};

struct SurfacePoint {
  std::array<double, 3> point;  ///< [mm]
  /// Unit, away from the spine; of the derivatives where no rational one is known, and not a number
  /// where these are dependent.
  std::array<double, 3> normal;
};

class PNSurface {
 public:
  explicit PNSurface(EnvelopeChain chain);
  explicit PNSurface(std::shared_ptr<const SectionSource> source);

  /// The surface at distance() + d [mm], on the side of the normal for d > 0. Throws GeometryError
  /// when d is not finite, or where the offsets are not rational.
  PNSurface offset(double d) const;
  double distance() const { return distance_; }
  /// The surfaces at other distances than zero are rational.
  bool has_offsets() const;

  /// Degree along and around of what the algebra delivers, the same for every offset.
  std::array<int, 2> degree() const;
  /// The distances, counted from distance zero, that have no singular point.
  OffsetRange regular_range() const;
  /// Throws GeometryError: no positive weights, degree above 25, or precision exhausted.
  std::vector<BSplineSurface> faces(Lines lines) const;
  Certificate certificate(Lines lines) const;
  /// Where the even faces cross themselves or each other; none where they were not seen to.
  std::optional<SelfIntersection> self_intersection() const;
  /// Points and normals of the even faces at their parameters, t along and v in [0, 4] around. Face
  /// by face t runs over the spine's parameters; in between it is the spine's own one, except where
  /// the radius changes so quickly that D has odd real roots. Zones at corners have no parameter on
  /// the spine. Across bands v is in [0, 1].
  std::vector<SurfacePoint> evaluate(const std::vector<double>& t,
                                     const std::vector<double>& v) const;

 private:
  struct Shared;
  struct Section;
  std::shared_ptr<const Section> section(Lines lines) const;

  std::shared_ptr<Shared> shared_;
  std::shared_ptr<std::array<std::shared_ptr<const Section>, 2>> sections_;
  double distance_ = 0;
};

}  // namespace pn
