// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/bezier/skin.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "pn/bezier/box_chart.hpp"
#include "pn/bezier/polar_chart.hpp"
#include "pn/bezier/separated_patch.hpp"
#include "pn/bezier/translational_skin.hpp"
#include "pn/geometry_error.hpp"
#include "pn/isotropic/translational_form.hpp"

namespace pn {
namespace {

using Parameters = std::array<double, 2>;

/// Quarterings of the triangle before a skin is given up.
constexpr int kMostQuarterings = 4;

/// The patch of a sheet in the chart of circles of either curve, a part of that over the square.
std::optional<SkinPatch> patch_by_circles(const TranslationalForm& form, Sheet sheet) {
  std::optional<SkinPatch> patch = best_patch(form.family, sheet);
  if (patch) {
    patch->place_of = [form, place_of = patch->place_of](const Parameters& uv) {
      return place_of(form.at(uv));
    };
  }
  return patch;
}

/// The better one of two patches.
std::optional<SkinPatch> better(std::optional<SkinPatch> a, std::optional<SkinPatch> b) {
  return a && (!b || a->weight_ratio >= b->weight_ratio) ? a : b;
}

/// The patch of a sheet, in the first chart of these in which the weights are even enough, else in
/// the best one; nothing where no weights are positive.
std::optional<SkinPatch> patch_of(const QuadraticFamily& family, Sheet sheet) {
  if (auto separated = separated_patch(family, sheet)) return separated;
  std::optional<SkinPatch> best = box_patch(family, sheet);
  if (best && best->weight_ratio > kEvenWeights) return best;
  if (const auto form = translational_form(family)) {
    best = better(std::move(best), patch_by_circles(*form, sheet));
  } else {
    for (SkinPatch& patch : polar_patches(family, sheet)) {
      best = better(std::move(best), std::move(patch));
    }
  }
  return best;
}

void append_patches(std::vector<PlacedPatch>& patches, const FamilyPart& part, Sheet sheet,
                    int quarterings) {
  std::optional<SkinPatch> patch = patch_of(part.family, sheet);
  if (patch && patch->weight_ratio > (quarterings == 0 ? 0 : kEvenWeights)) {
    const auto& [u, v, w] = part.corners;
    patches.push_back({std::move(*patch), {w, u, v}});
    return;
  }
  if (quarterings == 0) {
    throw GeometryError(ErrorCode::kWeightsNotPositive,
                        "No patches with positive weights were found for a skin: its normals turn "
                        "back too often. Divide the six spheres into smaller families.");
  }
  for (const FamilyPart& quarter : part.quartered()) {
    append_patches(patches, quarter, sheet, quarterings - 1);
  }
}

std::vector<Parameters> corners_of(const std::vector<PlacedPatch>& patches) {
  std::vector<Parameters> corners;
  for (const PlacedPatch& patch : patches) {
    corners.insert(corners.end(), patch.corners.begin(), patch.corners.end());
  }
  return corners;
}

/// The parameters in (0, 1) at which corners lie between two points. All are multiples of a power
/// of two, so the products are exact.
std::vector<double> corners_between(const std::vector<Parameters>& corners, const Parameters& from,
                                    const Parameters& to) {
  const double du = to[0] - from[0], dv = to[1] - from[1];
  std::vector<double> found;
  for (const Parameters& corner : corners) {
    const double u = corner[0] - from[0], v = corner[1] - from[1];
    if (u * dv != v * du) continue;
    const double at = std::abs(du) > std::abs(dv) ? u / du : v / dv;
    if (0 < at && at < 1) found.push_back(at);
  }
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

}  // namespace

std::vector<PlacedPatch> skin_patches(const QuadraticFamily& family, Sheet sheet) {
  std::vector<PlacedPatch> patches;
  append_patches(patches, {family}, sheet, kMostQuarterings);
  return patches;
}

std::vector<double> ends_along(const std::vector<PlacedPatch>& patches, std::size_t edge) {
  return corners_between(corners_of(patches), on_edge(edge, 0), on_edge(edge, 1));
}

std::vector<ExactPatch> exact_patches(const std::vector<PlacedPatch>& patches,
                                      const std::vector<std::array<double, 2>>& more) {
  std::vector<Parameters> ends = corners_of(patches);
  ends.insert(ends.end(), more.begin(), more.end());
  std::vector<ExactPatch> result;
  for (const auto& [patch, corners] : patches) {
    ExactPatch exact{patch.degree, patch.sections, {}};
    const auto paths = boundary(patch);
    for (std::size_t k = 0; k < 3; ++k) {
      const bool is_outer = patch.sheet == Sheet::kOuter;
      const std::size_t edge = is_outer ? k : 2 - k;
      const Parameters &a = corners[edge], &b = corners[(edge + 1) % 3];
      double from = 0;
      for (const double to : corners_between(ends, is_outer ? a : b, is_outer ? b : a)) {
        exact.boundary.push_back(part_of(paths[k], from, to));
        from = to;
      }
      exact.boundary.push_back(part_of(paths[k], from, 1));
    }
    result.push_back(std::move(exact));
  }
  return result;
}

OffsetRange regular_range(const QuadraticFamily& family) {
  double least = INFINITY, largest = -INFINITY;
  for (const auto& sphere : family.control()) {
    const double r = -sphere[3].to_double();
    least = std::min(least, r);
    largest = std::max(largest, r);
  }
  const double radius = regular_radius(family);
  return {std::nextafter(-radius - least, INFINITY), std::nextafter(radius - largest, -INFINITY)};
}

Skin::Skin(const QuadraticFamily& family, Sheet sheet, std::vector<std::string> notes)
    : PatchSource(exact_patches(skin_patches(family, sheet)), std::move(notes)), family_(family) {}

OffsetRange Skin::regular_range() const { return pn::regular_range(family_); }

}  // namespace pn
