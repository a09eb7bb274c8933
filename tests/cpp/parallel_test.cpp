// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/algebra/parallel.hpp"

#include <catch2/catch.hpp>
#include <stdexcept>
#include <string>
#include <vector>

TEST_CASE("Every index is worked on exactly once") {
  for (const std::size_t count : {0u, 1u, 2u, 1000u}) {
    std::vector<int> visits(count, 0);
    pn::for_each_index(count, [&](std::size_t i) { ++visits[i]; });
    CHECK(visits == std::vector<int>(count, 1));
  }
}

TEST_CASE("The error of the least index is thrown, whatever the threads did first") {
  for (int repetition = 0; repetition < 50; ++repetition) {
    try {
      pn::for_each_index(200, [](std::size_t i) {
        if (i % 7 == 3) throw std::runtime_error(std::to_string(i));
      });
      FAIL("no error was thrown");
    } catch (const std::runtime_error& error) {
      CHECK(error.what() == std::string("3"));
    }
  }
}

TEST_CASE("Blocks leave no index out, and none twice") {
  for (const std::size_t count : {0u, 1u, 31u, 32u, 33u, 1000u}) {
    std::vector<int> visits(count, 0);
    pn::for_each_index_in_blocks(count, 32, [&](std::size_t i) { ++visits[i]; });
    CHECK(visits == std::vector<int>(count, 1));
  }
}
