// SPDX-License-Identifier: LGPL-2.1-or-later
// Where a polynomial is negative on [0, 1]: decided exactly, shown rounded.
#pragma once

#include <optional>
#include <vector>

#include "pn/algebra/roots.hpp"

namespace pn {

struct NegativeInterval {
  double begin, end;
};

/// The first interval in [0, 1] between roots of p where p is negative; `roots` are all those of p
/// in [0, 1].
std::optional<NegativeInterval> first_negative_interval(const RationalPolynomial& p,
                                                        const std::vector<RealRoot>& roots);

}  // namespace pn
