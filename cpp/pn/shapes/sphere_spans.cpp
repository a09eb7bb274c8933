// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/shapes/sphere_spans.hpp"

#include <algorithm>
#include <iterator>
#include <sstream>

#include "pn/algebra/parallel.hpp"
#include "pn/algebra/roots.hpp"

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

std::optional<std::array<double, 2>> first_negative_interval(const RationalPolynomial& p) {
  std::vector<double> cuts = {0};
  for (const RealRoot& root : roots_in_unit_interval(p)) cuts.push_back(root.value.midpoint());
  cuts.push_back(1);
  std::sort(cuts.begin(), cuts.end());
  for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
    if (cuts[i] == cuts[i + 1]) continue;
    if (p(Rational::exactly((cuts[i] + cuts[i + 1]) / 2)).sign() < 0) {
      return std::array<double, 2>{cuts[i], cuts[i + 1]};
    }
  }
  return std::nullopt;
}

double parameter(const SphereSpan& span, double local) {
  const double begin = span.begin.to_double();
  return begin + local * (span.end.to_double() - begin);
}

std::string place(const SphereSpan& span, double local) {
  const Rational t = Rational::exactly(local);
  const double w = span.spheres.denominator(t).to_double();
  std::string text = "(";
  for (std::size_t i = 0; i < 3; ++i) {
    text += show(span.spheres.centre[i](t).to_double() / w) + (i < 2 ? ", " : ")");
  }
  return text;
}

std::string interval(const SphereSpan& span, double begin, double end) {
  return "parameters " + show(parameter(span, begin)) + " to " + show(parameter(span, end)) +
         ", near point " + place(span, (begin + end) / 2);
}

std::string show(double value) {
  std::ostringstream text;
  text.precision(6);
  text << value;
  return text.str();
}

}  // namespace pn
