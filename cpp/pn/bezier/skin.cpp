// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/bezier/skin.hpp"

#include <algorithm>
#include <cmath>

#include "pn/algebra/parallel.hpp"
#include "pn/algebra/roots.hpp"
#include "pn/bezier/box_chart.hpp"
#include "pn/bezier/polar_chart.hpp"
#include "pn/geometry_error.hpp"

namespace pn {
namespace {

/// Patches whose weights vary by more are avoided.
constexpr double kEvenWeights = 0.05;
/// Edges follow their paths to within this in parameters over [0, 1]. Polar charts are steep near
/// their base points, and doubles resolve less there.
constexpr double kParameterTolerance = 2e-13;
/// Quarterings of the triangle before a skin is given up.
constexpr int kMostQuarterings = 4;

/// The patch of a sheet with the best weights: in the box chart where they are even enough, else in
/// any chart. Nothing where no weights are positive.
std::optional<SkinPatch> best_patch(const QuadraticFamily& family, Sheet sheet) {
  std::optional<SkinPatch> best = box_patch(family, sheet);
  if (best && best->weight_ratio > kEvenWeights) return best;
  for (SkinPatch& patch : polar_patches(family, sheet)) {
    if (!best || !(best->weight_ratio >= patch.weight_ratio)) best = std::move(patch);
  }
  if (best && !(best->weight_ratio > 0)) best.reset();
  return best;
}

void append_patches(std::vector<SkinPatch>& patches, const QuadraticFamily& family, Sheet sheet,
                    int quarterings) {
  std::optional<SkinPatch> patch = best_patch(family, sheet);
  if (patch && (patch->weight_ratio > kEvenWeights || quarterings == 0)) {
    patches.push_back(std::move(*patch));
    return;
  }
  if (quarterings == 0) {
    throw GeometryError(ErrorCode::kWeightsNotPositive,
                        "No patches with positive weights were found for a skin: its normals turn "
                        "back too often. Divide the six spheres into smaller families.");
  }
  for (const QuadraticFamily& quarter : family.quartered()) {
    append_patches(patches, quarter, sheet, quarterings - 1);
  }
}

/// One Bezier patch, its first parameter counted from `place` on.
FaceNet face_net(const SkinPatch& patch, double place, long precision) {
  FaceNet face;
  face.stands_still = false;
  const auto [m, n] = patch.degree;
  face.frame.u_degree = m;
  face.frame.v_degree = n;
  face.frame.u_knots = {place, place + 1};
  face.frame.v_knots = {0, 1};
  face.frame.u_multiplicities = {m + 1, m + 1};
  face.frame.v_multiplicities = {n + 1, n + 1};
  const SurfaceSections<RealBall> sections = patch.sections(precision);
  std::array<std::vector<RealBall>, 3> point, direction;
  const auto coefficients = [&](TensorPolynomial<RealBall> p) {
    return to_bernstein(std::move(p += TensorPolynomial<RealBall>(m, n)));
  };
  for (std::size_t c = 0; c < 3; ++c) {
    point[c] = coefficients(sections.point[c]);
    direction[c] = coefficients(sections.direction[c]);
  }
  const std::vector<RealBall> weight = coefficients(sections.weight);
  for (std::size_t i = 0; i < weight.size(); ++i) {
    const RealBall inverse = RealBall(1) / weight[i];
    NetPole pole;
    pole.weight = weight[i];
    for (std::size_t c = 0; c < 3; ++c) {
      pole.point[c] = point[c][i] * inverse;
      pole.direction[c] = direction[c][i] * inverse;
    }
    face.poles.push_back(std::move(pole));
  }
  if (has_bad_weight(face)) throw Undecided("the sign of a weight");
  return face;
}

TrimmedFace trimmed_face(const SkinPatch& patch, std::size_t place) {
  TrimmedFace face{place, {{}}};
  for (const ParameterPath& path : boundary(patch)) {
    face.loops.front().push_back(edge_along(
        [path, place](double at) {
          const auto [p, q] = path(at);
          return std::array{static_cast<double>(place) + p, q};
        },
        kParameterTolerance));
  }
  return face;
}

}  // namespace

Skin::Skin(const QuadraticFamily& family, Sheet sheet, std::vector<std::string> notes)
    : family_(family), notes_(std::move(notes)) {
  std::vector<SkinPatch> patches;
  append_patches(patches, family, sheet, kMostQuarterings);
  patches_ = std::make_shared<const std::vector<SkinPatch>>(std::move(patches));
}

std::array<int, 2> Skin::degree() const {
  std::array<int, 2> degree = {0, 0};
  for (const SkinPatch& patch : *patches_) {
    for (std::size_t c = 0; c < 2; ++c) degree[c] = std::max(degree[c], patch.degree[c]);
  }
  return degree;
}

TrimmableNet Skin::net(Lines, long precision) const {
  std::vector<FaceNet> faces(patches_->size());
  for_each_index(faces.size(), [&](std::size_t i) {
    faces[i] = face_net((*patches_)[i], static_cast<double>(i), precision);
  });
  return {std::make_shared<const SectionNet>(std::move(faces), precision), [patches = patches_] {
            std::vector<TrimmedFace> trimmed(patches->size());
            for_each_index(trimmed.size(),
                           [&](std::size_t i) { trimmed[i] = trimmed_face((*patches)[i], i); });
            return trimmed;
          }};
}

OffsetRange Skin::regular_range() const {
  double least = INFINITY, largest = -INFINITY;
  for (const auto& sphere : family_.control()) {
    const double r = -sphere[3].to_double();
    least = std::min(least, r);
    largest = std::max(largest, r);
  }
  const double radius = pn::regular_radius(family_);
  return {std::nextafter(-radius - least, INFINITY), std::nextafter(radius - largest, -INFINITY)};
}

}  // namespace pn
