// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/shapes/conic_section.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "pn/algebra/common_factor.hpp"
#include "pn/algebra/parallel.hpp"
#include "pn/algebra/power_of_two.hpp"
#include "pn/algebra/roots.hpp"
#include "pn/algebra/rounded_square_root.hpp"
#include "pn/geometry_error.hpp"
#include "pn/input_numbers.hpp"
#include "pn/shapes/sphere_spans.hpp"

namespace pn {
namespace {

using Polynomial = RationalPolynomial;
using Direction = Vector3<Polynomial>;

/// An irrational length that does not change, |e2|, is rounded to so many bits more than those of a
/// double: far below the last place of any pole.
constexpr long kBitsOfLength = 128;

Polynomial dot(const Direction& a, const Direction& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

Direction cross(const Direction& a, const Direction& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

bool is_zero(const Direction& a) {
  return std::all_of(a.begin(), a.end(), [](const Polynomial& p) { return p.is_zero(); });
}

/// Without common factor, and neither very long nor very short.
Direction primitive(const Direction& a) {
  const Direction entries = coprime(a);
  const Polynomial size(power_of_two_near({entries[0], entries[1], entries[2]}));
  return {exact_quotient(entries[0], size), exact_quotient(entries[1], size),
          exact_quotient(entries[2], size)};
}

/// What a designer's direction is over Q.
Direction constant_direction(const std::array<double, 3>& direction, const std::string& name) {
  Direction result;
  for (std::size_t i = 0; i < 3; ++i) {
    require_input_number(direction[i], "A coordinate of the " + name);
    result[i] = Polynomial(Rational::exactly(direction[i]));
  }
  if (is_zero(result)) {
    throw GeometryError(ErrorCode::kBadAxis, "The " + name + " has no length.");
  }
  return result;
}

/// A span of the spine with the laws and directions of its sections. Its spheres are points.
struct Span : SphereSpan {
  std::vector<RationalSpan<1>> laws;
  Direction sideways, upwards;  ///< e1 and e2
};

std::string at(const Span& span, double local) {
  return "at parameter " + show(parameter(span, local)) + ", point " + place(span, local);
}

std::string at_all(const Span& span) {
  return "at parameters " + show(parameter(span, 0)) + " to " + show(parameter(span, 1));
}

/// Throws with a sentence that says of a function what is wrong, and where.
void require_positive(const Polynomial& p, const Span& span, const std::string& name) {
  if (is_positive_on_unit_interval(p)) return;
  const auto refuse = [&](const std::string& fault) {
    throw GeometryError(ErrorCode::kBadAxis, name + fault + ". It must be positive everywhere.");
  };
  if (p.is_zero()) refuse(" is zero " + at_all(span));
  if (const auto negative = first_negative_interval(p)) {
    refuse(" is negative at " + interval(span, (*negative)[0], (*negative)[1]));
  }
  refuse(" is zero " + at(span, roots_in_unit_interval(p).front().value.midpoint()));
}

Direction tangent(const Span& span) {
  const TangentDirection found = tangent_direction(span.spheres);
  if (found.content.is_zero()) {
    throw GeometryError(ErrorCode::kZeroLength,
                        "The spine stands still " + at_all(span) + ": this span has no length.");
  }
  return found.circles.axis;
}

void require_to_cross(const Direction& normal, const Span& span) {
  const Polynomial rise = dot(tangent(span), normal);
  if (rise.is_zero()) {
    throw GeometryError(ErrorCode::kBadAxis, "The spine runs within the plane of a section " +
                                                 at_all(span) + ". Choose another normal.");
  }
  const std::vector<RealRoot> roots = roots_in_unit_interval(rise);
  if (roots.empty()) return;
  throw GeometryError(ErrorCode::kBadAxis, "The spine runs parallel to the sections " +
                                               at(span, roots.front().value.midpoint()) +
                                               ". Choose another normal.");
}

/// With its directions e1 and e2.
Span directed(Span span, const SectionPlanes& planes) {
  const Direction up = constant_direction(planes.up, "direction upwards");
  Direction normal;
  const auto* parallel = std::get_if<ParallelPlanes>(&planes.kind);
  if (parallel) {
    normal = constant_direction(parallel->normal, "normal of the sections");
    require_to_cross(normal, span);
  } else {
    normal = tangent(span);
  }
  const std::string which = parallel ? "normal of the sections" : "spine";
  const Direction sideways = cross(normal, up);
  if (is_zero(sideways)) {
    throw GeometryError(ErrorCode::kBadAxis, "The direction upwards is that of the " + which + " " +
                                                 at_all(span) + ". Choose another one.");
  }
  if (std::holds_alternative<UprightPlanes>(planes.kind)) normal = cross(up, sideways);
  span.sideways = primitive(sideways);
  span.upwards = primitive(cross(span.sideways, normal));
  return span;
}

Direction operator-(const Direction& a) { return {-a[0], -a[1], -a[2]}; }

Vector3<Rational> value(const Direction& a, long t) {
  return {a[0](Rational(t)), a[1](Rational(t)), a[2](Rational(t))};
}

Rational dot(const Vector3<Rational>& a, const Vector3<Rational>& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/// The sign of a polynomial, which is not zero, just behind t = 0.
int sign_behind_start(const Polynomial& p) {
  int i = 0;
  while (p.coefficient(i).is_zero()) ++i;
  return p.coefficient(i).sign();
}

/// Common factors that were divided out may have changed signs. The first section is upright; the
/// others go on from it.
void orient(std::vector<Span>& spans, const SectionPlanes& planes) {
  const Direction up = constant_direction(planes.up, "direction upwards");
  int sign = sign_behind_start(dot(spans.front().upwards, up));
  for (std::size_t i = 0; i < spans.size(); ++i) {
    if (i > 0) sign = dot(value(spans[i - 1].upwards, 1), value(spans[i].upwards, 0)).sign();
    if (sign >= 0) continue;
    spans[i].sideways = -spans[i].sideways;
    spans[i].upwards = -spans[i].upwards;
  }
}

std::vector<Span> spans_of(const Curve& spine, const SectionPlanes& planes,
                           const std::vector<Law>& laws) {
  std::vector<Rational> breaks = spine.function().breaks;
  std::vector<PiecewiseRational<1>> functions;
  for (const Law& law : laws) {
    functions.push_back(law.over(breaks.front(), breaks.back()));
    breaks = united_breaks(breaks, functions.back().breaks);
  }
  for (PiecewiseRational<1>& function : functions) function = refined(function, breaks);
  std::vector<SphereSpan> parts = sphere_spans(spine, Law::constant(0), breaks);
  std::vector<Span> spans(parts.size());
  for_each_index(spans.size(), [&](std::size_t i) {
    Span span{std::move(parts[i]), {}, {}, {}};
    for (const PiecewiseRational<1>& function : functions) span.laws.push_back(function.spans[i]);
    spans[i] = directed(std::move(span), planes);
  });
  orient(spans, planes);
  return spans;
}

/// The angle between two directions, of either sign, at the ends where spans meet.
double turn(const Direction& left, const Direction& right) {
  const Vector3<Rational> a = value(left, 1), b = value(right, 0);
  const Rational cosine = dot(a, b), squares = dot(a, a) * dot(b, b);
  const double sine_squared = ((squares - cosine * cosine) / squares).to_double();
  return std::asin(std::min(1.0, std::sqrt(std::max(0.0, sine_squared))));
}

void require_no_corner(const Span& left, const Span& right) {
  const double angle =
      std::max(turn(left.sideways, right.sideways), turn(left.upwards, right.upwards));
  if (angle <= kRoundingAngle) return;
  throw GeometryError(ErrorCode::kCornerTooSharp,
                      "The sections turn by " + show(angle * 180 / M_PI) + " degrees " +
                          at(right, 0) +
                          ": they would not join. Round the corner of the spine, or take parallel "
                          "sections.");
}

MovingConic in_frame(const Span& span, const Matrix3<Polynomial>& conic) {
  MovingConic result;
  for (std::size_t i = 0; i < 3; ++i) {
    result.frame[i] = {span.sideways[i], span.upwards[i], span.spheres.centre[i]};
  }
  result.frame[3] = {Polynomial(), Polynomial(), span.spheres.denominator};
  result.conic = conic;
  return result;
}

Polynomial square(const Polynomial& p) { return p * p; }

/// The equation of the theorem, times the square of a b and of their denominators.
ConicSpan ellipses(const Span& span) {
  const RationalSpan<1>&a = span.laws[0], &b = span.laws[1];
  require_positive(a.numerator[0], span, "The half-axis to the side");
  require_positive(b.numerator[0], span, "The half-axis upwards");
  const Polynomial zero;
  const Polynomial across = square(a.denominator * b.numerator[0]),
                   along = square(b.denominator * a.numerator[0]),
                   weight = square(span.spheres.denominator * a.numerator[0] * b.numerator[0]);
  return {in_frame(span, {{{dot(span.sideways, span.sideways) * across, zero, zero},
                           {zero, dot(span.upwards, span.upwards) * along, zero},
                           {zero, zero, -weight}}}),
          std::nullopt};
}

/// |e2|, a polynomial. Only a constant factor may be irrational.
Polynomial length(const Direction& direction, const Span& span) {
  const Polynomial squared = dot(direction, direction);
  Polynomial root(1L);
  for (const SquarefreeFactor& part : squarefree_factorization(squared)) {
    if (part.multiplicity % 2 != 0) {
      throw GeometryError(
          ErrorCode::kNotRational,
          "Sections from the vertex are not rational " + at_all(span) +
              ": the length of their direction upwards is not. Take parallel "
              "sections, upright ones, or a plane spine and the normal of its plane as the "
              "direction upwards.");
    }
    for (int i = 0; i < part.multiplicity; i += 2) root *= part.factor;
  }
  // All factors are monic.
  root *= Polynomial(rounded_square_root(squared.coefficient(squared.degree()), kBitsOfLength));
  return root(Rational(0)).sign() < 0 ? -root : root;
}

/// x^2 = 2 R z - (1 + K) z^2 with x = y1 |e1| / (q y3), z = y2 |e2| / (q y3), and z < h, times the
/// denominators.
ConicSpan from_the_vertex(const Span& span) {
  const RationalSpan<1>&radius = span.laws[0], &constant = span.laws[1], &depth = span.laws[2];
  require_positive(radius.numerator[0], span, "The radius of curvature at the vertex");
  require_positive(depth.numerator[0], span, "The depth");
  const Polynomial one_and_constant = constant.denominator + constant.numerator[0];
  // Of 2 R / (1 + K) - h, which is positive for parabolas and hyperbolas anyway.
  require_positive(Polynomial(2L) * radius.numerator[0] * constant.denominator * depth.denominator -
                       one_and_constant * depth.numerator[0] * radius.denominator,
                   span, "The height of the ellipse above the depth");
  const Polynomial zero, unit = length(span.upwards, span);
  const Polynomial linear =
      -radius.numerator[0] * constant.denominator * unit * span.spheres.denominator;
  return {
      in_frame(span,
               {{{radius.denominator * constant.denominator * dot(span.sideways, span.sideways),
                  zero, zero},
                 {zero, radius.denominator * one_and_constant * square(unit), linear},
                 {zero, linear, zero}}}),
      Direction{zero, -depth.denominator * unit, depth.numerator[0] * span.spheres.denominator}};
}

std::vector<Law> laws_of(const ConicSection& section) {
  if (const auto* axes = std::get_if<HalfAxes>(&section)) return {axes->sideways, axes->upwards};
  const auto& vertex = std::get<VertexForm>(section);
  return {vertex.radius, vertex.conic_constant, vertex.depth};
}

}  // namespace

std::vector<ConicSpan> moving_conic_section(const Curve& spine, const SectionPlanes& planes,
                                            const ConicSection& section) {
  const std::vector<Span> spans = spans_of(spine, planes, laws_of(section));
  for (std::size_t i = 0; i + 1 < spans.size(); ++i) require_no_corner(spans[i], spans[i + 1]);
  if (joins(spine.function().spans.back(), spine.function().spans.front())) {
    require_no_corner(spans.back(), spans.front());
  }
  const auto conics = std::holds_alternative<HalfAxes>(section) ? ellipses : from_the_vertex;
  std::vector<ConicSpan> result(spans.size());
  for_each_index(spans.size(), [&](std::size_t i) { result[i] = conics(spans[i]); });
  return result;
}

}  // namespace pn
