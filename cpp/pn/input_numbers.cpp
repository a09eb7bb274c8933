// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/input_numbers.hpp"

#include <cmath>
#include <sstream>

#include "pn/geometry_error.hpp"

namespace pn {

void require_input_number(double number, std::string_view name) {
  if (!std::isfinite(number)) {
    throw GeometryError(ErrorCode::kNotFinite, std::string(name) + " is not a finite number.");
  }
  const double size = std::abs(number);
  if (size == 0 || (kSmallestInputNumber <= size && size <= kLargestInputNumber)) return;
  std::ostringstream sentence;
  sentence << name << " is " << number << "; a number must be zero or of a size between "
           << kSmallestInputNumber << " and " << kLargestInputNumber << ".";
  throw GeometryError(ErrorCode::kOutOfRange, sentence.str());
}

}  // namespace pn
