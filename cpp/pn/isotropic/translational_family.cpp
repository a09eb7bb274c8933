// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/isotropic/translational_family.hpp"

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

SphereParabolas SphereParabolas::halved(std::size_t i) const {
  SphereParabolas result = *this;
  const auto at = static_cast<std::ptrdiff_t>(i);
  result.breaks.insert(result.breaks.begin() + at + 1, (breaks[i] + breaks[i + 1]) * kHalf);
  result.spans[i] = spans[i].part(0L, kHalf);
  result.spans.insert(result.spans.begin() + at + 1, spans[i].part(kHalf, kHalf));
  return result;
}

}  // namespace pn
