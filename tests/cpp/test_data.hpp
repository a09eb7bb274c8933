// SPDX-License-Identifier: LGPL-2.1-or-later
// What tests read of the folder data.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace pn::test {

/// The content of a JSON file of that name. Throws std::runtime_error where there is none.
nlohmann::json test_data(const std::string& file_name);

}  // namespace pn::test
