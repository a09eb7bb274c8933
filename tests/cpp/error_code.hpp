// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <optional>

#include "pn/geometry_error.hpp"

namespace pn::test {

/// The code with which an action is refused; nothing when it is not.
template <class Action>
std::optional<ErrorCode> code_of(Action&& action) {
  try {
    action();
    return std::nullopt;
  } catch (const GeometryError& error) {
    return error.code();
  }
}

}  // namespace pn::test
