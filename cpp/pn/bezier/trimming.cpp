// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/bezier/trimming.hpp"

#include <array>
#include <memory>

#include "pn/algebra/parallel.hpp"
#include "pn/bezier/region_trims.hpp"
#include "pn/bezier/ruling_band.hpp"

namespace pn {
namespace {

using Point = std::array<double, 2>;

/// In parameters that run over about a unit: a little above what doubles resolve.
constexpr double kParameterTolerance = 1e-13;

/// One directrix of a band in the parameters of its segments.
class Directrix {
 public:
  struct Span {
    double begin, end;
    FormInU<double> form;
  };

  Directrix(std::vector<Span> spans, bool closed) : spans_(std::move(spans)) {
    for (const Span& span : spans_) joints_.push_back(band_parameter(span.form, 0));
    joints_.push_back(closed ? joints_.front() : band_parameter(spans_.back().form, 1));
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
  std::vector<Span> spans_;
  std::vector<double> joints_;
};

using Directrices = std::array<std::shared_ptr<const Directrix>, 2>;

Directrices directrices_of(const std::vector<LinedSegment>& segments, bool closed) {
  std::array<std::vector<Directrix::Span>, 2> spans;
  for (auto& side : spans) side.resize(segments.size());
  for_each_index(segments.size(), [&](std::size_t i) {
    const LinedSegment& segment = segments[i];
    DirectrixForms<double> forms = directrix_forms(std::get<RulingForms<double>>(segment.carrier),
                                                   isotropic_vector<double>(segment.lines));
    for (std::size_t side = 0; side < 2; ++side) {
      spans[side][i] = {segment.begin, segment.end, std::move(forms[side])};
    }
  });
  return {std::make_shared<const Directrix>(std::move(spans[0]), closed),
          std::make_shared<const Directrix>(std::move(spans[1]), closed)};
}

/// The face between both directrices over the segments [first, last): along the first one, back
/// along the second.
TrimEdgeLoop band_loop(const Directrices& directrices, std::size_t first, std::size_t last) {
  const auto& [low, high] = directrices;
  const std::size_t count = last - first;
  TrimEdgeLoop loop(2 * count + 2);
  for_each_index(count, [&, low = low, high = high](std::size_t k) {
    const std::size_t i = first + k;
    loop[k] = edge_along([low, i](double t) { return low->at(i, t); }, kParameterTolerance);
    loop[2 * count - k] =
        edge_along([high, i](double t) { return high->at(i, 1 - t); }, kParameterTolerance);
  });
  loop[count] = straight_edge(low->end(last - 1), high->end(last - 1));
  loop[2 * count + 1] = straight_edge(high->start(first), low->start(first));
  return loop;
}

}  // namespace

std::vector<TrimmedFace> trimmed_faces(const EnvelopeChain& chain, const ChainNet& net) {
  if (std::holds_alternative<BoundedRegion>(chain.extent)) return region_faces(chain, net);
  std::vector<TrimmedFace> result(net.faces().size());
  for (std::size_t i = 0; i < result.size(); ++i) result[i].net_face = i;
  if (!std::holds_alternative<RulingBand>(chain.extent)) return result;
  const Directrices directrices = directrices_of(net.segments(), chain.closed);
  for_each_index(result.size(), [&](std::size_t i) {
    const ChainPlace& place = net.places()[i];
    result[i].loops = {band_loop(directrices, place.first_segment, place.last_segment)};
  });
  return result;
}

}  // namespace pn
