// SPDX-License-Identifier: LGPL-2.1-or-later
// Section nets: the control points of all offsets at once, proved, and their rounding to doubles.
//
// Every section of Gamma has the same weights and parameters, and its control points are linear in
// the distance: x_d = P + d V with weights w, where P, V, w are balls. A section is rounded to the
// nearest doubles, once every number is known to within one unit in its last place.
//
// THEOREM (certificate). Let the exported surface have poles P^ and weights w^ = w (1 + e), |e| <=
// eps < 1, |P^ - P| <= delta, over the knots of the true one. At the same parameters the two
// surfaces differ by at most delta + eps / (1 - eps) diam / 2, where diam bounds the distance of
// any two true poles that are active on one knot span. Proof: x^ - x = sum l^ (P^ - P) + sum (w^ -
// w) B (P - x) / sum w^ B, with l^ >= 0 of sum 1. The first sum is at most delta. The second is sum
// l e (P - x) times sum w B / sum w^ B <= 1 / (1 - eps), with l = w B / sum w B; along any
// direction it is at most eps times the mean deviation of the P from their mean x, which is at most
// half of what they spread over.
//
// The bound is on the distance between corresponding points, so it also bounds the distance of the
// exported surface to the true envelope. It covers all rounding on export; the balls cover all
// before.
#pragma once

#include <array>
#include <utility>
#include <vector>

#include "pn/algebra/ball.hpp"
#include "pn/bezier/bspline_surface.hpp"

namespace pn {

/// A control point of all sections: pole P + d V of this weight.
struct NetPole {
  std::array<RealBall, 3> point;      ///< P [mm]
  std::array<RealBall, 3> direction;  ///< V; zero where normals are not rational
  RealBall weight;
};

/// One exported face: knots and control points, row by row along the spine.
struct FaceNet {
  BSplineSurface frame;        ///< knots and degrees; no poles yet
  bool stands_still;           ///< a zone of a sphere: its first parameter is not the spine's
  std::vector<NetPole> poles;  ///< row-major, as in BSplineSurface
  /// The face's own first and last row where a neighbour's row replaces it, else empty.
  std::vector<NetPole> replaced_first, replaced_last;
};

struct RoundedFace {
  BSplineSurface surface;
  double deviation;  ///< the theorem's bound [mm]
};

/// Some weight is negative, or so small that it is as good as zero. Throws Undecided when the
/// precision does not suffice.
bool has_bad_weight(const FaceNet& face);

class SectionNet {
 public:
  SectionNet(std::vector<FaceNet> faces, long precision)
      : faces_(std::move(faces)), precision_(precision) {}

  /// The faces at distance d [mm]. Throws Undecided when some number is not known to within one
  /// unit in its last place.
  std::vector<RoundedFace> section(double distance) const;
  /// Normals are rational.
  bool has_normals() const;
  /// The faces of (w1, w2, w3) / w4 over the same knots: unit normals, in doubles, as estimates.
  std::vector<BSplineSurface> normals() const;

  const std::vector<FaceNet>& faces() const { return faces_; }
  long precision() const { return precision_; }

 protected:
  std::vector<FaceNet> faces_;

 private:
  long precision_;
};

}  // namespace pn
