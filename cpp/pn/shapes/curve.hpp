// SPDX-License-Identifier: LGPL-2.1-or-later
// Spines, radius laws, curves of spheres: piecewise rational functions of a designer's doubles,
// over Q.
//
// A curve is a chain of spans. Each span is a rational function of a local parameter on [0, 1],
// exact: the B-spline's Bezier points are found by blossoming over Q (L. Ramshaw, Blossoms are
// polar forms, CAGD 6, 1989), so no knot is inserted in floating point. Degrees are those the data
// really have.
#pragma once

#include <array>
#include <vector>

#include "pn/algebra/rational_polynomial.hpp"

namespace pn {

/// A rational function of Dimension components on one span, in the local parameter on [0, 1].
template <std::size_t Dimension>
struct RationalSpan {
  std::array<RationalPolynomial, Dimension> numerator;
  RationalPolynomial denominator;  ///< positive on [0, 1]
};

/// One ends at the very point where the other begins.
template <std::size_t Dimension>
bool joins(const RationalSpan<Dimension>& left, const RationalSpan<Dimension>& right);

/// A continuous piecewise rational function; span i lies over [breaks[i], breaks[i + 1]].
template <std::size_t Dimension>
struct PiecewiseRational {
  std::vector<Rational> breaks;  ///< strictly increasing
  std::vector<RationalSpan<Dimension>> spans;
};

/// The same function over more breaks: `breaks`, ascending, has the same ends and all of its own.
template <std::size_t Dimension>
PiecewiseRational<Dimension> refined(const PiecewiseRational<Dimension>& function,
                                     const std::vector<Rational>& breaks);

/// A smaller turn [rad] where spans of a spine join is the rounding of the poles next to the joint,
/// a few hundred units in the last place of their chord.
inline constexpr double kRoundingAngle = 1e-13;

/// The data of a clamped B-spline, as OpenCASCADE and STEP give them: strictly increasing knots
/// with multiplicities, the first and the last degree + 1; as many weights as poles, or none.
template <std::size_t Dimension>
struct BSplineData {
  int degree = 0;
  std::vector<double> knots;
  std::vector<int> multiplicities;
  std::vector<std::array<double, Dimension>> poles;
  std::vector<double> weights;
};

/// A spine: a curve in space, in millimetres.
class Curve {
 public:
  /// k + 1 poles, k >= 1; positive weights or none. Throws GeometryError.
  static Curve bezier(const std::vector<std::array<double, 3>>& poles,
                      const std::vector<double>& weights = {});
  static Curve bspline(const BSplineData<3>& data);
  /// The curves end to end, each over an interval of its own length, the first where it lies. Each
  /// must begin at the very point where the one before ends.
  static Curve chain(const std::vector<Curve>& curves);

  const PiecewiseRational<3>& function() const { return function_; }
  /// The largest degree of a span.
  int degree() const;

 private:
  explicit Curve(PiecewiseRational<3> function) : function_(std::move(function)) {}
  PiecewiseRational<3> function_;
};

/// A radius law, in millimetres over the parameter of a spine.
class Law {
 public:
  /// The same value for every parameter; fits a spine of any domain.
  static Law constant(double value);
  static Law bezier(const std::vector<double>& coefficients,
                    const std::vector<double>& weights = {});
  static Law bspline(const BSplineData<1>& data);

  /// The law over the domain of a spine. Throws GeometryError when it is defined elsewhere.
  PiecewiseRational<1> over(const Rational& begin, const Rational& end) const;

 private:
  explicit Law(PiecewiseRational<1> function) : function_(std::move(function)) {}
  PiecewiseRational<1> function_;
  bool fits_any_domain_ = false;
};

/// A curve of spheres (x, y, z, r), in millimetres.
class SphereSpline {
 public:
  /// k + 1 spheres, k >= 1, over [0, 1]. Throws GeometryError.
  static SphereSpline bezier(const std::vector<std::array<double, 4>>& spheres);
  static SphereSpline bspline(const BSplineData<4>& data);

  const PiecewiseRational<4>& function() const { return function_; }

 private:
  explicit SphereSpline(PiecewiseRational<4> function) : function_(std::move(function)) {}
  PiecewiseRational<4> function_;
};

}  // namespace pn
