// SPDX-License-Identifier: LGPL-2.1-or-later
// The precision loop: a construction in balls is a function of the precision, run at 104 bits, then
// at 128, 256, ... until everything it must decide is proved. A cap gives an error, not a wrong
// answer.
#pragma once

#include <string>

#include "pn/algebra/roots.hpp"
#include "pn/geometry_error.hpp"

namespace pn {

/// That of double words, which suffice for nearly all inputs: poles keep about 23 digits for data
/// of degree 6.
inline constexpr long kLeastPrecision = DoubleWordBall::kPrecision;
inline constexpr long kMostPrecision = 4096;

/// What is tried after so many bits: the two words of Arb's shortest numbers, then twice as many.
constexpr long next_precision(long bits) {
  constexpr long kTwoWords = 128;
  return bits < kTwoWords ? kTwoWords : 2 * bits;
}

/// construct(bits) at the first precision, from `bits` on, at which it does not throw Undecided.
template <class Construct>
auto at_sufficient_precision(Construct&& construct, long bits = kLeastPrecision) {
  for (;; bits = next_precision(bits)) {
    try {
      return construct(bits);
    } catch (const Undecided& undecided) {
      if (next_precision(bits) <= kMostPrecision) continue;
      throw GeometryError(ErrorCode::kPrecisionExhausted,
                          std::string("With ") + std::to_string(bits) +
                              " bits it could not be decided: " + undecided.what());
    }
  }
}

}  // namespace pn
