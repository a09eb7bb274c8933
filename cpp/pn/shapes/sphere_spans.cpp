// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/shapes/sphere_spans.hpp"

#include <algorithm>
#include <iterator>
#include <sstream>

#include "pn/algebra/parallel.hpp"

namespace pn {
namespace {

/// The part of a function over [begin, end], which lies within one of its spans.
template <std::size_t Dimension>
RationalSpan<Dimension> restricted(const PiecewiseRational<Dimension>& function,
                                   const Rational& begin, const Rational& end) {
  const auto after = std::upper_bound(function.breaks.begin(), function.breaks.end(), begin);
  const auto index = static_cast<std::size_t>(after - function.breaks.begin()) - 1;
  const Rational& first = function.breaks[index];
  const Rational length = function.breaks[index + 1] - first;
  RationalSpan<Dimension> span = function.spans[index];
  if (first == begin && function.breaks[index + 1] == end) return span;
  const Rational origin = (begin - first) / length, part = (end - begin) / length;
  for (RationalPolynomial& p : span.numerator) p = p.on_interval(origin, part);
  span.denominator = span.denominator.on_interval(origin, part);
  return span;
}

struct RestrictedSpan {
  RationalSpan<3> curve;
  RationalSpan<1> law;
};

SphereCurve sphere_curve(const RestrictedSpan& span, bool same_weights) {
  const RationalPolynomial& q = span.curve.denominator;
  if (same_weights) return {span.curve.numerator, span.law.numerator[0], q};
  const RationalPolynomial& p = span.law.denominator;
  return {{span.curve.numerator[0] * p, span.curve.numerator[1] * p, span.curve.numerator[2] * p},
          span.law.numerator[0] * q,
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
  std::vector<RestrictedSpan> parts(breaks.size() - 1);
  for_each_index(parts.size(), [&](std::size_t i) {
    parts[i] = {restricted(centre, breaks[i], breaks[i + 1]),
                restricted(radius, breaks[i], breaks[i + 1])};
  });
  const bool same_weights = std::all_of(parts.begin(), parts.end(), [](const RestrictedSpan& part) {
    return part.curve.denominator == part.law.denominator;
  });
  std::vector<SphereSpan> spans(parts.size());
  for_each_index(spans.size(), [&](std::size_t i) {
    spans[i] = {sphere_curve(parts[i], same_weights), breaks[i], breaks[i + 1]};
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
