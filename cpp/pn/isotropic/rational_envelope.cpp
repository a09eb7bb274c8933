// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/isotropic/rational_envelope.hpp"

#include "pn/geometry_error.hpp"

namespace pn {
namespace {

using Vector = std::array<BivariateFunction, 3>;

BivariateFunction dot(const Vector& x, const Vector& y) {
  return x[0] * y[0] + x[1] * y[1] + x[2] * y[2];
}

/// N = m_u x m_v
Vector normal_of_centres(const SphereSurface& f) {
  const auto component = [&](std::size_t i, std::size_t j) {
    return f[i].derivative(Variable::kU) * f[j].derivative(Variable::kV) -
           f[j].derivative(Variable::kU) * f[i].derivative(Variable::kV);
  };
  return {component(1, 2), component(2, 0), component(0, 1)};
}

Vector composed(const Vector& x, const Reparametrization& change) {
  return {x[0].composed<2>({change.u, change.v}), x[1].composed<2>({change.u, change.v}),
          x[2].composed<2>({change.u, change.v})};
}

OrientedSurface sheet_with_normal(const Vector& n, const SphereSurface& f) {
  return {{f[0] - f[3] * n[0], f[1] - f[3] * n[1], f[2] - f[3] * n[2]}, n};
}

Vector reflected(const Vector& n, const Vector& mirror_normal) {
  const BivariateFunction factor =
      BivariateFunction(2L) * dot(n, mirror_normal) / dot(mirror_normal, mirror_normal);
  return {n[0] - factor * mirror_normal[0], n[1] - factor * mirror_normal[1],
          n[2] - factor * mirror_normal[2]};
}

}  // namespace

OrientedSurface other_sheet(const OrientedSurface& sheet, const SphereSurface& f) {
  return sheet_with_normal(reflected(sheet.normal, normal_of_centres(f)), f);
}

RationalEnvelope rational_envelope(const SphereSurface& f) {
  const Vector normal = normal_of_centres(f);
  if (dot(normal, normal).is_zero()) {
    throw GeometryError(ErrorCode::kZeroLength,
                        "The centres of the spheres lie on a curve, so they are no mid-surface.");
  }
  if (mos_root(f)) return {f, envelope_sheets(f), std::nullopt};
  const IsotropicField w = stereographic_field();
  const auto found = reparametrizations(f, w);
  if (found.empty() && has_developable_sheets(f)) {
    throw GeometryError(ErrorCode::kDevelopable,
                        "The normals of the skins depend on one parameter only: the skins are "
                        "developable, and no surfaces over their normals.");
  }
  if (found.empty()) {
    throw GeometryError(ErrorCode::kNotRational,
                        "The family is not rational: its normals are no rational functions of its "
                        "parameters, nor its parameters of the normals.");
  }
  const Reparametrization& contact = found.front();
  const SphereSurface spheres = contact(f);
  const Vector n = {w[0] / w[3], w[1] / w[3], w[2] / w[3]};
  // N of f before its parameters are changed has far lower degrees, and the same direction.
  const Vector second = reflected(n, composed(normal, contact));
  return {spheres, {sheet_with_normal(n, spheres), sheet_with_normal(second, spheres)}, contact};
}

}  // namespace pn
