// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/bezier/rational_source.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "pn/algebra/parallel.hpp"
#include "pn/algebra/tensor_bernstein.hpp"
#include "pn/bezier/skin_patch.hpp"
#include "pn/geometry_error.hpp"

namespace pn {
namespace {

using Polynomial = BivariatePolynomial;
using Vector = std::array<Polynomial, 3>;

/// OpenCASCADE's largest degree.
constexpr int kMostDegree = 25;
/// Patches whose weights vary by more are halved.
constexpr double kEvenWeights = 0.01;
/// Halvings of a patch before it is given up.
constexpr int kMostHalvings = 10;
/// Bits that tell the sign of a weight; the net takes as many as it needs.
constexpr long kWeightBits = 192;
/// Samples of the focal distances along a side of a patch.
constexpr int kSamples = 24;
/// Limits are found to within this part of their distance from the base.
constexpr double kLimitTolerance = 1e-6;
/// Distances tried before a limit is given up, each half as far from the base.
constexpr int kMostHalfDistances = 40;

const Rational kHalf = Rational(1L) / Rational(2L);

double evenness(const RationalSections& patch) {
  return least_ratio(
      patch.sections.weight.mapped([](const Rational& c) { return RealBall(c, kWeightBits); }));
}

int degree(const RationalSections& patch, Variable variable) {
  int result = patch.sections.weight.degree(variable);
  for (const auto* vector : {&patch.sections.point, &patch.sections.direction}) {
    for (const auto& p : *vector) result = std::max(result, p.degree(variable));
  }
  return result;
}

std::array<RationalSections, 2> halves(const RationalSections& patch, Variable variable) {
  const Rational zero, one(1L);
  return variable == Variable::kU ? std::array{part_of(patch, {zero, zero}, {kHalf, one}),
                                               part_of(patch, {kHalf, zero}, {one, one})}
                                  : std::array{part_of(patch, {zero, zero}, {one, kHalf}),
                                               part_of(patch, {zero, kHalf}, {one, one})};
}

double least_evenness(const std::array<RationalSections, 2>& parts) {
  return std::min(evenness(parts[0]), evenness(parts[1]));
}

void append_parts(std::vector<RationalSections>& parts, const RationalSections& patch,
                  int halvings) {
  if (evenness(patch) > kEvenWeights) {
    parts.push_back(patch);
    return;
  }
  if (halvings == 0) {
    throw GeometryError(ErrorCode::kWeightsNotPositive,
                        "No patches with positive weights were found: the surface or the mirror "
                        "that it comes from has a singular point, or nearly one.");
  }
  const auto along_u = halves(patch, Variable::kU), along_v = halves(patch, Variable::kV);
  const bool by_u = least_evenness(along_u) > least_evenness(along_v);
  for (const RationalSections& half : by_u ? along_u : along_v) {
    append_parts(parts, half, halvings - 1);
  }
}

std::vector<ExactPatch> exact_patches(const std::vector<RationalSections>& parts) {
  std::vector<ExactPatch> patches;
  for (const RationalSections& part : parts) {
    patches.push_back({{degree(part, Variable::kU), degree(part, Variable::kV)},
                       [part](long bits) { return enclosed(part, bits); },
                       {}});
  }
  return patches;
}

Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

Vector derivative(const Vector& a, Variable variable) {
  return {a[0].derivative(variable), a[1].derivative(variable), a[2].derivative(variable)};
}

Vector in_ring(const std::array<TensorPolynomial<Rational>, 3>& a) {
  return {pn::in_ring(a[0]), pn::in_ring(a[1]), pn::in_ring(a[2])};
}

/// N(X) of the theorem by one of its components.
Polynomial area_component(const Vector& x, const Polynomial& w, std::size_t i) {
  const Vector xu = derivative(x, Variable::kU), xv = derivative(x, Variable::kV);
  return w * cross(xu, xv)[i] + w.derivative(Variable::kU) * cross(xv, x)[i] +
         w.derivative(Variable::kV) * cross(x, xu)[i];
}

/// l0 + l1 d + l2 d^2 by its coefficients, for distances in units of the length L.
using AreaFactor = std::array<Polynomial, 3>;

/// That of a patch, counted from `base`, and positive at the middle unless it vanishes there.
AreaFactor area_factor(const RationalSections& part, const Rational& base) {
  const Polynomial w = pn::in_ring(part.sections.weight);
  const Vector v = in_ring(part.sections.direction);
  Vector x = in_ring(part.sections.point);
  for (std::size_t c = 0; c < 3; ++c) x[c] += Polynomial(base) * v[c];
  const std::size_t i = v[2].is_zero() ? (v[1].is_zero() ? 0 : 1) : 2;
  const Polynomial component = *quotient(v[i], gcd(gcd(v[0], v[1]), v[2]));
  const auto at = [&](long d) {
    Vector moved = x;
    for (std::size_t c = 0; c < 3; ++c) moved[c] += Polynomial(d) * v[c];
    return *quotient(area_component(moved, w, i), component);
  };
  const Polynomial zero = at(0), plus = at(1), minus = at(-1), half(kHalf);
  AreaFactor l = {zero, half * (plus - minus), half * (plus + minus) - zero};
  if (l[0](kHalf, kHalf).sign() < 0) {
    for (Polynomial& p : l) p = -p;
  }
  return l;
}

/// With -d in place of d.
AreaFactor reversed(const AreaFactor& l) { return {l[0], -l[1], l[2]}; }

/// No section from 0 to d is singular: proved.
bool is_regular(const AreaFactor& l, const Rational& d) {
  const Polynomial distance(d), two(2L);
  return is_positive_on_square(two * l[0] + distance * l[1]) &&
         is_positive_on_square(l[0] + distance * l[1] + distance * distance * l[2]);
}

bool is_not_negative(const Polynomial& p) {
  return p.is_zero() || has_non_negative_coefficients(p) || is_positive_on_square(p);
}

/// No section at any d > 0 is singular: proved.
bool is_regular_for_ever(const AreaFactor& l) {
  return is_not_negative(l[1]) && is_not_negative(l[2]);
}

/// The least positive root of a quadratic polynomial; infinite without one.
double least_positive_root(double c, double b, double a) {
  const double discriminant = b * b - 4 * a * c;
  double least = std::numeric_limits<double>::infinity();
  if (discriminant < 0) return least;
  const double q = -0.5 * (b + std::copysign(std::sqrt(discriminant), b));
  for (const double root : {q / a, c / q}) {
    if (root > 0) least = std::min(least, root);
  }
  return least;
}

struct FocalSample {
  double distance = std::numeric_limits<double>::infinity();
  std::size_t part = 0;
  double u = 0, v = 0;
};

/// The nearest focal point seen at the samples of a patch.
FocalSample nearest_sample(const AreaFactor& l, std::size_t part) {
  std::array<TensorPolynomial<double>, 3> sampled;
  for (std::size_t k = 0; k < 3; ++k) {
    sampled[k] = dense(l[k]).mapped([](const Rational& c) { return c.to_double(); });
  }
  FocalSample nearest;
  for (int i = 0; i <= kSamples; ++i) {
    for (int j = 0; j <= kSamples; ++j) {
      const double u = static_cast<double>(i) / kSamples, v = static_cast<double>(j) / kSamples;
      const double distance =
          least_positive_root(sampled[0].at(u, v), sampled[1].at(u, v), sampled[2].at(u, v));
      if (distance < nearest.distance) nearest = {distance, part, u, v};
    }
  }
  return nearest;
}

bool all_of(const std::vector<AreaFactor>& factors,
            const std::function<bool(const AreaFactor&)>& condition) {
  std::vector<char> holds(factors.size());
  for_each_index(factors.size(), [&](std::size_t i) { holds[i] = condition(factors[i]) ? 1 : 0; });
  return std::all_of(holds.begin(), holds.end(), [](char held) { return held != 0; });
}

struct Limit {
  double distance;  ///< proved, in units of the length
  FocalSample focus;
};

/// How far the sections go in the direction of the normal.
Limit limit(const std::vector<AreaFactor>& factors) {
  std::vector<FocalSample> samples(factors.size());
  for_each_index(factors.size(),
                 [&](std::size_t i) { samples[i] = nearest_sample(factors[i], i); });
  const FocalSample focus =
      *std::min_element(samples.begin(), samples.end(),
                        [](const auto& a, const auto& b) { return a.distance < b.distance; });
  if (all_of(factors, is_regular_for_ever)) {
    return {std::numeric_limits<double>::infinity(), FocalSample{}};
  }
  const auto is_proved = [&](double d) {
    return all_of(factors,
                  [&](const AreaFactor& l) { return is_regular(l, Rational::exactly(d)); });
  };
  // Nothing was seen but cannot be proved for ever: far away is as good.
  constexpr double kFar = 1e6;
  double high = std::min(focus.distance, kFar), low = high * (1 - kLimitTolerance);
  int tries = 0;
  while (!is_proved(low)) {
    if (++tries == kMostHalfDistances) return {0, focus};
    high = low;
    low /= 2;
  }
  while (high - low > kLimitTolerance * high) {
    const double middle = low + (high - low) / 2;
    (is_proved(middle) ? low : high) = middle;
  }
  return {low, focus};
}

double evaluated(const TensorPolynomial<Rational>& p, const FocalSample& at) {
  return p.at(Rational::exactly(at.u), Rational::exactly(at.v)).to_double();
}

std::optional<FocalPoint> focal_point(const RationalSections& part, const FocalSample& focus,
                                      double distance, double length) {
  if (!std::isfinite(focus.distance)) return std::nullopt;
  FocalPoint result{{}, {}, distance};
  const double weight = evaluated(part.sections.weight, focus);
  for (std::size_t c = 0; c < 3; ++c) {
    result.base[c] = evaluated(part.sections.point[c], focus) / weight;
    result.point[c] = result.base[c] +
                      distance / (weight * length) * evaluated(part.sections.direction[c], focus);
  }
  return result;
}

}  // namespace

std::vector<RationalSections> evenly_weighted(const std::vector<RationalSections>& patches) {
  std::vector<std::vector<RationalSections>> parts(patches.size());
  for_each_index(patches.size(), [&](std::size_t i) {
    const int most = std::max(degree(patches[i], Variable::kU), degree(patches[i], Variable::kV));
    if (most > kMostDegree) {
      throw GeometryError(ErrorCode::kDegreeTooHigh, "The surface would have degree " +
                                                         std::to_string(most) +
                                                         "; faces have degree 25 at most.");
    }
    append_parts(parts[i], patches[i], kMostHalvings);
  });
  std::vector<RationalSections> result;
  for (auto& some : parts) std::move(some.begin(), some.end(), std::back_inserter(result));
  return result;
}

RationalSource::RationalSource(const std::vector<RationalSections>& patches, double base,
                               std::vector<std::string> notes)
    : RationalSource(evenly_weighted(patches), base, std::move(notes),
                     std::all_of(patches.begin(), patches.end(), [](const auto& patch) {
                       return patch.squared_length.has_value();
                     })) {}

RationalSource::RationalSource(std::vector<RationalSections> parts, double base,
                               std::vector<std::string> notes, bool has_offsets)
    : PatchSource(exact_patches(parts), std::move(notes)),
      parts_(std::move(parts)),
      base_(base),
      has_offsets_(has_offsets) {}

OffsetRange RationalSource::regular_range() const {
  if (!has_offsets_) return {0, 0};
  // In units of the length, rounded towards the base.
  constexpr double kInwards = 1 - 1e-15;
  const double length = std::sqrt(parts_.front().squared_length->to_double());
  const Rational base = Rational::exactly(base_ / length);
  std::vector<AreaFactor> above(parts_.size()), below(parts_.size());
  for_each_index(parts_.size(), [&](std::size_t i) {
    above[i] = area_factor(parts_[i], base);
    below[i] = reversed(above[i]);
  });
  if (!all_of(above, [](const AreaFactor& l) { return is_positive_on_square(l[0]); })) {
    return {base_, base_};
  }
  const Limit up = limit(above), down = limit(below);
  const double upper = std::nextafter(base_ + up.distance * length * kInwards, -INFINITY),
               lower = std::nextafter(base_ - down.distance * length * kInwards, INFINITY);
  return {std::isfinite(down.distance) ? lower : -INFINITY,
          std::isfinite(up.distance) ? upper : INFINITY,
          focal_point(parts_[down.focus.part], down.focus, base_ - down.focus.distance * length,
                      length),
          focal_point(parts_[up.focus.part], up.focus, base_ + up.focus.distance * length, length)};
}

}  // namespace pn
