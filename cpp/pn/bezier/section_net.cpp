// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/bezier/section_net.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "pn/algebra/bernstein.hpp"
#include "pn/algebra/parallel.hpp"
#include "pn/algebra/roots.hpp"
#include "pn/geometry_error.hpp"

namespace pn {
namespace {

/// The rows of a segment at a common degree: Bernstein coefficients of q00, q01, q11 in each row.
struct SegmentRows {
  std::array<std::array<std::vector<RealBall>, 3>, 7> component;  ///< [x y z, V1 V2 V3, w][q][row]
  bool has_no_negative_weight(const std::vector<CircleColumns>& circle, long precision) const;
};

int degree_of(const LinedSegment& segment) {
  return segment.curve.denominator.degree() + 2 * segment.spinor.degree[0];
}

SegmentRows rows_of(const LinedSegment& segment, int degree) {
  const HomogeneousSections<RealBall> forms =
      sections(segment.curve, isotropic_vector<RealBall>(segment.spinor));
  const auto bernstein = [&](const Form<RealBall>& form) {
    return to_bernstein(form.elevated(degree).coefficients());
  };
  SegmentRows rows;
  for (std::size_t q = 0; q < 3; ++q) {
    for (std::size_t i = 0; i < 3; ++i) {
      rows.component[i][q] = bernstein(forms.point[i].coefficient[q]);
      rows.component[3 + i][q] = bernstein(forms.direction[i].coefficient[q]);
    }
    rows.component[6][q] = bernstein(forms.weight.coefficient[q]);
  }
  return rows;
}

using ColumnWeights = std::array<RealBall, 3>;

ColumnWeights in_balls(const std::array<Rational, 3>& column, long precision) {
  return {RealBall(column[0], precision), RealBall(column[1], precision),
          RealBall(column[2], precision)};
}

RealBall value(const std::array<std::vector<RealBall>, 3>& component, std::size_t row,
               const ColumnWeights& column) {
  RealBall sum = component[0][row] * column[0];
  sum.add_product(component[1][row], column[1]);
  sum.add_product(component[2][row], column[2]);
  return sum;
}

NetPole pole_of(const SegmentRows& rows, std::size_t row, const ColumnWeights& column) {
  NetPole pole;
  pole.weight = value(rows.component[6], row, column);
  const RealBall inverse = RealBall(1) / pole.weight;
  for (std::size_t i = 0; i < 3; ++i) {
    pole.point[i] = value(rows.component[i], row, column) * inverse;
    pole.direction[i] = value(rows.component[3 + i], row, column) * inverse;
  }
  return pole;
}

bool SegmentRows::has_no_negative_weight(const std::vector<CircleColumns>& circle,
                                         long precision) const {
  for (const CircleColumns& columns : circle) {
    for (const auto& coefficients : columns.coefficients) {
      const ColumnWeights column = in_balls(coefficients, precision);
      for (std::size_t row = 0; row < component[6][0].size(); ++row) {
        if (value(component[6], row, column).is_negative()) return false;
      }
    }
  }
  return true;
}

/// A run of segments on one face along the spine: [first, last).
struct Run {
  std::size_t first, last;
  int degree;
};

std::vector<Run> smooth_runs(const std::vector<LinedSegment>& segments) {
  std::vector<Run> runs;
  for (std::size_t i = 0; i < segments.size(); ++i) {
    if (i == 0 || segments[i].joint_before != Joint::kSmooth) runs.push_back({i, i, 0});
    runs.back().last = i + 1;
    runs.back().degree = std::max(runs.back().degree, degree_of(segments[i]));
  }
  return runs;
}

/// Knots along a run: C1, so inner ones have multiplicity degree - 1.
BSplineSurface frame_of(const std::vector<LinedSegment>& segments, const Run& run,
                        const CircleColumns& circle) {
  BSplineSurface frame;
  frame.u_degree = run.degree;
  for (std::size_t i = run.first; i < run.last; ++i) {
    frame.u_knots.push_back(segments[i].begin);
    frame.u_multiplicities.push_back(i == run.first ? run.degree + 1 : run.degree - 1);
  }
  frame.u_knots.push_back(segments[run.last - 1].end);
  frame.u_multiplicities.push_back(run.degree + 1);
  frame.v_degree = circle.degree;
  frame.v_knots = circle.knots;
  frame.v_multiplicities = circle.multiplicities;
  return frame;
}

/// The control rows of a C1 spline from those of its Bezier pieces: the row at a joint is a mean of
/// its neighbours and is left out.
struct RowPlace {
  std::size_t segment, row;
};

std::vector<RowPlace> control_rows(const Run& run) {
  const auto degree = static_cast<std::size_t>(run.degree);
  std::vector<RowPlace> rows = {{run.first, 0}};
  for (std::size_t segment = run.first; segment < run.last; ++segment) {
    for (std::size_t row = 1; row < degree; ++row) rows.push_back({segment, row});
  }
  rows.push_back({run.last - 1, degree});
  return rows;
}

std::vector<ColumnWeights> column_weights(const CircleColumns& circle, long precision) {
  std::vector<ColumnWeights> columns;
  for (const auto& coefficients : circle.coefficients) {
    columns.push_back(in_balls(coefficients, precision));
  }
  return columns;
}

FaceNet face_net(const std::vector<LinedSegment>& segments, const std::vector<SegmentRows>& rows,
                 const Run& run, const CircleColumns& circle, long precision) {
  FaceNet face;
  face.frame = frame_of(segments, run, circle);
  face.stands_still = segments[run.first].stands_still;
  const std::vector<ColumnWeights> columns = column_weights(circle, precision);
  const std::vector<RowPlace> places = control_rows(run);
  const bool closed = circle.coefficients.front() == circle.coefficients.back();
  face.poles.resize(places.size() * columns.size());
  for (std::size_t i = 0; i < places.size(); ++i) {
    for (std::size_t j = 0; j < columns.size(); ++j) {
      NetPole& pole = face.poles[i * columns.size() + j];
      pole = closed && j + 1 == columns.size()
                 ? face.poles[i * columns.size()]
                 : pole_of(rows[places[i].segment], places[i].row, columns[j]);
      if (pole.weight.is_positive()) continue;
      if (!pole.weight.is_negative()) throw Undecided("the sign of a weight");
      throw GeometryError(ErrorCode::kWeightsNotPositive,
                          "No patch with positive weights was found between parameters " +
                              std::to_string(segments[run.first].begin) + " and " +
                              std::to_string(segments[run.last - 1].end) + ".");
    }
  }
  return face;
}

std::vector<NetPole> first_row(const FaceNet& face) {
  const auto count = static_cast<std::ptrdiff_t>(face.frame.v_count());
  return {face.poles.begin(), face.poles.begin() + count};
}

std::vector<NetPole> last_row(const FaceNet& face) {
  const auto count = static_cast<std::ptrdiff_t>(face.frame.v_count());
  return {face.poles.end() - count, face.poles.end()};
}

/// Gives a face the end row of the one before: one circle, bit for bit.
void share_row(const FaceNet& before, FaceNet* face) {
  face->replaced_first = first_row(*face);
  const std::vector<NetPole> shared = last_row(before);
  std::copy(shared.begin(), shared.end(), face->poles.begin());
}

/// The same for the circle where a closed chain comes back.
void close_row(const FaceNet& first, FaceNet* face) {
  face->replaced_last = last_row(*face);
  const std::vector<NetPole> shared = first_row(first);
  std::copy(shared.begin(), shared.end(),
            face->poles.end() - static_cast<std::ptrdiff_t>(shared.size()));
}

int arcs_with_positive_weights(const std::vector<SegmentRows>& rows, Lines lines, long precision) {
  for (int arcs = kLeastArcs; arcs < kMostArcs; arcs *= 2) {
    const auto circle = circle_columns(lines, arcs);
    if (std::all_of(rows.begin(), rows.end(), [&](const SegmentRows& segment) {
          return segment.has_no_negative_weight(circle, precision);
        })) {
      return arcs;
    }
  }
  return kMostArcs;
}

/// A coordinate this much smaller than the surface is zero on export: 2^-100 of its size.
constexpr int kNegligibleBits = 100;
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

RoundedFace rounded(const FaceNet& face, double exact_distance) {
  const RealBall distance(exact_distance);
  BSplineSurface surface = face.frame;
  std::vector<std::array<RealBall, 3>> poles;
  poles.reserve(face.poles.size());
  double size = 0;
  for (const NetPole& pole : face.poles) {
    poles.push_back(pole_at(pole, distance));
    for (const RealBall& x : poles.back()) size = std::max(size, std::abs(x.midpoint()));
  }
  surface.poles.reserve(poles.size());
  surface.weights.reserve(poles.size());
  double delta = 0;
  for (std::size_t i = 0; i < poles.size(); ++i) {
    Point p, error;
    for (std::size_t c = 0; c < 3; ++c) {
      p[c] = rounded_coordinate(poles[i][c], size);
      error[c] = std::max(unit_in_last_place(p[c]), std::ldexp(size, -kNegligibleBits));
    }
    surface.poles.push_back(p);
    surface.weights.push_back(rounded_weight(face.poles[i].weight));
    delta = std::max(delta, length(error));
  }
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
  const double diameter = active_diameter(surface) + 2 * delta;
  const double deviation = (delta + epsilon / (1 - epsilon) * diameter) * kRoundingOfBounds;
  return {std::move(surface), deviation};
}

}  // namespace

SectionNet::SectionNet(const EnvelopeChain& chain, Lines lines, long precision)
    : precision_(precision) {
  const std::vector<LinedSegment> segments = lined_segments(chain, lines, precision);
  const std::vector<Run> runs = smooth_runs(segments);
  for (const Run& run : runs) {
    if (run.degree <= kLargestDegree) continue;
    throw GeometryError(
        ErrorCode::kDegreeTooHigh,
        "The exact surface would have degree " + std::to_string(run.degree) +
            " along the spine between parameters " + std::to_string(segments[run.first].begin) +
            " and " + std::to_string(segments[run.last - 1].end) + "; CAD systems stop at " +
            std::to_string(kLargestDegree) + ". Lower the degree of spine and radius there.");
  }
  std::vector<int> degrees(segments.size());
  for (const Run& run : runs) {
    std::fill(degrees.begin() + static_cast<std::ptrdiff_t>(run.first),
              degrees.begin() + static_cast<std::ptrdiff_t>(run.last), run.degree);
  }
  std::vector<SegmentRows> rows(segments.size());
  for_each_index(rows.size(), [&](std::size_t i) { rows[i] = rows_of(segments[i], degrees[i]); });
  const std::vector<CircleColumns> circle =
      circle_columns(lines, arcs_with_positive_weights(rows, lines, precision));
  faces_.resize(runs.size() * circle.size());
  for_each_index(faces_.size(), [&](std::size_t i) {
    faces_[i] =
        face_net(segments, rows, runs[i / circle.size()], circle[i % circle.size()], precision);
  });
  for (std::size_t i = circle.size(); i < faces_.size(); ++i) {
    share_row(faces_[i - circle.size()], &faces_[i]);
  }
  if (!chain.closed) return;
  for (std::size_t i = 0; i < circle.size(); ++i) {
    close_row(faces_[i], &faces_[faces_.size() - circle.size() + i]);
  }
}

std::vector<RoundedFace> SectionNet::section(double distance) const {
  std::vector<RoundedFace> result(faces_.size());
  for_each_index(faces_.size(), [&](std::size_t i) { result[i] = rounded(faces_[i], distance); });
  return result;
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
