// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/bezier/section_net.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "pn/algebra/parallel.hpp"
#include "pn/algebra/roots.hpp"
#include "pn/geometry_error.hpp"

namespace pn {
namespace {

/// A row of control points takes about ten microseconds, as long as to wake another thread.
constexpr std::size_t kRowsPerTask = 32;

/// A weight below this part of the largest is as good as zero, and other faces are tried instead:
/// 2^ to this power.
constexpr int kNegligibleWeightBits = -40;

/// A coordinate this much smaller than the surface is zero on export: 2^-90 of its size. That is
/// where 128 bits leave the coordinates of an ellipsoid that vanish.
constexpr int kNegligibleBits = 90;
/// The arithmetic of the bounds below rounds by a few hundred units in the last place at most.
constexpr double kRoundingOfBounds = 1 + 1e-12;

double rounded_coordinate(const RealBall& x, double size) {
  if (const auto nearest = x.rounded()) return *nearest;
  if (x.magnitude_upper() <= std::ldexp(size, -kNegligibleBits)) return 0;
  throw Undecided("the last place of a pole");
}

double rounded_weight(const RealBall& x) {
  if (const auto nearest = x.rounded()) return *nearest;
  throw Undecided("the last place of a weight");
}

double unit_in_last_place(double x) {
  x = std::abs(x);
  return std::nextafter(x, std::numeric_limits<double>::infinity()) - x;
}

using Point = std::array<double, 3>;

double length(const Point& v) { return std::hypot(v[0], v[1], v[2]); }

std::array<RealBall, 3> pole_at(const NetPole& pole, const RealBall& distance) {
  return {pole.point[0] + distance * pole.direction[0],
          pole.point[1] + distance * pole.direction[1],
          pole.point[2] + distance * pole.direction[2]};
}

/// How far a pole that replaces another lies from it, and by what factor their weights differ.
struct Difference {
  double pole = 0, weight = 0;
};

Difference difference(const NetPole& own, const NetPole& shared, const RealBall& distance) {
  const auto a = pole_at(own, distance), b = pole_at(shared, distance);
  const Point gap = {(a[0] - b[0]).magnitude_upper(), (a[1] - b[1]).magnitude_upper(),
                     (a[2] - b[2]).magnitude_upper()};
  return {length(gap), ((shared.weight - own.weight) / own.weight).magnitude_upper()};
}

/// The box of some rows of poles.
struct Box {
  Point low = {INFINITY, INFINITY, INFINITY}, high = {-INFINITY, -INFINITY, -INFINITY};
  void add(const Point& p) {
    for (std::size_t i = 0; i < 3; ++i) {
      low[i] = std::min(low[i], p[i]);
      high[i] = std::max(high[i], p[i]);
    }
  }
  double diagonal() const { return length({high[0] - low[0], high[1] - low[1], high[2] - low[2]}); }
};

/// The largest diagonal of the boxes around the poles that are active on one knot span along the
/// spine.
double active_diameter(const BSplineSurface& surface) {
  const std::size_t columns = surface.v_count();
  double diameter = 0;
  std::size_t last = 0;
  for (std::size_t span = 0; span + 1 < surface.u_knots.size(); ++span) {
    last += static_cast<std::size_t>(surface.u_multiplicities[span]);
    const std::size_t end = last, begin = end - static_cast<std::size_t>(surface.u_degree) - 1;
    Box box;
    for (std::size_t i = begin * columns; i < end * columns; ++i) box.add(surface.poles[i]);
    diameter = std::max(diameter, box.diagonal());
  }
  return diameter;
}

/// The largest coordinate of a pole, nearly.
double estimated_size(const FaceNet& face, double distance) {
  double size = 0;
  for (const NetPole& pole : face.poles) {
    for (std::size_t c = 0; c < 3; ++c) {
      const double x = pole.point[c].midpoint() + distance * pole.direction[c].midpoint();
      size = std::max(size, std::abs(x));
    }
  }
  return size;
}

/// How far a rounded pole is from the true one at most.
double rounding_error(const Point& pole, double size) {
  const double negligible = std::ldexp(size, -kNegligibleBits);
  return length({std::max(unit_in_last_place(pole[0]), negligible),
                 std::max(unit_in_last_place(pole[1]), negligible),
                 std::max(unit_in_last_place(pole[2]), negligible)});
}

RoundedFace rounded(const FaceNet& face, double exact_distance) {
  const RealBall distance(exact_distance);
  BSplineSurface surface = face.frame;
  const std::size_t columns = surface.v_count(), rows = surface.u_count();
  const double size = estimated_size(face, exact_distance);
  surface.poles.resize(face.poles.size());
  surface.weights.resize(face.poles.size());
  for_each_index_in_blocks(rows, kRowsPerTask, [&](std::size_t row) {
    for (std::size_t i = row * columns; i < (row + 1) * columns; ++i) {
      const auto pole = pole_at(face.poles[i], distance);
      for (std::size_t c = 0; c < 3; ++c) surface.poles[i][c] = rounded_coordinate(pole[c], size);
      surface.weights[i] = rounded_weight(face.poles[i].weight);
    }
  });
  double delta = 0;
  for (const Point& pole : surface.poles) delta = std::max(delta, rounding_error(pole, size));
  Difference largest;
  const auto compare = [&](const NetPole& own, const NetPole& shared) {
    const Difference d = difference(own, shared, distance);
    largest.pole = std::max(largest.pole, d.pole);
    largest.weight = std::max(largest.weight, d.weight);
  };
  for (std::size_t j = 0; j < face.replaced_first.size(); ++j) {
    compare(face.replaced_first[j], face.poles[j]);
  }
  for (std::size_t j = 0; j < face.replaced_last.size(); ++j) {
    compare(face.replaced_last[j], face.poles[face.poles.size() - face.replaced_last.size() + j]);
  }
  delta += largest.pole;
  const double epsilon = std::numeric_limits<double>::epsilon() + 2 * largest.weight;
  // The theorem asks for eps < 1: rows whose weights differ by more do not make one edge.
  if (!(epsilon < 1)) {
    throw GeometryError(ErrorCode::kWeightsNotPositive,
                        "Neighbouring faces do not meet with the same weights; divide the input "
                        "into separate parts.");
  }
  const double diameter = active_diameter(surface) + 2 * delta;
  const double deviation = (delta + epsilon / (1 - epsilon) * diameter) * kRoundingOfBounds;
  return {std::move(surface), deviation};
}

}  // namespace

bool has_bad_weight(const FaceNet& face) {
  double largest = 0;
  for (const NetPole& pole : face.poles) {
    largest = std::max(largest, std::abs(pole.weight.midpoint()));
  }
  const double negligible = std::ldexp(largest, kNegligibleWeightBits);
  return std::any_of(face.poles.begin(), face.poles.end(), [&](const NetPole& pole) {
    if (pole.weight.magnitude_upper() <= negligible || pole.weight.is_negative()) return true;
    if (pole.weight.is_positive()) return false;
    throw Undecided("the sign of a weight");
  });
}

std::vector<RoundedFace> SectionNet::section(double distance) const {
  std::vector<RoundedFace> result(faces_.size());
  for_each_index(faces_.size(), [&](std::size_t i) { result[i] = rounded(faces_[i], distance); });
  return result;
}

bool SectionNet::has_normals() const {
  const auto is_zero = [](const RealBall& x) { return x.is_zero(); };
  const std::vector<NetPole>& poles = faces_.front().poles;
  return !std::all_of(poles.begin(), poles.end(), [&](const NetPole& pole) {
    return std::all_of(pole.direction.begin(), pole.direction.end(), is_zero);
  });
}

std::vector<BSplineSurface> SectionNet::normals() const {
  std::vector<BSplineSurface> result;
  for (const FaceNet& face : faces_) {
    BSplineSurface surface = face.frame;
    for (const NetPole& pole : face.poles) {
      surface.poles.push_back({pole.direction[0].midpoint(), pole.direction[1].midpoint(),
                               pole.direction[2].midpoint()});
      surface.weights.push_back(pole.weight.midpoint());
    }
    result.push_back(std::move(surface));
  }
  return result;
}

}  // namespace pn
