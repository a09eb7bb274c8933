// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/algebra/memo.hpp"

#include <atomic>
#include <catch2/catch.hpp>
#include <stdexcept>
#include <vector>

#include "pn/algebra/parallel.hpp"

using pn::Memo;

TEST_CASE("A memo finds every value once, in whatever thread", "[memo]") {
  Memo<int, int> squares;
  std::atomic<int> computed = 0;
  std::vector<int> found(1000);
  pn::for_each_index(found.size(), [&](std::size_t i) {
    const int x = static_cast<int>(i % 10);
    found[i] = squares(x, [&] {
      ++computed;
      return x * x;
    });
  });
  for (std::size_t i = 0; i < found.size(); ++i) {
    CHECK(found[i] == static_cast<int>((i % 10) * (i % 10)));
  }
  CHECK(computed == 10);
}

TEST_CASE("A value that could not be found is asked for again", "[memo]") {
  Memo<int, int> memo;
  CHECK_THROWS_AS(memo(1, []() -> int { throw std::domain_error("none"); }), std::domain_error);
  CHECK(memo(1, [] { return 2; }) == 2);
  CHECK(memo(1, []() -> int { throw std::domain_error("none"); }) == 2);
}
