// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/bezier/offset_limits.hpp"

#include <cmath>
#include <limits>
#include <queue>
#include <vector>

#include "pn/algebra/form.hpp"

namespace pn {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
/// Bounds are wanted in doubles; a little more keeps the roundings of a few hundred operations
/// away.
constexpr long kBits = 80;
/// Beyond this many intervals the bound reached so far is returned: still proven, only less tight.
constexpr int kMostIntervals = 100000;

/// A function value with its derivative by t, both enclosed over an interval of t.
struct Jet {
  RealBall value, slope;
};

Jet operator+(const Jet& a, const Jet& b) { return {a.value + b.value, a.slope + b.slope}; }
Jet operator-(const Jet& a, const Jet& b) { return {a.value - b.value, a.slope - b.slope}; }
Jet operator*(const Jet& a, const Jet& b) {
  return {a.value * b.value, a.slope * b.value + a.value * b.slope};
}
Jet operator/(const Jet& a, const Jet& b) {
  const RealBall quotient = a.value / b.value;
  return {quotient, (a.slope - quotient * b.slope) / b.value};
}
Jet operator-(const Jet& a) { return {-a.value, -a.slope}; }
Jet sqrt(const Jet& a) {
  const RealBall root = sqrt(a.value);
  return {root, a.slope / (root * RealBall(2))};
}

/// A polynomial and its derivative in balls.
class BallPolynomial {
 public:
  explicit BallPolynomial(const RationalPolynomial& p)
      : value_(in_balls(p)), slope_(in_balls(p.derivative())) {}
  Jet operator()(const RealBall& t) const { return {value_(t), slope_(t)}; }

 private:
  static Form<RealBall> in_balls(const RationalPolynomial& p) {
    std::vector<RealBall> result;
    for (const Rational& c : coefficients(p, std::max(p.degree(), 0)))
      result.emplace_back(c, kBits);
    return Form<RealBall>(std::move(result));
  }
  Form<RealBall> value_, slope_;
};

/// A function on [0, 1] with a lower bound on intervals and an upper bound of its minimum at
/// points.
class BoundedFunction {
 public:
  virtual ~BoundedFunction() = default;
  /// No value on [low, high] is less.
  virtual double lower_bound(double low, double high) const = 0;
  /// Some value near t is not larger.
  virtual double value_bound(double t) const = 0;
};

RealBall interval(double low, double high) { return RealBall::between(low, high, kBits); }

double finite_or(double x, double otherwise) { return std::isnan(x) ? otherwise : x; }

/// The better of the range of a jet and its mean value form about the middle.
double mean_value_bound(const Jet& over, const Jet& at_middle, double low, double high) {
  const double natural = finite_or(over.value.lower(), -kInfinity);
  const RealBall half(RealBall(high) - RealBall(low));
  const RealBall form = at_middle.value - abs(over.slope) * half * RealBall(0.5);
  return std::max(natural, finite_or(form.lower(), -kInfinity));
}

class RadiusFunction : public BoundedFunction {
 public:
  explicit RadiusFunction(const SphereCurve& curve)
      : radius_(curve.radius), denominator_(curve.denominator) {}

  double lower_bound(double low, double high) const override {
    return mean_value_bound(at(interval(low, high)), at(RealBall(0.5 * (low + high))), low, high);
  }
  double value_bound(double t) const override { return at(RealBall(t)).value.upper(); }

 private:
  Jet at(const RealBall& t) const {
    const RealBall precise = t.at_precision(kBits);
    return radius_(precise) / denominator_(precise);
  }
  BallPolynomial radius_, denominator_;
};

/// The focal distance lambda D / K - r where K > 0, infinite elsewhere.
class FocalDistance : public BoundedFunction {
 public:
  FocalDistance(const ChainLink& link) : FocalDistance(link.envelope, link.content) {}

  double lower_bound(double low, double high) const override {
    const Values over = at(interval(low, high));
    const double largest_turn = over.turn.value.upper();
    if (largest_turn <= 0) return kInfinity;
    if (over.turn.value.is_positive()) {
      const Values middle = at(RealBall(0.5 * (low + high)));
      return mean_value_bound(distance(over), distance(middle), low, high);
    }
    const RealBall bound =
        RealBall(std::max(0.0, over.advance.value.lower())) / RealBall(largest_turn) -
        RealBall(over.radius.value.upper());
    return finite_or(bound.lower(), -kInfinity);
  }
  double value_bound(double t) const override {
    const Values values = at(RealBall(t));
    if (!values.turn.value.is_positive()) return kInfinity;
    return finite_or(distance(values).value.upper(), kInfinity);
  }

 private:
  /// |lambda| D |M|^2, K |M|^2 for the sign of lambda, and r.
  struct Values {
    Jet advance, turn, radius;
  };

  FocalDistance(const AlongCurve& envelope, const RationalPolynomial& content)
      : FocalDistance(envelope.curve(), envelope.circles(), content) {}

  FocalDistance(const SphereCurve& curve, const CircleFamily& circles,
                const RationalPolynomial& content)
      : advance_(content * circles.discriminant() * squared_axis(circles)),
        mean_turn_(mean_turn(circles)),
        spread_squared_(circles.discriminant() * squared_cross(circles)),
        has_spread_(!squared_cross(circles).is_zero()),
        radius_(curve.radius),
        denominator_(curve.denominator) {}

  static RationalPolynomial dot(const CircleFamily& a, const CircleFamily& b) {
    return a.axis[0] * b.axis[0] + a.axis[1] * b.axis[1] + a.axis[2] * b.axis[2];
  }
  static RationalPolynomial squared_axis(const CircleFamily& c) { return dot(c, c); }
  static CircleFamily derivative(const CircleFamily& c) {
    return {{c.axis[0].derivative(), c.axis[1].derivative(), c.axis[2].derivative()},
            c.level.derivative()};
  }
  static RationalPolynomial mean_turn(const CircleFamily& c) {
    const CircleFamily d = derivative(c);
    return d.level * squared_axis(c) - c.level * dot(c, d);
  }
  static RationalPolynomial squared_cross(const CircleFamily& c) {
    const CircleFamily d = derivative(c);
    const RationalPolynomial mixed = dot(c, d);
    return squared_axis(c) * squared_axis(d) - mixed * mixed;
  }

  Values at(const RealBall& point) const {
    const RealBall t = point.at_precision(kBits);
    const Jet q = denominator_(t);
    Jet advance = advance_(t) / (q * q);
    Jet turn = mean_turn_(t);
    // Where the spine runs backwards, lambda < 0, the roles of the two sides are exchanged.
    if (advance.value.is_negative()) {
      advance = -advance;
      turn = -turn;
    } else if (!advance.value.is_positive()) {
      turn.value = abs(turn.value);
    }
    if (has_spread_) turn = turn + sqrt(spread_squared_(t));
    return {advance, turn, radius_(t) / q};
  }

  static Jet distance(const Values& values) { return values.advance / values.turn - values.radius; }

  BallPolynomial advance_, mean_turn_, spread_squared_;
  bool has_spread_;
  BallPolynomial radius_, denominator_;
};

/// A proven lower bound of the least value of all functions on [0, 1], within `tolerance` of it.
template <class Function>
double certified_minimum(const std::vector<Function>& functions, double tolerance) {
  struct Interval {
    double bound, low, high;
    std::size_t function;
    bool operator<(const Interval& other) const { return bound > other.bound; }
  };
  std::priority_queue<Interval> open;
  double best = kInfinity;
  const auto add = [&](std::size_t i, double low, double high) {
    const double bound = functions[i].lower_bound(low, high);
    best = std::min(best, functions[i].value_bound(low + (high - low) / 2));
    if (bound <= best) open.push({bound, low, high, i});
  };
  for (std::size_t i = 0; i < functions.size(); ++i) {
    for (const double end : {0.0, 1.0}) best = std::min(best, functions[i].value_bound(end));
    add(i, 0, 1);
  }
  for (int count = 0; !open.empty() && count < kMostIntervals; ++count) {
    const Interval least = open.top();
    if (least.bound >= best - tolerance || least.bound == kInfinity) break;
    open.pop();
    const double middle = least.low + (least.high - least.low) / 2;
    add(least.function, least.low, middle);
    add(least.function, middle, least.high);
  }
  return open.empty() ? best : std::min(best, open.top().bound);
}

}  // namespace

OffsetRange regular_range(const EnvelopeChain& chain, double tolerance) {
  std::vector<RadiusFunction> radii;
  std::vector<FocalDistance> focal;
  for (const ChainLink& link : chain.links) {
    radii.emplace_back(link.envelope.curve());
    if (!link.stands_still()) focal.emplace_back(link);
  }
  return {-certified_minimum(radii, tolerance), certified_minimum(focal, tolerance)};
}

double default_tolerance(const EnvelopeChain& chain) {
  double largest = 0;
  for (const ChainLink& link : chain.links) {
    for (const long end : {0L, 1L}) {
      const SphereCurve& curve = link.envelope.curve();
      const Rational radius = curve.radius(Rational(end)) / curve.denominator(Rational(end));
      largest = std::max(largest, std::abs(radius.to_double()));
    }
  }
  return 1e-9 * largest;
}

}  // namespace pn
