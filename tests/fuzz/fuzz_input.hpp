// SPDX-License-Identifier: LGPL-2.1-or-later
// Inputs of a designer from the bytes of a fuzzer.
//
// Nearly every byte string is a valid call, else a fuzzer would see little but the first check.
// Most numbers are one byte, a quarter of a small integer, so that equal points, parallel lines and
// double roots are common; a few are any double, NaN and infinity included. Sizes are bounded: what
// takes long because it is large tells nothing. After the last byte all are zero.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "pn/algebra/rational_polynomial.hpp"
#include "pn/shapes/curve.hpp"
#include "pn/shapes/spline_surface.hpp"

namespace pn::fuzz {

/// Of the splines: their largest degree, and the largest number of spans.
struct SplineSize {
  int degree, spans;
};

class FuzzInput {
 public:
  FuzzInput(const std::uint8_t* data, std::size_t size) : next_(data), end_(data + size) {}

  std::uint8_t byte() { return next_ == end_ ? std::uint8_t{0} : *next_++; }
  /// From 0 to below `count`.
  int choice(int count) { return byte() % count; }
  bool flag() { return choice(2) == 1; }
  /// Once in 64 bytes: for what makes an input invalid.
  bool seldom() { return byte() >= 252; }
  double number();

  template <std::size_t Dimension>
  std::array<double, Dimension> point() {
    std::array<double, Dimension> result;
    for (double& x : result) x = number();
    return result;
  }

  /// A point near another one.
  template <std::size_t Dimension>
  std::array<double, Dimension> point_near(std::array<double, Dimension> centre) {
    for (double& x : centre) x += number() / 8;
    return centre;
  }

  std::vector<double> numbers(std::size_t count);

  /// Often closed, sometimes rational, seldom no spline at all.
  template <std::size_t Dimension>
  BSplineData<Dimension> bspline(const SplineSize& size);

  SplineSurfaceData spline_surface(const SplineSize& size);

  Curve curve(const SplineSize& size) { return Curve::bspline(bspline<3>(size)); }
  SphereSpline sphere_spline(const SplineSize& size);
  /// Constant, or a Bezier function over [0, 1], or a spline.
  Law law(const SplineSize& size);

  /// By Bernstein coefficients. Throws GeometryError: kNotFinite.
  RationalPolynomial polynomial(int degree);
  template <std::size_t Size>
  std::array<std::array<RationalPolynomial, Size>, Size> symmetric_matrix(int degree) {
    std::array<std::array<RationalPolynomial, Size>, Size> result;
    for (std::size_t i = 0; i < Size; ++i) {
      for (std::size_t j = 0; j <= i; ++j) result[i][j] = result[j][i] = polynomial(degree);
    }
    return result;
  }
  template <std::size_t Size>
  std::array<RationalPolynomial, Size> polynomials(int degree) {
    std::array<RationalPolynomial, Size> result;
    for (RationalPolynomial& p : result) p = polynomial(degree);
    return result;
  }

 private:
  /// Any eight bytes.
  double bits();

  const std::uint8_t *next_, *end_;
};

}  // namespace pn::fuzz
