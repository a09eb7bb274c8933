// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/geometry_error.hpp"

#include <catch2/catch.hpp>
#include <set>

using pn::ErrorCode;

TEST_CASE("Every code has a name of its own", "[geometry_error]") {
  const int count = static_cast<int>(ErrorCode::kPrecisionExhausted) + 1;
  std::set<std::string> names;
  for (int i = 0; i < count; ++i) names.insert(to_string(static_cast<ErrorCode>(i)));
  CHECK(static_cast<int>(names.size()) == count);
  CHECK(to_string(ErrorCode::kNegativeRadius) == "negative_radius");
  CHECK_THROWS_AS(to_string(static_cast<ErrorCode>(count)), std::logic_error);
}

TEST_CASE("An error carries its code and its sentence", "[geometry_error]") {
  const pn::GeometryError error(ErrorCode::kGap, "There is a gap.");
  CHECK(error.code() == ErrorCode::kGap);
  CHECK(std::string(error.what()) == "There is a gap.");
}
