// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/algebra/cancellation.hpp"

#include <atomic>
#include <catch2/catch.hpp>
#include <stdexcept>
#include <thread>
#include <vector>

#include "pn/algebra/parallel.hpp"

using namespace pn;

TEST_CASE("Work that nobody stops is done", "[cancellation]") {
  Cancellation cancellation;
  std::vector<int> visits(100, 0);
  cancellation.run([&] { for_each_index(visits.size(), [&](std::size_t i) { ++visits[i]; }); });
  CHECK(visits == std::vector<int>(100, 1));
  CHECK_FALSE(cancellation.is_requested());
}

TEST_CASE("Its own errors pass through", "[cancellation]") {
  Cancellation cancellation;
  const auto fail = [] { throw std::runtime_error("no"); };
  CHECK_THROWS_AS(cancellation.run(fail), std::runtime_error);
  CHECK_FALSE(cancellation.is_requested());
}

TEST_CASE("A request before the work stops it at the first loop", "[cancellation]") {
  Cancellation cancellation;
  cancellation.request();
  bool worked = false;
  const auto work = [&] { for_each_index(3, [&](std::size_t) { worked = true; }); };
  CHECK_THROWS_AS(cancellation.run(work), Cancelled);
  CHECK_FALSE(worked);
}

TEST_CASE("Endless work stops on a request, also in nested loops", "[cancellation]") {
  for (const std::size_t count : {1u, 2u, 50u}) {
    Cancellation cancellation;
    std::atomic<int> rounds = 0;
    std::thread other([&] {
      while (rounds < 10) std::this_thread::yield();
      cancellation.request();
    });
    const auto endless = [&] {
      for (;;) {
        for_each_index(count,
                       [&](std::size_t) { for_each_index(2, [&](std::size_t) { ++rounds; }); });
      }
    };
    CHECK_THROWS_AS(cancellation.run(endless), Cancelled);
    other.join();
  }
}

TEST_CASE("A request stops only its own work", "[cancellation]") {
  Cancellation stopped, other;
  int visits = 0;
  const auto inner = [&] { for_each_index(1, [&](std::size_t) { ++visits; }); };
  stopped.request();
  other.run([&] {
    CHECK_THROWS_AS(stopped.run(inner), Cancelled);
    inner();
  });
  CHECK(visits == 1);
  inner();
  CHECK(visits == 2);
}
