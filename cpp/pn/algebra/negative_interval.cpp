// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/algebra/negative_interval.hpp"

#include <algorithm>

namespace pn {

std::optional<NegativeInterval> first_negative_interval(const RationalPolynomial& p,
                                                        const std::vector<RealRoot>& roots) {
  std::vector<double> cuts = {0};
  for (const RealRoot& root : roots) cuts.push_back(root.value.midpoint());
  cuts.push_back(1);
  std::sort(cuts.begin(), cuts.end());
  for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
    if (cuts[i] == cuts[i + 1]) continue;
    if (p(Rational::exactly((cuts[i] + cuts[i + 1]) / 2)).sign() < 0) {
      return NegativeInterval{cuts[i], cuts[i + 1]};
    }
  }
  return std::nullopt;
}

}  // namespace pn
