// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/algebra/parallel.hpp"

#include <algorithm>
#include <atomic>
#include <catch2/catch.hpp>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

/// An error that counts how many of it live, and the most that ever did.
class CountedError : public std::runtime_error {
 public:
  CountedError(std::atomic<int>& living, std::atomic<int>& most)
      : std::runtime_error("counted"), living_(living) {
    most = std::max<int>(most, ++living_);
  }
  CountedError(const CountedError& other) : std::runtime_error(other), living_(other.living_) {
    ++living_;
  }
  ~CountedError() override { --living_; }

 private:
  std::atomic<int>& living_;
};

}  // namespace

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

TEST_CASE("Of many errors few live at a time") {
  // Without memory the C++ runtime has room for some hundreds, and ends the process beyond it.
  std::atomic<int> living{0}, most{0};
  CHECK_THROWS_AS(pn::for_each_index(5000, [&](std::size_t) { throw CountedError(living, most); }),
                  CountedError);
  CHECK(living == 0);
  CHECK(most >= 1);
  CHECK(most <= 200);
}

TEST_CASE("Blocks leave no index out, and none twice") {
  for (const std::size_t count : {0u, 1u, 31u, 32u, 33u, 1000u}) {
    std::vector<int> visits(count, 0);
    pn::for_each_index_in_blocks(count, 32, [&](std::size_t i) { ++visits[i]; });
    CHECK(visits == std::vector<int>(count, 1));
  }
}
