// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/bezier/trim_region.hpp"

#include <algorithm>
#include <cmath>

#include "pn/bezier/parameter_curve.hpp"

namespace pn {
namespace {

using Point = std::array<double, 2>;

/// Chords for each knot span of a curve: those that are interpolated have eight spans or more.
constexpr int kChords = 16;

double distance(const Point& p, const Point& from, const Point& to) {
  const Point side = {to[0] - from[0], to[1] - from[1]};
  const Point way = {p[0] - from[0], p[1] - from[1]};
  const double square = side[0] * side[0] + side[1] * side[1];
  const double along = square > 0 ? (way[0] * side[0] + way[1] * side[1]) / square : 0;
  const double part = std::clamp(along, 0.0, 1.0);
  return std::hypot(way[0] - part * side[0], way[1] - part * side[1]);
}

/// Whether the segment has a point in the rectangle, by the part of it between each pair of sides.
bool meets(const Rectangle& rectangle, const Point& from, const Point& to) {
  double first = 0, last = 1;
  for (std::size_t c = 0; c < 2; ++c) {
    const double step = to[c] - from[c];
    if (step == 0) {
      if (from[c] < rectangle.low[c] || from[c] > rectangle.high[c]) return false;
      continue;
    }
    const double a = (rectangle.low[c] - from[c]) / step, b = (rectangle.high[c] - from[c]) / step;
    first = std::max(first, std::min(a, b));
    last = std::min(last, std::max(a, b));
  }
  return first <= last;
}

}  // namespace

TrimRegion::TrimRegion(const std::vector<TrimLoop>& loops) {
  for (const TrimLoop& loop : loops) {
    for (const ParameterCurve& curve : loop) {
      const int chords = curve.degree == 1 ? 1 : kChords;
      for (std::size_t span = 0; span + 1 < curve.knots.size(); ++span) {
        const double begin = curve.knots[span], length = curve.knots[span + 1] - begin;
        for (int i = 0; i < chords; ++i) {
          const auto at = [&](double k) { return evaluate(curve, begin + length * k / chords); };
          const Point from = at(i), to = at(i + 1);
          chords_.push_back({from, to, 2 * distance(at(i + 0.5), from, to)});
        }
      }
    }
  }
}

bool TrimRegion::is_enclosed(const Point& p) const {
  bool enclosed = false;
  for (const auto& [a, b, sag] : chords_) {
    const bool crosses = (a[1] > p[1]) != (b[1] > p[1]);
    if (crosses && p[0] < a[0] + (p[1] - a[1]) / (b[1] - a[1]) * (b[0] - a[0])) {
      enclosed = !enclosed;
    }
  }
  return enclosed;
}

bool TrimRegion::contains(const Point& point) const {
  if (chords_.empty()) return true;
  const auto is_near = [&](const Chord& c) { return distance(point, c.from, c.to) <= c.sag; };
  return is_enclosed(point) && std::none_of(chords_.begin(), chords_.end(), is_near);
}

TrimRegion::Part TrimRegion::part_of(const Rectangle& rectangle) const {
  if (chords_.empty()) return Part::kAll;
  const auto is_met = [&](const Chord& c) { return meets(rectangle, c.from, c.to); };
  if (std::any_of(chords_.begin(), chords_.end(), is_met)) return Part::kSome;
  const Point middle = {rectangle.middle(Variable::kU), rectangle.middle(Variable::kV)};
  return is_enclosed(middle) ? Part::kAll : Part::kNone;
}

}  // namespace pn
