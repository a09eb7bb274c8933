// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/isotropic/translational_family.hpp"

#include <algorithm>

namespace pn {
namespace {

using Vector = MinkowskiVector<Rational>;

const Rational kHalf = Rational(1L) / Rational(2L);

/// x + t y
Vector moved(Vector x, const Rational& t, const Vector& y) {
  for (std::size_t c = 0; c < 4; ++c) x[c] += t * y[c];
  return x;
}

Vector scaled(Vector x, const Rational& factor) {
  for (Rational& c : x) c *= factor;
  return x;
}

bool is_zero(const Vector& x) {
  return std::all_of(x.begin(), x.end(), [](const Rational& c) { return c.is_zero(); });
}

/// The vector orthogonal to three: zero when they are dependent.
Vector orthogonal(const Vector& a, const Vector& b, const Vector& c) {
  const auto minor = [&](std::size_t i, std::size_t j, std::size_t k) {
    return a[i] * (b[j] * c[k] - b[k] * c[j]) - a[j] * (b[i] * c[k] - b[k] * c[i]) +
           a[k] * (b[i] * c[j] - b[j] * c[i]);
  };
  return {minor(1, 2, 3), -minor(0, 2, 3), minor(0, 1, 3), minor(0, 1, 2)};
}

/// m_u x m_v
std::array<Rational, 3> cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

}  // namespace

Vector SphereParabola::slope(const Rational& t) const { return moved(first, t, second); }

SphereParabola SphereParabola::part(const Rational& origin, const Rational& length) const {
  return {scaled(second, length * length), scaled(slope(origin), length),
          moved(moved(start, origin, first), origin * origin * kHalf, second)};
}

QuadraticFamily quadratic_family(const TranslationalFamily& family) {
  const auto& [c, d] = family;
  const Vector b002 = moved(c.start, 1L, d.start), b101 = moved(b002, kHalf, c.first),
               b011 = moved(b002, kHalf, d.first);
  return QuadraticFamily({moved(moved(b002, 1L, c.first), kHalf, c.second),
                          moved(b101, kHalf, d.first),
                          moved(moved(b002, 1L, d.first), kHalf, d.second), b101, b011, b002});
}

std::array<QuadraticFamily, 2> triangles(const TranslationalFamily& family) {
  const auto reversed = [](const SphereParabola& x) { return x.part(1L, -1L); };
  return {quadratic_family(family), quadratic_family({reversed(family.c), reversed(family.d)})};
}

std::optional<std::array<double, 2>> unreal_place(const TranslationalFamily& family) {
  const auto [low, high] = triangles(family);
  if (const auto place = unreal_place(low)) return place;
  if (const auto place = unreal_place(high)) return std::array{1 - (*place)[0], 1 - (*place)[1]};
  return std::nullopt;
}

bool is_flat(const TranslationalFamily& family, Sheet sheet) {
  const Vector &c1 = family.c.first, &c2 = family.c.second, &d1 = family.d.first,
               &d2 = family.d.second;
  // c1 and d1 are independent, being f_u and f_v at a corner.
  Vector z = orthogonal(c1, d1, c2);
  if (is_zero(z)) z = orthogonal(c1, d1, d2);
  if (is_zero(z)) return true;
  const auto is_orthogonal = [&](const Vector& x) { return minkowski(z, x).is_zero(); };
  if (!is_orthogonal(c2) || !is_orthogonal(d2) || !is_orthogonal(z)) return false;
  const auto across = cross(c1, d1);
  const Rational side = z[0] * across[0] + z[1] * across[1] + z[2] * across[2];
  return (side * z[3]).sign() == (sheet == Sheet::kOuter ? 1 : -1);
}

SphereParabolas SphereParabolas::halved(std::size_t i) const {
  SphereParabolas result = *this;
  const auto at = static_cast<std::ptrdiff_t>(i);
  result.breaks.insert(result.breaks.begin() + at + 1, (breaks[i] + breaks[i + 1]) * kHalf);
  result.spans[i] = spans[i].part(0L, kHalf);
  result.spans.insert(result.spans.begin() + at + 1, spans[i].part(kHalf, kHalf));
  return result;
}

}  // namespace pn
