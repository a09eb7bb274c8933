// SPDX-License-Identifier: LGPL-2.1-or-later
// Chain source: a chain of envelopes as a source of sections.
#pragma once

#include "pn/bezier/section_source.hpp"
#include "pn/isotropic/envelope_chain.hpp"

namespace pn {

class ChainSource : public SectionSource {
 public:
  explicit ChainSource(EnvelopeChain chain);

  std::array<int, 2> degree() const override;
  TrimmableNet net(Lines lines, long precision) const override;
  OffsetRange regular_range() const override;
  bool is_exact() const override;
  std::vector<std::string> notes() const override;

 private:
  std::shared_ptr<const EnvelopeChain> chain_;  ///< shared with the nets, which may outlive this
};

}  // namespace pn
