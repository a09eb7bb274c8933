// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/bezier/section_net.hpp"

#include <algorithm>
#include <cmath>

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

/// A coordinate this much smaller than the surface is zero on export: 2^-60 of its size. That is
/// below the last place of the others, and where 104 bits leave those of an ellipsoid that vanish.
constexpr int kNegligibleBits = 60;
/// The arithmetic of the bounds below rounds by a few hundred units in the last place at most.
constexpr double kRoundingOfBounds = 1 + 1e-12;

/// A double for an exact number, and how far they are from each other at most.
struct RoundedNumber {
  double value, error;
};

RoundedNumber rounded_coordinate(const RealBall& x, double size) {
  if (const auto nearest = x.rounded()) return {*nearest, x.rounding_error()};
  const double magnitude = x.magnitude_upper();
  if (magnitude <= std::ldexp(size, -kNegligibleBits)) return {0, magnitude};
  throw Undecided("the last place of a pole");
}

RoundedNumber rounded_weight(const RealBall& x) {
  if (const auto nearest = x.rounded()) return {*nearest, x.rounding_error()};
  throw Undecided("the last place of a weight");
}

using Point = std::array<double, 3>;

double length(const Point& v) { return std::hypot(v[0], v[1], v[2]); }

std::array<RealBall, 3> pole_at(const NetPole& pole, const RealBall& distance) {
  return {pole.point[0] + distance * pole.direction[0],
          pole.point[1] + distance * pole.direction[1],
          pole.point[2] + distance * pole.direction[2]};
}

/// How far one pole lies from another, and by what part their weights differ.
struct Difference {
  double pole = 0, weight = 0;
  void include(const Difference& other) {
    pole = std::max(pole, other.pole);
    weight = std::max(weight, other.weight);
  }
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

/// The indices of the control points that are active on one span of such knots.
struct ActiveRange {
  std::size_t begin, end;
};

std::vector<ActiveRange> active_ranges(int degree, const std::vector<int>& multiplicities) {
  std::vector<ActiveRange> ranges;
  std::size_t end = 0;
  for (std::size_t span = 0; span + 1 < multiplicities.size(); ++span) {
    end += static_cast<std::size_t>(multiplicities[span]);
    ranges.push_back({end - static_cast<std::size_t>(degree) - 1, end});
  }
  return ranges;
}

/// The largest diagonal of the boxes around the poles that are active on one span of both knot
/// vectors.
double active_diameter(const BSplineSurface& surface) {
  const std::size_t columns = surface.v_count();
  const auto across = active_ranges(surface.v_degree, surface.v_multiplicities);
  double diameter = 0;
  for (const ActiveRange& u : active_ranges(surface.u_degree, surface.u_multiplicities)) {
    for (const ActiveRange& v : across) {
      Box box;
      for (std::size_t i = u.begin; i < u.end; ++i) {
        for (std::size_t j = v.begin; j < v.end; ++j) box.add(surface.poles[i * columns + j]);
      }
      diameter = std::max(diameter, box.diagonal());
    }
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

RoundedFace rounded(const FaceNet& face, double exact_distance) {
  const RealBall distance(exact_distance);
  BSplineSurface surface = face.frame;
  const std::size_t columns = surface.v_count(), rows = surface.u_count();
  const double size = estimated_size(face, exact_distance);
  surface.poles.resize(face.poles.size());
  surface.weights.resize(face.poles.size());
  std::vector<Difference> rounding(rows);
  for_each_index_in_blocks(rows, kRowsPerTask, [&](std::size_t row) {
    for (std::size_t i = row * columns; i < (row + 1) * columns; ++i) {
      const auto pole = pole_at(face.poles[i], distance);
      Point errors;
      for (std::size_t c = 0; c < 3; ++c) {
        const RoundedNumber coordinate = rounded_coordinate(pole[c], size);
        surface.poles[i][c] = coordinate.value;
        errors[c] = coordinate.error;
      }
      const RoundedNumber weight = rounded_weight(face.poles[i].weight);
      surface.weights[i] = weight.value;
      rounding[row].include({length(errors), weight.error / (weight.value - weight.error)});
    }
  });
  Difference rounded;
  for (const Difference& row : rounding) rounded.include(row);
  Difference largest;
  const auto compare = [&](const NetPole& own, const NetPole& shared) {
    largest.include(difference(own, shared, distance));
  };
  for (std::size_t j = 0; j < face.replaced_first.size(); ++j) {
    compare(face.replaced_first[j], face.poles[j]);
  }
  for (std::size_t j = 0; j < face.replaced_last.size(); ++j) {
    compare(face.replaced_last[j], face.poles[face.poles.size() - face.replaced_last.size() + j]);
  }
  const double delta = rounded.pole + largest.pole;
  const double epsilon = rounded.weight + 2 * largest.weight;
  // The theorem asks for eps < 1: rows whose weights differ by more do not make one edge.
  if (!(epsilon < 1)) {
    throw GeometryError(ErrorCode::kWeightsNotPositive,
                        "Neighbouring faces do not meet with the same weights; divide the input "
                        "into separate parts.");
  }
  const double diameter = active_diameter(surface) + 2 * delta;
  const double deviation = (delta + epsilon / (1 - epsilon) * diameter / 2) * kRoundingOfBounds;
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
