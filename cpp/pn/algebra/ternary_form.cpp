// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/algebra/ternary_form.hpp"

#include <algorithm>

namespace pn {

bool has_positive_coefficients(const TernaryForm<Rational>& form) {
  const auto& c = form.coefficients();
  return std::all_of(c.begin(), c.end(), [](const Rational& x) { return x.sign() > 0; });
}

}  // namespace pn
