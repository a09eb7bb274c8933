// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/bezier/exact_patch.hpp"

#include <algorithm>

#include "pn/algebra/ball_vector.hpp"
#include "pn/algebra/parallel.hpp"
#include "pn/algebra/roots.hpp"

namespace pn {
namespace {

/// Edges follow their paths to within this in parameters over [0, 1]. Polar charts are steep near
/// their base points, and doubles resolve less there.
constexpr double kParameterTolerance = 2e-13;

/// One Bezier patch, its first parameter counted from `place` on.
FaceNet face_net(const ExactPatch& patch, double place, long precision) {
  FaceNet face;
  face.stands_still = false;
  const int m = patch.degree[0], n = patch.degree[1];
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
  const std::vector<RealBall> even_weight = normalized(weight);
  for (std::size_t i = 0; i < weight.size(); ++i) {
    const RealBall inverse = RealBall(1) / weight[i];
    NetPole pole;
    pole.weight = even_weight[i];
    for (std::size_t c = 0; c < 3; ++c) {
      pole.point[c] = point[c][i] * inverse;
      pole.direction[c] = direction[c][i] * inverse;
    }
    face.poles.push_back(std::move(pole));
  }
  if (has_bad_weight(face)) throw Undecided("the sign of a weight");
  return face;
}

TrimmedFace trimmed_face(const ExactPatch& patch, std::size_t place) {
  if (patch.boundary.empty()) return {place, {}};
  TrimmedFace face{place, {{}}};
  for (const ParameterPath& path : patch.boundary) {
    const auto moved = [path, place](double at) {
      const auto [p, q] = path(at);
      return std::array{static_cast<double>(place) + p, q};
    };
    face.loops.front().push_back(edge_along(moved, kParameterTolerance));
  }
  return face;
}

}  // namespace

ParameterPath part_of(const ParameterPath& path, double from, double to) {
  if (from == 0 && to == 1) return path;
  return [=](double at) { return path(from * (1 - at) + to * at); };
}

PatchSource::PatchSource(std::vector<ExactPatch> patches, std::vector<std::string> notes)
    : patches_(std::make_shared<const std::vector<ExactPatch>>(std::move(patches))),
      notes_(std::move(notes)) {}

std::array<int, 2> PatchSource::degree() const {
  std::array<int, 2> degree = {0, 0};
  for (const ExactPatch& patch : *patches_) {
    for (std::size_t c = 0; c < 2; ++c) degree[c] = std::max(degree[c], patch.degree[c]);
  }
  return degree;
}

TrimmableNet PatchSource::net(Lines, long precision) const {
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

}  // namespace pn
