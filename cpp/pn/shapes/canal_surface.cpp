// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/shapes/canal_surface.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "pn/algebra/parallel.hpp"
#include "pn/algebra/roots.hpp"
#include "pn/geometry_error.hpp"
#include "pn/isotropic/along_curve.hpp"

namespace pn {
namespace {

/// OpenCASCADE takes points closer than this [mm] for the same: a zone narrower than that is no
/// face.
constexpr double kClosableGap = 1e-7;
/// A joint that turns by more than this [rad] is a corner whatever its size.
constexpr double kClosableAngle = 1e-6;

using Vector4 = std::array<Rational, 4>;

struct Span : SphereSpan {
  TangentDirection direction;
};

std::vector<Span> with_directions(std::vector<SphereSpan> parts) {
  std::vector<Span> spans(parts.size());
  for_each_index(spans.size(), [&](std::size_t i) {
    TangentDirection direction = tangent_direction(parts[i].spheres);
    spans[i] = {std::move(parts[i]), std::move(direction)};
  });
  return spans;
}

void require_radius(const Span& span) {
  const RationalPolynomial& radius = span.spheres.radius;
  if (radius.is_zero() || is_positive_on_unit_interval(radius)) return;
  const auto negative = first_negative_interval(radius);
  if (!negative) return;
  throw GeometryError(
      ErrorCode::kNegativeRadius,
      "The radius is negative at " + interval(span, (*negative)[0], (*negative)[1]) + ".");
}

void require_envelope(const Span& span) {
  if (span.direction.content.is_zero()) {
    throw GeometryError(
        ErrorCode::kZeroLength,
        "The spine stands still at " + interval(span, 0, 1) + ": this span has no length.");
  }
  const RationalPolynomial discriminant = span.direction.circles.discriminant();
  if (discriminant.is_zero()) {
    throw GeometryError(ErrorCode::kDevelopable,
                        "The radius changes exactly as fast as the spine advances at " +
                            interval(span, 0, 1) + ": the spheres touch in a curve only.");
  }
  if (is_positive_on_unit_interval(discriminant)) return;
  if (const auto steep = first_negative_interval(discriminant)) {
    throw GeometryError(
        ErrorCode::kRadiusTooSteep,
        "The radius changes faster than the spine advances at " +
            interval(span, (*steep)[0], (*steep)[1]) +
            ": there the spheres have no envelope. Let the radius change more slowly.");
  }
  const double touch = roots_in_unit_interval(discriminant).front().value.midpoint();
  throw GeometryError(ErrorCode::kPinched,
                      "The radius changes exactly as fast as the spine advances at parameter " +
                          show(parameter(span, touch)) + ", point " + place(span, touch) +
                          ": the envelope shrinks to a point there.");
}

/// The envelope along a span or a corner; an error says where.
Envelope envelope_along(const SphereCurve& spheres, const CircleFamily& circles, const Span& span) {
  try {
    return along_curve(spheres, circles);
  } catch (const GeometryError& error) {
    throw GeometryError(error.code(),
                        std::string(error.what()) + ", at " + interval(span, 0, 1) + ".");
  }
}

Vector4 circle_at(const CircleFamily& circles, long t) {
  const Rational x(t);
  return {circles.axis[0](x), circles.axis[1](x), circles.axis[2](x), circles.level(x)};
}

Rational dot(const Vector4& a, const Vector4& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + a[3] * b[3];
}

Rational minkowski(const Vector4& a, const Vector4& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2] - a[3] * b[3];
}

/// Exactly parallel and of the same direction.
bool is_same_circle(const Vector4& a, const Vector4& b) {
  const Rational product = dot(a, b);
  return product.sign() > 0 && product * product == dot(a, a) * dot(b, b);
}

/// The circles of two directions on the unit sphere meet in two points.
bool do_circles_cross(const Vector4& a, const Vector4& b) {
  const Rational product = minkowski(a, b);
  return product * product < minkowski(a, a) * minkowski(b, b);
}

/// The angle between two directions in R^4, for the closing of rounding gaps only.
double angle(const Vector4& a, const Vector4& b) {
  const Rational product = dot(a, b);
  const Rational squares = dot(a, a) * dot(b, b);
  const double sine_squared = ((squares - product * product) / squares).to_double();
  const double sine = std::sqrt(std::max(0.0, sine_squared));
  return product.sign() > 0 ? sine : M_PI - sine;
}

/// The sign of p just inside the end t of [0, 1].
int sign_near(const RationalPolynomial& p, long end) {
  const RationalPolynomial from_end = end == 0 ? p : p.on_interval(Rational(1), Rational(-1));
  for (int i = 0; i <= from_end.degree(); ++i) {
    const int sign = from_end.coefficient(i).sign();
    if (sign != 0) return sign;
  }
  return 0;
}

Span reversed_orientation(Span span) {
  span.direction.circles = -span.direction.circles;
  span.direction.content = -span.direction.content;
  return span;
}

/// Spans whose circle families point forward along the first of them and continue each other: where
/// the spine runs back in itself inside a span, the family runs on and the content changes sign.
std::vector<Span> oriented(std::vector<Span> spans) {
  int sign = 1;
  for (Span& span : spans) {
    if (sign_near(span.direction.content, 0) != sign) span = reversed_orientation(std::move(span));
    sign = sign_near(span.direction.content, 1);
  }
  return spans;
}

/// Centre, radius and denominator agree up to the second derivative in the spine's parameter, and
/// the first one, of which the circles are made, does not vanish.
bool is_smooth(const Span& left, const Span& right) {
  if (left.direction.content(Rational(1)).is_zero()) return false;
  return meets({left.spheres, left.begin, left.end}, {right.spheres, right.begin, right.end}, 2);
}

double radius_at_start(const Span& span) {
  const Rational zero(0);
  return (span.spheres.radius(zero) / span.spheres.denominator(zero)).to_double();
}

/// The sphere that stands still at the start of a span.
SphereCurve standing_sphere(const Span& span) {
  const Rational zero(0);
  const SphereCurve& s = span.spheres;
  return {{s.centre[0](zero), s.centre[1](zero), s.centre[2](zero)},
          s.radius(zero),
          s.denominator(zero)};
}

RationalPolynomial between(const Rational& a, const Rational& b) {
  return RationalPolynomial({a, b - a});
}

/// A factor near 1 / sqrt(D): it makes the zone's circles turn evenly. Any positive one is exact.
Rational evening_factor(const Vector4& circle) {
  return Rational::exactly(1 / std::sqrt(minkowski(circle, circle).to_double()));
}

/// The pencil of circles from the end of `left` to the start of `right`, around a standing sphere.
CircleFamily turning_circles(const Vector4& left, const Vector4& right, const Span& at) {
  const Rational a = evening_factor(left), b = evening_factor(right);
  CircleFamily circles{{between(left[0] * a, right[0] * b), between(left[1] * a, right[1] * b),
                        between(left[2] * a, right[2] * b)},
                       between(left[3] * a, right[3] * b)};
  if (!is_positive_on_unit_interval(circles.discriminant())) {
    throw GeometryError(
        ErrorCode::kCornerTooSharp,
        "The spine or the radius turns too sharply at parameter " + show(at.begin.to_double()) +
            ", point " + place(at, 0) +
            ": the circles on both sides cannot be joined by a zone of the sphere.");
  }
  return circles;
}

/// Builds the chain link by link.
class ChainBuilder {
 public:
  explicit ChainBuilder(std::vector<Span> spans) : spans_(std::move(spans)) {}

  EnvelopeChain chain() {
    plan();
    std::vector<std::optional<Envelope>> envelopes(plans_.size());
    for_each_index(plans_.size(), [&](std::size_t i) {
      envelopes[i] =
          envelope_along(plans_[i].spheres, plans_[i].direction.circles, spans_[plans_[i].span]);
    });
    for (std::size_t i = 0; i < plans_.size(); ++i) {
      Plan& plan = plans_[i];
      chain_.links.push_back(
          {std::move(*envelopes[i]),
           CurveOfSpheres{std::move(plan.spheres), std::move(plan.direction.circles),
                          std::move(plan.direction.content)},
           plan.begin, plan.end, plan.joint_before});
    }
    separate_substituted_links();
    return std::move(chain_);
  }

 private:
  struct Plan {
    std::size_t span;  ///< the span itself, or the one that follows a corner
    SphereCurve spheres;
    TangentDirection direction;
    double begin, end;
    Joint joint_before;
  };

  void plan() {
    chain_.closed = is_closed();
    for (std::size_t i = 0; i < spans_.size(); ++i) {
      const Joint joint = i > 0 ? joint_between(i - 1, i) : Joint::kNone;
      plans_.push_back({i, spans_[i].spheres, spans_[i].direction, spans_[i].begin.to_double(),
                        spans_[i].end.to_double(), joint});
    }
    if (chain_.closed) plans_.front().joint_before = joint_between(spans_.size() - 1, 0);
  }

  /// The joint of a span to the one before; a corner gets its zone, which comes in between.
  Joint joint_between(std::size_t before, std::size_t after) {
    const Span &left = spans_[before], &right = spans_[after];
    const Vector4 a = circle_at(left.direction.circles, 1),
                  b = circle_at(right.direction.circles, 0);
    if (is_same_circle(a, b)) return is_smooth(left, right) ? Joint::kSmooth : Joint::kTangent;
    const double turn = angle(a, b);
    const double at = left.end.to_double();
    if (turn <= kRoundingAngle) return Joint::kTangent;
    if (turn <= kClosableAngle && turn * std::abs(radius_at_start(right)) <= kClosableGap) {
      chain_.exact = false;
      chain_.notes.push_back("At parameter " + show(at) + " the spine turns by " + show(turn) +
                             " rad; the joint is closed and its gap counted in the deviation.");
      return Joint::kTangent;
    }
    if (do_circles_cross(a, b)) {
      chain_.notes.push_back("At the corner at parameter " + show(at) + ", point " +
                             place(right, 0) + ", the envelope overlaps itself on the inner side.");
    }
    plans_.push_back({after,
                      standing_sphere(right),
                      {turning_circles(a, b, right), {}},
                      at,
                      at,
                      Joint::kTangent});
    return Joint::kTangent;
  }

  /// The last sphere is the first one; where the direction differs, the chain closes with a corner.
  bool is_closed() const {
    const SphereCurve &first = spans_.front().spheres, &last = spans_.back().spheres;
    const Rational zero(0), one(1);
    const auto meets = [&](const RationalPolynomial& p, const RationalPolynomial& q) {
      return p(one) * first.denominator(zero) == q(zero) * last.denominator(one);
    };
    return meets(last.radius, first.radius) &&
           std::equal(last.centre.begin(), last.centre.end(), first.centre.begin(), meets);
  }

  /// Across a substituted link the parameter does not run on evenly, so its joints are only
  /// tangent.
  void separate_substituted_links() {
    const std::size_t count = chain_.links.size();
    for (std::size_t i = 0; i < count; ++i) {
      Joint& joint = chain_.links[i].joint_before;
      const ChainLink& before = chain_.links[(i + count - 1) % count];
      if (joint == Joint::kSmooth &&
          (chain_.links[i].envelope.is_substituted() || before.envelope.is_substituted())) {
        joint = Joint::kTangent;
      }
    }
  }

  std::vector<Span> spans_;
  std::vector<Plan> plans_;
  EnvelopeChain chain_;
};

}  // namespace

EnvelopeChain canal_surface(std::vector<SphereSpan> spheres) {
  std::vector<Span> spans = with_directions(std::move(spheres));
  for_each_index(spans.size(), [&](std::size_t i) {
    require_radius(spans[i]);
    require_envelope(spans[i]);
  });
  return ChainBuilder(oriented(std::move(spans))).chain();
}

EnvelopeChain canal_surface(const Curve& spine, const Law& radius) {
  return canal_surface(sphere_spans(spine, radius));
}

}  // namespace pn
