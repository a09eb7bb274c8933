// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/geometry_error.hpp"

namespace pn {

std::string to_string(ErrorCode code) {
  switch (code) {
    case ErrorCode::kNotFinite:
      return "not_finite";
    case ErrorCode::kOutOfRange:
      return "out_of_range";
    case ErrorCode::kWrongShape:
      return "wrong_shape";
    case ErrorCode::kBadKnots:
      return "bad_knots";
    case ErrorCode::kNotATriangulation:
      return "not_a_triangulation";
    case ErrorCode::kNonPositiveWeight:
      return "non_positive_weight";
    case ErrorCode::kGap:
      return "gap";
    case ErrorCode::kZeroLength:
      return "zero_length";
    case ErrorCode::kDomainMismatch:
      return "domain_mismatch";
    case ErrorCode::kNegativeRadius:
      return "negative_radius";
    case ErrorCode::kRadiusTooSteep:
      return "radius_too_steep";
    case ErrorCode::kDevelopable:
      return "developable";
    case ErrorCode::kPinched:
      return "pinched";
    case ErrorCode::kCornerTooSharp:
      return "corner_too_sharp";
    case ErrorCode::kDegreeTooHigh:
      return "degree_too_high";
    case ErrorCode::kWeightsNotPositive:
      return "weights_not_positive";
    case ErrorCode::kBadAxis:
      return "bad_axis";
    case ErrorCode::kBadBounds:
      return "bad_bounds";
    case ErrorCode::kRegionEmpty:
      return "region_empty";
    case ErrorCode::kRegionUnbounded:
      return "region_unbounded";
    case ErrorCode::kRegionUnsupported:
      return "region_unsupported";
    case ErrorCode::kNotRational:
      return "not_rational";
    case ErrorCode::kIdenticalCurves:
      return "identical_curves";
    case ErrorCode::kCurvesMeet:
      return "curves_meet";
    case ErrorCode::kGrazingLight:
      return "grazing_light";
    case ErrorCode::kLightOnMirror:
      return "light_on_mirror";
    case ErrorCode::kSingularConics:
      return "singular_conics";
    case ErrorCode::kNoRealPoints:
      return "no_real_points";
    case ErrorCode::kPrecisionExhausted:
      return "precision_exhausted";
  }
  throw std::logic_error("an error code without a name");
}

}  // namespace pn
