// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/isotropic/translational_form.hpp"

#include <algorithm>
#include <utility>

#include "pn/isotropic/along_surface.hpp"

namespace pn {
namespace {

using Vector = MinkowskiVector<Rational>;
using Direction = std::array<Rational, 2>;

bool is_zero(const Vector& x) {
  return std::all_of(x.begin(), x.end(), [](const Rational& c) { return c.is_zero(); });
}

Vector combined(const Rational& s, const Vector& x, const Rational& t, const Vector& y) {
  Vector result;
  for (std::size_t c = 0; c < 4; ++c) result[c] = s * x[c] + t * y[c];
  return result;
}

/// B(x, y)
Vector mixed(const PowerForm<Rational>& f, const Direction& x, const Direction& y) {
  const Vector first = combined(x[0] * y[0], f[0], x[1] * y[1], f[2]);
  return combined(1L, first, x[0] * y[1] + x[1] * y[0], f[1]);
}

/// (A, B, C) up to a factor, by the minors of two coordinates; zero where they are dependent.
std::array<Rational, 3> relation(const PowerForm<Rational>& f, std::size_t i, std::size_t j) {
  const auto minor = [&](std::size_t k, std::size_t l) {
    return f[k][i] * f[l][j] - f[l][i] * f[k][j];
  };
  return {minor(1, 2), minor(2, 0), minor(0, 1)};
}

/// The directions of theorem 1 from a relation that is not zero.
std::optional<std::array<Direction, 2>> roots(const std::array<Rational, 3>& relation) {
  const auto& [a, b, c] = relation;
  const Rational discriminant = b * b - Rational(4L) * a * c;
  const auto root = square_root(discriminant);
  if (!root || root->is_zero()) return std::nullopt;
  // Of both ways to write the roots the one that divides by no zero.
  const Rational sum = b.sign() < 0 ? b - *root : b + *root, two(2L);
  return std::array<Direction, 2>{{{two * a, sum}, {sum, two * c}}};
}

/// The rulings of a parabolic cylinder and another direction.
std::optional<std::array<Direction, 2>> rulings(const PowerForm<Rational>& f) {
  const Direction along_u = {1L, 0L}, along_v = {0L, 1L};
  for (std::size_t c = 0; c < 4; ++c) {
    if (!f[0][c].is_zero()) return std::array<Direction, 2>{along_u, {-f[1][c], f[0][c]}};
    if (!f[2][c].is_zero()) return std::array<Direction, 2>{along_v, {f[2][c], -f[1][c]}};
  }
  return std::nullopt;
}

std::optional<std::array<Direction, 2>> directions(const PowerForm<Rational>& f) {
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = i + 1; j < 4; ++j) {
      const auto found = relation(f, i, j);
      if (std::any_of(found.begin(), found.end(), [](const Rational& x) { return !x.is_zero(); })) {
        return roots(found);
      }
    }
  }
  return rulings(f);
}

Rational determinant(const std::array<Direction, 2>& d) {
  return d[0][0] * d[1][1] - d[0][1] * d[1][0];
}

/// p or q up to scale and origin: at u = 1 and at v = 1, being zero at the origin.
struct Range {
  Rational low, length;
};
Range range_of(const Direction& x) {
  const Rational zero, low = std::min({zero, x[0], x[1]}), high = std::max({zero, x[0], x[1]});
  return {low, high - low};
}

}  // namespace

std::array<double, 2> TranslationalForm::at(const std::array<double, 2>& uv) const {
  std::array<double, 2> result;
  for (std::size_t i = 0; i < 2; ++i) {
    const auto& [constant, by_u, by_v] = parameters[i];
    result[i] = constant.to_double() + by_u.to_double() * uv[0] + by_v.to_double() * uv[1];
  }
  return result;
}

std::optional<TranslationalForm> translational_form(const QuadraticFamily& family) {
  const PowerForm<Rational> f = family.power();
  const auto found = directions(f);
  if (!found || !is_zero(mixed(f, (*found)[0], (*found)[1]))) return std::nullopt;
  std::array<Direction, 2> d = *found;
  if (determinant(d).sign() < 0) std::swap(d[0], d[1]);
  const auto& [x, y] = d;
  const Rational scale = determinant(d);
  const std::array<Direction, 2> inverse = {
      {{y[1] / scale, -y[0] / scale}, {-x[1] / scale, x[0] / scale}}};
  TranslationalForm result;
  const auto curve = [&](std::size_t i, const Vector& start) {
    const auto [low, length] = range_of(inverse[i]);
    result.parameters[i] = {-low / length, inverse[i][0] / length, inverse[i][1] / length};
    const SphereParabola parabola{mixed(f, d[i], d[i]), combined(d[i][0], f[3], d[i][1], f[4]),
                                  start};
    return parabola.part(low, length);
  };
  result.family = {curve(0, f[5]), curve(1, {})};
  return result;
}

}  // namespace pn
