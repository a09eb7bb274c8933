// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/bezier/box_chart.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <memory>

#include "pn/bezier/contact_solver.hpp"
#include "pn/bezier/stereographic.hpp"

namespace pn {
namespace {

using Complex = std::complex<double>;
using Parameters = std::array<double, 2>;

/// Bits of free choices: enough for a frame as flat as a sheet may be.
constexpr int kFrameBits = 24;
/// Bits at which weights are judged.
constexpr long kJudgingBits = 128;

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

std::vector<Sample> edge_samples(const FamilyInDoubles& family, Sheet sheet,
                                 const Stereographic& rotation) {
  std::vector<Sample> samples;
  for (const Parameters& uv : edge_points()) {
    samples.push_back({uv, rotation.projected(family.normal(sheet, uv[0], uv[1]))});
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
  std::vector<Parameters> images;
  for (const Sample& sample : samples) images.push_back(directions.parameters(sample.z));
  const ImageBox box = box_around(images);
  Frame frame{directions.origin, {}};
  double shortest = INFINITY;
  for (std::size_t c = 0; c < 2; ++c) {
    const Complex side = directions.across[c] * (box.high[c] - box.low[c]);
    if (!(std::abs(side) > 0) || !std::isfinite(std::abs(side))) return std::nullopt;
    frame.across[c] = shortened(side, std::abs(side), kFrameBits);
    frame.origin += directions.across[c] * box.low[c];
    shortest = std::min(shortest, std::abs(side));
  }
  frame.origin = shortened(frame.origin, shortest, kFrameBits);
  return frame;
}

/// S_p x S_q shall point along the normal, which is against m_u x m_v on the inner sheet.
Frame oriented(Frame frame, Sheet sheet) {
  if (sheet == Sheet::kInner) std::swap(frame.across[0], frame.across[1]);
  return frame;
}

/// w on the parallelogram of a frame, times a number that makes it one of integers.
IsotropicPolynomials<Rational> isotropic_polynomials(const Stereographic& rotation,
                                                     const Frame& frame) {
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

SurfaceSections<RealBall> in_balls(const SurfaceSections<Rational>& exact, long bits) {
  const auto converted = [bits](const TensorPolynomial<Rational>& p) {
    return p.mapped([bits](const Rational& c) { return RealBall(c, bits); });
  };
  return {
      {converted(exact.point[0]), converted(exact.point[1]), converted(exact.point[2])},
      {converted(exact.direction[0]), converted(exact.direction[1]), converted(exact.direction[2])},
      converted(exact.weight)};
}

}  // namespace

std::optional<SkinPatch> box_patch(const QuadraticFamily& family, Sheet sheet) {
  const FamilyInDoubles doubles(family);
  const Stereographic rotation(doubles.normal(sheet, 1.0 / 3, 1.0 / 3));
  const std::vector<Sample> samples = edge_samples(doubles, sheet, rotation);
  const std::optional<Frame> found = around(samples, fitted(samples));
  if (!found) return std::nullopt;
  const Frame frame = oriented(*found, sheet);
  const IsotropicPolynomials<Rational> w = isotropic_polynomials(rotation, frame);
  const IntegerPowerForm f = integer_power_form(family);
  const Contact<Rational> contact = contact_of(f.form, w);
  const auto exact = std::make_shared<const SurfaceSections<Rational>>(
      without_common_factor(scaled_sections(f, w, contact), contact.e));
  const auto place_of = [doubles, sheet, rotation, frame,
                         solver =
                             std::make_shared<const ContactSolver>(contact)](const Parameters& uv) {
    const Complex z = rotation.projected(doubles.normal(sheet, uv[0], uv[1]));
    return solver->solution(uv, frame.parameters(z));
  };
  return SkinPatch{{exact->weight.degree(Variable::kU), exact->weight.degree(Variable::kV)},
                   [exact](long bits) { return in_balls(*exact, bits); },
                   place_of,
                   sheet,
                   least_ratio(exact->weight.mapped(
                       [](const Rational& c) { return RealBall(c, kJudgingBits); }))};
}

}  // namespace pn
