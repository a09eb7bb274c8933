// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/bezier/chain_source.hpp"

#include <algorithm>

#include "pn/bezier/chain_net.hpp"
#include "pn/bezier/trimming.hpp"

namespace pn {

ChainSource::ChainSource(EnvelopeChain chain)
    : chain_(std::make_shared<const EnvelopeChain>(std::move(chain))) {}

std::array<int, 2> ChainSource::degree() const {
  std::array<int, 2> degree = {0, 0};
  for (const ChainLink& link : chain_->links) {
    degree[0] = std::max(degree[0], link.envelope.degree());
    degree[1] = std::max(degree[1], link.envelope.degree_around());
  }
  return degree;
}

TrimmableNet ChainSource::net(Lines lines, long precision) const {
  const auto net = std::make_shared<const ChainNet>(*chain_, lines, precision);
  return {net, [chain = chain_, net] { return trimmed_faces(*chain, *net); }};
}

OffsetRange ChainSource::regular_range() const {
  return pn::regular_range(*chain_, default_tolerance(*chain_));
}

bool ChainSource::is_exact() const { return chain_->exact; }

std::vector<std::string> ChainSource::notes() const { return chain_->notes; }

}  // namespace pn
