// SPDX-License-Identifier: LGPL-2.1-or-later
// Geometry errors: a closed set of reasons, each with a sentence for the user.
#pragma once

#include <stdexcept>
#include <string>

namespace pn {

enum class ErrorCode {
  kNotFinite,           ///< a number is NaN or infinite
  kOutOfRange,          ///< a number is neither zero nor of a size between 1e-100 and 1e+100
  kWrongShape,          ///< arrays of the wrong size, too few poles, a degree below 1
  kBadKnots,            ///< knots not increasing, multiplicities that do not fit
  kNotATriangulation,   ///< triangles that run clockwise, overlap, or meet in parts of edges
  kNonPositiveWeight,   ///< a weight is zero or negative
  kGap,                 ///< a curve or a law jumps
  kZeroLength,          ///< a span along which nothing moves
  kDomainMismatch,      ///< spine and radius are not defined over the same parameters
  kNegativeRadius,      ///< the radius is negative somewhere
  kRadiusTooSteep,      ///< |r'| > |m'| somewhere: no envelope there
  kDevelopable,         ///< |r'| = |m'| identically: the envelope is a curve
  kPinched,             ///< |r'| = |m'| at a parameter: the envelope shrinks to a point there; or a
                        ///< ruled surface has a pinch point
  kCornerTooSharp,      ///< the circles on both sides of a corner cannot be joined
  kDegreeTooHigh,       ///< the result would exceed degree 25
  kWeightsNotPositive,  ///< no patch with positive weights was found
  kBadAxis,             ///< a half-axis is not positive, or an axis has no direction
  kBadBounds,           ///< bounds that are empty or inverted
  kRegionEmpty,         ///< the bounds miss the surface
  kRegionUnbounded,     ///< the surface is infinite and the bounds do not end it
  kRegionUnsupported,   ///< a region that no few faces cover
  kNotRational,         ///< the offset is known not to be rational
  kIdenticalCurves,     ///< both curves of a ruled surface are one
  kCurvesMeet,          ///< a ruling has no length
  kGrazingLight,        ///< light runs along a mirror everywhere
  kLightOnMirror,       ///< a light source is on the mirror
  kSingularConics,      ///< all conics of a family are pairs of lines
  kNoRealPoints,        ///< a conic of a family has no real points
  kPrecisionExhausted,  ///< something could not be proved at the highest precision
};

/// The name of a code as Python and JSON show it, such as "negative_radius".
std::string to_string(ErrorCode code);

class GeometryError : public std::invalid_argument {
 public:
  GeometryError(ErrorCode code, const std::string& sentence)
      : std::invalid_argument(sentence), code_(code) {}
  ErrorCode code() const { return code_; }

 private:
  ErrorCode code_;
};

}  // namespace pn
