// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/bezier/curvature_limits.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "pn/algebra/parallel.hpp"
#include "pn/algebra/precision.hpp"
#include "pn/algebra/tensor_bernstein.hpp"
#include "pn/bezier/proved_limit.hpp"

namespace pn {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
/// Differences of 1e-18 of coefficients of degree 40 are certain with so many bits.
constexpr long kFirstBits = 192;
/// More bits do not shorten a proof, so the margin grows until the proof is short enough.
/// Beyond a million times the size, with the default tolerance, doubles would leave no digits.
constexpr Margins kMargins = {10, kInfinity, 1e15};
/// A proof that takes more rectangles than this lacks room,
constexpr int kMostTiles = 4096;
/// or so many returns from doubles to balls,
constexpr int kMostRenewals = 256;
/// or rectangles as narrow as this, at which parameters still are exact doubles.
constexpr double kNarrowest = 0x1p-45;
/// Samples in each direction that look for the critical place; the proof does not rest on them.
constexpr int kSamples = 17;
/// The search for the least sample ends with such steps: the square of this no longer changes it.
constexpr double kLeastStep = 1e-8;
/// And after so many moves.
constexpr int kMostMoves = 1000;
/// A sample on the edge of the region may be outside by so much of the parameters.
constexpr double kEdge = 1e-12;
/// Newton's steps to the edge of the region.
constexpr int kMostSteps = 12;

using Vector = std::array<BivariatePolynomial, 3>;

BivariatePolynomial dot(const Vector& a, const Vector& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

Vector operator*(const BivariatePolynomial& factor, const Vector& a) {
  return {factor * a[0], factor * a[1], factor * a[2]};
}

Vector operator+(const Vector& a, const Vector& b) {
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}

Vector operator-(const Vector& a, const Vector& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

Vector derivative(const Vector& a, Variable by) {
  return {a[0].derivative(by), a[1].derivative(by), a[2].derivative(by)};
}

/// A polynomial in doubles, in powers of the parameters less 1/2, which are small.
class DoublePolynomial {
 public:
  struct Jet {
    double value, u, v, uu, uv, vv;
  };

  explicit DoublePolynomial(const BivariatePolynomial& p) {
    const RationalPolynomial shifted({Rational(1L) / Rational(2L), Rational(1L)});
    const BivariatePolynomial centred = p.composed(BivariatePolynomial(shifted, Variable::kU),
                                                   BivariatePolynomial(shifted, Variable::kV));
    for (int i = 0; i <= centred.degree(Variable::kU); ++i) {
      coefficients_.emplace_back();
      for (int j = 0; j <= centred.degree(Variable::kV); ++j) {
        coefficients_.back().push_back(centred.coefficient(i, j).to_double());
      }
    }
  }

  Jet operator()(double u, double v) const {
    const double s = u - 0.5, t = v - 0.5;
    Jet jet = {};
    for (std::size_t i = coefficients_.size(); i-- > 0;) {
      double value = 0, first = 0, half_second = 0;
      for (std::size_t j = coefficients_[i].size(); j-- > 0;) {
        half_second = half_second * t + first;
        first = first * t + value;
        value = value * t + coefficients_[i][j];
      }
      jet.uu = jet.uu * s + jet.u;
      jet.uv = jet.uv * s + jet.v;
      jet.u = jet.u * s + jet.value;
      jet.value = jet.value * s + value;
      jet.v = jet.v * s + first;
      jet.vv = jet.vv * s + 2 * half_second;
    }
    jet.uu *= 2;
    return jet;
  }

 private:
  std::vector<std::vector<double>> coefficients_;
};

struct Parameters {
  double u, v;
};

/// Samples of a patch in doubles.
class PatchSampler {
 public:
  explicit PatchSampler(const RationalPatch& patch)
      : point_{DoublePolynomial(patch.point[0]), DoublePolynomial(patch.point[1]),
               DoublePolynomial(patch.point[2])},
        weight_(patch.weight),
        region_(patch.region.begin(), patch.region.end()),
        side_(patch.side) {}

  /// The distance of the nearest focal point towards direction n, direction = 1 or -1.
  double focal_distance(const Parameters& at, int direction) const {
    const auto [x, xu, xv, xuu, xuv, xvv] = jet(at);
    const Point normal = cross(xu, xv);
    const double area = std::hypot(normal[0], normal[1], normal[2]);
    const double length = std::hypot(xu[0], xu[1], xu[2]);
    if (!(area > 0)) return 0;
    const double scale = side_ * direction / area;
    // Weingarten's map in an orthonormal frame that begins with x_u: no digits cancel in the
    // difference of its eigenvalues, as they would in H^2 - K.
    const double along = dot(xu, xv) / length, aside = area / length;
    const double p = scale * dot(normal, xuu) / (length * length);
    const double q = (scale * dot(normal, xuv) / length - along * p) / aside;
    const double r =
        (scale * dot(normal, xvv) - along * (2 * aside * q + along * p)) / (aside * aside);
    const double curvature = (p + r) / 2 + std::hypot((p - r) / 2, q);
    return curvature > 0 ? 1 / curvature : kInfinity;
  }

  /// The point at a signed distance on the normal of a place.
  FocalPoint focal_point(const Parameters& at, double distance) const {
    const Jet surface = jet(at);
    const Point normal = cross(surface.u, surface.v);
    const double area = std::hypot(normal[0], normal[1], normal[2]);
    FocalPoint result = {surface.point, surface.point, distance};
    for (std::size_t i = 0; i < 3; ++i) result.point[i] += distance * side_ * normal[i] / area;
    return result;
  }

  /// A place of the region near `at`, if there is one.
  std::optional<Parameters> into_region(Parameters at) const {
    for (int steps = 0; steps < kMostSteps; ++steps) {
      at = {std::clamp(at.u, 0.0, 1.0), std::clamp(at.v, 0.0, 1.0)};
      double farthest = kEdge, du = 0, dv = 0;
      for (const DoublePolynomial& edge : region_) {
        const DoublePolynomial::Jet g = edge(at.u, at.v);
        if (g.value >= 0) continue;
        const double square = g.u * g.u + g.v * g.v;
        if (!(square > 0)) return std::nullopt;
        const double outside = -g.value / std::sqrt(square);
        if (!(outside > farthest)) continue;
        farthest = outside;
        du = -g.value * g.u / square;
        dv = -g.value * g.v / square;
      }
      if (farthest == kEdge) return at;
      at = {at.u + du, at.v + dv};
    }
    return std::nullopt;
  }

 private:
  using Point = std::array<double, 3>;
  struct Jet {
    Point point, u, v, uu, uv, vv;
  };

  Jet jet(const Parameters& at) const {
    const DoublePolynomial::Jet w = weight_(at.u, at.v);
    Jet x;
    for (std::size_t i = 0; i < 3; ++i) {
      const DoublePolynomial::Jet p = point_[i](at.u, at.v);
      x.point[i] = p.value / w.value;
      x.u[i] = (p.u - x.point[i] * w.u) / w.value;
      x.v[i] = (p.v - x.point[i] * w.v) / w.value;
      x.uu[i] = (p.uu - x.point[i] * w.uu - 2 * x.u[i] * w.u) / w.value;
      x.uv[i] = (p.uv - x.point[i] * w.uv - x.u[i] * w.v - x.v[i] * w.u) / w.value;
      x.vv[i] = (p.vv - x.point[i] * w.vv - 2 * x.v[i] * w.v) / w.value;
    }
    return x;
  }

  static double dot(const Point& a, const Point& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  }
  static Point cross(const Point& a, const Point& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
  }

  std::array<DoublePolynomial, 3> point_;
  DoublePolynomial weight_;
  std::vector<DoublePolynomial> region_;
  int side_;
};

/// The polynomials of the theorem for one patch.
struct CurvaturePolynomials {
  BivariatePolynomial common;  ///< c
  BivariatePolynomial square;  ///< S
  BivariatePolynomial area;    ///< U
  BivariatePolynomial gauss;   ///< V
  BivariatePolynomial mean;    ///< T
  std::vector<BivariatePolynomial> region;
};

BivariatePolynomial exact_quotient(const BivariatePolynomial& a, const BivariatePolynomial& b) {
  return quotient(a, b).value();
}

bool is_constant(const BivariatePolynomial& p) {
  return p.degree(Variable::kU) <= 0 && p.degree(Variable::kV) <= 0;
}

/// The common factor of the plane coordinates with the sign that it has at a place of the region;
/// 1 when it is constant.
BivariatePolynomial common_factor(const Vector& normal, const BivariatePolynomial& level,
                                  const Parameters& inside) {
  BivariatePolynomial common = gcd(normal[0], normal[1]);
  for (const BivariatePolynomial& p : {normal[2], level}) {
    if (!common.is_zero() && is_constant(common)) return 1L;
    common = gcd(common, p);
  }
  if (is_constant(common)) return common.is_zero() ? BivariatePolynomial() : 1L;
  const Rational value = common(Rational::exactly(inside.u), Rational::exactly(inside.v));
  return value.sign() < 0 ? -common : common;
}

CurvaturePolynomials curvature_polynomials(const RationalPatch& patch, const Parameters& inside) {
  const Vector& x = patch.point;
  const BivariatePolynomial& w = patch.weight;
  const Vector xu = derivative(x, Variable::kU), xv = derivative(x, Variable::kV);
  const BivariatePolynomial wu = w.derivative(Variable::kU), wv = w.derivative(Variable::kV);
  const Vector product = cross(xu, xv);
  Vector normal = w * product + wu * cross(xv, x) + wv * cross(x, xu);
  BivariatePolynomial level = -dot(x, product);
  const BivariatePolynomial common = common_factor(normal, level, inside);
  if (common.is_zero()) return {};
  if (!is_constant(common)) {
    for (BivariatePolynomial& p : normal) p = exact_quotient(p, common);
    level = exact_quotient(level, common);
  }

  const auto second = [&](const Vector& slope, const BivariatePolynomial& weight_slope,
                          Variable by) {
    return dot(normal, derivative(slope, by)) + level * weight_slope.derivative(by);
  };
  const BivariatePolynomial uu = second(xu, wu, Variable::kU), uv = second(xu, wu, Variable::kV),
                            vv = second(xv, wv, Variable::kV);
  const Vector au = w * xu - wu * x, av = w * xv - wv * x;
  BivariatePolynomial kappa = uu * vv - uv * uv;
  BivariatePolynomial eta =
      dot(au, au) * vv - BivariatePolynomial(2L) * dot(au, av) * uv + dot(av, av) * uu;
  BivariatePolynomial area(1L);
  if (!is_constant(common)) {
    area = common * common;
    for (int power = 0; power < 2; ++power) {
      const auto less_kappa = quotient(kappa, common), less_eta = quotient(eta, common);
      if (!less_kappa || !less_eta) break;
      kappa = *less_kappa;
      eta = *less_eta;
      area = exact_quotient(area, common);
    }
  }
  const BivariatePolynomial square = dot(normal, normal);
  const BivariatePolynomial w2 = w * w;
  return {common,
          square,
          area * square * square,
          w2 * w2 * kappa,
          BivariatePolynomial(static_cast<long>(patch.side)) * w * eta,
          patch.region};
}

/// The largest degrees of some polynomials.
struct Degrees {
  int u = 0, v = 0;
};

Degrees degrees(const std::vector<BivariatePolynomial>& polynomials) {
  Degrees result;
  for (const BivariatePolynomial& p : polynomials) {
    result.u = std::max(result.u, p.degree(Variable::kU));
    result.v = std::max(result.v, p.degree(Variable::kV));
  }
  return result;
}

TensorBernstein enclosed(const BivariatePolynomial& p, const Degrees& degrees, long bits) {
  return TensorBernstein(p, degrees.u, degrees.v, bits);
}

/// A polynomial on a tile. Once it has one sign it has it on all parts of the tile.
class Term {
 public:
  explicit Term(const TensorBernstein* whole) : whole_(whole) { settle(RoundedBernstein(*whole)); }

  /// 0: not known.
  int sign() const { return sign_; }
  bool is_open() const { return sign_ == 0; }
  /// The coefficients of an open term.
  const RoundedBernstein& rounded() const { return *rounded_; }

  std::array<Term, 2> halved(Variable variable) const {
    std::array<Term, 2> halves = {*this, *this};
    if (!is_open()) return halves;
    std::array<RoundedBernstein, 2> rounded = rounded_->halved(variable);
    for (std::size_t i = 0; i < 2; ++i) halves[i].settle(std::move(rounded[i]));
    return halves;
  }

  bool lacks_digits() const { return is_open() && rounded_->lacks_digits(); }
  void renew(const Rectangle& rectangle) { settle(RoundedBernstein(whole_->on(rectangle))); }

 private:
  void settle(RoundedBernstein rounded) {
    sign_ = rounded.is_positive() ? 1 : rounded.is_negative() ? -1 : 0;
    rounded_.reset();
    if (is_open()) rounded_ = std::move(rounded);
  }

  const TensorBernstein* whole_;  // on the unit square
  int sign_ = 0;
  std::optional<RoundedBernstein> rounded_;
};

/// A rectangle of parameters and what is known there.
struct Tile {
  Rectangle rectangle;
  std::vector<Term> terms;
  std::vector<Term> region;  ///< what may have both signs or is negative

  bool is_outside() const {
    return std::any_of(region.begin(), region.end(), [](const Term& g) { return g.sign() < 0; });
  }
};

std::array<Tile, 2> halved(const Tile& tile, Variable variable) {
  const std::array<Rectangle, 2> rectangles = tile.rectangle.halved(variable);
  std::array<Tile, 2> halves = {Tile{rectangles[0], {}, {}}, Tile{rectangles[1], {}, {}}};
  for (const auto list : {&Tile::terms, &Tile::region}) {
    for (const Term& term : tile.*list) {
      std::array<Term, 2> both = term.halved(variable);
      for (std::size_t i = 0; i < 2; ++i) (halves[i].*list).push_back(std::move(both[i]));
    }
  }
  return halves;
}

std::vector<Term> terms_of(const std::vector<TensorBernstein>& enclosures) {
  std::vector<Term> terms;
  for (const TensorBernstein& enclosure : enclosures) terms.emplace_back(&enclosure);
  return terms;
}

Variable longer_side(const Rectangle& rectangle) {
  const bool wide = rectangle.length(Variable::kU) >= rectangle.length(Variable::kV);
  return wide ? Variable::kU : Variable::kV;
}

/// A proof on the region by halving: `question` gives the variable by which a tile is to be halved,
/// or nothing where the proof is complete; `refuted` may end it at the middle of a tile.
template <class Question, class Refuted>
bool is_proved(Tile root, Question&& question, Refuted&& refuted) {
  std::vector<Tile> open = {std::move(root)};
  int renewals = 0;
  for (int count = 0; !open.empty(); ++count) {
    if (count == kMostTiles) return false;
    Tile tile = std::move(open.back());
    open.pop_back();
    if (tile.is_outside()) continue;
    tile.region.erase(std::remove_if(tile.region.begin(), tile.region.end(),
                                     [](const Term& g) { return g.sign() > 0; }),
                      tile.region.end());
    const std::optional<Variable> variable = question(tile);
    if (!variable) continue;
    if (refuted(tile.rectangle)) return false;
    if (tile.rectangle.length(*variable) <= kNarrowest) return false;
    for (Tile& half : halved(tile, *variable)) {
      for (Term& term : half.terms) {
        if (!term.lacks_digits()) continue;
        if (++renewals > kMostRenewals) return false;
        term.renew(half.rectangle);
      }
      open.push_back(std::move(half));
    }
  }
  return true;
}

/// p > 0 on the region, proved.
bool is_positive(const BivariatePolynomial& p, const std::vector<BivariatePolynomial>& region,
                 long bits) {
  const TensorBernstein whole = enclosed(p, degrees({p}), bits);
  std::vector<TensorBernstein> edges;
  for (const BivariatePolynomial& g : region) edges.push_back(enclosed(g, degrees({g}), bits));
  const auto question = [](const Tile& tile) -> std::optional<Variable> {
    const Term& term = tile.terms.front();
    if (term.sign() > 0) return std::nullopt;
    return term.is_open() ? term.rounded().decisive_variable() : longer_side(tile.rectangle);
  };
  return is_proved({{}, {Term(&whole)}, terms_of(edges)}, question,
                   [](const Rectangle&) { return false; });
}

/// p >= 0 on the region, proved: by coefficients that may vanish, on the whole square, or else
/// without zeros.
bool is_non_negative(const BivariatePolynomial& p, const std::vector<BivariatePolynomial>& region,
                     long bits) {
  return has_non_negative_coefficients(p) || is_positive(p, region, bits);
}

/// The enclosures that the certificates of one patch are made of.
struct Enclosures {
  TensorBernstein area, gauss, mean;            ///< U, V, T
  std::array<TensorBernstein, 3> discriminant;  ///< B in powers of d^2
  std::vector<TensorBernstein> region;          ///< in the degrees of B, to be subtracted from it
};

Enclosures enclosures(const CurvaturePolynomials& p, long bits) {
  const std::array<BivariatePolynomial, 3> b = {
      p.area * p.area, BivariatePolynomial(2L) * p.area * p.gauss - p.mean * p.mean * p.square,
      p.gauss * p.gauss};
  std::vector<BivariatePolynomial> all(b.begin(), b.end());
  all.insert(all.end(), p.region.begin(), p.region.end());
  const Degrees low = degrees({p.area, p.gauss}), high = degrees(all);
  std::vector<TensorBernstein> region;
  for (const BivariatePolynomial& g : p.region) region.push_back(enclosed(g, high, bits));
  return {enclosed(p.area, low, bits),
          enclosed(p.gauss, low, bits),
          enclosed(p.mean, degrees({p.mean}), bits),
          {enclosed(b[0], high, bits), enclosed(b[1], high, bits), enclosed(b[2], high, bits)},
          std::move(region)};
}

/// The order of the terms of a tile.
enum TermIndex : std::size_t { kA, kB, kT, kRest };

/// p less such multiples of the polynomials of the region as make it most level: where that is
/// positive, p is positive in the region. (At a place on the edge where p is least its gradient is
/// such a combination of theirs, and of p itself only much smaller tiles would be positive.)
RoundedBernstein levelled(const RoundedBernstein& p, const std::vector<Term>& region) {
  RoundedBernstein result = p;
  std::array<double, 2> rest = p.slope();
  std::vector<std::array<double, 2>> slopes;
  for (const Term& g : region) slopes.push_back(g.rounded().slope());
  std::vector<double> factors(region.size(), 0.0);
  constexpr int kSweeps = 30;  // of coordinate descent: for two edges it converges like cos^60
  for (int sweep = 0; sweep < kSweeps; ++sweep) {
    for (std::size_t i = 0; i < region.size(); ++i) {
      const double square = slopes[i][0] * slopes[i][0] + slopes[i][1] * slopes[i][1];
      if (!(square > 0)) continue;
      const double wanted = (rest[0] * slopes[i][0] + rest[1] * slopes[i][1]) / square;
      const double change = std::max(wanted, -factors[i]);
      factors[i] += change;
      for (std::size_t c = 0; c < 2; ++c) rest[c] -= change * slopes[i][c];
    }
  }
  for (std::size_t i = 0; i < region.size(); ++i) {
    if (factors[i] > 0) result = result.minus(factors[i], region[i].rounded());
  }
  return result;
}

/// The three certificates of the corollary.
std::optional<Variable> open_question(const Tile& tile) {
  const Term &a = tile.terms[kA], &b = tile.terms[kB], &t = tile.terms[kT],
             &rest = tile.terms[kRest];
  if (t.sign() < 0 && (a.sign() > 0 || b.sign() < 0)) return std::nullopt;
  if (t.sign() < 0 && a.is_open()) return a.rounded().decisive_variable();
  if (b.is_open()) {
    if (tile.region.empty()) return b.rounded().decisive_variable();
    const RoundedBernstein level = levelled(b.rounded(), tile.region);
    if (!level.is_positive()) {
      if (tile.region.size() > 1) return level.decisive_variable();
      // Tiles that become thin across the edge need not become short along it.
      return level.bending_variable().value_or(tile.region.front().rounded().decisive_variable());
    }
  }
  if (a.sign() > 0 && rest.sign() > 0 && b.sign() >= 0) return std::nullopt;
  for (const Term* term : {&a, &rest, &t}) {
    if (term->is_open()) return term->rounded().decisive_variable();
  }
  return longer_side(tile.rectangle);
}

using Sample = LimitSample<Parameters>;

/// All that is computed once for a patch.
struct PatchData {
  PatchSampler sampler;
  CurvaturePolynomials polynomials;
};

PatchData patch_data(const RationalPatch& patch) {
  PatchSampler sampler(patch);
  const Parameters middle = {0.5, 0.5};
  CurvaturePolynomials polynomials =
      curvature_polynomials(patch, sampler.into_region(middle).value_or(middle));
  return {std::move(sampler), std::move(polynomials)};
}

/// x_u x x_v vanishes nowhere in the region, proved.
bool is_immersed(const CurvaturePolynomials& p, long bits) {
  return is_positive(p.common, p.region, bits) && is_positive(p.square, p.region, bits);
}

/// How far the offsets of a patch go in the direction of its normal, or against it.
class CurvatureLimit {
 public:
  using Place = Parameters;

  CurvatureLimit(const PatchData& patch, const Enclosures& enclosures, int direction, long bits)
      : patch_(&patch), enclosures_(&enclosures), direction_(direction), bits_(bits) {
    const double step = 1.0 / (kSamples - 1);
    Sample least;
    for (int i = 0; i < kSamples; ++i) {
      for (int j = 0; j < kSamples; ++j) {
        const Sample sample = sample_near({i * step, j * step});
        if (sample.value < least.value) least = sample;
      }
    }
    least_sample_ = refined(least, step / 2);
  }

  const Sample& least_sample() const { return least_sample_; }
  FocalPoint focal_point(const Sample& sample) const {
    return patch_->sampler.focal_point(sample.at, direction_ * sample.value);
  }

  /// No curvature bends towards this side, proved: k1 + k2 <= 0 <= k1 k2.
  bool is_unlimited() const {
    const CurvaturePolynomials& p = patch_->polynomials;
    return is_non_negative(direction_ > 0 ? -p.mean : p.mean, p.region, bits_) &&
           is_non_negative(p.gauss, p.region, bits_);
  }

  Verdict<Parameters> verdict(double distance) const {
    const Enclosures& e = *enclosures_;
    const RealBall d = RealBall(distance).at_precision(bits_), square = d * d;
    const TensorBernstein more = e.gauss * square;
    const TensorBernstein a = e.area + more, rest = e.area + more * RealBall(-1),
                          b = e.discriminant[0] +
                              (e.discriminant[1] + e.discriminant[2] * square) * square,
                          t = e.mean * RealBall(direction_);
    Sample smaller;
    const auto refuted = [&](const Rectangle& tile) {
      const Sample sample = sample_near({tile.middle(Variable::kU), tile.middle(Variable::kV)});
      if (sample.value > distance) return false;
      const double length = std::max(tile.length(Variable::kU), tile.length(Variable::kV));
      smaller = refined(sample, length / 2);
      return true;
    };
    const Tile whole = {{}, {Term(&a), Term(&b), Term(&t), Term(&rest)}, terms_of(e.region)};
    return {is_proved(whole, open_question, refuted), smaller};
  }

 private:
  Sample sample_near(const Parameters& at) const {
    const std::optional<Parameters> inside = patch_->sampler.into_region(at);
    if (!inside) return {};
    return {patch_->sampler.focal_distance(*inside, direction_), *inside};
  }

  /// The least sample nearby, by a search with steps that shrink.
  Sample refined(Sample least, double step) const {
    for (int moves = 0; moves < kMostMoves && step > kLeastStep; ++moves) {
      Sample best = least;
      for (const int i : {-1, 0, 1}) {
        for (const int j : {-1, 0, 1}) {
          const Sample sample = sample_near({least.at.u + i * step, least.at.v + j * step});
          if (sample.value < best.value) best = sample;
        }
      }
      if (best.value == least.value) step /= 2;
      least = best;
    }
    return least;
  }

  const PatchData* patch_;
  const Enclosures* enclosures_;
  int direction_;
  long bits_;
  Sample least_sample_;
};

Sample least_sample(const CurvatureLimit& limit) { return limit.least_sample(); }

Verdict<Parameters> verdict(const CurvatureLimit& limit, double distance) {
  return limit.verdict(distance);
}

/// The limit of the offsets in one direction.
struct DirectedLimit {
  double distance;
  std::optional<FocalPoint> focal_point;
};

/// The limit of all patches in one direction.
DirectedLimit limit_at_precision(const std::vector<PatchData>& patches,
                                 const std::vector<Enclosures>& enclosures, int direction,
                                 double tolerance, long bits) {
  std::vector<std::optional<CurvatureLimit>> candidates(patches.size());
  for_each_index(patches.size(), [&](std::size_t i) {
    CurvatureLimit limit(patches[i], enclosures[i], direction, bits);
    const bool far = limit.least_sample().value >= kMargins.farthest * tolerance;
    if (!far || !limit.is_unlimited()) candidates[i] = limit;
  });
  std::vector<CurvatureLimit> limits;
  for (const auto& candidate : candidates) {
    if (candidate) limits.push_back(*candidate);
  }
  if (limits.empty()) return {kInfinity, std::nullopt};
  const ProvedLimit<Parameters> proved = proved_limit(limits, tolerance, 0, kMargins);
  if (!proved.critical) return {proved.distance, std::nullopt};
  const auto& [limit, sample] = *proved.critical;
  return {proved.distance, limits[limit].focal_point(sample)};
}

OffsetRange range_at_precision(const std::vector<PatchData>& patches, double tolerance, long bits) {
  for (const PatchData& patch : patches) {
    if (!is_immersed(patch.polynomials, bits)) return {0, 0};
  }
  std::vector<std::optional<Enclosures>> made(patches.size());
  for_each_index(patches.size(),
                 [&](std::size_t i) { made[i] = enclosures(patches[i].polynomials, bits); });
  std::vector<Enclosures> all;
  for (auto& one : made) all.push_back(std::move(*one));
  const DirectedLimit lower = limit_at_precision(patches, all, -1, tolerance, bits),
                      upper = limit_at_precision(patches, all, 1, tolerance, bits);
  return {-lower.distance, upper.distance, lower.focal_point, upper.focal_point};
}

}  // namespace

OffsetRange curvature_limits(const std::vector<RationalPatch>& patches, double tolerance) {
  std::vector<std::optional<PatchData>> made(patches.size());
  for_each_index(patches.size(), [&](std::size_t i) { made[i] = patch_data(patches[i]); });
  std::vector<PatchData> all;
  for (auto& one : made) all.push_back(std::move(*one));
  try {
    return at_sufficient_precision(
        [&](long bits) { return range_at_precision(all, tolerance, bits); }, kFirstBits);
  } catch (const GeometryError& error) {
    if (error.code() != ErrorCode::kPrecisionExhausted) throw;
    return {0, 0};  // What cannot be proved is not claimed: the empty range is certain.
  }
}

}  // namespace pn
