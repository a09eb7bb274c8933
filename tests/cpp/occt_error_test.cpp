// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/occt/occt_error.hpp"

#include <Standard_OutOfRange.hxx>
#include <catch2/catch.hpp>

using Catch::Matchers::Equals;

TEST_CASE("A failure of OpenCASCADE keeps its kind and message") {
  const auto fail = []() -> int { throw Standard_OutOfRange("index 7"); };
  CHECK_THROWS_WITH(pn::with_occt_errors(fail), Equals("Standard_OutOfRange: index 7"));
  CHECK_THROWS_AS(pn::with_occt_errors(fail), pn::OcctError);
}

TEST_CASE("What does not fail, or fails otherwise, passes through") {
  CHECK(pn::with_occt_errors([] { return 3; }) == 3);
  const auto fail = []() -> int { throw std::logic_error("ours"); };
  CHECK_THROWS_AS(pn::with_occt_errors(fail), std::logic_error);
}
