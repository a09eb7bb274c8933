// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/bezier/segment_faces.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "pn/algebra/ball_vector.hpp"
#include "pn/algebra/bernstein.hpp"
#include "pn/algebra/memo.hpp"
#include "pn/algebra/parallel.hpp"
#include "pn/algebra/roots.hpp"
#include "pn/bezier/knot_insertion.hpp"
#include "pn/geometry_error.hpp"

namespace pn {
namespace {

/// A row of control points takes about ten microseconds, as long as to wake another thread.
constexpr std::size_t kRowsPerTask = 32;

/// The rows of control points of one homogeneous component: for each Bernstein coefficient along
/// the coefficients in u.
using ComponentRows = std::vector<std::vector<RealBall>>;

/// The rows of a segment at a common degree.
struct SegmentRows {
  std::array<ComponentRows, 3> point, direction;
  ComponentRows weight;
};

int degree_of(const SectionSegment& segment) {
  return segment.sections.weight.coefficient.front().degree();
}

ComponentRows rows_of(const FormInU<RealBall>& form, int degree,
                      const BernsteinOfBalls& bernstein) {
  ComponentRows rows(static_cast<std::size_t>(degree) + 1);
  for (const Form<RealBall>& c : form.coefficient) {
    std::vector<RealBall> along = bernstein(c.elevated(degree).coefficients());
    for (std::size_t row = 0; row < rows.size(); ++row) rows[row].push_back(std::move(along[row]));
  }
  return rows;
}

SegmentRows rows_of(const SectionSegment& segment, int degree, long precision) {
  const BernsteinOfBalls bernstein(degree, precision);
  SegmentRows rows;
  for (std::size_t i = 0; i < 3; ++i) {
    rows.point[i] = rows_of(segment.sections.point[i], degree, bernstein);
    rows.direction[i] = rows_of(segment.sections.direction[i], degree, bernstein);
  }
  rows.weight = rows_of(segment.sections.weight, degree, bernstein);
  return rows;
}

using ColumnWeights = std::vector<RealBall>;

ColumnWeights in_balls(const std::vector<Rational>& column, long precision) {
  ColumnWeights weights;
  for (const Rational& x : column) weights.emplace_back(x, precision);
  return weights;
}

NetPole pole_of(const SegmentRows& rows, std::size_t row, const ColumnWeights& column) {
  NetPole pole;
  pole.weight = dot(rows.weight[row], column);
  const RealBall inverse = RealBall(1) / pole.weight;
  for (std::size_t i = 0; i < 3; ++i) {
    pole.point[i] = dot(rows.point[i][row], column) * inverse;
    pole.direction[i] = dot(rows.direction[i][row], column) * inverse;
  }
  return pole;
}

/// The doubles that divide a segment into equal spans.
std::vector<double> inner_knots(const SectionSegment& segment, int spans) {
  std::vector<double> knots;
  for (int i = 1; i < spans; ++i) {
    knots.push_back(segment.begin + (segment.end - segment.begin) * i / spans);
  }
  return knots;
}

/// A run of segments on one face along the spine: [first, last).
struct Run {
  std::size_t first, last;
  int degree;
};

std::vector<Run> smooth_runs(const std::vector<const SectionSegment*>& segments) {
  std::vector<Run> runs;
  for (std::size_t i = 0; i < segments.size(); ++i) {
    if (i == 0 || segments[i]->joint_before != Joint::kSmooth) runs.push_back({i, i, 0});
    runs.back().last = i + 1;
    runs.back().degree = std::max(runs.back().degree, degree_of(*segments[i]));
  }
  return runs;
}

/// Knots along a run: C1, so inner ones have multiplicity degree - 1.
BSplineSurface frame_of(const std::vector<const SectionSegment*>& segments, const Run& run,
                        int spans, const CircleColumns& circle) {
  BSplineSurface frame;
  frame.u_degree = run.degree;
  for (std::size_t i = run.first; i < run.last; ++i) {
    frame.u_knots.push_back(segments[i]->begin);
    frame.u_multiplicities.push_back(i == run.first ? run.degree + 1 : run.degree - 1);
    for (const double knot : inner_knots(*segments[i], spans)) {
      frame.u_knots.push_back(knot);
      frame.u_multiplicities.push_back(1);
    }
  }
  frame.u_knots.push_back(segments[run.last - 1]->end);
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

std::vector<RowPlace> control_rows(const Run& run, int spans) {
  const auto last = static_cast<std::size_t>(run.degree + spans - 1);
  std::vector<RowPlace> rows = {{run.first, 0}};
  for (std::size_t segment = run.first; segment < run.last; ++segment) {
    for (std::size_t row = 1; row < last; ++row) rows.push_back({segment, row});
  }
  rows.push_back({run.last - 1, last});
  return rows;
}

/// The rows over so many equal spans instead of one, with simple knots between them.
SegmentRows with_inner_knots(SegmentRows rows, const std::vector<Rational>& knots, long precision) {
  const auto refine = [&](ComponentRows& component) {
    const std::size_t count = component.size();
    SplineColumns<RealBall> spline{static_cast<int>(count) - 1, {}, std::move(component)};
    spline.knots.assign(count, Rational(0));
    spline.knots.resize(2 * count, Rational(1));
    for (const Rational& knot : knots) {
      spline = with_knot(spline, knot, [&](const Rational& x) { return RealBall(x, precision); });
    }
    component = std::move(spline.points);
  };
  for (std::size_t i = 0; i < 3; ++i) {
    refine(rows.point[i]);
    refine(rows.direction[i]);
  }
  refine(rows.weight);
  return rows;
}

/// The same in the segment's own parameter.
std::vector<Rational> own_parameters(const SectionSegment& segment,
                                     const std::vector<double>& knots) {
  const Rational begin = Rational::exactly(segment.begin), end = Rational::exactly(segment.end);
  std::vector<Rational> result;
  for (const double knot : knots) {
    result.push_back((Rational::exactly(knot) - begin) / (end - begin));
  }
  return result;
}

/// The segments of a chain, brought to one degree on every face, and their rows.
struct Rows {
  const std::vector<const SectionSegment*>& segments;
  std::vector<Run> runs;
  std::vector<SegmentRows> rows;
  int spans;  ///< of every segment along; more than one only where a segment is a face of its own
  long precision;
};

Rows rows_of_all(const std::vector<const SectionSegment*>& segments, int spans, long precision) {
  Rows strip{segments, {}, {}, spans, precision};
  strip.runs = smooth_runs(strip.segments);
  std::vector<int> degrees;
  for (const Run& run : strip.runs) degrees.resize(run.last, run.degree);
  strip.rows.resize(strip.segments.size());
  for_each_index(strip.rows.size(), [&](std::size_t i) {
    const auto knots = own_parameters(*segments[i], inner_knots(*segments[i], spans));
    strip.rows[i] =
        with_inner_knots(rows_of(*segments[i], degrees[i], precision), knots, precision);
  });
  return strip;
}

/// The columns of a face, and their weights in balls.
struct FaceColumns {
  CircleColumns circle;
  std::vector<ColumnWeights> weights;
};

SegmentFace face_net(const Rows& strip, const Run& run, const FaceColumns& columns, int arcs) {
  const CircleColumns& circle = columns.circle;
  const std::vector<ColumnWeights>& weights = columns.weights;
  SegmentFace face;
  face.frame = frame_of(strip.segments, run, strip.spans, circle);
  face.stands_still = strip.segments[run.first]->stands_still;
  face.place = {arcs, run.first, run.last};
  const std::vector<RowPlace> places = control_rows(run, strip.spans);
  const bool closed = circle.coefficients.front() == circle.coefficients.back();
  const std::size_t count = weights.size();
  face.poles.resize(places.size() * count);
  for_each_index_in_blocks(places.size(), kRowsPerTask, [&](std::size_t i) {
    NetPole* const row = &face.poles[i * count];
    for (std::size_t j = 0; j < count; ++j) {
      const bool repeats = closed && j + 1 == count;
      row[j] = repeats ? row[0] : pole_of(strip.rows[places[i].segment], places[i].row, weights[j]);
    }
  });
  return face;
}

bool has_bad_weights(const std::vector<SegmentFace>& run) {
  return std::any_of(run.begin(), run.end(), has_bad_weight);
}

/// Two end rows, one of which replaces the other: one circle, bit for bit.
std::vector<NetPole> exchanged(std::vector<NetPole>::iterator own,
                               std::vector<NetPole>::const_iterator shared, std::size_t count) {
  std::vector<NetPole> replaced(own, own + static_cast<std::ptrdiff_t>(count));
  std::copy(shared, shared + static_cast<std::ptrdiff_t>(count), own);
  return replaced;
}

/// Gives every run the last row of the one before where they meet, and the last run of a closed
/// chain the first row.
std::vector<SegmentFace> with_shared_rows(std::vector<std::vector<SegmentFace>> runs, bool closed,
                                          const std::vector<const SectionSegment*>& segments) {
  const auto last_row = [](SegmentFace& face) {
    return face.poles.end() - static_cast<std::ptrdiff_t>(face.frame.v_count());
  };
  for (std::size_t i = 1; i < runs.size(); ++i) {
    if (segments[runs[i].front().place.first_segment]->joint_before == Joint::kNone) continue;
    for (std::size_t j = 0; j < runs[i].size(); ++j) {
      SegmentFace& face = runs[i][j];
      face.replaced_first =
          exchanged(face.poles.begin(), last_row(runs[i - 1][j]), face.frame.v_count());
    }
  }
  if (closed) {
    for (std::size_t j = 0; j < runs.back().size(); ++j) {
      SegmentFace &first = runs.front()[j], &last = runs.back()[j];
      last.replaced_last = exchanged(last_row(last), first.poles.begin(), last.frame.v_count());
    }
  }
  std::vector<SegmentFace> faces;
  for (auto& run : runs) std::move(run.begin(), run.end(), std::back_inserter(faces));
  return faces;
}

/// What is tried until all weights are positive: into how many spans every arc around and every
/// segment along is cut.
struct FaceChoice {
  int factor, spans;
};

/// From few poles to many.
std::vector<FaceChoice> face_choices(SpansAlong along) {
  constexpr int kMostFactor = kMostArcs / kLeastArcs;
  std::vector<FaceChoice> choices;
  for (int factor = 1; factor <= kMostFactor; factor *= 2) {
    if (along == SpansAlong::kMany) {
      choices.insert(choices.end(), {{factor, factor}, {factor, 2 * factor}, {2 * factor, factor}});
    } else {
      choices.push_back({factor, 1});
    }
  }
  return choices;
}

/// The columns of the faces over a segment.
std::vector<CircleColumns> columns_of(Around around, Lines lines, int factor, int form_degree) {
  const auto part = [&](int first, int last) {
    return refined(circle_part(first, last, kLeastArcs, form_degree), factor);
  };
  switch (around) {
    case Around::kCircle:
      return circle_columns(lines, factor * kLeastArcs, form_degree);
    case Around::kHalves:
      return {part(0, kLeastArcs / 2), part(kLeastArcs / 2, kLeastArcs)};
    case Around::kUnequalParts:
      return {part(0, kArcsOfLargerPart), part(kArcsOfLargerPart, kLeastArcs)};
    case Around::kLargerPart:
      return {part(0, kArcsOfLargerPart)};
    case Around::kArc:
      return {straight_band(factor, form_degree)};
  }
  throw std::logic_error("a part of the circle without columns");
}

/// The same with their weights at a precision: constants of the method, found once.
const std::vector<FaceColumns>& face_columns(Around around, Lines lines, int factor,
                                             int form_degree, long precision) {
  static Memo<std::tuple<Around, Lines, int, int, long>, std::vector<FaceColumns>> known;
  return known({around, lines, factor, form_degree, precision}, [&] {
    std::vector<FaceColumns> faces;
    for (CircleColumns& circle : columns_of(around, lines, factor, form_degree)) {
      std::vector<ColumnWeights> weights;
      for (const auto& column : circle.coefficients) weights.push_back(in_balls(column, precision));
      faces.push_back({std::move(circle), std::move(weights)});
    }
    return faces;
  });
}

/// The arcs of the whole circle to which the second parameter of a face belongs; none for an arc.
int arcs_of(Around around, int factor) {
  if (around == Around::kArc) return 0;
  return around == Around::kCircle ? factor * kLeastArcs : kLeastArcs;
}

/// The faces run by run, side by side within a run.
std::vector<std::vector<SegmentFace>> face_nets(const Rows& strip, Lines lines, int factor,
                                                int form_degree) {
  std::vector<std::vector<SegmentFace>> faces(strip.runs.size());
  for_each_index(faces.size(), [&](std::size_t i) {
    const Run& run = strip.runs[i];
    const Around around = strip.segments[run.first]->around;
    const auto& columns = face_columns(around, lines, factor, form_degree, strip.precision);
    faces[i].resize(columns.size());
    for_each_index(columns.size(), [&](std::size_t j) {
      faces[i][j] = face_net(strip, run, columns[j], arcs_of(around, factor));
    });
  });
  return faces;
}

/// The circles of quadrics are taken whole, unlike those of canal surfaces, from a pole on.
bool has_poles(Around around) {
  return around == Around::kHalves || around == Around::kUnequalParts;
}

/// At a pole of the parametrization a row of control points is one point, and exported as one.
void gather_at_poles(FaceNet& face) {
  const auto gather = [&](std::size_t row) {
    const std::size_t columns = face.frame.v_count();
    NetPole* const poles = &face.poles[row * columns];
    for (std::size_t j = 1; j < columns; ++j) {
      poles[j].point = poles[0].point;
      poles[j].direction = poles[0].direction;
    }
  };
  if (face.frame.u_knots.front() == 0) gather(0);
  if (face.frame.u_knots.back() == 1) gather(face.frame.u_count() - 1);
}

}  // namespace

std::vector<SegmentFace> segment_faces(const SegmentChain& chain, Lines lines, long precision) {
  const auto& [segments, closed, along] = chain;
  const int form_degree = segments.front()->sections.weight.degree();
  for (const auto& [factor, spans] : face_choices(along)) {
    const Rows strip = rows_of_all(segments, spans, precision);
    auto faces = face_nets(strip, lines, factor, form_degree);
    if (std::any_of(faces.begin(), faces.end(), has_bad_weights)) continue;
    if (has_poles(segments.front()->around)) {
      for (auto& run : faces) std::for_each(run.begin(), run.end(), gather_at_poles);
    }
    return with_shared_rows(std::move(faces), closed, segments);
  }
  throw GeometryError(ErrorCode::kWeightsNotPositive,
                      "No patches with positive weights were found, not even with " +
                          std::to_string(kMostArcs) +
                          " arcs around; divide the input into smaller parts.");
}

}  // namespace pn
