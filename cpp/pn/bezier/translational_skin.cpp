// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/bezier/translational_skin.hpp"

#include <algorithm>

#include "pn/algebra/parallel.hpp"
#include "pn/bezier/circle_chart.hpp"
#include "pn/bezier/separated_patch.hpp"
#include "pn/bezier/skin.hpp"
#include "pn/geometry_error.hpp"

namespace pn {
namespace {

using Parameters = std::array<double, 2>;

/// Rounds of halvings before a skin is given up.
constexpr int kMostHalvings = 6;

/// The patches of a sheet, pair by pair of spans, those of one span of c together.
struct PatchGrid {
  TranslationalSpline spline;
  std::vector<std::optional<SkinPatch>> patches;

  std::size_t columns() const { return spline.d.spans.size(); }
  TranslationalFamily family(std::size_t k) const {
    return spline.family(k / columns(), k % columns());
  }
};

PatchGrid patch_grid(TranslationalSpline spline, Sheet sheet) {
  PatchGrid grid{std::move(spline), {}};
  grid.patches.resize(grid.spline.c.spans.size() * grid.columns());
  for_each_index(grid.patches.size(),
                 [&](std::size_t k) { grid.patches[k] = best_patch(grid.family(k), sheet); });
  return grid;
}

double ratio_of(const std::optional<SkinPatch>& patch) { return patch ? patch->weight_ratio : 0; }

/// The worse weights of a sheet over the halves u < 1/2 and u > 1/2.
double ratio_of_halves(const TranslationalFamily& family, Sheet sheet) {
  const Rational half = Rational(1L) / Rational(2L);
  return std::min(ratio_of(best_patch({family.c.part(0L, half), family.d}, sheet)),
                  ratio_of(best_patch({family.c.part(half, half), family.d}, sheet)));
}

/// Halving c leaves better weights than halving d.
bool is_better_along_c(const TranslationalFamily& family, Sheet sheet) {
  return ratio_of_halves(family, sheet) > ratio_of_halves(family.exchanged(), opposite(sheet));
}

/// The spline with a span halved for every patch without even weights.
TranslationalSpline refined(const PatchGrid& grid, Sheet sheet) {
  std::vector<char> along_c(grid.spline.c.spans.size()), along_d(grid.columns());
  for (std::size_t k = 0; k < grid.patches.size(); ++k) {
    if (ratio_of(grid.patches[k]) > kEvenWeights) continue;
    const bool is_along_c = is_better_along_c(grid.family(k), sheet);
    (is_along_c ? along_c[k / grid.columns()] : along_d[k % grid.columns()]) = 1;
  }
  TranslationalSpline result = grid.spline;
  for (std::size_t i = along_c.size(); i-- > 0;) {
    if (along_c[i] != 0) result.c = result.c.halved(i);
  }
  for (std::size_t j = along_d.size(); j-- > 0;) {
    if (along_d[j] != 0) result.d = result.d.halved(j);
  }
  return result;
}

bool is_even(const PatchGrid& grid) {
  return std::all_of(grid.patches.begin(), grid.patches.end(),
                     [](const auto& patch) { return ratio_of(patch) > kEvenWeights; });
}

/// The sides of the unit square as the boundary of a patch, which lies on their left: on the inner
/// sheet, which is seen from the other side, they run clockwise around the square.
std::vector<ParameterPath> square_boundary(const SkinPatch& patch) {
  constexpr std::array<Parameters, 4> kCorners = {{{0, 0}, {1, 0}, {1, 1}, {0, 1}}};
  const bool is_outer = patch.sheet == Sheet::kOuter;
  std::vector<ParameterPath> sides;
  for (std::size_t k = 0; k < 4; ++k) {
    const std::size_t first = is_outer ? k : (4 - k) % 4, last = is_outer ? (k + 1) % 4 : 3 - k;
    const Parameters from = kCorners[first], to = kCorners[last];
    sides.emplace_back([place_of = patch.place_of, from, to](double at) {
      return place_of({from[0] * (1 - at) + to[0] * at, from[1] * (1 - at) + to[1] * at});
    });
  }
  return sides;
}

std::vector<ExactPatch> exact_patches(const TranslationalSpline& spline, Sheet sheet) {
  PatchGrid grid = patch_grid(spline, sheet);
  for (int i = 0; i < kMostHalvings && !is_even(grid); ++i) {
    grid = patch_grid(refined(grid, sheet), sheet);
  }
  std::vector<ExactPatch> result;
  for (const auto& patch : grid.patches) {
    if (!patch) {
      throw GeometryError(
          ErrorCode::kWeightsNotPositive,
          "No patches with positive weights were found for a skin: its normals turn too far within "
          "a span. Divide the curves of spheres into shorter spans.");
    }
    result.push_back({patch->degree, patch->sections, square_boundary(*patch)});
  }
  return result;
}

}  // namespace

std::optional<SkinPatch> best_patch(const TranslationalFamily& family, Sheet sheet) {
  if (auto separated = separated_patch(quadratic_family(family), sheet)) return separated;
  const std::optional<SkinPatch> along_c = circle_patch(family, sheet),
                                 along_d = circle_patch(family.exchanged(), opposite(sheet));
  if (!(std::max(ratio_of(along_c), ratio_of(along_d)) > 0)) return std::nullopt;
  if (ratio_of(along_c) >= ratio_of(along_d)) return along_c;
  return SkinPatch{along_d->degree, along_d->sections,
                   [place_of = along_d->place_of](const Parameters& uv) {
                     return place_of({uv[1], uv[0]});
                   },
                   sheet, along_d->weight_ratio};
}

TranslationalSkin::TranslationalSkin(const TranslationalSpline& spline, Sheet sheet,
                                     std::vector<std::string> notes)
    : PatchSource(exact_patches(spline, sheet), std::move(notes)), spline_(spline) {}

OffsetRange TranslationalSkin::regular_range() const {
  const std::size_t columns = spline_.d.spans.size();
  std::vector<OffsetRange> ranges(2 * spline_.c.spans.size() * columns);
  for_each_index(ranges.size(), [&](std::size_t k) {
    const TranslationalFamily family = spline_.family(k / 2 / columns, k / 2 % columns);
    ranges[k] = pn::regular_range(triangles(family)[k % 2]);
  });
  OffsetRange all = ranges.front();
  for (const OffsetRange& range : ranges) {
    all.lower = std::max(all.lower, range.lower);
    all.upper = std::min(all.upper, range.upper);
  }
  return all;
}

}  // namespace pn
