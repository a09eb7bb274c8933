// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/bezier/trimming.hpp"

#include <array>
#include <memory>

#include "pn/algebra/parallel.hpp"
#include "pn/bezier/band_trims.hpp"
#include "pn/bezier/region_trims.hpp"
#include "pn/bezier/ruling_band.hpp"

namespace pn {
namespace {

BandSides directrices_of(const std::vector<LinedSegment>& segments, bool closed) {
  std::array<std::vector<BandSide::Span>, 2> spans;
  for (auto& side : spans) side.resize(segments.size());
  for_each_index(segments.size(), [&](std::size_t i) {
    const LinedSegment& segment = segments[i];
    DirectrixForms<double> forms = directrix_forms(std::get<RulingForms<double>>(segment.carrier),
                                                   isotropic_vector<double>(segment.lines));
    for (std::size_t side = 0; side < 2; ++side) {
      spans[side][i] = {segment.begin, segment.end, [form = std::move(forms[side])](double t) {
                          return band_parameter(form, t);
                        }};
    }
  });
  return band_sides(std::move(spans), closed);
}

}  // namespace

std::vector<TrimmedFace> trimmed_faces(const EnvelopeChain& chain, const ChainNet& net) {
  if (std::holds_alternative<BoundedRegion>(chain.extent)) return region_faces(chain, net);
  std::vector<TrimmedFace> result(net.faces().size());
  for (std::size_t i = 0; i < result.size(); ++i) result[i].net_face = i;
  if (!std::holds_alternative<RulingBand>(chain.extent)) return result;
  const auto directrices = directrices_of(net.segments(), chain.closed);
  for_each_index(result.size(), [&](std::size_t i) {
    const ChainPlace& place = net.places()[i];
    result[i].loops = {band_loop(directrices, place.first_segment, place.last_segment)};
  });
  return result;
}

}  // namespace pn
