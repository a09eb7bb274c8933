// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/input_numbers.hpp"

#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include "error_code.hpp"

using namespace pn;
using namespace pn::test;

namespace {

std::optional<ErrorCode> refusal(double number) {
  return code_of([=] { require_input_number(number, "A pole"); });
}

}  // namespace

TEST_CASE("Zero and the sizes of both limits are taken, what lies beyond is refused",
          "[input_numbers]") {
  for (const double size : {0.0, kSmallestInputNumber, 1.0, kLargestInputNumber}) {
    CHECK(!refusal(size));
    CHECK(!refusal(-size));
  }
  for (const double size :
       {std::nextafter(kSmallestInputNumber, 0.0), std::numeric_limits<double>::denorm_min(),
        std::nextafter(kLargestInputNumber, HUGE_VAL), std::numeric_limits<double>::max()}) {
    CHECK(refusal(size) == ErrorCode::kOutOfRange);
    CHECK(refusal(-size) == ErrorCode::kOutOfRange);
  }
  for (const double bad : {NAN, INFINITY, -INFINITY}) {
    CHECK(refusal(bad) == ErrorCode::kNotFinite);
  }
}

TEST_CASE("A list is refused for one of its numbers, by name and value", "[input_numbers]") {
  CHECK_THROWS_WITH(
      require_input_numbers(std::array{1.0, -1e200, 2.0}, "A pole"),
      "A pole is -1e+200; a number must be zero or of a size between 1e-100 and 1e+100.");
  CHECK_THROWS_WITH(require_input_numbers(std::array{1.0, double{NAN}}, "A pole"),
                    "A pole is not a finite number.");
  CHECK_NOTHROW(require_input_numbers(std::array<double, 0>{}, "A pole"));
}
