// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/bezier/trimming.hpp"

#include <algorithm>
#include <cmath>
#include <memory>

#include "pn/algebra/parallel.hpp"
#include "pn/bezier/evaluation.hpp"
#include "pn/bezier/region_trims.hpp"
#include "pn/bezier/ruling_band.hpp"

namespace pn {
namespace {

using Point = std::array<double, 2>;

/// In parameters that run over about a unit: two orders above what doubles resolve.
constexpr double kParameterTolerance = 2e-14;
/// Points of an edge at which its distance from the true boundary is measured.
constexpr int kSamples = 200;

/// One directrix of a band in the parameters of its segments.
class Directrix {
 public:
  Directrix(const EnvelopeChain& chain, const std::vector<LinedSegment>& segments,
            std::size_t which) {
    for (const LinedSegment& segment : segments) {
      spans_.push_back({segment.begin, segment.end,
                        directrix_forms(std::get<RulingForms<double>>(segment.carrier),
                                        isotropic_vector<double>(segment.lines))[which]});
    }
    for (const Span& span : spans_) joints_.push_back(band_parameter(span.form, 0));
    joints_.push_back(chain.closed ? joints_.front() : band_parameter(spans_.back().form, 1));
  }

  /// Where it crosses the start of a segment, and the end of one: computed once, so that neighbours
  /// share their corners.
  Point start(std::size_t i) const { return {spans_[i].begin, joints_[i]}; }
  Point end(std::size_t i) const { return {spans_[i].end, joints_[i + 1]}; }

  /// Along segment i.
  Point at(std::size_t i, double t) const {
    if (t == 0) return start(i);
    if (t == 1) return end(i);
    const Span& span = spans_[i];
    return {span.begin + t * (span.end - span.begin), band_parameter(span.form, t)};
  }

 private:
  struct Span {
    double begin, end;
    FormInU<double> form;
  };
  std::vector<Span> spans_;
  std::vector<double> joints_;
};

TrimEdge edge_along(const ParameterPath& path) {
  return {interpolated(path, kParameterTolerance), path};
}

TrimEdge side(const Point& start, const Point& end) { return {straight_line(start, end), {}}; }

/// The face between both directrices over the segments [first, last).
TrimEdgeLoop band_loop(const std::shared_ptr<const Directrix>& low,
                       const std::shared_ptr<const Directrix>& high, std::size_t first,
                       std::size_t last) {
  TrimEdgeLoop loop;
  for (std::size_t i = first; i < last; ++i) {
    loop.push_back(edge_along([low, i](double t) { return low->at(i, t); }));
  }
  loop.push_back(side(low->end(last - 1), high->end(last - 1)));
  for (std::size_t i = last; i-- > first;) {
    loop.push_back(edge_along([high, i](double t) { return high->at(i, 1 - t); }));
  }
  loop.push_back(side(high->start(first), low->start(first)));
  return loop;
}

}  // namespace

std::vector<TrimmedFace> trimmed_faces(const EnvelopeChain& chain, const SectionNet& net) {
  if (std::holds_alternative<BoundedRegion>(chain.extent)) return region_faces(chain, net);
  std::vector<TrimmedFace> result(net.faces().size());
  for (std::size_t i = 0; i < result.size(); ++i) result[i].net_face = i;
  if (!std::holds_alternative<RulingBand>(chain.extent)) return result;
  const auto low = std::make_shared<const Directrix>(chain, net.segments(), 0);
  const auto high = std::make_shared<const Directrix>(chain, net.segments(), 1);
  for_each_index(result.size(), [&](std::size_t i) {
    const FaceNet& face = net.faces()[i];
    result[i].loops = {band_loop(low, high, face.first_segment, face.last_segment)};
  });
  return result;
}

std::vector<TrimLoop> curves_of(const TrimmedFace& face) {
  std::vector<TrimLoop> loops;
  for (const TrimEdgeLoop& edges : face.loops) {
    loops.emplace_back();
    for (const TrimEdge& edge : edges) loops.back().push_back(edge.curve);
  }
  return loops;
}

double trim_deviation(const BSplineSurface& section, const TrimmedFace& face) {
  double largest = 0;
  for (const TrimEdgeLoop& loop : face.loops) {
    for (const TrimEdge& edge : loop) {
      if (!edge.path) continue;
      for (int i = 0; i <= kSamples; ++i) {
        const double at = static_cast<double>(i) / kSamples;
        const Point exact = edge.path(at), near = evaluate(edge.curve, at);
        const auto a = evaluate(section, exact[0], exact[1]);
        const auto b = evaluate(section, near[0], near[1]);
        largest = std::max(largest, std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]));
      }
    }
  }
  return largest;
}

}  // namespace pn
