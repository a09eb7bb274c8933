// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/shapes/quadric.hpp"

#include <algorithm>
#include <cmath>

#include "pn/geometry_error.hpp"
#include "pn/input_numbers.hpp"
#include "pn/isotropic/along_rulings.hpp"
#include "pn/isotropic/quadric_pencil.hpp"
#include "pn/shapes/canal_surface.hpp"
#include "pn/shapes/quadric_patches.hpp"
#include "pn/shapes/ruled_surface.hpp"
#include "pn/shapes/sphere_spans.hpp"

namespace pn {
namespace {

using Eigen::Vector3d;

/// Graphs are certified a little beyond the region.
constexpr double kBeyond = 1.0625;

Vector3d no_point() { return Vector3d::Constant(std::nan("")); }

Vector3d product(const Vector3d& a, const Vector3d& b) { return a.cwiseProduct(b); }

Interval about_zero(double width) { return {-width, width}; }

GeometryError bounds_miss() { return {ErrorCode::kRegionEmpty, "The bounds miss the surface."}; }

/// What two intervals have in common; the bounds miss the surface where that is nothing.
Interval common(const Interval& a, const Interval& b) {
  const Interval result = {std::max(a.low, b.low), std::min(a.high, b.high)};
  if (result.low <= result.high) return result;
  throw bounds_miss();
}

double farthest(const Interval& interval) {
  return std::max(std::abs(interval.low), std::abs(interval.high));
}

/// A quadric with the normal and its inverse, in doubles.
struct OrientedQuadric {
  TracedQuadric traced;
  double side;                                               ///< of the gradient
  std::array<Vector3d, 2> poles = {no_point(), no_point()};  ///< of the parametrization, if any

  /// Not of unit length.
  Vector3d normal(const Vector3d& p) const { return side * traced.equation.half_gradient(p); }
  /// Of a surface that is not developable.
  Vector3d point(const Vector3d& n) const {
    const auto& [square, half_linear, constant, is_upper] = traced.equation;
    if (half_linear != 0) {
      const double x = half_linear * n.x() / (n.z() * square.x()),
                   y = half_linear * n.y() / (n.z() * square.y());
      return {x, y, -(square.x() * x * x + square.y() * y * y) / (2 * half_linear)};
    }
    const Vector3d p = n.cwiseQuotient(square);
    return side * std::sqrt(-constant / n.dot(p)) * p;
  }
};

/// The umbilic of a quadric at which the family begins or ends.
Vector3d pole_at(const OrientedQuadric& quadric, const QuadricFamily& family, double end) {
  const LocalForms forms = family.forms(64);
  const CircleForms<double> circles = midpoint(forms.circles);
  const Vector3d axis(circles.axis[0](end), circles.axis[1](end), circles.axis[2](end));
  return quadric.point(-axis / circles.level(end));
}

/// Of a surface that opens upwards.
void require_bounded(const QuadricBounds& bounds) {
  if (bounds.box[2].high < HUGE_VAL) return;
  if (bounds.box[0].is_bounded() && bounds.box[1].is_bounded()) return;
  throw GeometryError(ErrorCode::kRegionUnbounded,
                      "The surface is infinite. Give the largest height z, or bounds of both x and "
                      "y.");
}

void require_heights(const QuadricBounds& bounds) {
  if (bounds.box[2].is_bounded()) return;
  throw GeometryError(ErrorCode::kRegionUnbounded,
                      "The surface is infinite. Give the least and the largest height z.");
}

// The quadrics one by one ------------------------------------------------------------------------

OrientedQuadric oriented_ellipsoid(const Vector3d& a, const QuadricFamily& family) {
  const Box extent = {about_zero(a.x()), about_zero(a.y()), about_zero(a.z())};
  OrientedQuadric quadric{{{product(a, a).cwiseInverse(), 0, -1, false}, extent, extent, {}}, 1};
  quadric.poles = {pole_at(quadric, family, 0), pole_at(quadric, family, 1)};
  quadric.traced.stops = {quadric.poles[0], quadric.poles[1]};
  return quadric;
}

/// A surface that opens upwards from its vertex, with elliptic levels whose half-axes are these
/// times a scale that depends on the height.
OrientedQuadric oriented_bowl(const QuadricEquation& equation, const Vector3d& a, double vertex,
                              const std::function<double(double)>& scale_at,
                              const std::function<double(double, double)>& height,
                              const QuadricBounds& bounds) {
  require_bounded(bounds);
  const Interval infinite, upwards = {vertex, HUGE_VAL};
  const double scale = scale_at(common(upwards, bounds.box[2]).high);
  if (!(scale > 0)) throw bounds_miss();
  const Interval x = common(bounds.box[0], about_zero(scale * a.x())),
                 y = common(bounds.box[1], about_zero(scale * a.y()));
  const Interval z = common(bounds.box[2], {vertex, height(farthest(x), farthest(y))});
  return {{equation, {infinite, infinite, upwards}, {x, y, z}, {}}, 1};
}

OrientedQuadric with_first_pole(OrientedQuadric quadric, const QuadricFamily& family) {
  quadric.poles[0] = pole_at(quadric, family, 0);
  quadric.traced.stops = {quadric.poles[0]};
  return quadric;
}

OrientedQuadric oriented_two_sheet_hyperboloid(const Vector3d& a, const QuadricBounds& bounds) {
  const Vector3d squares(a.x() * a.x(), a.y() * a.y(), -a.z() * a.z());
  return oriented_bowl(
      {squares.cwiseInverse(), 0, 1, true}, a, a.z(),
      [=](double z) { return std::sqrt((z / a.z() - 1) * (z / a.z() + 1)); },
      [=](double x, double y) { return a.z() * std::hypot(1, std::hypot(x / a.x(), y / a.y())); },
      bounds);
}

/// c (1/a^2, sign/b^2, 0).
Vector3d squares_of_paraboloid(const Vector3d& a, double sign) {
  return {a.z() / (a.x() * a.x()), sign * a.z() / (a.y() * a.y()), 0};
}

OrientedQuadric oriented_elliptic_paraboloid(const Vector3d& a, const QuadricBounds& bounds) {
  const Vector3d squares = squares_of_paraboloid(a, 1);
  return oriented_bowl(
      {squares, -0.5, 0, false}, a, 0, [=](double z) { return std::sqrt(z / a.z()); },
      [=](double x, double y) { return squares.x() * x * x + squares.y() * y * y; }, bounds);
}

/// Around a region of a paraboloid: above the border of the rectangle that holds it, but not above
/// its largest height.
std::vector<Vector3d> farthest_normals(const OrientedQuadric& paraboloid) {
  constexpr int kPlaces = 16;
  const auto& [x, y, z] = paraboloid.traced.reach;
  const double top = z.high;
  const Vector3d& square = paraboloid.traced.equation.square;
  std::vector<Vector3d> normals;
  const auto add = [&](double p, double q) {
    const double height = square.x() * p * p + square.y() * q * q;
    const double scale = std::sqrt(std::min(1.0, top / height));
    normals.push_back(paraboloid.normal({scale * p, scale * q, 0}).normalized());
  };
  for (int i = 0; i <= kPlaces; ++i) {
    const double part = static_cast<double>(i) / kPlaces;
    for (const double p : {x.low, x.high}) add(p, y.low + part * (y.high - y.low));
    for (const double q : {y.low, y.high}) add(x.low + part * (x.high - x.low), q);
  }
  return normals;
}

/// Half the width in x and in y of a rectangle over which a region is certified.
std::array<double, 2> half_widths(const OrientedQuadric& quadric) {
  return {kBeyond * farthest(quadric.traced.reach[0]), kBeyond * farthest(quadric.traced.reach[1])};
}

// Regions ----------------------------------------------------------------------------------------

/// Where on a link a point of the surface lies, and the point of a place.
struct Parametrization {
  std::function<double(const Vector3d& point, const Vector3d& normal)> parameter;
  std::function<Vector3d(const ContactPoint&)> point;
};

Parametrization by_normals(const OrientedQuadric& quadric,
                           std::function<double(const Vector3d&, const Vector3d&)> parameter) {
  return {std::move(parameter), [=](const ContactPoint& at) { return quadric.point(at.normal); }};
}

/// The loops of a region that is not the whole surface.
std::vector<RegionLoop> region_loops(const OrientedQuadric& quadric, const QuadricBounds& bounds) {
  std::vector<RegionLoop> loops = region_loops(bounds, quadric.traced);
  if (loops.empty()) throw bounds_miss();
  return loops;
}

BoundedRegion region_of(const OrientedQuadric& quadric, const QuadricBounds& bounds,
                        const std::vector<RegionLoop>& loops,
                        const Parametrization& parametrization) {
  BoundedRegion region;
  for (const RegionLoop& loop : loops) {
    region.loops.emplace_back();
    for (const auto& arc : loop) {
      region.loops.back().push_back(
          [=, parameter = parametrization.parameter](double s) -> ContactPoint {
            const Vector3d p = arc(s), n = quadric.normal(p).normalized();
            return {parameter(p, n), n};
          });
    }
  }
  region.contains = [=, point = parametrization.point](const ContactPoint& at) {
    return is_inside(bounds, point(at));
  };
  // A pole on the boundary is an end of arcs, whatever rounding says of the bounds there.
  const auto ends_at = [&](const Vector3d& pole) {
    return std::any_of(loops.begin(), loops.end(), [&](const RegionLoop& loop) {
      return std::any_of(loop.begin(), loop.end(), [&](const auto& arc) {
        return (arc(0) - pole).norm() <= kSamePoint * quadric.traced.size();
      });
    });
  };
  const auto reaches = [&](const Vector3d& pole) {
    return pole.allFinite() && (is_inside(bounds, pole) || ends_at(pole));
  };
  region.has_first_pole = reaches(quadric.poles[0]);
  region.has_last_pole = reaches(quadric.poles[1]);
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
                           const OrientedQuadric& quadric, const QuadricBounds& bounds,
                           std::vector<RationalPatch> base) {
  const Parametrization parametrization = by_normals(
      quadric, [family](const Vector3d&, const Vector3d& n) { return family->parameter(n); });
  const QuadricBounds effective = effective_bounds(bounds, quadric.traced);
  const auto loops =
      are_none(effective) ? std::vector<RegionLoop>{} : region_loops(quadric, effective);
  return chain_of(
      Envelope([family](long precision) { return family->forms(precision); }, "nothing"),
      region_of(quadric, effective, loops, parametrization), std::move(base));
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
Range range_on(const std::vector<RegionLoop>& loops,
               const std::function<double(const Vector3d&)>& f) {
  Range range{HUGE_VAL, -HUGE_VAL};
  for (const RegionLoop& loop : loops) {
    for (const auto& arc : loop) {
      for (int i = 0; i <= kHullSamples; ++i) {
        range.add(f(arc(static_cast<double>(i) / kHullSamples)));
      }
    }
  }
  return range;
}

/// Half the extent of a saddle in one direction across, where only its heights and the other
/// direction are bounded: |y / b| of |z| = c ((y / b)^2 - (x / a)^2).
double width_by_height(double other, double height, double c) {
  return std::sqrt(other * other + std::max(0.0, height) / c);
}

OrientedQuadric oriented_hyperbolic_paraboloid(const Vector3d& a, const QuadricBounds& bounds) {
  const Vector3d squares = squares_of_paraboloid(a, -1);
  const auto& [in_x, in_y, in_z] = bounds.box;
  Interval x = in_x, y = in_y;
  if (x.is_bounded() && in_z.low > -HUGE_VAL) {
    y = common(y, about_zero(a.y() * width_by_height(farthest(x) / a.x(), -in_z.low, a.z())));
  }
  if (y.is_bounded() && in_z.high < HUGE_VAL) {
    x = common(x, about_zero(a.x() * width_by_height(farthest(y) / a.y(), in_z.high, a.z())));
  }
  if (!x.is_bounded() || !y.is_bounded()) {
    throw GeometryError(ErrorCode::kRegionUnbounded,
                        "The surface is infinite. Give bounds of both x and y, or of one of them "
                        "and of the height z.");
  }
  const Interval z = common(
      in_z, {squares.y() * farthest(y) * farthest(y), squares.x() * farthest(x) * farthest(x)});
  return {{{squares, -0.5, 0, false}, Box(), {x, y, z}, {}}, -1};
}

/// z = c (x^2/a^2 - y^2/b^2): T = x/a - y/b is constant on a ruling, S = x/a + y/b runs along it.
EnvelopeChain hyperbolic_paraboloid(const std::array<Rational, 3>& half, const Vector3d& a,
                                    const QuadricBounds& given) {
  const OrientedQuadric quadric = oriented_hyperbolic_paraboloid(a, given);
  const QuadricBounds bounds = effective_bounds(given, quadric.traced);
  const auto loops = region_loops(quadric, bounds);
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
                  region_of(quadric, bounds, loops,
                            by_normals(quadric,
                                       [=](const Vector3d& p, const Vector3d&) {
                                         return (ruling(p) - t.low) / (t.high - t.low);
                                       })),
                  paraboloid_patches(half, -1, 1, bounds, half_widths(quadric)));
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

/// Nothing but heights bounds a surface around the z-axis.
bool is_whole_ring(const QuadricBounds& bounds) {
  return are_none({{bounds.box[0], bounds.box[1], Interval()}, bounds.angle});
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

OrientedQuadric oriented_one_sheet_hyperboloid(const Vector3d& a, const QuadricBounds& bounds) {
  const Interval& z = bounds.box[2];
  const double scale = std::hypot(1, farthest(z) / a.z());
  const Interval x = common(bounds.box[0], about_zero(scale * a.x())),
                 y = common(bounds.box[1], about_zero(scale * a.y()));
  const Vector3d squares(a.x() * a.x(), a.y() * a.y(), -a.z() * a.z());
  // Between the heights, which always cut it, the surface has an extent.
  const Box extent = {about_zero(scale * a.x()), about_zero(scale * a.y()), Interval()};
  return {{{squares.cwiseInverse(), 0, -1, false}, extent, {x, y, z}, {}}, 1};
}

/// Angles modulo pi on the loops: the middle of the shortest arc that holds them all.
double middle_on(const std::vector<RegionLoop>& loops,
                 const std::function<double(const Vector3d&)>& angle) {
  std::vector<double> angles;
  for (const RegionLoop& loop : loops) {
    for (const auto& arc : loop) {
      for (int i = 0; i <= kHullSamples; ++i) {
        const double x = angle(arc(static_cast<double>(i) / kHullSamples));
        angles.push_back(x - M_PI * std::floor(x / M_PI));
      }
    }
  }
  std::sort(angles.begin(), angles.end());
  double middle = (angles.front() + angles.back()) / 2;
  double widest = angles.front() + M_PI - angles.back();
  for (std::size_t i = 0; i + 1 < angles.size(); ++i) {
    if (angles[i + 1] - angles[i] <= widest) continue;
    widest = angles[i + 1] - angles[i];
    middle = (angles[i] + angles[i + 1] + M_PI) / 2;
  }
  return middle;
}

EnvelopeChain one_sheet_hyperboloid(const std::array<Rational, 3>& half, const Vector3d& a,
                                    const QuadricBounds& given) {
  require_heights(given);
  const Interval& heights = given.box[2];
  const OrientedQuadric quadric = oriented_one_sheet_hyperboloid(a, given);
  const QuadricBounds bounds = effective_bounds(given, quadric.traced);
  if (is_whole_ring(bounds)) return whole_one_sheet_hyperboloid(half, heights);
  const auto loops = region_loops(quadric, bounds);
  // The direction of (n, d) on the ruling through a point.
  const auto direction = [=](const Vector3d& p) {
    const double first = p.x() / a.x() - p.z() / a.z(), second = 1 - p.y() / a.y();
    const double third = 1 + p.y() / a.y(), fourth = p.x() / a.x() + p.z() / a.z();
    return std::hypot(first, second) > std::hypot(third, fourth) ? std::atan2(first, second)
                                                                 : std::atan2(third, fourth);
  };
  const double start = middle_on(loops, direction);
  const auto turn = [=](const Vector3d& p) { return std::remainder(direction(p) - start, M_PI); };
  const Range range = range_on(loops, turn).widened();
  if (range.high - range.low > kWidestLink) {
    throw GeometryError(ErrorCode::kRegionUnsupported,
                        "The region goes too far around for its rulings. Divide it by angles, or "
                        "take the surface all around.");
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
  return chain_of(rulings_between(low, high),
                  region_of(quadric, bounds, loops, by_normals(quadric, place)),
                  {bounded(ruled_patch(low, high), bounds)});
}

// Developable quadrics ---------------------------------------------------------------------------

void require_revolution(const std::array<double, 3>& half_axes, const char* what) {
  if (half_axes[0] == half_axes[1]) return;
  throw GeometryError(ErrorCode::kNotRational,
                      std::string("The offset of an elliptic ") + what +
                          " is not rational: its normals have the length of an ellipse's, an "
                          "elliptic function. Only the one of revolution (a = b) is exact.");
}

/// A surface of revolution about z, which between its heights has this radius at most.
OrientedQuadric oriented_about_axis(const QuadricEquation& equation, double widest,
                                    const QuadricBounds& bounds) {
  const Interval width = about_zero(widest);
  const Box extent = {width, width, Interval()};
  const Box reach = {common(bounds.box[0], width), common(bounds.box[1], width), bounds.box[2]};
  return {{equation, extent, reach, {}}, 1};
}

/// Heights somewhat beyond those of a region, so that its boundary lies inside, and on the same
/// side of an apex at z = 0.
Interval beyond_heights(const Interval& heights, bool has_apex) {
  constexpr double kMargin = 0.0625;
  const double margin = kMargin * (heights.high - heights.low);
  const Interval wider = {heights.low - margin, heights.high + margin};
  if (!has_apex) return wider;
  return {heights.low > 0 ? std::max(wider.low, heights.low / 2) : wider.low,
          heights.high < 0 ? std::min(wider.high, heights.high / 2) : wider.high};
}

/// The region of a link over these heights, on which t grows with z, where bounds cut it further.
BoundedRegion region_about_axis(const OrientedQuadric& quadric, const QuadricBounds& bounds,
                                const Interval& heights,
                                const std::function<double(double)>& radius_at) {
  const double low = heights.low, high = heights.high;
  const Parametrization parametrization = {
      [=](const Vector3d& p, const Vector3d&) { return (p.z() - low) / (high - low); },
      [=](const ContactPoint& at) -> Vector3d {
        const double z = low + at.t * (high - low);
        const double scale = radius_at(z) / std::hypot(at.normal.x(), at.normal.y());
        return {scale * at.normal.x(), scale * at.normal.y(), z};
      }};
  return region_of(quadric, bounds, region_loops(quadric, bounds), parametrization);
}

EnvelopeChain cylinder_between(double radius, const Interval& heights) {
  return canal_surface(Curve::bezier({{0, 0, heights.low}, {0, 0, heights.high}}),
                       Law::constant(radius));
}

EnvelopeChain cylinder_of_revolution(double radius, const QuadricBounds& given) {
  require_heights(given);
  const double square = 1 / (radius * radius);
  const OrientedQuadric quadric =
      oriented_about_axis({{square, square, 0}, 0, -1, false}, radius, given);
  const QuadricBounds bounds = effective_bounds(given, quadric.traced);
  if (is_whole_ring(bounds)) return cylinder_between(radius, given.box[2]);
  const Interval heights = beyond_heights(given.box[2], false);
  EnvelopeChain chain = cylinder_between(radius, heights);
  chain.extent = region_about_axis(quadric, bounds, heights, [=](double) { return radius; });
  return chain;
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

EnvelopeChain cone_of_revolution(const HalfAxes& half, const QuadricBounds& given) {
  require_heights(given);
  if (given.box[2].low <= 0 && given.box[2].high >= 0) {
    throw GeometryError(ErrorCode::kRegionUnsupported,
                        "The region holds the apex of the cone, where it has no normal. Give "
                        "heights on one side of z = 0.");
  }
  const double a = half[0].to_double(), c = half[2].to_double();
  const OrientedQuadric quadric =
      oriented_about_axis({{1 / (a * a), 1 / (a * a), -1 / (c * c)}, 0, 0, false},
                          farthest(given.box[2]) * a / c, given);
  const QuadricBounds bounds = effective_bounds(given, quadric.traced);
  const bool is_whole = is_whole_ring(bounds);
  const Interval heights = is_whole ? given.box[2] : beyond_heights(given.box[2], true);
  const auto radius_at = [=](double z) { return std::abs(z) * a / c; };
  Extent extent = WholeCircle{};
  if (!is_whole) extent = region_about_axis(quadric, bounds, heights, radius_at);
  std::vector<RationalPatch> patches;
  for (const RationalPatch& patch : cone_patches(half, given.box[2])) {
    patches.push_back(bounded(patch, bounds));
  }
  EnvelopeChain chain = chain_of(
      Envelope([=](long precision) { return cone_forms(half[0], half[2], heights, precision); },
               "nothing"),
      std::move(extent), std::move(patches));
  if (!is_whole) return chain;
  chain.links.front().begin = heights.low;
  chain.links.front().end = heights.high;
  return chain;
}

/// The widths of a parabolic cylinder at which its heights are those of the bounds.
Interval within_heights(const Interval& x, const Interval& z, const HalfAxes& half) {
  const auto width_at = [&](double height) {
    return half[0].to_double() * std::sqrt(std::max(0.0, height) / half[2].to_double());
  };
  if (z.high <= 0) throw bounds_miss();
  const Interval below = z.high < HUGE_VAL ? common(x, about_zero(width_at(z.high))) : x;
  if (z.low <= 0) return below;
  const double least = width_at(z.low);
  if (below.low > -least) return common(below, {least, HUGE_VAL});
  if (below.high < least) return common(below, {-HUGE_VAL, -least});
  throw GeometryError(ErrorCode::kRegionUnsupported,
                      "The least height leaves two parts of the parabolic cylinder. Bound x to one "
                      "of them.");
}

/// Between the parabolas at both ends of y; from the far one to the near one the normal is below.
EnvelopeChain parabolic_cylinder(const HalfAxes& half, const QuadricBounds& bounds) {
  if (bounds.angle) {
    throw GeometryError(ErrorCode::kRegionUnsupported,
                        "A parabolic cylinder has no sectors. Bound x and y, or the height z and "
                        "y.");
  }
  const Interval x = within_heights(bounds.box[0], bounds.box[2], half);
  if (!x.is_bounded() || !bounds.box[1].is_bounded()) {
    throw GeometryError(ErrorCode::kRegionUnbounded,
                        "The surface is infinite. Give bounds of y, and of x or the largest height "
                        "z.");
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
    const std::string name(1, "abc"[i]);
    require_input_number(half_axes[i], "The half-axis " + name);
    const bool is_unused = (kind == QuadricKind::kEllipticCylinder && i == 2) ||
                           (kind == QuadricKind::kParabolicCylinder && i == 1);
    if (!is_unused && half_axes[i] <= 0) {
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
      return pencil_chain(family, oriented_ellipsoid(a, *family), bounds,
                          ellipsoid_patches(half, bounds));
    }
    case QuadricKind::kTwoSheetHyperboloid: {
      const auto family = two_sheet_hyperboloid_family(half);
      const OrientedQuadric sheet =
          with_first_pole(oriented_two_sheet_hyperboloid(a, bounds), *family);
      return pencil_chain(family, sheet, bounds,
                          two_sheet_hyperboloid_patches(half, bounds, half_widths(sheet)));
    }
    case QuadricKind::kEllipticParaboloid: {
      const OrientedQuadric bowl = oriented_elliptic_paraboloid(a, bounds);
      const auto family = elliptic_paraboloid_family(half, farthest_normals(bowl));
      return pencil_chain(family, with_first_pole(bowl, *family), bounds,
                          paraboloid_patches(half, 1, -1, bounds, half_widths(bowl)));
    }
    case QuadricKind::kHyperbolicParaboloid:
      return hyperbolic_paraboloid(half, a, bounds);
    case QuadricKind::kOneSheetHyperboloid:
      return one_sheet_hyperboloid(half, a, bounds);
    case QuadricKind::kEllipticCylinder:
      require_revolution(half_axes, "cylinder");
      return cylinder_of_revolution(half_axes[0], bounds);
    case QuadricKind::kEllipticCone:
      require_revolution(half_axes, "cone");
      return cone_of_revolution(half, bounds);
    case QuadricKind::kParabolicCylinder:
      return parabolic_cylinder(half, bounds);
  }
  throw std::logic_error("a kind of quadric without a construction");
}

}  // namespace pn
