// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/shapes/moebius_canal_surface.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "pn/algebra/common_factor.hpp"
#include "pn/algebra/parallel.hpp"
#include "pn/algebra/roots.hpp"
#include "pn/conics/characteristic_circle.hpp"
#include "pn/geometry_error.hpp"

namespace pn {
namespace {

using Polynomial = RationalPolynomial;

/// A span of a curve in P^4. `squared` are the same spheres with r^2 in place of the radius, which
/// name the places.
struct Span {
  MoebiusCurve curve;
  SphereSpan squared;
};

/// |d y - a|^2 = d b for the centre a / d and the squared radius b / d.
MoebiusCurve moebius_curve(const SphereCurve& squared) {
  const auto& [a, b, d] = squared;
  return coprime(moebius_point(SphereEquation<Polynomial>{
      d * d, {d * a[0], d * a[1], d * a[2]}, a[0] * a[0] + a[1] * a[1] + a[2] * a[2] - d * b}));
}

/// Centre and squared radius with the denominator w^2, w = 0 at planes.
SphereCurve squared_spheres(const MoebiusCurve& curve) {
  const auto [w, q, z] = sphere_equation(curve);
  return {{q[0] * w, q[1] * w, q[2] * w}, moebius_product(curve, curve), w * w};
}

/// The positive root of a polynomial that is a square over Q.
std::optional<Polynomial> square_root(const Polynomial& p) {
  if (p.is_zero()) return p;
  const std::optional<Rational> leading = pn::square_root(p.coefficient(p.degree()));
  if (!leading) return std::nullopt;
  Polynomial root(*leading);
  for (const auto& [factor, multiplicity] : squarefree_factorization(p)) {
    if (multiplicity % 2 != 0) return std::nullopt;
    for (int i = 0; i < multiplicity / 2; ++i) root *= factor;
  }
  return root;
}

/// r instead of r^2, where it is rational and not zero inside the span.
std::optional<SphereSpan> with_rational_radius(const SphereSpan& squared) {
  const auto& [a, b, d] = squared.spheres;
  const std::optional<Polynomial> root = square_root(b * d);
  if (!root) return std::nullopt;
  const Rational half = Rational(1L) / Rational(2L);
  const Polynomial radius = (*root)(half).sign() < 0 ? -*root : *root;
  auto all = coprime(std::array{a[0], a[1], a[2], radius, d});
  if (all[4](half).sign() < 0) {
    for (Polynomial& p : all) p = -p;
  }
  const Polynomial inside = all[3].without_root(Rational(0)).without_root(Rational(1));
  const bool keeps_sign =
      is_positive_on_unit_interval(inside) || is_positive_on_unit_interval(-inside);
  if (!keeps_sign || !is_positive_on_unit_interval(all[4])) return std::nullopt;
  return SphereSpan{{{all[0], all[1], all[2]}, all[3], all[4]}, squared.begin, squared.end};
}

std::optional<std::vector<SphereSpan>> with_rational_radii(const std::vector<Span>& spans) {
  std::vector<SphereSpan> spheres;
  for (const Span& span : spans) {
    std::optional<SphereSpan> here = with_rational_radius(span.squared);
    if (!here) return std::nullopt;
    spheres.push_back(std::move(*here));
  }
  return spheres;
}

/// "at parameters ..." where p is negative, or else "at parameter ..." where it is zero.
std::string where_not_positive(const Polynomial& p, const Span& span) {
  if (p.is_zero()) return "at " + interval(span.squared, 0, 1);
  if (const auto negative = first_negative_interval(p)) {
    return "at " + interval(span.squared, (*negative)[0], (*negative)[1]);
  }
  const double zero = roots_in_unit_interval(p).front().value.midpoint();
  return "at parameter " + show(parameter(span.squared, zero)) + ", point " +
         place(span.squared, zero);
}

void require_real_spheres(const Span& span) {
  const Polynomial square = moebius_product(span.curve, span.curve);
  if (is_positive_on_unit_interval(square)) return;
  throw GeometryError(ErrorCode::kNegativeRadius, "The squared radius is not positive " +
                                                      where_not_positive(square, span) + ".");
}

bool is_constant(const Polynomial& p) { return p.degree() < 1; }

void require_circles(const Span& span) {
  if (span.curve[0] == span.curve[4]) {
    throw GeometryError(ErrorCode::kDevelopable,
                        "All spheres are planes: their envelope is a developable surface.");
  }
  const std::vector<Polynomial> line = line_coordinates(tangent_pencil(span.curve));
  if (std::all_of(line.begin(), line.end(), [](const Polynomial& p) { return p.is_zero(); })) {
    throw GeometryError(ErrorCode::kZeroLength, "The spheres stand still " +
                                                    where_not_positive(Polynomial(), span) +
                                                    ": this span has no length.");
  }
  const Polynomial discriminant = circle_discriminant(line);
  if (discriminant.is_zero()) {
    throw GeometryError(ErrorCode::kDevelopable,
                        "The radius changes exactly as fast as the spine advances " +
                            where_not_positive(discriminant, span) +
                            ": the spheres touch in a curve only.");
  }
  if (std::all_of(line.begin(), line.end(), is_constant)) {
    throw GeometryError(ErrorCode::kDevelopable, "All spheres pass through the same circle " +
                                                     where_not_positive(Polynomial(), span) +
                                                     ": they envelop nothing else.");
  }
  if (is_positive_on_unit_interval(discriminant)) return;
  const std::string where = where_not_positive(discriminant, span);
  if (first_negative_interval(discriminant)) {
    throw GeometryError(ErrorCode::kRadiusTooSteep,
                        "The radius changes faster than the spine advances " + where +
                            ": there the spheres have no envelope. Let the squared radius change "
                            "more slowly.");
  }
  throw GeometryError(ErrorCode::kPinched,
                      "The radius changes exactly as fast as the spine advances " + where +
                          ": the envelope shrinks to a point there.");
}

/// The coordinates of the tangent at an end of the span.
std::vector<Rational> tangent_at(const Span& span, long end) {
  std::vector<Rational> values;
  for (const Polynomial& p : line_coordinates(tangent_pencil(span.curve))) {
    values.push_back(p(Rational(end)));
  }
  return values;
}

/// The sine of the angle between two vectors.
double sine(const std::vector<Rational>& a, const std::vector<Rational>& b) {
  Rational aa, ab, bb;
  for (std::size_t i = 0; i < a.size(); ++i) {
    aa += a[i] * a[i];
    ab += a[i] * b[i];
    bb += b[i] * b[i];
  }
  return std::sqrt(((aa * bb - ab * ab) / (aa * bb)).to_double());
}

/// The circles are the same exactly where the tangents in P^4 are. What the rounding of poles
/// leaves is closed with the faces.
void require_no_corner(const Span& left, const Span& right) {
  if (sine(tangent_at(left, 1), tangent_at(right, 0)) <= kRoundingAngle) return;
  throw GeometryError(ErrorCode::kCornerTooSharp,
                      "The spine or the squared radius turns at parameter " +
                          show(right.squared.begin.to_double()) + ", point " +
                          place(right.squared, 0) +
                          ": the circles on both sides are not the same. Let both run on "
                          "smoothly.");
}

std::vector<ConicSpan> circles_of(const std::vector<Span>& spans) {
  std::vector<ConicSpan> circles(spans.size());
  for_each_index(spans.size(), [&](std::size_t i) {
    require_real_spheres(spans[i]);
    require_circles(spans[i]);
    circles[i] = {shared_circle(tangent_pencil(spans[i].curve)), std::nullopt};
  });
  for (std::size_t i = 0; i + 1 < spans.size(); ++i) require_no_corner(spans[i], spans[i + 1]);
  return circles;
}

CanalSurfaceFromSquares envelope_of(const std::vector<Span>& spans) {
  if (auto spheres = with_rational_radii(spans)) return canal_surface(std::move(*spheres));
  return circles_of(spans);
}

}  // namespace

CanalSurfaceFromSquares moebius_canal_surface(const Curve& spine, const Law& squared_radius) {
  std::vector<Span> spans;
  for (SphereSpan& squared : sphere_spans(spine, squared_radius)) {
    spans.push_back({moebius_curve(squared.spheres), std::move(squared)});
  }
  return envelope_of(spans);
}

CanalSurfaceFromSquares moebius_canal_surface(const MoebiusCurve& curve) {
  if (std::all_of(curve.begin(), curve.end(), [](const Polynomial& p) { return p.is_zero(); })) {
    throw GeometryError(ErrorCode::kWrongShape, "All coordinates of the curve are zero.");
  }
  const MoebiusCurve spheres = coprime(curve);
  return envelope_of({{spheres, {squared_spheres(spheres), Rational(0), Rational(1)}}});
}

}  // namespace pn
