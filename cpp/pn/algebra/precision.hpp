// SPDX-License-Identifier: LGPL-2.1-or-later
// The precision loop: a construction in balls is a function of the precision, run at 128 bits, then
// at 256, 512, ... until everything it must decide is proved. A cap gives an error, not a wrong
// answer.
#pragma once

#include <string>

#include "pn/algebra/roots.hpp"
#include "pn/geometry_error.hpp"

namespace pn {

/// Suffices for nearly all inputs: poles keep about 30 digits for data of degree 6.
inline constexpr long kLeastPrecision = 128;
inline constexpr long kMostPrecision = 4096;

/// construct(bits) at the first precision, from `bits` on, at which it does not throw Undecided.
template <class Construct>
auto at_sufficient_precision(Construct&& construct, long bits = kLeastPrecision) {
  for (;; bits *= 2) {
    try {
      return construct(bits);
    } catch (const Undecided& undecided) {
      if (2 * bits <= kMostPrecision) continue;
      throw GeometryError(ErrorCode::kPrecisionExhausted,
                          std::string("With ") + std::to_string(bits) +
                              " bits it could not be decided: " + undecided.what());
    }
  }
}

}  // namespace pn
