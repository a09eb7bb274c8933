// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/bezier/offset_limits.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include "pn/algebra/bernstein.hpp"
#include "pn/algebra/precision.hpp"
#include "pn/algebra/roots.hpp"
#include "pn/bezier/curvature_limits.hpp"
#include "pn/bezier/proved_limit.hpp"

namespace pn {
namespace {

using Eigen::Vector3d;

constexpr double kInfinity = std::numeric_limits<double>::infinity();
/// Differences of 1e-9 of large coefficients of degree 40 are mostly certain with so many bits.
constexpr long kFirstBits = 192;
/// With each precision the distance may back off from the least sample by 8 tolerances. The
/// farthest is, with the default tolerance, a billion times the size of the surface.
constexpr Margins kMargins = {2, 8, 1e18};
/// Intervals are halved this often before a distance counts as not provable.
constexpr int kMostHalvings = 40;
/// And a proof that takes more intervals than this lacks precision.
constexpr int kMostIntervals = 4096;
/// Samples that look for the critical place of a link; the proof does not rest on them.
constexpr int kSamples = 33;

using Polynomial = std::vector<RealBall>;  // Bernstein coefficients

Form<RealBall> in_balls(const RationalPolynomial& p, long bits) {
  std::vector<RealBall> result;
  for (const Rational& c : coefficients(p, std::max(p.degree(), 0))) result.emplace_back(c, bits);
  return Form<RealBall>(std::move(result));
}

/// The value at a double, right to all its digits: in doubles high degrees would leave few of them.
double value_at(const Form<RealBall>& p, double t) { return p(RealBall(t)).midpoint(); }

/// The sum of two polynomials of different degrees.
Form<RealBall> sum(const Form<RealBall>& a, const Form<RealBall>& b) {
  const int degree = std::max(a.degree(), b.degree());
  return a.elevated(degree) + b.elevated(degree);
}

/// The halves of a Bernstein polynomial (P. de Casteljau).
std::array<Polynomial, 2> halved(Polynomial b) {
  Polynomial left, right(b.size());
  for (std::size_t n = b.size(); n > 0; --n) {
    left.push_back(b.front());
    right[n - 1] = b[n - 1];
    for (std::size_t i = 0; i + 1 < n; ++i) b[i] = scaled(b[i] + b[i + 1], -1);
  }
  return {std::move(left), std::move(right)};
}

bool is_positive(const Polynomial& b) {
  return std::all_of(b.begin(), b.end(), [](const RealBall& c) { return c.is_positive(); });
}

/// A vector that is shorter than this part of another, after most of it has cancelled, is rounding.
constexpr double kRounding = 1e-12;

Vector3d value_at(const std::array<RationalPolynomial, 3>& p, const Rational& t) {
  return {p[0](t).to_double(), p[1](t).to_double(), p[2](t).to_double()};
}

/// The derivatives of the components.
CircleFamily derivative(const CircleFamily& c) {
  return {{c.axis[0].derivative(), c.axis[1].derivative(), c.axis[2].derivative()},
          c.level.derivative()};
}

/// The unit vector perpendicular to an axis that is nearest to a direction; any one when the
/// direction is parallel to the axis.
Vector3d perpendicular(const Vector3d& axis, const Vector3d& direction) {
  const Vector3d aside = direction - direction.dot(axis) / axis.squaredNorm() * axis;
  const bool is_parallel = aside.norm() <= kRounding * direction.norm();
  return is_parallel ? axis.unitOrthogonal() : aside.normalized();
}

/// The unit normal on the circle at t whose focal distance is least: where n.M' + R' is largest for
/// a spine that advances.
Vector3d critical_normal(const CurveOfSpheres& spheres, const Rational& t) {
  const Vector3d axis = value_at(spheres.circles.axis, t);
  const double level = spheres.circles.level(t).to_double(), square = axis.squaredNorm();
  const double radius = std::sqrt(std::max(0.0, 1 - level * level / square));
  const Vector3d aside = perpendicular(axis, value_at(derivative(spheres.circles).axis, t));
  const bool backwards = spheres.content(Rational(1) / Rational(2)).sign() < 0;
  return -level / square * axis + (backwards ? -radius : radius) * aside;
}

std::array<double, 3> coordinates(const Vector3d& p) { return {p.x(), p.y(), p.z()}; }

/// The focal point at this distance on the critical normal at t.
FocalPoint focal_point(const ChainLink& link, const Rational& t, double distance) {
  const SphereCurve& curve = link.spheres->curve;
  const double denominator = curve.denominator(t).to_double();
  const Vector3d centre = value_at(curve.centre, t) / denominator;
  const double radius = curve.radius(t).to_double() / denominator;
  const Vector3d normal = critical_normal(*link.spheres, t);
  return {coordinates(centre + radius * normal), coordinates(centre + (radius + distance) * normal),
          distance};
}

/// A bound on the distances of one link: finite where `sample` is, and provable.
class Limit {
 public:
  using Place = double;  ///< the parameter

  explicit Limit(const ChainLink& link) : link_(&link) {}
  virtual ~Limit() = default;
  const ChainLink& link() const { return *link_; }
  /// The limit at a parameter.
  virtual double sample(double t) const = 0;
  /// Polynomials whose positivity on [0, 1] proves that `distance` is within the limit everywhere.
  virtual std::vector<Form<RealBall>> conditions(double distance) const = 0;

 private:
  const ChainLink* link_;
};

/// -d < r: the limit r of the distance inwards.
class RadiusLimit : public Limit {
 public:
  RadiusLimit(const ChainLink& link, long bits)
      : Limit(link),
        radius_(in_balls(link.spheres->curve.radius, bits)),
        denominator_(in_balls(link.spheres->curve.denominator, bits)) {}

  double sample(double t) const override {
    return value_at(radius_, t) / value_at(denominator_, t);
  }
  std::vector<Form<RealBall>> conditions(double inwards) const override {
    return {sum(radius_, denominator_ * RealBall(-inwards))};
  }

 private:
  Form<RealBall> radius_, denominator_;
};

/// d < lambda D / K - r where K > 0: the limit outwards.
class FocalLimit : public Limit {
 public:
  FocalLimit(const ChainLink& link, long bits)
      : Limit(link),
        radius_(in_balls(link.spheres->curve.radius, bits)),
        denominator_(in_balls(link.spheres->curve.denominator, bits)) {
    const CircleFamily& circles = link.spheres->circles;
    RationalPolynomial content = link.spheres->content;
    const CircleFamily slope = derivative(circles);
    const RationalPolynomial square = dot(circles, circles), mixed = dot(circles, slope);
    const RationalPolynomial discriminant = circles.discriminant();
    RationalPolynomial turn = slope.level * square - circles.level * mixed;
    // A span that runs backwards from a cusp before it has lambda < 0 and the other sign of n.M' +
    // R'.
    if (content(Rational(1) / Rational(2)).sign() < 0) {
      content = -content;
      turn = -turn;
    }
    const RationalPolynomial advance = content * discriminant * square;
    const RationalPolynomial spread = discriminant * (square * dot(slope, slope) - mixed * mixed);
    unlimited_ = is_non_positive(turn) && is_non_negative(turn * turn - spread);
    advance_ = in_balls(advance, bits);
    turn_ = in_balls(turn, bits);
    spread_ = in_balls(spread, bits);
  }

  /// K <= 0 on the whole link, proved: no distance outwards is too large.
  bool is_unlimited() const { return unlimited_; }

  double sample(double t) const override {
    const double turn = value_at(turn_, t) + std::sqrt(std::max(0.0, value_at(spread_, t)));
    if (turn <= 0) return kInfinity;
    const double q = value_at(denominator_, t);
    return value_at(advance_, t) / (q * q * turn) - value_at(radius_, t) / q;
  }

  std::vector<Form<RealBall>> conditions(double distance) const override {
    const Form<RealBall> rho = sum(radius_, denominator_ * RealBall(distance)) * denominator_;
    const Form<RealBall> a = sum(advance_, rho * turn_ * RealBall(-1));
    return {a, sum(a * a, rho * rho * spread_ * RealBall(-1))};
  }

 private:
  static RationalPolynomial dot(const CircleFamily& a, const CircleFamily& b) {
    return a.axis[0] * b.axis[0] + a.axis[1] * b.axis[1] + a.axis[2] * b.axis[2];
  }
  static bool is_non_negative(const RationalPolynomial& p) {
    return p.is_zero() || is_positive_on_unit_interval(p);
  }
  static bool is_non_positive(const RationalPolynomial& p) { return is_non_negative(-p); }

  bool unlimited_ = false;
  Form<RealBall> advance_, turn_, spread_, radius_, denominator_;
};

using Sample = LimitSample<double>;

/// The least sample of a link, refined between its neighbours.
Sample least_sample(const Limit& limit) {
  Sample least{limit.sample(0), 0};
  for (int i = 1; i < kSamples; ++i) {
    const double t = static_cast<double>(i) / (kSamples - 1);
    const double value = limit.sample(t);
    if (value < least.value) least = {value, t};
  }
  const double step = 1.0 / (kSamples - 1);
  double low = std::max(0.0, least.at - step), high = std::min(1.0, least.at + step);
  constexpr int kThirds =
      60;  // down to a relative width of 1e-10, where the value no longer changes
  for (int i = 0; i < kThirds; ++i) {
    const double a = low + (high - low) / 3, b = high - (high - low) / 3;
    const double at_a = limit.sample(a), at_b = limit.sample(b);
    if (at_a < least.value) least = {at_a, a};
    if (at_b < least.value) least = {at_b, b};
    (at_a < at_b ? high : low) = at_a < at_b ? b : a;
  }
  return least;
}

Verdict<double> verdict(const Limit& limit, double distance) {
  struct Interval {
    std::vector<Polynomial> conditions;
    double low, high;
    int halvings;
  };
  std::vector<Interval> open(1);
  open[0] = {{}, 0, 1, 0};
  for (const Form<RealBall>& form : limit.conditions(distance)) {
    open[0].conditions.push_back(to_bernstein(form.coefficients()));
  }
  Sample least;
  for (int count = 0; !open.empty(); ++count) {
    if (count == kMostIntervals) return {false, least};
    const Interval interval = std::move(open.back());
    open.pop_back();
    if (std::all_of(interval.conditions.begin(), interval.conditions.end(), is_positive)) continue;
    const double middle = interval.low + (interval.high - interval.low) / 2;
    const double value = limit.sample(middle);
    if (value < least.value) least = {value, middle};
    if (least.value <= distance || interval.halvings == kMostHalvings) return {false, least};
    Interval left{{}, interval.low, middle, interval.halvings + 1};
    Interval right{{}, middle, interval.high, interval.halvings + 1};
    for (const Polynomial& condition : interval.conditions) {
      auto [first, second] = halved(condition);
      left.conditions.push_back(std::move(first));
      right.conditions.push_back(std::move(second));
    }
    open.push_back(std::move(left));
    open.push_back(std::move(right));
  }
  return {true, least};
}

/// The spine has a cusp inside the link.
bool turns_back(const ChainLink& link) {
  if (link.stands_still()) return false;
  RationalPolynomial inside = link.spheres->content;
  for (const long end : {0L, 1L}) inside = inside.without_root(Rational(end));
  return !roots_in_unit_interval(inside).empty();
}

/// The focal point at the critical place of some limits; `direction` is -1 for those inwards.
template <class SomeLimit>
std::optional<FocalPoint> focal_point(const std::vector<SomeLimit>& limits,
                                      const ProvedLimit<double>& proved, int direction) {
  if (!proved.critical) return std::nullopt;
  const auto& [limit, sample] = *proved.critical;
  return focal_point(limits[limit].link(), Rational::exactly(sample.at), direction * sample.value);
}

OffsetRange range_at_precision(const EnvelopeChain& chain, double tolerance, long bits) {
  std::vector<RadiusLimit> radii;
  std::vector<FocalLimit> focal;
  for (const ChainLink& link : chain.links) {
    radii.emplace_back(link, bits);
    if (link.stands_still()) continue;
    FocalLimit limit(link, bits);
    if (!limit.is_unlimited()) focal.push_back(std::move(limit));
  }
  const ProvedLimit<double> inwards = proved_limit(radii, tolerance, -kInfinity, kMargins);
  const double lower = -inwards.distance;
  const ProvedLimit<double> outwards = focal.empty()
                                           ? ProvedLimit<double>{kInfinity, std::nullopt}
                                           : proved_limit(focal, tolerance, lower, kMargins);
  return {lower, outwards.distance, focal_point(radii, inwards, -1),
          focal_point(focal, outwards, 1)};
}

bool has_spheres(const EnvelopeChain& chain) { return chain.links.front().spheres.has_value(); }

/// The largest distance of a corner of a patch from its middle.
double extent(const RationalPatch& patch) {
  const auto at = [&](const Rational& u, const Rational& v) {
    std::array<double, 3> p;
    for (std::size_t i = 0; i < 3; ++i) {
      p[i] = patch.point[i](u, v).to_double() / patch.weight(u, v).to_double();
    }
    return p;
  };
  const Rational half = Rational(1) / Rational(2);
  const auto middle = at(half, half);
  double largest = 0;
  for (const long u : {0L, 1L}) {
    for (const long v : {0L, 1L}) {
      const auto corner = at(Rational(u), Rational(v));
      const double distance =
          std::hypot(corner[0] - middle[0], corner[1] - middle[1], corner[2] - middle[2]);
      if (std::isfinite(distance)) largest = std::max(largest, distance);
    }
  }
  return largest;
}

/// The distance between the ends of a link's spine.
double chord(const ChainLink& link) {
  const SphereCurve& curve = link.spheres->curve;
  double square = 0;
  for (const RationalPolynomial& centre : curve.centre) {
    const auto at = [&](long t) { return centre(Rational(t)) / curve.denominator(Rational(t)); };
    const double difference = (at(1) - at(0)).to_double();
    square += difference * difference;
  }
  return std::sqrt(square);
}

}  // namespace

OffsetRange regular_range(const EnvelopeChain& chain, double tolerance) {
  if (!chain.base.empty()) return curvature_limits(chain.base, tolerance);
  if (!has_spheres(chain)) return {0, 0};
  if (std::any_of(chain.links.begin(), chain.links.end(), turns_back)) return {0, 0};
  try {
    return at_sufficient_precision(
        [&](long bits) { return range_at_precision(chain, tolerance, bits); }, kFirstBits);
  } catch (const GeometryError& error) {
    if (error.code() != ErrorCode::kPrecisionExhausted) throw;
    return {0, 0};  // What cannot be proved is not claimed: the empty range is certain.
  }
}

double default_tolerance(const EnvelopeChain& chain) {
  double size = std::numeric_limits<double>::min();
  for (const RationalPatch& patch : chain.base) size = std::max(size, extent(patch));
  if (!has_spheres(chain)) return 1e-9 * size;
  for (const ChainLink& link : chain.links) {
    const RadiusLimit radius(link, kFirstBits);
    size = std::max({size, std::abs(radius.sample(0)), std::abs(radius.sample(1)), chord(link)});
  }
  return 1e-9 * size;
}

}  // namespace pn
