// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/shapes/sphere_spans.hpp"

#include <algorithm>
#include <iterator>
#include <sstream>

#include "pn/algebra/parallel.hpp"

namespace pn {
namespace {

SphereCurve sphere_curve(const RationalSpan<3>& curve, const RationalSpan<1>& law,
                         bool same_weights) {
  const RationalPolynomial& q = curve.denominator;
  if (same_weights) return {curve.numerator, law.numerator[0], q};
  const RationalPolynomial& p = law.denominator;
  return {{curve.numerator[0] * p, curve.numerator[1] * p, curve.numerator[2] * p},
          law.numerator[0] * q,
          q * p};
}

bool agree(const RationalPolynomial& left, const RationalPolynomial& right,
           const Rational& left_length, const Rational& right_length, int order) {
  const Rational one(1), zero(0);
  RationalPolynomial a = left, b = right;
  Rational a_scale(1), b_scale(1);
  for (int i = 0; i <= order; ++i) {
    if (a(one) * b_scale != b(zero) * a_scale) return false;
    a = a.derivative();
    b = b.derivative();
    a_scale *= left_length;
    b_scale *= right_length;
  }
  return true;
}

}  // namespace

std::vector<Rational> united_breaks(const std::vector<Rational>& a,
                                    const std::vector<Rational>& b) {
  std::vector<Rational> all;
  std::set_union(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(all));
  return all;
}

std::vector<SphereSpan> sphere_spans(const Curve& curve, const Law& law,
                                     const std::vector<Rational>& more) {
  const PiecewiseRational<3>& centre = curve.function();
  const PiecewiseRational<1> radius = law.over(centre.breaks.front(), centre.breaks.back());
  const std::vector<Rational> breaks =
      united_breaks(united_breaks(centre.breaks, radius.breaks), more);
  const std::vector<RationalSpan<3>> centres = refined(centre, breaks).spans;
  const std::vector<RationalSpan<1>> radii = refined(radius, breaks).spans;
  const bool same_weights =
      std::equal(centres.begin(), centres.end(), radii.begin(),
                 [](const auto& a, const auto& b) { return a.denominator == b.denominator; });
  std::vector<SphereSpan> spans(centres.size());
  for_each_index(spans.size(), [&](std::size_t i) {
    spans[i] = {sphere_curve(centres[i], radii[i], same_weights), breaks[i], breaks[i + 1]};
  });
  return spans;
}

bool meets(const SphereSpan& left, const SphereSpan& right, int order) {
  const Rational a = left.end - left.begin, b = right.end - right.begin;
  const auto equal = [&](const RationalPolynomial& p, const RationalPolynomial& q) {
    return agree(p, q, a, b, order);
  };
  return equal(left.spheres.denominator, right.spheres.denominator) &&
         equal(left.spheres.radius, right.spheres.radius) &&
         std::equal(left.spheres.centre.begin(), left.spheres.centre.end(),
                    right.spheres.centre.begin(), equal);
}

std::string show(double value) {
  std::ostringstream text;
  text.precision(6);
  text << value;
  return text.str();
}

}  // namespace pn
