// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/shapes/ruled_surface.hpp"

#include <algorithm>

#include "pn/algebra/parallel.hpp"
#include "pn/algebra/roots.hpp"
#include "pn/geometry_error.hpp"
#include "pn/isotropic/along_rulings.hpp"
#include "pn/isotropic/developable.hpp"
#include "pn/shapes/quadric_patches.hpp"
#include "pn/shapes/sphere_spans.hpp"

namespace pn {
namespace {

/// A span of the surface with its rulings.
struct Span {
  std::array<SphereSpan, 2> directrices;
  JoinedRulings joined;
  Rulings rulings;  ///< with least denominator, at the scale at which they continue those before
  RulingNormal normal;           ///< of the joined rulings
  std::vector<RealRoot> torsal;  ///< rulings on [0, 1], where the span is not developable

  const Rational& begin() const { return directrices[0].begin; }
  const Rational& end() const { return directrices[0].end; }
};

bool is_developable(const Span& span) { return span.normal.torsion.is_zero(); }

double parameter(const Span& span, double local) {
  const double begin = span.begin().to_double();
  return begin + local * (span.end().to_double() - begin);
}

std::string interval(const Span& span) {
  return "parameters " + show(parameter(span, 0)) + " to " + show(parameter(span, 1));
}

/// The breaks of one curve in the parameter of another, its domain mapped affinely.
std::vector<Rational> mapped(const std::vector<Rational>& breaks, const std::vector<Rational>& to) {
  const Rational scale = (to.back() - to.front()) / (breaks.back() - breaks.front());
  std::vector<Rational> result;
  for (const Rational& b : breaks) result.push_back(to.front() + (b - breaks.front()) * scale);
  return result;
}

bool is_point(const SphereCurve& c) { return tangent_direction(c).content.is_zero(); }

void require_length(const Span& span) {
  for (const SphereSpan& directrix : span.directrices) {
    if (!is_point(directrix.spheres)) continue;
    throw GeometryError(ErrorCode::kZeroLength, "One of the curves stands still at " +
                                                    interval(span) +
                                                    ": all rulings there pass through one point.");
  }
  const RationalPolynomial& content = span.joined.content;
  if (content.is_zero()) {
    throw GeometryError(
        ErrorCode::kIdenticalCurves,
        "Both curves are the same at " + interval(span) + ": there are no rulings between them.");
  }
  const std::vector<RealRoot> meetings = roots_in_unit_interval(content);
  if (meetings.empty()) return;
  throw GeometryError(ErrorCode::kCurvesMeet,
                      "The curves meet at parameter " +
                          show(parameter(span, meetings.front().value.midpoint())) +
                          ": the ruling there has no length. Shorten the curves a little.");
}

/// All spheres are points: the surface itself is a ruled one.
bool is_line_family(const Span& span) {
  return span.directrices[0].spheres.radius.is_zero() &&
         span.directrices[1].spheres.radius.is_zero();
}

using Vector4 = std::array<RationalPolynomial, 4>;

RationalPolynomial minkowski(const Vector4& a, const Vector4& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2] - a[3] * b[3];
}

Vector4 vector_of(const CircleFamily& g) { return {g.axis[0], g.axis[1], g.axis[2], -g.level}; }

/// <g, g> <a', b'> - <g, a'> <g, b'> for two directrices, up to positive factors.
RationalPolynomial contact_product(const SphereCurve& a, const SphereCurve& b,
                                   const CircleFamily& direction) {
  const TangentDirection first = tangent_direction(a), second = tangent_direction(b);
  const Vector4 g = vector_of(direction), p = vector_of(first.circles),
                q = vector_of(second.circles);
  return first.content * second.content *
         (minkowski(g, g) * minkowski(p, q) - minkowski(g, p) * minkowski(g, q));
}

/// Positive where a sphere of a directrix touches the envelope.
RationalPolynomial contact_discriminant(const SphereCurve& directrix, const CircleFamily& g) {
  return contact_product(directrix, directrix, g);
}

void require_cones(const Span& span) {
  const CircleFamily& direction = span.joined.rulings.direction;
  if (!is_positive_on_unit_interval(direction.discriminant())) {
    throw GeometryError(ErrorCode::kRadiusTooSteep,
                        "At " + interval(span) +
                            " one of two spheres lies inside the other or touches it from within: "
                            "they have no common cone. Let the radii differ less or move the "
                            "centres apart.");
  }
  if (is_line_family(span)) return;
  for (const SphereSpan& directrix : span.directrices) {
    if (is_positive_on_unit_interval(contact_discriminant(directrix.spheres, direction))) continue;
    throw GeometryError(ErrorCode::kRadiusTooSteep,
                        "At " + interval(span) +
                            " the cones grow faster than they move: they have no envelope there. "
                            "Let the radii change more slowly.");
  }
}

void require_simple_torsal_rulings(const Span& span) {
  for (const RealRoot& torsal : span.torsal) {
    if (torsal.multiplicity == 1) continue;
    throw GeometryError(
        ErrorCode::kDevelopable,
        "The surface is developable to second order along the ruling at parameter " +
            show(parameter(span, torsal.value.midpoint())) + ". Move one of the curves a little.");
  }
}

/// A torsal ruling has one point without a tangent plane, its pinch point. The tangent planes at
/// the directrices have the same normal if it is beyond them, opposite ones if it is between.
void require_no_pinch_points(const Span& span) {
  if (!is_line_family(span)) return;
  const auto& [first, second] = span.directrices;
  const std::vector<RealRoot> pinched = roots_in_unit_interval_without_positive(
      span.normal.torsion,
      contact_product(first.spheres, second.spheres, span.joined.rulings.direction));
  if (pinched.empty()) return;
  throw GeometryError(ErrorCode::kPinched,
                      "The surface has a pinch point on the ruling at parameter " +
                          show(parameter(span, pinched.front().value.midpoint())) +
                          ", without a tangent plane. Shorten the curves, or move one of them so "
                          "that the curves run in the same direction there.");
}

SpanPlace place_of(const std::vector<Span>& spans, std::size_t i, bool closed) {
  return {spans[i].end() - spans[i].begin(), i > 0 || closed, i + 1 < spans.size() || closed};
}

GeometryError not_rational(const Span& span) {
  return {ErrorCode::kDevelopable,
          "The surface is developable at " + interval(span) +
              ": its tangent planes are the same all along each ruling, and its offset is not "
              "rational. Planes, cylinders and cones of revolution and parabolic cylinders are "
              "exact."};
}

void require_regular_rulings(const Span& span) {
  if (is_developable(span)) return;
  require_simple_torsal_rulings(span);
  require_no_pinch_points(span);
}

/// The parameters of the torsal rulings that count on a span, ascending.
std::vector<double> torsal_parameters(const Span& span, const SpanPlace& place) {
  if (is_developable(span)) return {};
  const auto [low, high] = torsal_range(place);
  const RationalPolynomial in_range = torsal_polynomial(span.normal).on_interval(low, high - low);
  std::vector<double> parameters;
  for (const RealRoot& root : roots_in_unit_interval(in_range)) {
    const double local = low.to_double() + root.value.midpoint() * (high - low).to_double();
    parameters.push_back(parameter(span, local));
  }
  std::sort(parameters.begin(), parameters.end());
  return parameters;
}

/// Each torsal ruling raises the degree, so a span has one at most: doubles between them.
std::vector<Rational> cuts_between_torsal_rulings(const std::vector<Span>& spans, bool closed) {
  std::vector<Rational> cuts;
  for (std::size_t i = 0; i < spans.size(); ++i) {
    const auto torsal = torsal_parameters(spans[i], place_of(spans, i, closed));
    for (std::size_t j = 0; j + 1 < torsal.size(); ++j) {
      const Rational cut = Rational::exactly((torsal[j] + torsal[j + 1]) / 2);
      if (spans[i].begin() < cut && cut < spans[i].end()) cuts.push_back(cut);
    }
  }
  return cuts;
}

/// What a torsal ruling beside neighbours costs of the degree, and what lines cost that turn.
constexpr int kDegreeOfTorsalRuling = 4, kDegreeOfLines = 4;

/// The degree of lines in space has no room for a torsal ruling and for lines that turn.
bool is_crowded(const Span& span) {
  return is_line_family(span) &&
         degree_of_lines(span.rulings) + kDegreeOfTorsalRuling + kDegreeOfLines > kLargestDegree;
}

/// The half length of a short span around a torsal ruling, as a part of the span: lines need not
/// turn over it.
constexpr double kShort = 1.0 / 256;

/// In a crowded span a torsal ruling gets a short span of its own, so that its neighbours keep room
/// for their lines: doubles on both sides.
std::vector<Rational> cuts_around_torsal_rulings(const std::vector<Span>& spans, bool closed) {
  std::vector<Rational> cuts;
  for (std::size_t i = 0; i < spans.size(); ++i) {
    if (!is_crowded(spans[i])) continue;
    const double half = kShort * (parameter(spans[i], 1) - parameter(spans[i], 0));
    for (const double torsal : torsal_parameters(spans[i], place_of(spans, i, closed))) {
      for (const double place : {torsal - half, torsal + half}) {
        const Rational cut = Rational::exactly(place);
        if (spans[i].begin() < cut && cut < spans[i].end()) cuts.push_back(cut);
      }
    }
  }
  return cuts;
}

/// Speeds that differ by no more than this part are one: the rounding of poles and weights, some
/// hundred units in the last place. The gap is counted in the deviation.
constexpr double kRoundingOfSpeeds = 1e-12;

/// Sphere and velocity in R^{3,1} at an end of a span, by the designer's parameter.
Eigen::Vector4d velocity(const SphereSpan& span, long end) {
  const Rational t(end), length = span.end - span.begin;
  const RationalPolynomial& q = span.spheres.denominator;
  const Rational weight = q(t), slope = q.derivative()(t);
  const auto component = [&](const RationalPolynomial& p) {
    const Rational rate = p.derivative()(t) * weight - p(t) * slope;
    return (rate / (weight * weight * length)).to_double();
  };
  const SphereCurve& c = span.spheres;
  return {component(c.centre[0]), component(c.centre[1]), component(c.centre[2]),
          component(c.radius)};
}

bool runs_on(const SphereSpan& left, const SphereSpan& right) {
  const Eigen::Vector4d before = velocity(left, 1), after = velocity(right, 0);
  return meets(left, right, 0) &&
         (after - before).norm() <= kRoundingOfSpeeds * (after.norm() + before.norm());
}

/// The directions of the rulings with their denominator, as one curve.
SphereSpan directions(const Span& span) {
  const CircleFamily& g = span.rulings.direction;
  return {{g.axis, g.level, span.rulings.point.denominator}, span.begin(), span.end()};
}

/// The sections are as smooth as the curves when the coprime directions of the rulings are so too,
/// and no torsal root is divided out of them.
Joint joint_between(const Span& left, const Span& right) {
  const auto& [a, b] = left.directrices;
  const auto& [c, d] = right.directrices;
  if (meets(a, c, 2) && meets(b, d, 2) && meets(directions(left), directions(right), 2) &&
      left.torsal.empty() && right.torsal.empty()) {
    return Joint::kSmooth;
  }
  if (runs_on(a, c) && runs_on(b, d)) return Joint::kTangent;
  throw GeometryError(ErrorCode::kCornerTooSharp,
                      "At parameter " + show(parameter(right, 0)) +
                          " the curves have a corner or change their speed at once, and the "
                          "surface has a crease along the ruling. Offset both sides by "
                          "themselves.");
}

bool is_closed(const std::vector<Span>& spans) {
  return runs_on(spans.back().directrices[0], spans.front().directrices[0]) &&
         runs_on(spans.back().directrices[1], spans.front().directrices[1]);
}

Span span_between(const SphereSpan& first, const SphereSpan& second) {
  Span span{{first, second}, joined(first.spheres, second.spheres), {}, {}, {}};
  require_length(span);
  span.rulings = with_least_denominator(span.joined.rulings);
  span.normal = ruling_normal(span.joined.rulings);
  if (is_developable(span)) return span;
  require_cones(span);
  span.torsal = roots_in_unit_interval(torsal_polynomial(span.normal));
  return span;
}

std::vector<Span> spans_between(const std::vector<SphereSpan>& first,
                                const std::vector<SphereSpan>& second) {
  std::vector<Span> spans(first.size());
  for_each_index(spans.size(),
                 [&](std::size_t i) { spans[i] = span_between(first[i], second[i]); });
  return spans;
}

Envelope envelope_of(const Span& span, const SpanPlace& place) {
  const std::array<SphereCurve, 2> directrices = {span.directrices[0].spheres,
                                                  span.directrices[1].spheres};
  try {
    if (!is_developable(span)) {
      return along_rulings(span.rulings, directrices, place);
    }
    const auto strip = is_line_family(span) ? developable_strip(directrices) : std::nullopt;
    if (strip) return along_strip(*strip);
  } catch (const GeometryError& error) {
    throw GeometryError(error.code(), std::string(error.what()) + ", at " + interval(span) + ".");
  }
  throw not_rational(span);
}

/// A polynomial at an end of a span over one at the start of the next.
Rational ratio(const RationalPolynomial& before, const RationalPolynomial& after) {
  return before(Rational(1)) / after(Rational(0));
}

/// The factor by which the directions of `after` continue those of `before` at their joint, read
/// off the largest coordinate.
Rational ratio(const CircleFamily& before, const CircleFamily& after) {
  const std::array<const RationalPolynomial*, 4> left = {&before.axis[0], &before.axis[1],
                                                         &before.axis[2], &before.level};
  const std::array<const RationalPolynomial*, 4> right = {&after.axis[0], &after.axis[1],
                                                          &after.axis[2], &after.level};
  std::size_t largest = 0;
  const auto size = [&](std::size_t i) { return std::abs((*right[i])(Rational(0)).to_double()); };
  for (std::size_t i = 1; i < 4; ++i) {
    if (size(i) > size(largest)) largest = i;
  }
  return ratio(*left[largest], *right[largest]);
}

/// The same lines with direction and denominator at other scales.
Rulings scaled(Rulings rulings, const Rational& direction, const Rational& denominator) {
  const RationalPolynomial g(direction), q(denominator);
  for (std::size_t i = 0; i < 3; ++i) {
    rulings.direction.axis[i] *= g;
    rulings.point.centre[i] *= q;
  }
  rulings.direction.level *= g;
  rulings.point.radius *= q;
  rulings.point.denominator *= q;
  return rulings;
}

/// Spans that meet with the same weights: content and denominators that were divided out differ.
std::vector<Span> continued(std::vector<Span> spans) {
  for (std::size_t i = 1; i < spans.size(); ++i) {
    const Rulings &before = spans[i - 1].rulings, &own = spans[i].rulings;
    spans[i].rulings = scaled(own, ratio(before.direction, own.direction),
                              ratio(before.point.denominator, own.point.denominator));
  }
  return spans;
}

/// The last rulings come back to the first at the same scale.
bool closes_at_scale(const std::vector<Span>& spans) {
  const Rational one(1);
  const Rulings &last = spans.back().rulings, &first = spans.front().rulings;
  return ratio(last.direction, first.direction) == one &&
         ratio(last.point.denominator, first.point.denominator) == one;
}

/// All spans are skew, or all are developable: then they are strips, which meet in their rulings.
Extent extent_of(const std::vector<Span>& spans) {
  const auto developable = std::find_if(spans.begin(), spans.end(), is_developable);
  if (developable == spans.end()) return RulingBand{};
  if (std::all_of(spans.begin(), spans.end(), is_developable)) return Strip{};
  throw not_rational(*developable);
}

Joint joint_of(const Extent& extent, const Span& left, const Span& right) {
  const Joint joint = joint_between(left, right);
  return std::holds_alternative<Strip>(extent) ? Joint::kTangent : joint;
}

EnvelopeChain chain_of(std::vector<Span> unscaled) {
  const std::vector<Span> spans = continued(std::move(unscaled));
  EnvelopeChain chain;
  chain.extent = extent_of(spans);
  chain.closed = is_closed(spans) && closes_at_scale(spans);
  std::vector<std::optional<Envelope>> envelopes(spans.size());
  for_each_index(spans.size(), [&](std::size_t i) {
    envelopes[i] = envelope_of(spans[i], place_of(spans, i, chain.closed));
  });
  for (std::size_t i = 0; i < spans.size(); ++i) {
    Joint joint = Joint::kNone;
    if (i > 0) joint = joint_of(chain.extent, spans[i - 1], spans[i]);
    if (i == 0 && chain.closed) joint = joint_of(chain.extent, spans.back(), spans.front());
    const Envelope& before = *envelopes[(i + spans.size() - 1) % spans.size()];
    const bool is_substituted = envelopes[i]->is_substituted() || before.is_substituted();
    if (joint == Joint::kSmooth && is_substituted) joint = Joint::kTangent;
    chain.links.push_back({*envelopes[i], std::nullopt, spans[i].begin().to_double(),
                           spans[i].end().to_double(), joint});
    const auto& [first, second] = spans[i].directrices;
    if (is_line_family(spans[i])) chain.base.push_back(ruled_patch(first.spheres, second.spheres));
  }
  return chain;
}

/// A curve over another domain.
std::vector<SphereSpan> moved(std::vector<SphereSpan> spans, const std::vector<Rational>& breaks) {
  for (std::size_t i = 0; i < spans.size(); ++i) {
    spans[i].begin = breaks[i];
    spans[i].end = breaks[i + 1];
  }
  return spans;
}

}  // namespace

EnvelopeChain ruled_surface(const SphereCurve& first, const SphereCurve& second) {
  const Rational zero(0), one(1);
  const std::vector<Span> spans = spans_between({{first, zero, one}}, {{second, zero, one}});
  require_regular_rulings(spans.front());
  return chain_of(spans);
}

EnvelopeChain ruled_surface(const Curve& first, const Curve& second) {
  const Law point = Law::constant(0);
  return cone_envelope(first, point, second, point);
}

EnvelopeChain cone_envelope(const Curve& first_centres, const Law& first_radii,
                            const Curve& second_centres, const Law& second_radii) {
  const std::vector<Rational>& a = first_centres.function().breaks;
  const std::vector<Rational>& b = second_centres.function().breaks;
  const auto spans_over = [&](const std::vector<Rational>& breaks) {
    return spans_between(
        sphere_spans(first_centres, first_radii, breaks),
        moved(sphere_spans(second_centres, second_radii, mapped(breaks, b)), breaks));
  };
  const std::vector<Rational> breaks = united_breaks(a, mapped(b, a));
  const std::vector<Span> spans = spans_over(breaks);
  for_each_index(spans.size(), [&](std::size_t i) { require_regular_rulings(spans[i]); });
  const bool closed = is_closed(spans);
  std::vector<Rational> cuts = cuts_between_torsal_rulings(spans, closed);
  const std::vector<Rational> around = cuts_around_torsal_rulings(spans, closed);
  cuts.insert(cuts.end(), around.begin(), around.end());
  std::sort(cuts.begin(), cuts.end());
  return chain_of(cuts.empty() ? spans : spans_over(united_breaks(breaks, cuts)));
}

}  // namespace pn
