// SPDX-License-Identifier: LGPL-2.1-or-later
// Numbers of the input: zero, or of a size between 1e-100 and 1e+100.
//
// Exact arithmetic would carry through what lies beyond, but a resultant of degree n in numbers of
// size 2^e has entries of n e bits: for poles of 1e+308 the roots that a surface needs are not
// found while a designer waits. And the result must be doubles again. No drawing comes near these
// limits: the visible universe is 1e+30 millimetres wide.
#pragma once

#include <string_view>

namespace pn {

constexpr double kSmallestInputNumber = 1e-100;
constexpr double kLargestInputNumber = 1e+100;

/// Throws GeometryError: kNotFinite, or kOutOfRange for what is neither zero nor of such a size.
/// The sentence begins with the name, as in "A pole".
void require_input_number(double number, std::string_view name);

/// Of a list or an array.
template <class Numbers>
void require_input_numbers(const Numbers& numbers, std::string_view name) {
  for (const double number : numbers) require_input_number(number, name);
}

}  // namespace pn
