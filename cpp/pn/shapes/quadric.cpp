// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/shapes/quadric.hpp"

#include <algorithm>
#include <cmath>

#include "pn/geometry_error.hpp"
#include "pn/isotropic/along_rulings.hpp"
#include "pn/isotropic/quadric_pencil.hpp"
#include "pn/shapes/canal_surface.hpp"
#include "pn/shapes/quadric_patches.hpp"
#include "pn/shapes/ruled_surface.hpp"
#include "pn/shapes/sphere_spans.hpp"

namespace pn {
namespace {

using Eigen::Vector3d;

/// Conics on infinite surfaces are drawn so far beyond the region.
constexpr double kBeyond = 1.0625;

/// What of a quadric the tracing of its regions needs, in doubles.
struct TracedQuadric {
  QuadricSections sections;
  std::function<Vector3d(const Vector3d& point)> normal;  ///< not of unit length
  std::function<Vector3d(const Vector3d& normal)> point;
  double size;                    ///< of the region [mm]
  std::array<double, 2> widths;   ///< half the extent of a graph in x and in y
  Vector3d some_point;            ///< of the surface
  std::array<Vector3d, 2> poles;  ///< of the parametrization; NaN where there is none
};

Vector3d no_point() { return Vector3d::Constant(std::nan("")); }

Vector3d product(const Vector3d& a, const Vector3d& b) { return a.cwiseProduct(b); }

/// Coordinates (x_axis, and the two others in order).
Vector3d assembled(std::size_t axis, double own, double next, double last) {
  Vector3d p;
  p(static_cast<Eigen::Index>(axis)) = own;
  p(static_cast<Eigen::Index>((axis + 1) % 3)) = next;
  p(static_cast<Eigen::Index>((axis + 2) % 3)) = last;
  return p;
}

BoundaryConic ellipse(std::size_t axis, double value, double next, double last) {
  return {[=](double t) {
            const double angle = 2 * M_PI * t;
            return assembled(axis, value, next * std::cos(angle), last * std::sin(angle));
          },
          true};
}

/// The umbilic of an ellipsoid or two-sheet hyperboloid at which the family begins or ends.
Vector3d pole_at(const QuadricFamily& family, double end) {
  const LocalForms forms = family.forms(64);
  const CircleForms<double> circles = midpoint(forms.circles);
  const Vector3d axis(circles.axis[0](end), circles.axis[1](end), circles.axis[2](end));
  return -axis / circles.level(end);
}

// The quadrics one by one ------------------------------------------------------------------------

TracedQuadric traced_ellipsoid(const Vector3d& a, const QuadricFamily& family) {
  TracedQuadric traced;
  traced.sections.plane = [=](std::size_t axis, double value) -> std::optional<BoundaryConic> {
    const auto i = static_cast<Eigen::Index>(axis);
    const double ratio = value / a(i);
    if (std::abs(ratio) >= 1) return std::nullopt;
    const double scale = std::sqrt((1 - ratio) * (1 + ratio));
    return ellipse(axis, value, scale * a((i + 1) % 3), scale * a((i + 2) % 3));
  };
  traced.sections.half_plane = [=](double angle) -> BoundaryConic {
    const double r = 1 / std::hypot(std::cos(angle) / a.x(), std::sin(angle) / a.y());
    return {[=](double t) {
              const double s = r * std::sin(M_PI * t);
              return Vector3d(s * std::cos(angle), s * std::sin(angle), a.z() * std::cos(M_PI * t));
            },
            false};
  };
  traced.normal = [=](const Vector3d& p) { return Vector3d(p.cwiseQuotient(product(a, a))); };
  traced.point = [=](const Vector3d& n) {
    return Vector3d(product(product(a, a), n) / product(a, n).norm());
  };
  traced.size = a.maxCoeff();
  traced.some_point = {0, 0, a.z()};
  traced.poles = {traced.point(pole_at(family, 0)), traced.point(pole_at(family, 1))};
  return traced;
}

/// Half the width of a region in x and in y, from its box and from what its height allows.
std::array<double, 2> half_widths(const QuadricBounds& bounds, double by_height_x,
                                  double by_height_y) {
  const auto width = [](const Interval& interval, double by_height) {
    return kBeyond * std::min(by_height, std::max(std::abs(interval.low), std::abs(interval.high)));
  };
  return {width(bounds.box[0], by_height_x), width(bounds.box[1], by_height_y)};
}

void require_bounded(const QuadricBounds& bounds, bool height_ends_it) {
  if (height_ends_it && bounds.box[2].high < HUGE_VAL) return;
  if (bounds.box[0].is_bounded() && bounds.box[1].is_bounded()) return;
  throw GeometryError(ErrorCode::kRegionUnbounded,
                      height_ends_it
                          ? "The surface is infinite. Give the largest height z, or bounds of both "
                            "x and y."
                          : "The surface is infinite. Give bounds of both x and y.");
}

/// A surface z = height(x, y) over a rectangle, with elliptic levels of these half-axes at a
/// height.
TracedQuadric traced_graph(const std::array<double, 2>& widths,
                           std::function<double(double, double)> height,
                           std::function<std::optional<std::array<double, 2>>(double)> level) {
  TracedQuadric traced;
  traced.sections.plane = [=](std::size_t axis, double value) -> std::optional<BoundaryConic> {
    if (axis == 2) {
      const auto half = level(value);
      if (!half) return std::nullopt;
      return ellipse(2, value, (*half)[0], (*half)[1]);
    }
    if (std::abs(value) >= widths[axis]) return std::nullopt;
    const double width = widths[1 - axis];
    return BoundaryConic{[=](double t) {
                           const double other = (2 * t - 1) * width;
                           const double x = axis == 0 ? value : other;
                           const double y = axis == 0 ? other : value;
                           return Vector3d(x, y, height(x, y));
                         },
                         false};
  };
  const double reach = std::hypot(widths[0], widths[1]);
  traced.sections.half_plane = [=](double angle) -> BoundaryConic {
    return {[=](double t) {
              const double x = t * reach * std::cos(angle), y = t * reach * std::sin(angle);
              return Vector3d(x, y, height(x, y));
            },
            false};
  };
  traced.size = reach;
  traced.widths = widths;
  traced.some_point = {0, 0, height(0, 0)};
  traced.poles = {no_point(), no_point()};
  return traced;
}

TracedQuadric traced_two_sheet_hyperboloid(const Vector3d& a, const QuadricBounds& bounds,
                                           const QuadricFamily& family) {
  require_bounded(bounds, true);
  const auto scale_at = [=](double z) {
    return std::sqrt(std::max(0.0, z * z / (a.z() * a.z()) - 1));
  };
  const double scale = scale_at(bounds.box[2].high);
  TracedQuadric traced = traced_graph(
      half_widths(bounds, scale * a.x(), scale * a.y()),
      [=](double x, double y) { return a.z() * std::hypot(1, std::hypot(x / a.x(), y / a.y())); },
      [=](double z) -> std::optional<std::array<double, 2>> {
        if (z <= a.z()) return std::nullopt;
        return std::array<double, 2>{scale_at(z) * a.x(), scale_at(z) * a.y()};
      });
  const Vector3d squares(a.x() * a.x(), a.y() * a.y(), -a.z() * a.z());
  traced.normal = [=](const Vector3d& p) { return Vector3d(p.cwiseQuotient(squares)); };
  traced.point = [=](const Vector3d& n) {
    return Vector3d(product(squares, n) / std::sqrt(-n.dot(product(squares, n))));
  };
  traced.poles[0] = traced.point(pole_at(family, 0));
  return traced;
}

TracedQuadric traced_elliptic_paraboloid(const Vector3d& a, const QuadricBounds& bounds,
                                         const QuadricFamily& family) {
  require_bounded(bounds, true);
  const double scale = std::sqrt(std::max(0.0, bounds.box[2].high / a.z()));
  TracedQuadric traced = traced_graph(
      half_widths(bounds, scale * a.x(), scale * a.y()),
      [=](double x, double y) {
        return a.z() * (x * x / (a.x() * a.x()) + y * y / (a.y() * a.y()));
      },
      [=](double z) -> std::optional<std::array<double, 2>> {
        if (z <= 0) return std::nullopt;
        return std::array<double, 2>{std::sqrt(z / a.z()) * a.x(), std::sqrt(z / a.z()) * a.y()};
      });
  const double px = a.x() * a.x() / (2 * a.z()), py = a.y() * a.y() / (2 * a.z());
  traced.normal = [=](const Vector3d& p) { return Vector3d(p.x() / px, p.y() / py, -1); };
  traced.point = [=](const Vector3d& n) {
    const double x = -px * n.x() / n.z(), y = -py * n.y() / n.z();
    return Vector3d(x, y, (x * x / px + y * y / py) / 2);
  };
  traced.poles[0] = traced.point(pole_at(family, 0));
  return traced;
}

// Regions ----------------------------------------------------------------------------------------

/// Where on a link a point of the surface lies.
using ParameterOf = std::function<double(const Vector3d& point, const Vector3d& normal)>;

std::vector<BoundaryLoop> traced_loops(const TracedQuadric& traced, const QuadricBounds& bounds) {
  std::vector<Vector3d> stops;
  for (const Vector3d& pole : traced.poles) {
    if (pole.allFinite()) stops.push_back(pole);
  }
  return boundary_loops(bounds, traced.sections, traced.size, stops);
}

BoundedRegion region_of(const TracedQuadric& traced, const QuadricBounds& bounds,
                        const std::vector<BoundaryLoop>& loops, const ParameterOf& parameter) {
  BoundedRegion region;
  for (const BoundaryLoop& loop : loops) {
    region.loops.emplace_back();
    for (const auto& arc : loop) {
      region.loops.back().push_back([=, normal = traced.normal](double s) -> ContactPoint {
        const Vector3d p = arc(s), n = normal(p).normalized();
        return {parameter(p, n), n};
      });
    }
  }
  region.contains = [=, point = traced.point](const Vector3d& n) {
    return is_inside(bounds, point(n));
  };
  // A pole on the boundary is an end of arcs, whatever rounding says of the bounds there.
  const auto ends_at = [&](const Vector3d& pole) {
    return std::any_of(loops.begin(), loops.end(), [&](const BoundaryLoop& loop) {
      return std::any_of(loop.begin(), loop.end(), [&](const auto& arc) {
        return (arc(0) - pole).norm() <= kSamePoint * traced.size;
      });
    });
  };
  const auto reaches = [&](const Vector3d& pole) {
    return pole.allFinite() && (is_inside(bounds, pole) || ends_at(pole));
  };
  region.has_first_pole = reaches(traced.poles[0]);
  region.has_last_pole = reaches(traced.poles[1]);
  if (loops.empty() && !is_inside(bounds, traced.some_point)) {
    throw GeometryError(ErrorCode::kRegionEmpty, "The bounds miss the surface.");
  }
  return region;
}

EnvelopeChain chain_of(Envelope envelope, Extent extent, std::vector<RationalPatch> base) {
  EnvelopeChain chain;
  chain.links.push_back({std::move(envelope), std::nullopt, 0, 1, Joint::kNone});
  chain.extent = std::move(extent);
  chain.base = std::move(base);
  return chain;
}

EnvelopeChain pencil_chain(const std::shared_ptr<const QuadricFamily>& family,
                           const TracedQuadric& traced, const QuadricBounds& bounds,
                           std::vector<RationalPatch> base) {
  const ParameterOf parameter = [family](const Vector3d&, const Vector3d& n) {
    return family->parameter(n);
  };
  return chain_of(
      Envelope([family](long precision) { return family->forms(precision); }, "nothing"),
      region_of(traced, bounds, traced_loops(traced, bounds), parameter), std::move(base));
}

// Ruled quadrics ---------------------------------------------------------------------------------

RationalPolynomial linear(const Rational& start, const Rational& end) {
  return RationalPolynomial({start, end - start});
}

/// Rulings between directrices, which no quadric has torsal: the place of the span is of no
/// account.
Envelope rulings_between(const SphereCurve& low, const SphereCurve& high) {
  return along_rulings(with_least_denominator(joined(low, high).rulings), {low, high},
                       {Rational(1), false, false});
}

struct Range {
  double low, high;

  void add(double x) {
    low = std::min(low, x);
    high = std::max(high, x);
  }
  /// A little wider, so that the boundary lies inside.
  Range widened() const {
    const double margin = 0.02 * (high - low);
    return {low - margin, high + margin};
  }
};

constexpr int kHullSamples = 64;

/// The range of a function on the boundary of a region, which holds that inside.
Range range_on(const std::vector<BoundaryLoop>& loops,
               const std::function<double(const Vector3d&)>& f) {
  Range range{HUGE_VAL, -HUGE_VAL};
  for (const BoundaryLoop& loop : loops) {
    for (const auto& arc : loop) {
      for (int i = 0; i <= kHullSamples; ++i) {
        range.add(f(arc(static_cast<double>(i) / kHullSamples)));
      }
    }
  }
  return range;
}

/// z = c (x^2/a^2 - y^2/b^2): T = x/a - y/b is constant on a ruling, S = x/a + y/b runs along it.
EnvelopeChain hyperbolic_paraboloid(const std::array<Rational, 3>& half, const Vector3d& a,
                                    const QuadricBounds& bounds) {
  if (std::isfinite(bounds.box[2].low) || std::isfinite(bounds.box[2].high)) {
    throw GeometryError(ErrorCode::kRegionUnsupported,
                        "Heights do not bound a hyperbolic paraboloid well. Give bounds of x and "
                        "y, or an angle.");
  }
  require_bounded(bounds, false);
  TracedQuadric traced = traced_graph(
      half_widths(bounds, HUGE_VAL, HUGE_VAL),
      [=](double x, double y) { return a.z() * (x / a.x() - y / a.y()) * (x / a.x() + y / a.y()); },
      [](double) { return std::nullopt; });
  const double px = a.x() * a.x() / (2 * a.z()), py = a.y() * a.y() / (2 * a.z());
  traced.normal = [=](const Vector3d& p) { return Vector3d(-p.x() / px, p.y() / py, 1); };
  traced.point = [=](const Vector3d& n) {
    const double x = -px * n.x() / n.z(), y = py * n.y() / n.z();
    return Vector3d(x, y, (x * x / px - y * y / py) / 2);
  };
  const std::vector<BoundaryLoop> loops = traced_loops(traced, bounds);
  if (loops.empty()) throw GeometryError(ErrorCode::kRegionEmpty, "The bounds miss the surface.");
  const auto ruling = [=](const Vector3d& p) { return p.x() / a.x() - p.y() / a.y(); };
  const Range t = range_on(loops, ruling).widened();
  const Range s =
      range_on(loops, [=](const Vector3d& p) { return p.x() / a.x() + p.y() / a.y(); }).widened();
  const Rational half_number = Rational(1) / Rational(2);
  const RationalPolynomial tau = linear(Rational::exactly(t.low), Rational::exactly(t.high));
  const auto directrix = [&](double along) -> SphereCurve {
    const RationalPolynomial sigma(Rational::exactly(along));
    return {{(sigma + tau) * RationalPolynomial(half[0] * half_number),
             (sigma - tau) * RationalPolynomial(half[1] * half_number),
             sigma * tau * RationalPolynomial(half[2])},
            RationalPolynomial(0L),
            RationalPolynomial(1L)};
  };
  return chain_of(rulings_between(directrix(s.low), directrix(s.high)),
                  region_of(traced, bounds, loops,
                            [=](const Vector3d& p, const Vector3d&) {
                              return (ruling(p) - t.low) / (t.high - t.low);
                            }),
                  paraboloid_patches(half, -1, 1, bounds, traced.widths));
}

/// The directrix at height z over the rulings T = n / d of x^2/a^2 + y^2/b^2 - z^2/c^2 = 1.
SphereCurve hyperboloid_directrix(const std::array<Rational, 3>& half, const Rational& z,
                                  const RationalPolynomial& n, const RationalPolynomial& d) {
  const auto times = [](const Rational& x, const RationalPolynomial& p) {
    return RationalPolynomial(x) * p;
  };
  const RationalPolynomial sum = d * d + n * n, difference = d * d - n * n;
  const RationalPolynomial mixed = times(Rational(2), n * d);
  return {{times(half[0], times(half[2], mixed) + times(z, difference)),
           times(half[1], times(z, mixed) - times(half[2], difference)), times(z * half[2], sum)},
          RationalPolynomial(0L),
          times(half[2], sum)};
}

/// All the way around: four links, between which (n, d) turns by equal areas, so that their
/// sections meet with the same weights.
EnvelopeChain whole_one_sheet_hyperboloid(const std::array<Rational, 3>& half,
                                          const Interval& heights) {
  constexpr std::array<std::array<long, 2>, 5> kCorners = {
      {{0, 1}, {1, 1}, {1, 0}, {1, -1}, {0, -1}}};
  EnvelopeChain chain;
  chain.extent = RulingBand{};
  chain.closed = true;
  for (std::size_t i = 0; i < 4; ++i) {
    const auto between = [&](std::size_t c) {
      return linear(Rational(kCorners[i][c]), Rational(kCorners[i + 1][c]));
    };
    const auto directrix = [&](double z) {
      return hyperboloid_directrix(half, Rational::exactly(z), between(0), between(1));
    };
    const SphereCurve low = directrix(heights.low), high = directrix(heights.high);
    chain.links.push_back({rulings_between(low, high), std::nullopt, static_cast<double>(i),
                           static_cast<double>(i + 1), Joint::kTangent});
    chain.base.push_back(ruled_patch(low, high));
  }
  return chain;
}

/// The largest turn of the rulings, as an angle of (n, d), that one link covers well.
constexpr double kWidestLink = 0.75 * M_PI;

EnvelopeChain one_sheet_hyperboloid(const std::array<Rational, 3>& half, const Vector3d& a,
                                    const QuadricBounds& bounds) {
  const Interval& heights = bounds.box[2];
  if (!heights.is_bounded()) {
    throw GeometryError(ErrorCode::kRegionUnbounded,
                        "The surface is infinite. Give the least and the largest height z.");
  }
  for (const std::size_t axis : {0u, 1u}) {
    if (std::isfinite(bounds.box[axis].low) || std::isfinite(bounds.box[axis].high)) {
      throw GeometryError(ErrorCode::kRegionUnsupported,
                          "Of a one-sheet hyperboloid bounds of z and of the angle are supported, "
                          "not of x and y.");
    }
  }
  if (!bounds.angle) return whole_one_sheet_hyperboloid(half, heights);
  TracedQuadric traced;
  const auto scale_at = [=](double z) { return std::hypot(1, z / a.z()); };
  traced.sections.plane = [=](std::size_t axis, double z) -> std::optional<BoundaryConic> {
    return ellipse(axis, z, scale_at(z) * a.x(), scale_at(z) * a.y());
  };
  traced.sections.half_plane = [=](double angle) -> BoundaryConic {
    const double r = 1 / std::hypot(std::cos(angle) / a.x(), std::sin(angle) / a.y());
    const double low = heights.low, high = heights.high;
    const double over = 0.25 * (high - low);
    return {[=](double t) {
              const double z = low - over + t * (high - low + 2 * over);
              const double s = r * scale_at(z);
              return Vector3d(s * std::cos(angle), s * std::sin(angle), z);
            },
            false};
  };
  const Vector3d squares(a.x() * a.x(), a.y() * a.y(), -a.z() * a.z());
  traced.normal = [=](const Vector3d& p) { return Vector3d(p.cwiseQuotient(squares)); };
  traced.point = [=](const Vector3d& n) {
    return Vector3d(product(squares, n) / std::sqrt(n.dot(product(squares, n))));
  };
  traced.size = scale_at(std::max(std::abs(heights.low), std::abs(heights.high))) * a.maxCoeff();
  traced.poles = {no_point(), no_point()};
  traced.some_point = no_point();
  const std::vector<BoundaryLoop> loops = traced_loops(traced, bounds);
  // The direction of (n, d) on the ruling through a point, from the start of the sector on.
  const double middle_angle = (bounds.angle->low + bounds.angle->high) / 2;
  const Vector3d middle(a.x() * std::cos(middle_angle), a.y() * std::sin(middle_angle), 0);
  const auto direction = [=](const Vector3d& p) {
    const double first = p.x() / a.x() - p.z() / a.z(), second = 1 - p.y() / a.y();
    const double third = 1 + p.y() / a.y(), fourth = p.x() / a.x() + p.z() / a.z();
    return std::hypot(first, second) > std::hypot(third, fourth) ? std::atan2(first, second)
                                                                 : std::atan2(third, fourth);
  };
  const double start = direction(middle);
  const auto turn = [=](const Vector3d& p) { return std::remainder(direction(p) - start, M_PI); };
  const Range range = range_on(loops, turn).widened();
  if (range.high - range.low > kWidestLink) {
    throw GeometryError(
        ErrorCode::kRegionUnsupported,
        "The sector is too wide for its rulings. Divide it, or take the surface all "
        "around.");
  }
  const auto corner = [&](double by) {
    return std::array<Rational, 2>{Rational::exactly(std::sin(start + by)),
                                   Rational::exactly(std::cos(start + by))};
  };
  const auto first = corner(range.low), last = corner(range.high);
  const RationalPolynomial n = linear(first[0], last[0]), d = linear(first[1], last[1]);
  const auto place = [=](const Vector3d& p, const Vector3d&) {
    const double angle = start + turn(p), s = std::sin(angle), c = std::cos(angle);
    const double at_first = first[0].to_double() * c - first[1].to_double() * s;
    const double at_last = last[0].to_double() * c - last[1].to_double() * s;
    return at_first / (at_first - at_last);
  };
  const SphereCurve low = hyperboloid_directrix(half, Rational::exactly(heights.low), n, d);
  const SphereCurve high = hyperboloid_directrix(half, Rational::exactly(heights.high), n, d);
  return chain_of(rulings_between(low, high), region_of(traced, bounds, loops, place),
                  {bounded(ruled_patch(low, high), bounds)});
}

// Developable quadrics ---------------------------------------------------------------------------

void require_heights_only(const QuadricBounds& bounds) {
  if (!bounds.box[2].is_bounded()) {
    throw GeometryError(ErrorCode::kRegionUnbounded,
                        "The surface is infinite. Give the least and the largest height z.");
  }
  const auto is_bound = [](const Interval& i) {
    return std::isfinite(i.low) || std::isfinite(i.high);
  };
  if (!bounds.angle && !is_bound(bounds.box[0]) && !is_bound(bounds.box[1])) return;
  throw GeometryError(ErrorCode::kRegionUnsupported,
                      "Of cylinders and cones only bounds of the height z are supported.");
}

void require_revolution(const std::array<double, 3>& half_axes, const char* what) {
  if (half_axes[0] == half_axes[1]) return;
  throw GeometryError(ErrorCode::kNotRational,
                      std::string("The offset of an elliptic ") + what +
                          " is not rational: its normals have the length of an ellipse's, an "
                          "elliptic function. Only the one of revolution (a = b) is exact.");
}

EnvelopeChain cylinder_of_revolution(double radius, const Interval& heights) {
  return canal_surface(Curve::bezier({{0, 0, heights.low}, {0, 0, heights.high}}),
                       Law::constant(radius));
}

/// Spheres on the axis that touch the cone at the heights of the region.
LocalForms cone_forms(const Rational& a, const Rational& c, const Interval& heights,
                      long precision) {
  const RealBall squares(a * a + c * c, precision);
  const RealBall sine = RealBall(a, precision) / sqrt(squares);
  const RealBall up = squares / RealBall(c * c, precision);
  const RealBall low = up * RealBall(Rational::exactly(heights.low), precision);
  const RealBall rise =
      up * RealBall(Rational::exactly(heights.high) - Rational::exactly(heights.low), precision);
  const Form<RealBall> zero = Form<RealBall>::zero(1), centre({low, rise});
  const bool below = heights.high < 0;
  const RealBall growth = below ? -sine : sine;
  const Form<RealBall> none = Form<RealBall>::zero(0);
  return {SphereCurveForms<RealBall>{
              {zero, zero, centre}, centre * growth, Form<RealBall>({RealBall(1), RealBall(0)})},
          CircleForms<RealBall>{{none, none, Form<RealBall>::constant(RealBall(1))},
                                Form<RealBall>::constant(growth)},
          {},
          false};
}

EnvelopeChain cone_of_revolution(const Rational& a, const Rational& c, const Interval& heights) {
  if (heights.low <= 0 && heights.high >= 0) {
    throw GeometryError(ErrorCode::kRegionUnsupported,
                        "The region holds the apex of the cone, where it has no normal. Give "
                        "heights on one side of z = 0.");
  }
  EnvelopeChain chain = chain_of(
      Envelope([=](long precision) { return cone_forms(a, c, heights, precision); }, "nothing"),
      WholeCircle{}, cone_patches({a, a, c}, heights));
  chain.links.front().begin = heights.low;
  chain.links.front().end = heights.high;
  return chain;
}

/// Between the parabolas at both ends of y; from the far one to the near one the normal is below.
EnvelopeChain parabolic_cylinder(const HalfAxes& half, const QuadricBounds& bounds) {
  require_bounded(bounds, false);
  const Interval &x = bounds.box[0], &z = bounds.box[2];
  if (bounds.angle || std::isfinite(z.low) || std::isfinite(z.high)) {
    throw GeometryError(ErrorCode::kRegionUnsupported,
                        "Of a parabolic cylinder bounds of x and y are supported.");
  }
  const RationalPolynomial across = linear(Rational::exactly(x.low), Rational::exactly(x.high));
  const auto parabola = [&](double y) -> SphereCurve {
    return {{across, RationalPolynomial(Rational::exactly(y)),
             RationalPolynomial(half[2] / (half[0] * half[0])) * across * across},
            RationalPolynomial(0L),
            RationalPolynomial(1L)};
  };
  return ruled_surface(parabola(bounds.box[1].high), parabola(bounds.box[1].low));
}

void require_half_axes(QuadricKind kind, const std::array<double, 3>& half_axes) {
  for (std::size_t i = 0; i < 3; ++i) {
    const bool is_unused = (kind == QuadricKind::kEllipticCylinder && i == 2) ||
                           (kind == QuadricKind::kParabolicCylinder && i == 1);
    if (is_unused) continue;
    const std::string name(1, "abc"[i]);
    if (!std::isfinite(half_axes[i])) {
      throw GeometryError(ErrorCode::kNotFinite, "The half-axis " + name + " is not a number.");
    }
    if (half_axes[i] <= 0) {
      throw GeometryError(
          ErrorCode::kBadAxis,
          "The half-axis " + name + " must be positive; it is " + show(half_axes[i]) + ".");
    }
  }
}

}  // namespace

EnvelopeChain quadric(QuadricKind kind, const std::array<double, 3>& half_axes,
                      const QuadricBounds& bounds) {
  require_half_axes(kind, half_axes);
  require_bounds(bounds);
  const Vector3d a(half_axes[0], half_axes[1], half_axes[2]);
  const std::array<Rational, 3> half = {Rational::exactly(a.x()), Rational::exactly(a.y()),
                                        Rational::exactly(a.z())};
  switch (kind) {
    case QuadricKind::kEllipsoid: {
      const auto family = ellipsoid_family(half);
      return pencil_chain(family, traced_ellipsoid(a, *family), bounds,
                          ellipsoid_patches(half, bounds));
    }
    case QuadricKind::kTwoSheetHyperboloid: {
      const auto family = two_sheet_hyperboloid_family(half);
      const TracedQuadric traced = traced_two_sheet_hyperboloid(a, bounds, *family);
      return pencil_chain(family, traced, bounds,
                          two_sheet_hyperboloid_patches(half, bounds, traced.widths));
    }
    case QuadricKind::kEllipticParaboloid: {
      const auto family = elliptic_paraboloid_family(half);
      const TracedQuadric traced = traced_elliptic_paraboloid(a, bounds, *family);
      return pencil_chain(family, traced, bounds,
                          paraboloid_patches(half, 1, -1, bounds, traced.widths));
    }
    case QuadricKind::kHyperbolicParaboloid:
      return hyperbolic_paraboloid(half, a, bounds);
    case QuadricKind::kOneSheetHyperboloid:
      return one_sheet_hyperboloid(half, a, bounds);
    case QuadricKind::kEllipticCylinder:
      require_heights_only(bounds);
      require_revolution(half_axes, "cylinder");
      return cylinder_of_revolution(half_axes[0], bounds.box[2]);
    case QuadricKind::kEllipticCone:
      require_heights_only(bounds);
      require_revolution(half_axes, "cone");
      return cone_of_revolution(half[0], half[2], bounds.box[2]);
    case QuadricKind::kParabolicCylinder:
      return parabolic_cylinder(half, bounds);
  }
  throw std::logic_error("a kind of quadric without a construction");
}

}  // namespace pn
