// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/bezier/corner_lune.hpp"

#include <algorithm>
#include <complex>
#include <memory>

#include "pn/algebra/precision.hpp"
#include "pn/bezier/skin_patch.hpp"
#include "pn/bezier/stereographic.hpp"
#include "pn/geometry_error.hpp"

namespace pn {
namespace {

using Complex = std::complex<double>;
using Eigen::Vector3d;

/// Places on a side at which its image is looked at.
constexpr int kSamples = 24;
/// Weights that vary by more have their degree raised, up to the largest one that is tried.
constexpr double kEvenWeights = 0.05;
constexpr int kMostDegree = 8;

/// The sphere with the normals of w.
SurfaceSections<Rational> sphere_sections(const MinkowskiVector<Rational>& sphere,
                                          const IsotropicPolynomials<Rational>& w) {
  SurfaceSections<Rational> x;
  for (std::size_t c = 0; c < 3; ++c) {
    x.point[c] = w[3] * sphere[c] - w[c] * sphere[3];
    x.direction[c] = w[c];
  }
  x.weight = w[3];
  return x;
}

/// The least even degree at which the weights are even enough; none up to the largest.
std::optional<int> raised_degree(const SurfaceSections<Rational>& x) {
  const TensorPolynomial<RealBall> weight = in_balls(x, kLeastPrecision).weight;
  for (int degree = 2; degree <= kMostDegree; degree += 2) {
    if (least_ratio(weight + TensorPolynomial<RealBall>(degree, degree)) > kEvenWeights) {
      return degree;
    }
  }
  return std::nullopt;
}

}  // namespace

ExactPatch corner_lune(const QuadraticFamily& family, std::size_t edge) {
  constexpr std::array<std::size_t, 3> kCornerAfter = {0, 2, 5};
  const NormalArc before = end_arc(family, edge, 1), after = end_arc(family, (edge + 1) % 3, 0);
  const Vector3d middle = (before(0.5) + after(0.5)).normalized();
  const Stereographic chart(middle);
  std::vector<Complex> images;
  for (int i = 0; i <= kSamples; ++i) {
    const double at = static_cast<double>(i) / kSamples;
    images.push_back(chart.projected(before(at)));
    images.push_back(chart.projected(after(at)));
  }
  const Complex along = images.back() - images.front();  // from tip to tip
  const auto frame = frame_around(images, {0, {along, Complex(0, 1) * along}});
  std::optional<int> degree;
  std::shared_ptr<const SurfaceSections<Rational>> x;
  if (frame) {
    x = std::make_shared<const SurfaceSections<Rational>>(sphere_sections(
        family.control()[kCornerAfter[edge]], isotropic_polynomials(chart, *frame)));
    degree = raised_degree(*x);
  }
  if (!degree) {
    throw GeometryError(ErrorCode::kWeightsNotPositive,
                        "The edges of the mid-surface turn back at a corner: the sphere there has "
                        "no patch with positive weights.");
  }
  const auto side = [&](const NormalArc& arc, bool is_forward) -> ParameterPath {
    return [=, place = *frame](double at) {
      return place.parameters(chart.projected(arc(is_forward ? at : 1 - at)));
    };
  };
  return {{*degree, *degree},
          [x](long bits) { return in_balls(*x, bits); },
          {side(after, true), side(before, false)}};
}

}  // namespace pn
