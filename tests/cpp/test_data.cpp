// SPDX-License-Identifier: LGPL-2.1-or-later
#include "test_data.hpp"

#include <fstream>
#include <stdexcept>

namespace pn::test {

nlohmann::json test_data(const std::string& file_name) {
  std::ifstream file(PN_TEST_DATA "/" + file_name);
  if (!file) throw std::runtime_error("There is no file of test data named " + file_name + ".");
  return nlohmann::json::parse(file);
}

}  // namespace pn::test
