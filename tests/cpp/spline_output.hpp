// SPDX-License-Identifier: LGPL-2.1-or-later
// How tests show a B-spline: as the braces that make it.
#pragma once

#include <ostream>

#include "pn/shapes/curve.hpp"

namespace pn::test {

template <std::size_t Dimension>
std::ostream& operator<<(std::ostream& out, const BSplineData<Dimension>& data) {
  const auto list = [&](const auto& values) {
    out << "{";
    for (const auto& value : values) out << value << ", ";
    out << "}";
  };
  out << "{" << data.degree << ", ";
  list(data.knots);
  out << ", ";
  list(data.multiplicities);
  out << ", {";
  for (const auto& pole : data.poles) {
    list(pole);
    out << ", ";
  }
  out << "}, ";
  list(data.weights);
  return out << "}";
}

}  // namespace pn::test
