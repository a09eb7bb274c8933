// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/bezier/conic_source.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <memory>
#include <optional>
#include <utility>

#include "pn/algebra/parallel.hpp"
#include "pn/algebra/rational_matrix.hpp"
#include "pn/bezier/band_trims.hpp"
#include "pn/bezier/segment_faces.hpp"
#include "pn/conics/quadratic_cones.hpp"
#include "pn/geometry_error.hpp"

namespace pn {
namespace {

using Polynomial = RationalPolynomial;

/// Conics that differ by less than this part of their size meet but for the rounding of the numbers
/// that they were made of. What is closed so is counted in the deviation.
constexpr double kRounding = 1e-12;

std::string place(const ConicPoints& conics, double s) {
  char text[32];
  std::snprintf(text, sizeof text, "at t = %.6g", conics.t_at(s));
  return text;
}

/// Where a polynomial is not positive on [0, 1], first of all: at the start or at a root.
std::optional<double> first_not_positive(const Polynomial& p) {
  if (is_positive_on_unit_interval(p)) return std::nullopt;
  if (p(Rational(0)).sign() <= 0) return 0;
  const std::vector<RealRoot> roots = roots_in_unit_interval(p);
  return std::min_element(roots.begin(), roots.end(),
                          [](const RealRoot& a, const RealRoot& b) {
                            return a.value.midpoint() < b.value.midpoint();
                          })
      ->value.midpoint();
}

void check_ellipses(const ConicPoints& conics) {
  if (const auto s = first_not_positive(conics.invariants().infinity)) {
    throw GeometryError(ErrorCode::kRegionUnbounded,
                        "The conic " + place(conics, *s) +
                            " is no ellipse: it has points at infinity, and no cut takes a finite "
                            "part of it.");
  }
}

/// Finite parts, by conic_points.hpp.
void check_arcs(const ConicPoints& conics) {
  const auto [infinity, mixed, cut] = conics.invariants();
  if (const auto s = first_not_positive(-cut)) {
    throw GeometryError(
        ErrorCode::kRegionEmpty,
        "The line that cuts the conic " + place(conics, *s) + " does not meet it in two points.");
  }
  const auto refuse = [&](double s) {
    throw GeometryError(ErrorCode::kRegionUnbounded,
                        "The part of the conic " + place(conics, s) +
                            " on the positive side of the line that cuts it is no finite arc.");
  };
  // From here on [c, w] is not zero where [w, w] is not positive, so it keeps its sign there.
  if (const auto s = first_not_positive(mixed * mixed - infinity * cut)) refuse(*s);
  if (infinity(Rational(0)).sign() <= 0 && mixed(Rational(0)).sign() >= 0) refuse(0);
  const auto bad = infinity.is_zero() ? std::vector<RealRoot>{}
                                      : roots_in_unit_interval_without_positive(infinity, -mixed);
  if (!bad.empty()) refuse(bad.front().value.midpoint());
}

std::array<Vector4OfPolynomials, 3> points_of_frame(const MovingConic& conic) {
  std::array<Vector4OfPolynomials, 3> points;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t c = 0; c < 4; ++c) points[i][c] = conic.frame[c][i];
  }
  return points;
}

/// The planes (e1, e2, e3, e4) of the conics.
Vector4OfPolynomials planes(const MovingConic& conic) {
  const auto [a, b, c] = points_of_frame(conic);
  return join(a, b, c);
}

/// With a frame that spans a plane at every t, also those that are not real: points of the conics
/// that have poles in a flat frame may be of lower degree. With a cut, where it must, in [0, 1].
ConicSpan with_regular_frame(const ConicSpan& span) {
  Polynomial common;
  for (const Polynomial& p : planes(span.conic)) common = gcd(common, p);
  if (common.is_zero()) {
    throw GeometryError(ErrorCode::kSingularConics,
                        "The three points that span the plane are on one line for all t.");
  }
  if (common.degree() < 1) return span;
  if (!span.cut) return {conic_of_tangent_planes(tangent_planes_of(span.conic).matrix), {}};
  const std::vector<RealRoot> roots = roots_in_unit_interval(common);
  if (roots.empty()) return span;
  char text[32];
  std::snprintf(text, sizeof text, "%.6g", roots.front().value.midpoint());
  throw GeometryError(ErrorCode::kSingularConics,
                      std::string("The three points that span the plane are on one line at t = ") +
                          text + "; with a cut they may not be.");
}

/// The conic at t, its entries constant.
MovingConic conic_at(const MovingConic& conic, const Rational& t) {
  MovingConic result = conic;
  for (auto& row : result.frame) {
    for (Polynomial& entry : row) entry = entry(t);
  }
  for (auto& row : result.conic) {
    for (Polynomial& entry : row) entry = entry(t);
  }
  return result;
}

RationalMatrix values_at(const Matrix4OfPolynomials& matrix, const Rational& t) {
  RationalMatrix values;
  for (const Vector4OfPolynomials& row : matrix) {
    values.emplace_back();
    for (const Polynomial& entry : row) values.back().push_back(entry(t));
  }
  return values;
}

/// Of the conic at t alone, whose numbers are short; by continuity where it is not regular.
RationalMatrix tangent_planes_at(const ConicSpan& span, long end) {
  const Rational t(end);
  const MovingConic here = conic_at(span.conic, t);
  const RationalMatrix values =
      values_at(congruent(adjugate(here.conic), points_of_frame(here)), t);
  if (row_echelon_form(values).size() == 3) return values;
  return values_at(tangent_planes_of(span.conic).matrix, t);
}

/// Divided by the largest magnitude of an entry.
Eigen::MatrixXd in_doubles(const RationalMatrix& rows) {
  const auto magnitude = [](const Rational& x) { return x.sign() < 0 ? -x : x; };
  Rational largest;
  for (const auto& row : rows) {
    for (const Rational& entry : row) largest = std::max(largest, magnitude(entry));
  }
  Eigen::MatrixXd result(rows.size(), rows.front().size());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    for (std::size_t j = 0; j < rows[i].size(); ++j) {
      result(i, j) = (rows[i][j] / largest).to_double();
    }
  }
  return result;
}

/// About as long as the coordinates of the points of a conic: of its tangent planes the entries
/// D_ij are squares of lengths, D_i4 are lengths, and D44 is a number, 0 for a parabola.
double size_of(const Eigen::Matrix4d& d) {
  const double squares = d.topLeftCorner<3, 3>().cwiseAbs().maxCoeff();
  const double lengths = d.topRightCorner<3, 1>().cwiseAbs().maxCoeff();
  return squares / std::max(lengths, std::sqrt(squares * std::abs(d(3, 3))));
}

/// Whether they are the same up to a positive factor and the rounding of a designer's numbers.
bool are_alike(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b) {
  return (a.normalized() - b.normalized()).norm() <= kRounding;
}

/// The pole of the cut at an end of a span, with the sign of its positive side.
std::vector<Rational> pole_at(const ConicSpan& span, int end) {
  const Matrix3<Polynomial> dual = adjugate(span.conic.conic);
  const Rational t(long{end});
  std::vector<Rational> pole;
  for (const Vector3<Polynomial>& row : span.conic.frame) {
    Rational sum;
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < 3; ++j) sum += row[i](t) * dual[i][j](t) * (*span.cut)[j](t);
    }
    pole.push_back(sum);
  }
  return pole;
}

bool ends_where_begins(const ConicSpan& span, const ConicSpan& next) {
  const RationalMatrix end = tangent_planes_at(span, 1), begin = tangent_planes_at(next, 0);
  if (row_echelon_form(end).size() != 3 || row_echelon_form(begin).size() != 3) return false;
  const Eigen::Matrix4d a = in_doubles(end), b = in_doubles(begin);
  const double inverse_size = 1 / size_of(a);
  const Eigen::DiagonalMatrix<double, 4> unit(inverse_size, inverse_size, inverse_size, 1);
  const Eigen::Matrix4d left = unit * a * unit, right = unit * b * unit;
  if (!are_alike(left, right) && !are_alike(left, -right)) return false;
  return !span.cut ||
         are_alike(in_doubles({pole_at(span, 1)}) * unit, in_doubles({pole_at(next, 0)}) * unit);
}

void check_joints(const std::vector<ConicSpan>& spans) {
  for (std::size_t i = 0; i + 1 < spans.size(); ++i) {
    if (spans[i].cut.has_value() != spans[i + 1].cut.has_value()) {
      throw GeometryError(ErrorCode::kWrongShape,
                          "Some spans have a cut and some have none; all need one, or none.");
    }
    if (ends_where_begins(spans[i], spans[i + 1])) continue;
    throw GeometryError(ErrorCode::kGap,
                        "Span " + std::to_string(i + 2) +
                            " does not begin with the conic with which the one before ends, or "
                            "that conic is singular.");
  }
}

std::shared_ptr<const ConicPoints> points_of(const ConicSpan& span) {
  auto conics = std::make_shared<const ConicPoints>(with_regular_frame(span));
  if (span.cut) {
    check_arcs(*conics);
  } else {
    check_ellipses(*conics);
  }
  if (conics->degree() > kLargestDegree) {
    throw GeometryError(
        ErrorCode::kDegreeTooHigh,
        "The surface has degree " + std::to_string(conics->degree()) + " along t; 25 is the most.");
  }
  return conics;
}

/// The same of one span among others, which a refusal names.
std::shared_ptr<const ConicPoints> points_of(const std::vector<ConicSpan>& spans,
                                             std::size_t index) {
  try {
    return points_of(spans[index]);
  } catch (const GeometryError& error) {
    if (spans.size() == 1) throw;
    throw GeometryError(error.code(), "Span " + std::to_string(index + 1) + ": " + error.what());
  }
}

/// The dimension of the space that the planes of all conics span.
std::size_t rank_of_planes(const std::vector<ConicSpan>& spans) {
  RationalMatrix rows;
  for (const ConicSpan& span : spans) {
    const Vector4OfPolynomials plane = planes(span.conic);
    int degree = 0;
    for (const Polynomial& p : plane) degree = std::max(degree, p.degree());
    for (int k = 0; k <= degree; ++k) {
      rows.emplace_back();
      for (const Polynomial& p : plane) rows.back().push_back(p.coefficient(k));
    }
  }
  return row_echelon_form(rows).size();
}

/// Where an arc begins and ends in its band, by the form of its cut: the zeros s of a (1 - s)^2 + 2
/// b s (1 - s) + c s^2, for b > 0 and a, c <= 0.
double low_end(const FormInU<double>& cut, double t) {
  const double a = cut.coefficient[0](t), b = cut.coefficient[1](t), c = cut.coefficient[2](t);
  const double sum = b + std::sqrt(b * b - a * c);
  return -a / (sum - a);
}

double high_end(const FormInU<double>& cut, double t) {
  const double a = cut.coefficient[0](t), b = cut.coefficient[1](t), c = cut.coefficient[2](t);
  const double sum = b + std::sqrt(b * b - a * c);
  return sum / (sum - c);
}

BandSides ends_of_arcs(const std::vector<ConicSegment>& segments, bool closed) {
  std::array<std::vector<BandSide::Span>, 2> spans;
  for (const ConicSegment& segment : segments) {
    spans[0].push_back(
        {segment.begin, segment.end, [cut = segment.cut](double t) { return low_end(cut, t); }});
    spans[1].push_back(
        {segment.begin, segment.end, [cut = segment.cut](double t) { return high_end(cut, t); }});
  }
  return band_sides(std::move(spans), closed);
}

}  // namespace

ConicSource::ConicSource(const std::vector<ConicSpan>& spans, std::vector<std::string> notes)
    : notes_(std::move(notes)) {
  if (spans.empty()) throw GeometryError(ErrorCode::kWrongShape, "There is no conic.");
  chain_.spans.resize(spans.size());
  for_each_index(spans.size(), [&](std::size_t i) { chain_.spans[i] = points_of(spans, i); });
  check_joints(spans);
  chain_.closed = ends_where_begins(spans.back(), spans.front());
  if (rank_of_planes(spans) == 1) {
    notes_.push_back(
        "All conics lie in one plane: the surface is a part of it, with folds where the "
        "conics have an envelope.");
  }
}

std::array<int, 2> ConicSource::degree() const {
  int along = 0;
  for (const auto& span : chain_.spans) along = std::max(along, span->degree());
  return {along, 2};
}

TrimmableNet ConicSource::net(Lines lines, long precision) const {
  const std::vector<ConicSegment> segments = lined_segments(chain_, lines, precision);
  SegmentChain chain{{}, chain_.closed, SpansAlong::kOne};
  for (const ConicSegment& segment : segments) chain.segments.push_back(&segment);
  std::vector<FaceNet> faces;
  std::vector<ChainPlace> places;
  for (SegmentFace& face : segment_faces(chain, lines, precision)) {
    places.push_back(face.place);
    faces.push_back(std::move(face));
  }
  const bool is_trimmed = !segments.front().cut.coefficient.empty();
  const auto ends = is_trimmed ? ends_of_arcs(segments, chain_.closed) : BandSides{};
  return {std::make_shared<const SectionNet>(std::move(faces), precision), [places, ends] {
            std::vector<TrimmedFace> trimmed(places.size());
            for_each_index(trimmed.size(), [&](std::size_t i) {
              trimmed[i].net_face = i;
              if (!ends) return;
              trimmed[i].loops = {band_loop(ends, places[i].first_segment, places[i].last_segment)};
            });
            return trimmed;
          }};
}

}  // namespace pn
