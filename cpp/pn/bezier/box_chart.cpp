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

/// Bits at which weights are judged.
constexpr long kJudgingBits = 128;

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
PlaneFrame fitted(const std::vector<Sample>& samples) {
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

/// S_p x S_q shall point along the normal, which is against m_u x m_v on the inner sheet.
PlaneFrame oriented(PlaneFrame frame, Sheet sheet) {
  if (sheet == Sheet::kInner) std::swap(frame.across[0], frame.across[1]);
  return frame;
}

}  // namespace

std::optional<SkinPatch> box_patch(const QuadraticFamily& family, Sheet sheet) {
  const FamilyInDoubles doubles(family);
  const Stereographic rotation(doubles.normal(sheet, 1.0 / 3, 1.0 / 3));
  const std::vector<Sample> samples = edge_samples(doubles, sheet, rotation);
  std::vector<Complex> images;
  for (const Sample& sample : samples) images.push_back(sample.z);
  const std::optional<PlaneFrame> found = frame_around(images, fitted(samples));
  if (!found) return std::nullopt;
  const PlaneFrame frame = oriented(*found, sheet);
  const IsotropicPolynomials<Rational> w = isotropic_polynomials(rotation, frame);
  const IntegerPowerForm f = integer_power_form(family);
  const Contact<Rational> contact = contact_of(f.form, w);
  if (in_ring(contact.e).is_zero()) return std::nullopt;
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
