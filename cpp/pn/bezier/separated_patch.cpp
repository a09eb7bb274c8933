// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/bezier/separated_patch.hpp"

#include <algorithm>

#include "pn/algebra/precision.hpp"
#include "pn/isotropic/separated_sheets.hpp"

namespace pn {

std::optional<SkinPatch> separated_patch(const QuadraticFamily& family, Sheet sheet) {
  // S_u x S_v points along the normal of the outer sheet, which the inner one becomes.
  const bool is_outer = sheet == Sheet::kOuter;
  const QuadraticFamily seen = is_outer ? family : family.exchanged();
  const auto normal = rational_normal(seen, Sheet::kOuter);
  if (!normal) return std::nullopt;
  const auto sections_at = [seen, normal = *normal](long bits) {
    return sections(seen, normal, bits);
  };
  const SurfaceSections<RealBall> x = sections_at(kLeastPrecision);
  const auto degree = [&](Variable variable) {
    return std::max(x.point[0].degree(variable), x.weight.degree(variable));
  };
  return SkinPatch{{degree(Variable::kU), degree(Variable::kV)},
                   sections_at,
                   [is_outer](const std::array<double, 2>& uv) {
                     return is_outer ? uv : std::array{uv[1], uv[0]};
                   },
                   sheet,
                   least_ratio(x.weight)};
}

}  // namespace pn
