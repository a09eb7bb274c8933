// SPDX-License-Identifier: LGPL-2.1-or-later
// The ruled surfaces whose offsets are measured, in millimetres.
#pragma once

#include <array>
#include <vector>

#include "pn/isotropic/envelope_chain.hpp"
#include "pn/shapes/curve.hpp"

namespace pn::bench {

/// Two Bezier directrices of one degree, over [0, 1].
struct BezierRuled {
  std::vector<std::array<double, 3>> first, second;
};

/// Case R1: a bilinear patch over a square of side 10, twisted by 6.
BezierRuled bilinear_patch();

/// Case R2: between two cubics that wind against each other.
BezierRuled cubic_patch();

/// Two C2 cubic B-spline directrices of so many spans: a wavy strip that turns about its middle.
struct SplineRuled {
  BSplineData<3> first, second;
};
SplineRuled strip(int spans);

EnvelopeChain chain_of(const BezierRuled& ruled);
EnvelopeChain chain_of(const SplineRuled& ruled);

}  // namespace pn::bench
