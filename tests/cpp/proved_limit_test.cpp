// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/bezier/proved_limit.hpp"

#include <catch2/catch.hpp>
#include <cmath>

namespace {

/// A limit whose proofs need room, and whose samples are not the least until a proof meets that.
struct TestLimit {
  using Place = char;
  double first_sample, truth, room;
};

using Sample = pn::LimitSample<char>;

Sample least_sample(const TestLimit& limit) { return {limit.first_sample, 'f'}; }

pn::Verdict<char> verdict(const TestLimit& limit, double distance) {
  if (distance >= limit.truth) return {false, {limit.truth, 't'}};
  return {distance <= limit.truth - limit.room, {}};
}

pn::ProvedLimit<char> limit_of(const std::vector<TestLimit>& limits, const pn::Margins& margins) {
  return pn::proved_limit(limits, 1.0, 0, margins);
}

double proved(const std::vector<TestLimit>& limits, const pn::Margins& margins) {
  return limit_of(limits, margins).distance;
}

constexpr pn::Margins kMargins = {2, 8, 1e6};

}  // namespace

TEST_CASE("The distance is one tolerance below the least limit", "[proved_limit]") {
  CHECK(proved({{100, 100, 0.5}, {200, 200, 0.5}}, kMargins) == 99);
}

TEST_CASE("A smaller sample is where the search goes on", "[proved_limit]") {
  CHECK(proved({{100, 60, 0.5}}, kMargins) == 59);
  CHECK(proved({{100, 60, 0.5}, {90, 50, 0.5}}, kMargins) == 49);
  CHECK(proved({{INFINITY, 60, 0.5}}, kMargins) == 59);
}

TEST_CASE("The margin grows until the proof has room", "[proved_limit]") {
  CHECK(proved({{100, 100, 3}}, kMargins) == 96);
  CHECK(proved({{100, 60, 3}}, kMargins) == 56);
  CHECK_THROWS_AS(proved({{100, 100, 9}}, kMargins), pn::Undecided);
  CHECK(proved({{100, 100, 9}}, {10, INFINITY, 1e6}) == 90);
}

TEST_CASE("The ends of the search", "[proved_limit]") {
  CHECK(proved({{INFINITY, INFINITY, 0}}, kMargins) == 1e6 - 1);
  CHECK(proved({{0.5, 0.5, 0}}, kMargins) == 0);
  CHECK(proved({{100, 100, 200}}, {10, INFINITY, 1e6}) == 0);
}

TEST_CASE("The critical place is that of the least sample", "[proved_limit]") {
  const auto check = [](const std::vector<TestLimit>& limits, std::size_t limit, Sample sample) {
    const auto critical = limit_of(limits, kMargins).critical;
    REQUIRE(critical);
    CHECK(critical->limit == limit);
    CHECK(critical->sample.value == sample.value);
    CHECK(critical->sample.at == sample.at);
  };
  check({{200, 200, 0.5}, {100, 100, 0.5}}, 1, {100, 'f'});
  check({{100, 60, 3}}, 0, {60, 't'});
  check({{100, 60, 0.5}, {90, 50, 0.5}}, 1, {50, 't'});
  check({{0.5, 0.5, 0}}, 0, {0.5, 'f'});
  CHECK_FALSE(limit_of({{INFINITY, INFINITY, 0}}, kMargins).critical);
}
