// SPDX-License-Identifier: LGPL-2.1-or-later
// What the OpenCASCADE layer promises of every input: a result, or one of its declared errors.
#pragma once

#include <stdexcept>

#include "pn/occt/occt_error.hpp"
#include "surface_or_error.hpp"

namespace pn::fuzz {

/// The work may also throw std::invalid_argument and OcctError.
template <class Work>
int expect_shape_or_error(const Work& work) {
  return expect_result_or_error([&] {
    try {
      work();
    } catch (const std::invalid_argument& error) {
      require(*error.what() != '\0', "An error has a sentence.");
    } catch (const OcctError& error) {
      require(*error.what() != '\0', "An error has a sentence.");
    }
  });
}

}  // namespace pn::fuzz
