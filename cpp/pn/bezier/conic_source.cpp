// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/bezier/conic_source.hpp"

#include <algorithm>
#include <cstdio>
#include <memory>
#include <utility>

#include "pn/algebra/parallel.hpp"
#include "pn/algebra/rational_matrix.hpp"
#include "pn/bezier/segment_faces.hpp"
#include "pn/geometry_error.hpp"

namespace pn {
namespace {

using Polynomial = RationalPolynomial;

/// "at t = 0.5" or, of several spans, "at t = 0.5 of span 2".
std::string place(double t, std::size_t span, std::size_t count) {
  char text[64];
  if (count == 1) {
    std::snprintf(text, sizeof text, "at t = %.6g", t);
  } else {
    std::snprintf(text, sizeof text, "at t = %.6g of span %zu", t, span + 1);
  }
  return text;
}

void check_ellipses(const ConicPoints& conics, std::size_t span, std::size_t count) {
  const Polynomial ellipticity = conics.ellipticity();
  if (is_positive_on_unit_interval(ellipticity)) return;
  const bool at_start = ellipticity(Rational(0)).sign() <= 0;
  const double s = at_start ? 0 : roots_in_unit_interval(ellipticity).front().value.midpoint();
  throw GeometryError(ErrorCode::kRegionUnbounded,
                      "The conic " + place(conics.t_at(s), span, count) +
                          " is no ellipse: it has points at infinity.");
}

/// The planes that touch a conic, e^T D e = 0, at an end of its span: D by its ten entries.
std::vector<Rational> tangent_planes_at(const MovingConic& conic, int end) {
  const Matrix3<Polynomial> dual = adjugate(conic.conic);
  std::vector<Polynomial> entries;
  Polynomial common;
  for (std::size_t a = 0; a < 4; ++a) {
    for (std::size_t b = a; b < 4; ++b) {
      Polynomial sum;
      for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = 0; j < 3; ++j) {
          sum += conic.frame[a][i] * dual[i][j] * conic.frame[b][j];
        }
      }
      common = gcd(common, sum);
      entries.push_back(std::move(sum));
    }
  }
  std::vector<Rational> values;
  for (const Polynomial& entry : entries) {
    values.push_back(exact_quotient(entry, common)(Rational(long{end})));
  }
  return values;
}

std::size_t rank(const std::vector<Rational>& upper_triangle) {
  RationalMatrix matrix(4, std::vector<Rational>(4));
  auto entry = upper_triangle.begin();
  for (std::size_t a = 0; a < 4; ++a) {
    for (std::size_t b = a; b < 4; ++b) matrix[a][b] = matrix[b][a] = *entry++;
  }
  return row_echelon_form(matrix).size();
}

bool ends_where_begins(const ConicSpan& span, const ConicSpan& next) {
  const auto end = tangent_planes_at(span.conic, 1), begin = tangent_planes_at(next.conic, 0);
  return row_echelon_form({end, begin}).size() == 1 && rank(end) == 3;
}

void check_joints(const std::vector<ConicSpan>& spans) {
  for (std::size_t i = 0; i + 1 < spans.size(); ++i) {
    if (ends_where_begins(spans[i], spans[i + 1])) continue;
    throw GeometryError(ErrorCode::kGap,
                        "Span " + std::to_string(i + 2) +
                            " does not begin with the conic with which the one before ends, or "
                            "that conic is singular.");
  }
}

std::shared_ptr<const ConicPoints> points_of(const ConicSpan& span, std::size_t index,
                                             std::size_t count) {
  auto conics = std::make_shared<const ConicPoints>(span.conic);
  check_ellipses(*conics, index, count);
  if (conics->degree() > kLargestDegree) {
    throw GeometryError(
        ErrorCode::kDegreeTooHigh,
        "The surface has degree " + std::to_string(conics->degree()) + " along t; 25 is the most.");
  }
  return conics;
}

}  // namespace

ConicSource::ConicSource(const std::vector<ConicSpan>& spans, std::vector<std::string> notes)
    : notes_(std::move(notes)) {
  if (spans.empty()) throw GeometryError(ErrorCode::kWrongShape, "There is no conic.");
  chain_.spans.resize(spans.size());
  for_each_index(spans.size(),
                 [&](std::size_t i) { chain_.spans[i] = points_of(spans[i], i, spans.size()); });
  check_joints(spans);
  chain_.closed = ends_where_begins(spans.back(), spans.front());
}

std::array<int, 2> ConicSource::degree() const {
  int along = 0;
  for (const auto& span : chain_.spans) along = std::max(along, span->degree());
  return {along, 2};
}

TrimmableNet ConicSource::net(Lines lines, long precision) const {
  const std::vector<SectionSegment> segments = lined_segments(chain_, lines, precision);
  SegmentChain chain{{}, chain_.closed, SpansAlong::kOne};
  for (const SectionSegment& segment : segments) chain.segments.push_back(&segment);
  std::vector<FaceNet> faces;
  for (SegmentFace& face : segment_faces(chain, lines, precision)) faces.push_back(std::move(face));
  const std::size_t count = faces.size();
  return {std::make_shared<const SectionNet>(std::move(faces), precision), [count] {
            std::vector<TrimmedFace> whole;
            for (std::size_t i = 0; i < count; ++i) whole.push_back({i, {}});
            return whole;
          }};
}

}  // namespace pn
