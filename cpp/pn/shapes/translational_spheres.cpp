// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/shapes/translational_spheres.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <optional>

#include "pn/algebra/parallel.hpp"
#include "pn/geometry_error.hpp"
#include "pn/shapes/sphere_spans.hpp"

namespace pn {
namespace {

using Vector = MinkowskiVector<Rational>;

/// Directions of centres that differ by less [rad] count as one where no envelope could be proved:
/// about what a part of 2^-8 of a span resolves.
constexpr double kSameDirection = 1.0 / 64;

/// (m, -r) of a span.
SphereParabola parabola(const RationalSpan<4>& span) {
  SphereParabola result;
  for (std::size_t c = 0; c < 4; ++c) {
    const Rational sign(c == 3 ? -1L : 1L);
    result.start[c] = sign * span.numerator[c].coefficient(0);
    result.first[c] = sign * span.numerator[c].coefficient(1);
    result.second[c] = sign * span.numerator[c].coefficient(2) * Rational(2L);
  }
  return result;
}

std::string at(const char* name, const Rational& parameter) {
  return std::string("The ") + name + " curve of spheres, at parameter " +
         show(parameter.to_double());
}

void require_quadratic(const RationalSpan<4>& span, const char* name) {
  for (const RationalPolynomial& p : span.numerator) {
    if (p.degree() <= 2) continue;
    throw GeometryError(
        ErrorCode::kNotRational,
        std::string("The ") + name + " curve of spheres has degree " + std::to_string(p.degree()) +
            ": only of curves of degree 1 and 2 are rational skins made. Replace it "
            "by a quadratic spline.");
  }
}

bool is_zero(const Vector& x) {
  return std::all_of(x.begin(), x.end(), [](const Rational& c) { return c.is_zero(); });
}

/// Exactly parallel and of the same direction.
bool is_same_direction(const Vector& a, const Vector& b) {
  const auto dot = [](const Vector& x, const Vector& y) {
    return x[0] * y[0] + x[1] * y[1] + x[2] * y[2] + x[3] * y[3];
  };
  const Rational product = dot(a, b);
  return product.sign() > 0 && product * product == dot(a, a) * dot(b, b);
}

SphereParabolas parabolas(const SphereSpline& curve, const char* name) {
  const PiecewiseRational<4>& function = curve.function();
  SphereParabolas result{function.breaks, {}};
  for (std::size_t i = 0; i < function.spans.size(); ++i) {
    require_quadratic(function.spans[i], name);
    result.spans.push_back(parabola(function.spans[i]));
    const SphereParabola& span = result.spans.back();
    if (is_zero(span.first) && is_zero(span.second)) {
      throw GeometryError(ErrorCode::kZeroLength,
                          at(name, function.breaks[i]) + ", stands still for a span.");
    }
    if (i == 0 || is_same_direction(result.spans[i - 1].slope(1L), span.first)) continue;
    throw GeometryError(ErrorCode::kCornerTooSharp,
                        at(name, function.breaks[i]) +
                            ", has a corner: the skins on both sides do not meet there. Give inner "
                            "knots the multiplicity 1, or divide the curve.");
  }
  return result;
}

/// The centres move nearly in one direction in u and in v.
bool is_degenerate(const TranslationalFamily& family, const std::array<double, 2>& uv) {
  const auto direction = [](const Vector& x) {
    return Eigen::Vector3d(x[0].to_double(), x[1].to_double(), x[2].to_double());
  };
  const Eigen::Vector3d a = direction(family.c.slope(Rational::exactly(uv[0]))),
                        b = direction(family.d.slope(Rational::exactly(uv[1])));
  return a.cross(b).norm() <= kSameDirection * a.norm() * b.norm();
}

[[noreturn]] void refuse(const TranslationalSpline& spline, std::size_t i, std::size_t j,
                         const std::array<double, 2>& uv) {
  const auto parameter = [](const std::vector<Rational>& breaks, std::size_t span, double local) {
    const double begin = breaks[span].to_double(), end = breaks[span + 1].to_double();
    return show(begin + local * (end - begin));
  };
  const std::string where = "(u, v) = (" + parameter(spline.c.breaks, i, uv[0]) + ", " +
                            parameter(spline.d.breaks, j, uv[1]) + ")";
  if (is_degenerate(spline.family(i, j), uv)) {
    throw GeometryError(ErrorCode::kZeroLength,
                        "Both curves of spheres run in one direction near " + where +
                            ": translated along each other they are no mid-surface there.");
  }
  throw GeometryError(
      ErrorCode::kRadiusTooSteep,
      "The spheres have no envelope near " + where +
          ": the radius changes at least as fast as the centre moves, so one sphere "
          "swallows its neighbours.");
}

void require_envelope(const TranslationalSpline& spline) {
  const std::size_t columns = spline.d.spans.size();
  for_each_index(spline.c.spans.size() * columns, [&](std::size_t k) {
    const std::size_t i = k / columns, j = k % columns;
    if (const auto place = unreal_place(spline.family(i, j))) refuse(spline, i, j, *place);
  });
}

bool has_constant_radius(const SphereParabolas& curve) {
  return std::all_of(curve.spans.begin(), curve.spans.end(), [](const SphereParabola& span) {
    return span.first[3].is_zero() && span.second[3].is_zero();
  });
}

}  // namespace

TranslationalSpheres translational_spheres(const SphereSpline& c, const SphereSpline& d) {
  TranslationalSpheres result{{parabolas(c, "first"), parabolas(d, "second")}, {}};
  require_envelope(result.spline);
  if (has_constant_radius(result.spline.c) && has_constant_radius(result.spline.d)) {
    result.notes.emplace_back("All radii are equal: the skins are the offsets of the mid-surface.");
  }
  return result;
}

}  // namespace pn
