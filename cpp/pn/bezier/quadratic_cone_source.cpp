// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/bezier/quadratic_cone_source.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <memory>
#include <mutex>
#include <utility>

#include "pn/algebra/precision.hpp"
#include "pn/bezier/line_factor.hpp"
#include "pn/bezier/skin_patch.hpp"
#include "pn/conics/interval_substitution.hpp"
#include "pn/conics/quadratic_cone_envelope.hpp"
#include "pn/conics/stereographic_projection.hpp"
#include "pn/geometry_error.hpp"

namespace pn {
namespace {

/// OpenCASCADE's largest degree.
constexpr int kMostDegree = 25;
/// Patches whose weights vary by more are halved, as long as they may be.
constexpr double kEvenWeights = 0.02;
/// Halvings of a patch; where a weight is not positive after them, it vanishes nearby.
constexpr int kMostHalvings = 8;
/// Bits that tell the sign of a weight; the net takes as many as it needs.
constexpr long kWeightBits = 192;
/// Patches around all generators.
constexpr int kPatchesAround = 8;

/// The cones over s, t(s) from [0, 1] to [0, 1], real for all s.
QuadraticCones real_cones(const QuadraticCones& cones) {
  const ConicFamily family = family_of(cones);
  const Rational zero, one(1L);
  if (const auto interval = interval_without_real_points(family, zero, one)) {
    throw GeometryError(ErrorCode::kNoRealPoints,
                        "The cones have no real generators " + description(*interval) + ".");
  }
  const IntervalSubstitution substitution = interval_substitution(family, zero, one);
  Matrix4OfPolynomials matrix;
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = 0; j < 4; ++j) {
      matrix[i][j] = substitution(cones.matrix[i][j], cones.degree());
    }
  }
  return quadratic_cones(matrix);
}

void check_surface(const QuadraticCones& cones) {
  if (cones.vertex_degree() > 0 && envelops_curve(cones)) {
    throw GeometryError(ErrorCode::kDevelopable,
                        "The cones touch their envelope along one curve only: it is no surface.");
  }
}

/// An envelope and its points, at each precision once.
class EnclosedEnvelope {
 public:
  explicit EnclosedEnvelope(QuadraticCones cones) : envelope_(std::move(cones)) {}

  const QuadraticConeEnvelope& envelope() const { return envelope_; }
  const HomogeneousCoordinates<RealBall>& at(long bits) const {
    const std::lock_guard<std::mutex> lock(mutex_);
    const auto found = points_.find(bits);
    if (found != points_.end()) return found->second;
    return points_.emplace(bits, envelope_.contact_elements(bits).point).first->second;
  }

 private:
  QuadraticConeEnvelope envelope_;
  mutable std::mutex mutex_;
  mutable std::map<long, HomogeneousCoordinates<RealBall>> points_;
};

/// Generators of the cone at t = 1/2 by angles in [0, pi]: u = M (cos, sin), spread evenly.
class GeneratorCircle {
 public:
  explicit GeneratorCircle(const QuadraticConeEnvelope& envelope) {
    const Eigen::Matrix3d conic = conic_in_middle(envelope.cones());
    const Eigen::Matrix3d columns = generators_in_middle(envelope);
    // A point inside the conic, the mean of its points: its polar meets no generator, so it is a
    // definite form of u.
    constexpr int kSamples = 32;
    Eigen::Vector3d inside = Eigen::Vector3d::Zero();
    for (int i = 0; i < kSamples; ++i) {
      const double angle = i * M_PI / kSamples, c = std::cos(angle), s = std::sin(angle);
      inside += (columns * Eigen::Vector3d(c * c, c * s, s * s)).normalized();
    }
    const Eigen::RowVector3d form = inside.transpose() * conic * columns;
    Eigen::Matrix2d definite;
    definite << form[0], form[1] / 2, form[1] / 2, form[2];
    if (definite.trace() < 0) definite = -definite;
    const Eigen::LLT<Eigen::Matrix2d> cholesky(definite);
    from_circle_ = cholesky.info() == Eigen::Success
                       ? Eigen::Matrix2d(cholesky.matrixU().solve(Eigen::Matrix2d::Identity()))
                       : Eigen::Matrix2d(Eigen::Matrix2d::Identity());
  }

  /// (u0, u1), short numbers, of which those of angle + pi are the negatives.
  std::array<double, 2> operator()(double angle) const {
    const double turns = std::floor(angle / M_PI), rest = angle - turns * M_PI;
    const double sign = std::fmod(turns, 2) == 0 ? 1 : -1;
    const Eigen::Vector2d u = from_circle_ * Eigen::Vector2d(std::cos(rest), std::sin(rest));
    return {sign * lines::short_double(u[0]), sign * lines::short_double(u[1])};
  }

 private:
  static Eigen::Matrix3d conic_in_middle(const QuadraticCones& cones) {
    Eigen::Matrix3d result;
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < 3; ++j) {
        result(static_cast<int>(i), static_cast<int>(j)) =
            cones.conic[i][j](Rational(1L) / Rational(2L)).to_double();
      }
    }
    return result;
  }
  /// In the coordinates of the conic, by the coefficients of u0^2, u0 u1, u1^2.
  static Eigen::Matrix3d generators_in_middle(const QuadraticConeEnvelope& envelope) {
    const auto z = at_sufficient_precision([&](long bits) { return envelope.generators(bits); });
    const Rational half = Rational(1L) / Rational(2L);
    Eigen::Matrix3d result = Eigen::Matrix3d::Zero();
    for (int k = 0; k < 3; ++k) {
      for (std::size_t i = 0; i < 4; ++i) {
        const double zi = z[i].slice(Variable::kV, k).at(RealBall(0.5), RealBall()).midpoint();
        for (std::size_t j = 0; j < 3; ++j) {
          result(static_cast<int>(j), k) += envelope.cones().planes[i][j](half).to_double() * zi;
        }
      }
    }
    return result;
  }

  Eigen::Matrix2d from_circle_;
};

/// The part of the unit interval and of the generators that a patch covers.
struct Part {
  std::array<double, 2> t, angle;

  std::array<Part, 2> halved_along() const {
    const double middle = (t[0] + t[1]) / 2;
    return {Part{{t[0], middle}, angle}, Part{{middle, t[1]}, angle}};
  }
  std::array<Part, 2> halved_around() const {
    const double middle = (angle[0] + angle[1]) / 2;
    return {Part{t, {angle[0], middle}}, Part{t, {middle, angle[1]}}};
  }
};

using Polynomial = TensorPolynomial<RealBall>;

/// A polynomial of formal degree n in u over [0, 1]^2, for u between two places.
Polynomial restricted(const Polynomial& p, int n, const Part& part, const GeneratorCircle& circle,
                      long bits) {
  const Polynomial along =
      p.substituted(Variable::kU, RealBall(part.t[0]), RealBall(part.t[1]) - RealBall(part.t[0]));
  const auto begin = circle(part.angle[0]), end = circle(part.angle[1]);
  std::array<Polynomial, 2> u;
  for (std::size_t i = 0; i < 2; ++i) {
    u[i] = Polynomial(0, 1);
    // Sums and products of short doubles are not exact at the least precision.
    u[i](0, 0) = RealBall(begin[i]).at_precision(bits);
    u[i](0, 1) = RealBall(end[i]) - u[i](0, 0);
  }
  // Horner's scheme for sum c_k u0^(n - k) u1^k; the coefficients above the degree of p are zero.
  const auto coefficient = [&](int k) {
    return k <= along.degree(Variable::kV) ? along.slice(Variable::kV, k) : Polynomial();
  };
  Polynomial sum = coefficient(n), power = Polynomial::constant(RealBall(1L));
  for (int k = n - 1; k >= 0; --k) {
    power = power * u[0];
    sum = sum * u[1] + coefficient(k) * power;
  }
  return sum;
}

int degree_of(const HomogeneousCoordinates<RealBall>& x, Variable variable) {
  int degree = 0;
  for (const Polynomial& p : x) degree = std::max(degree, p.degree(variable));
  return degree;
}

HomogeneousCoordinates<RealBall> restricted(const HomogeneousCoordinates<RealBall>& x,
                                            const Part& part, const GeneratorCircle& circle,
                                            long bits) {
  const int n = degree_of(x, Variable::kV);
  return {restricted(x[0], n, part, circle, bits), restricted(x[1], n, part, circle, bits),
          restricted(x[2], n, part, circle, bits), restricted(x[3], n, part, circle, bits)};
}

/// An envelope and the places of its generators.
struct EnvelopeAround {
  EnclosedEnvelope envelope;
  GeneratorCircle circle;

  explicit EnvelopeAround(QuadraticCones cones)
      : envelope(std::move(cones)), circle(envelope.envelope()) {}

  HomogeneousCoordinates<RealBall> on(const Part& part, long bits) const {
    return restricted(envelope.at(bits), part, circle, bits);
  }
  Polynomial weight(const Part& part) const {
    const HomogeneousCoordinates<RealBall>& x = envelope.at(kWeightBits);
    return restricted(x[3], degree_of(x, Variable::kV), part, circle, kWeightBits);
  }
};

using Vector = Eigen::Vector3d;

/// The point of the contact curve of the cone at t = 1/2, in doubles.
class MiddleCurve {
 public:
  explicit MiddleCurve(const EnvelopeAround& surface) : circle_(surface.circle) {
    const HomogeneousCoordinates<RealBall>& x = surface.envelope.at(kWeightBits);
    const int n = degree_of(x, Variable::kV);
    for (std::size_t c = 0; c < 4; ++c) {
      for (int k = 0; k <= n; ++k) {
        const bool is_there = k <= x[c].degree(Variable::kV);
        coefficients_[c].push_back(
            is_there ? x[c].slice(Variable::kV, k).at(RealBall(0.5), RealBall()).midpoint() : 0);
      }
    }
  }

  Vector operator()(double angle) const {
    return Vector(value(0, angle), value(1, angle), value(2, angle)) / weight(angle);
  }
  double weight(double angle) const { return value(3, angle); }

  /// The angle of the point nearest to another one.
  double nearest(const Vector& point) const {
    constexpr int kSamples = 720, kRounds = 6, kZoom = 8;
    double best = 0;
    const auto look = [&](double begin, double step, int count) {
      double least = HUGE_VAL;
      for (int i = 0; i <= count; ++i) {
        const double angle = begin + i * step, distance = ((*this)(angle)-point).norm();
        if (distance < least) least = distance, best = angle;
      }
    };
    double step = M_PI / kSamples;
    look(0, step, kSamples);
    for (int round = 0; round < kRounds; ++round, step /= kZoom) {
      look(best - step, step / kZoom, 2 * kZoom);
    }
    return best;
  }

 private:
  double value(std::size_t c, double angle) const {
    const auto [u0, u1] = circle_(angle);
    double sum = 0, power = 1;
    for (std::size_t k = coefficients_[c].size(); k-- > 0; power *= u0) {
      sum = sum * u1 + coefficients_[c][k] * power;
    }
    return sum;
  }

  GeneratorCircle circle_;
  std::array<std::vector<double>, 4> coefficients_;
};

/// From the first of three angles past the second to the third, modulo pi.
std::array<double, 2> angles_of(const std::array<double, 3>& angles) {
  const auto after_first = [&](double angle) {
    const double turn = std::fmod(angle - angles[0], M_PI);
    return turn < 0 ? turn + M_PI : turn;
  };
  const double middle = after_first(angles[1]), end = after_first(angles[2]);
  return {angles[0], angles[0] + (middle <= end ? end : end - M_PI)};
}

/// Names the place where the weight was seen to be least.
[[noreturn]] void refuse_unbounded(const Polynomial& weight, const Part& part) {
  constexpr int kSamples = 16;
  double least = HUGE_VAL, place = 0;
  for (int i = 0; i <= kSamples; ++i) {
    for (int j = 0; j <= kSamples; ++j) {
      const double s = static_cast<double>(i) / kSamples, u = static_cast<double>(j) / kSamples;
      const double value = weight.at(RealBall(s), RealBall(u)).midpoint();
      if (value < least) least = value, place = s;
    }
  }
  char text[160];
  std::snprintf(
      text, sizeof text,
      "The contact curve of the cone at %.3g of the way reaches infinity, or nearly: only "
      "an arc without such points is a face.",
      part.t[0] + place * (part.t[1] - part.t[0]));
  throw GeometryError(ErrorCode::kRegionUnbounded, text);
}

/// Appends parts with weights of this sign.
void append_parts(std::vector<Part>& parts, const EnvelopeAround& surface, const Part& part,
                  const RealBall& sign, int halvings) {
  const auto evenness = [&](const Part& some) { return least_ratio(surface.weight(some) * sign); };
  if (evenness(part) > (halvings > 0 ? kEvenWeights : 0)) {
    parts.push_back(part);
    return;
  }
  if (halvings == 0) refuse_unbounded(surface.weight(part) * sign, part);
  const auto along = part.halved_along(), around = part.halved_around();
  const auto least = [&](const std::array<Part, 2>& halves) {
    return std::min(evenness(halves[0]), evenness(halves[1]));
  };
  for (const Part& half : least(along) > least(around) ? along : around) {
    append_parts(parts, surface, half, sign, halvings - 1);
  }
}

/// Without a field of normals: they would raise the degree.
ExactPatch patch(const std::shared_ptr<const EnvelopeAround>& surface, const Part& part,
                 const RealBall& sign) {
  return {surface->envelope.envelope().degree(),
          [=](long bits) {
            const HomogeneousCoordinates<RealBall> x = surface->on(part, bits);
            SurfaceSections<RealBall> sections;
            for (std::size_t c = 0; c < 3; ++c) sections.point[c] = x[c] * sign;
            sections.weight = x[3] * sign;
            return sections;
          },
          {}};
}

std::vector<ExactPatch> patches_of(const QuadraticCones& cones,
                                   const std::optional<ContactArc>& arc) {
  check_surface(cones);
  const auto surface = std::make_shared<const EnvelopeAround>(real_cones(cones));
  const int highest = surface->envelope.envelope().degree()[0];
  if (highest > kMostDegree) {
    throw GeometryError(
        ErrorCode::kDegreeTooHigh,
        "The surface would have degree " + std::to_string(highest) + " along t; 25 is the most.");
  }
  const MiddleCurve middle(*surface);
  std::array<double, 2> angles = {0, M_PI};
  if (arc) {
    std::array<double, 3> through;
    for (std::size_t i = 0; i < 3; ++i) {
      through[i] = middle.nearest({(*arc)[i][0], (*arc)[i][1], (*arc)[i][2]});
    }
    angles = angles_of(through);
  }
  const RealBall sign(middle.weight((angles[0] + angles[1]) / 2) < 0 ? -1L : 1L);
  const double turn = angles[1] - angles[0];
  const int count =
      std::max(1, static_cast<int>(std::ceil(std::abs(turn) * kPatchesAround / M_PI)));
  std::vector<Part> parts;
  for (int i = 0; i < count; ++i) {
    append_parts(parts, *surface,
                 {{0, 1}, {angles[0] + turn * i / count, angles[0] + turn * (i + 1) / count}}, sign,
                 kMostHalvings);
  }
  std::vector<ExactPatch> result;
  for (const Part& part : parts) result.push_back(patch(surface, part, sign));
  return result;
}

}  // namespace

QuadraticConeSource::QuadraticConeSource(const QuadraticCones& cones,
                                         const std::optional<ContactArc>& arc,
                                         std::vector<std::string> notes)
    : PatchSource(patches_of(cones, arc), std::move(notes)) {}

}  // namespace pn
