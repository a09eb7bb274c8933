// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/bezier/skin_patch.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <memory>
#include <vector>

namespace pn {
namespace {

using Complex = std::complex<double>;
using Eigen::Matrix2d;
using Eigen::Vector2d;
using Eigen::Vector3d;
using Parameters = std::array<double, 2>;

/// Places on each edge at which its image is looked at.
constexpr int kSamples = 24;
/// The chart is wider than what was seen of the edges by this part: they bend between the samples.
constexpr double kMargin = 1.0 / 50;
/// Bits of free choices: enough for a frame as flat as a sheet may be.
constexpr int kFrameBits = 24, kRotationBits = 12;
/// Steps of Newton's method from a start that is good to ten digits or more.
constexpr int kNewtonSteps = 3;

/// The multiple of `unit` nearest to x.
double rounded_to(double x, double unit) { return std::round(x / unit) * unit; }

Complex rounded_to(const Complex& z, double unit) {
  return {rounded_to(z.real(), unit), rounded_to(z.imag(), unit)};
}

/// The power of two by which numbers of the size of z have so many bits.
double unit_of(double size, int bits) {
  int exponent = 0;
  std::frexp(size, &exponent);
  return std::ldexp(1.0, exponent - bits);
}

struct Spinor {
  Complex a0, a1;
};

/// A spinor of this unit normal.
Spinor spinor_of(const Vector3d& n) {
  if (n.z() >= 0) return {1 + n.z(), {n.x(), n.y()}};
  return {{n.x(), -n.y()}, 1 - n.z()};
}

/// The rotation that moves a normal to the north pole, nearly: short and exact up to a factor.
class Rotation {
 public:
  explicit Rotation(const Vector3d& n) {
    const Spinor spinor = spinor_of(n);
    const double unit = unit_of(2, kRotationBits);
    a_ = {rounded_to(spinor.a0, unit), rounded_to(spinor.a1, unit)};
  }

  /// The spinors (a0, a1) and (-conj a1, conj a0) are the images of both poles.
  Spinor north() const { return a_; }
  Spinor south() const { return {-std::conj(a_.a1), std::conj(a_.a0)}; }

  /// The stereographic coordinate of a normal.
  Complex projected(const Vector3d& n) const {
    const Spinor x = spinor_of(n), s = south();
    return (std::conj(s.a0) * x.a0 + std::conj(s.a1) * x.a1) /
           (std::conj(a_.a0) * x.a0 + std::conj(a_.a1) * x.a1);
  }

 private:
  Spinor a_;
};

/// z = origin + p across[0] + q across[1]
struct Frame {
  Complex origin;
  std::array<Complex, 2> across;

  Parameters parameters(const Complex& z) const {
    const Complex from = z - origin;
    const auto cross = [](const Complex& x, const Complex& y) { return (std::conj(x) * y).imag(); };
    const double area = cross(across[0], across[1]);
    return {cross(from, across[1]) / area, cross(across[0], from) / area};
  }
};

struct Sample {
  Parameters uv;
  Complex z;
};

const std::array<Parameters, 3> kCorners = {{{0, 0}, {1, 0}, {0, 1}}};

Parameters on_edge(std::size_t edge, double at) {
  const Parameters &from = kCorners[edge], &to = kCorners[(edge + 1) % 3];
  return {from[0] * (1 - at) + to[0] * at, from[1] * (1 - at) + to[1] * at};
}

std::vector<Sample> edge_samples(const FamilyInDoubles& family, Sheet sheet,
                                 const Rotation& rotation) {
  std::vector<Sample> samples;
  for (std::size_t edge = 0; edge < 3; ++edge) {
    for (int i = 0; i < kSamples; ++i) {
      const Parameters uv = on_edge(edge, static_cast<double>(i) / kSamples);
      samples.push_back({uv, rotation.projected(family.normal(sheet, uv[0], uv[1]))});
    }
  }
  return samples;
}

/// The affine map from (u, v) to z of least squares.
Frame fitted(const std::vector<Sample>& samples) {
  const auto count = static_cast<Eigen::Index>(samples.size());
  Eigen::MatrixX3d parameters(count, 3);
  Eigen::VectorXcd images(count);
  for (Eigen::Index i = 0; i < count; ++i) {
    const Sample& sample = samples[static_cast<std::size_t>(i)];
    parameters.row(i) << 1, sample.uv[0], sample.uv[1];
    images(i) = sample.z;
  }
  const Eigen::Matrix3d normal = parameters.transpose() * parameters;
  const Eigen::Vector3cd fit = normal.inverse() * (parameters.transpose() * images);
  return {fit(0), {fit(1), fit(2)}};
}

/// The frame with the directions of another, around the samples, in short numbers; nothing when
/// they lie on a line.
std::optional<Frame> around(const std::vector<Sample>& samples, const Frame& directions) {
  Parameters low = {INFINITY, INFINITY}, high = {-INFINITY, -INFINITY};
  for (const Sample& sample : samples) {
    const Parameters p = directions.parameters(sample.z);
    for (std::size_t c = 0; c < 2; ++c) {
      low[c] = std::min(low[c], p[c]);
      high[c] = std::max(high[c], p[c]);
    }
  }
  Frame frame{directions.origin, {}};
  for (std::size_t c = 0; c < 2; ++c) {
    const double margin = kMargin * (high[c] - low[c]);
    const Complex side = directions.across[c] * (high[c] - low[c] + 2 * margin);
    if (!(std::abs(side) > 0) || !std::isfinite(std::abs(side))) return std::nullopt;
    frame.across[c] = rounded_to(side, unit_of(std::abs(side), kFrameBits));
    frame.origin += directions.across[c] * (low[c] - margin);
  }
  const double shortest = std::min(std::abs(frame.across[0]), std::abs(frame.across[1]));
  frame.origin = rounded_to(frame.origin, unit_of(shortest, kFrameBits));
  return frame;
}

/// S_p x S_q shall point along the normal, which is against m_u x m_v on the inner sheet.
Frame oriented(Frame frame, Sheet sheet) {
  if (sheet == Sheet::kInner) std::swap(frame.across[0], frame.across[1]);
  return frame;
}

/// w on the parallelogram of a frame, times a number that makes it one of integers.
IsotropicPolynomials<Rational> isotropic_polynomials(const Rotation& rotation, const Frame& frame) {
  const Spinor north = rotation.north(), south = rotation.south();
  const auto component = [&](const Complex& n, const Complex& s) {
    const auto part = [&](auto&& real_or_imaginary) {
      // Products of short doubles are exact in Q, not always in doubles.
      const auto product = [&](const Complex& z) {
        const auto number = [](double x) { return Rational::exactly(x); };
        return real_or_imaginary(
            number(s.real()) * number(z.real()) - number(s.imag()) * number(z.imag()),
            number(s.real()) * number(z.imag()) + number(s.imag()) * number(z.real()));
      };
      const Rational constant =
          real_or_imaginary(Rational::exactly(n.real()), Rational::exactly(n.imag()));
      return TensorPolynomial<Rational>::linear(constant + product(frame.origin),
                                                product(frame.across[0]), product(frame.across[1]));
    };
    return std::array{part([](const Rational& re, const Rational&) { return re; }),
                      part([](const Rational&, const Rational& im) { return im; })};
  };
  const auto a0 = component(north.a0, south.a0), a1 = component(north.a1, south.a1);
  const auto [re0, im0, re1, im1] = with_integers(std::array{a0[0], a0[1], a1[0], a1[1]});
  return pn::isotropic_polynomials(SpinorPolynomials<Rational>{{re0, re1}, {im0, im1}});
}

/// Solves a / e = u, b / e = v by Newton's method, in doubles.
class ContactSolver {
 public:
  explicit ContactSolver(const Contact<Rational>& contact) {
    Rational largest;
    for (const Rational& c : contact.e.coefficients()) {
      largest = std::max(largest, c.sign() < 0 ? -c : c,
                         [](const Rational& x, const Rational& y) { return x < y; });
    }
    const auto number = [&](const Rational& c) { return (c / largest).to_double(); };
    numerators_ = {Jet(contact.a.mapped(number)), Jet(contact.b.mapped(number))};
    e_ = Jet(contact.e.mapped(number));
  }

  Parameters solution(const Parameters& uv, const Parameters& start) const {
    Vector2d x(start[0], start[1]);
    for (int step = 0; step < kNewtonSteps; ++step) {
      Vector2d residue;
      Matrix2d slopes;
      const double e = e_.value.at(x(0), x(1));
      const Eigen::RowVector2d e_slopes = e_.slopes_at(x);
      for (int i = 0; i < 2; ++i) {
        const Jet& numerator = numerators_[static_cast<std::size_t>(i)];
        const double target = uv[static_cast<std::size_t>(i)];
        residue(i) = numerator.value.at(x(0), x(1)) - target * e;
        slopes.row(i) = numerator.slopes_at(x) - target * e_slopes;
      }
      x -= slopes.inverse() * residue;
    }
    return {x(0), x(1)};
  }

 private:
  struct Jet {
    TensorPolynomial<double> value, by_u, by_v;

    Jet() = default;
    explicit Jet(TensorPolynomial<double> p)
        : value(std::move(p)),
          by_u(value.derivative(Variable::kU)),
          by_v(value.derivative(Variable::kV)) {}
    Eigen::RowVector2d slopes_at(const Vector2d& x) const {
      return {by_u.at(x(0), x(1)), by_v.at(x(0), x(1))};
    }
  };

  std::array<Jet, 2> numerators_;
  Jet e_;
};

/// The smallest of some Bernstein coefficients in parts of the largest.
double least_ratio(const TensorPolynomial<RealBall>& weight) {
  double least = INFINITY, largest = 0;
  for (const RealBall& c : to_bernstein(weight)) {
    least = std::min(least, c.lower());
    largest = std::max(largest, c.upper());
  }
  return least / largest;
}

SurfaceSections<RealBall> in_balls(const SurfaceSections<Rational>& exact, long bits) {
  const auto converted = [bits](const TensorPolynomial<Rational>& p) {
    return p.mapped([bits](const Rational& c) { return RealBall(c, bits); });
  };
  return {
      {converted(exact.point[0]), converted(exact.point[1]), converted(exact.point[2])},
      {converted(exact.direction[0]), converted(exact.direction[1]), converted(exact.direction[2])},
      converted(exact.weight)};
}

/// The edges of the triangle counterclockwise on the outer sheet, clockwise on the inner one, whose
/// chart is reflected.
template <class Locate>
std::array<ParameterPath, 3> edge_paths(Sheet sheet, const Locate& locate) {
  std::array<ParameterPath, 3> edges;
  for (std::size_t k = 0; k < 3; ++k) {
    const bool is_outer = sheet == Sheet::kOuter;
    edges[k] = [locate, edge = is_outer ? k : 2 - k, is_outer](double at) {
      return locate(on_edge(edge, is_outer ? at : 1 - at));
    };
  }
  return edges;
}

}  // namespace

std::optional<SkinPatch> box_patch(const QuadraticFamily& family, Sheet sheet) {
  const FamilyInDoubles doubles(family);
  const Rotation rotation(doubles.normal(sheet, 1.0 / 3, 1.0 / 3));
  const std::vector<Sample> samples = edge_samples(doubles, sheet, rotation);
  const std::optional<Frame> found = around(samples, fitted(samples));
  if (!found) return std::nullopt;
  const Frame frame = oriented(*found, sheet);
  const IsotropicPolynomials<Rational> w = isotropic_polynomials(rotation, frame);
  const IntegerPowerForm f = integer_power_form(family);
  const Contact<Rational> contact = contact_of(f.form, w);
  const auto exact = std::make_shared<const SurfaceSections<Rational>>(
      without_common_factor(scaled_sections(f, w, contact), contact.e));
  const TensorPolynomial<RealBall> weight =
      exact->weight.mapped([](const Rational& c) { return RealBall(c, 128); });
  const auto locate = [doubles, sheet, rotation, frame,
                       solver =
                           std::make_shared<const ContactSolver>(contact)](const Parameters& uv) {
    const Complex z = rotation.projected(doubles.normal(sheet, uv[0], uv[1]));
    return solver->solution(uv, frame.parameters(z));
  };
  return SkinPatch{{exact->weight.degree(Variable::kU), exact->weight.degree(Variable::kV)},
                   [exact](long bits) { return in_balls(*exact, bits); },
                   edge_paths(sheet, locate),
                   least_ratio(weight)};
}

}  // namespace pn
