// SPDX-License-Identifier: LGPL-2.1-or-later
// Rational functions over Q from text, as printed in papers: "(s**2+t**2-1)/(2*s)".
#pragma once

#include <cctype>
#include <stdexcept>
#include <string>
#include <utility>

#include "pn/algebra/rational_function.hpp"

namespace pn::test {

/// A parser of sums, products, quotients, integer powers, and one letter for each variable.
template <std::size_t N>
class RationalExpression {
 public:
  RationalExpression(std::string text, std::string variables)
      : text_(std::move(text)), variables_(std::move(variables)) {}

  RationalFunction<N> value() {
    RationalFunction<N> result = sum();
    if (place_ != text_.size()) fail();
    return result;
  }

 private:
  RationalFunction<N> sum() {
    RationalFunction<N> result = taken("-") ? -product() : product();
    while (true) {
      if (taken("+")) {
        result += product();
      } else if (taken("-")) {
        result -= product();
      } else {
        return result;
      }
    }
  }

  RationalFunction<N> product() {
    RationalFunction<N> result = power();
    while (true) {
      if (taken("*")) {
        result *= power();
      } else if (taken("/")) {
        result /= power();
      } else {
        return result;
      }
    }
  }

  RationalFunction<N> power() {
    const RationalFunction<N> base = atom();
    if (!taken("**")) return base;
    RationalFunction<N> result(1L);
    for (long n = integer(); n > 0; --n) result *= base;
    return result;
  }

  RationalFunction<N> atom() {
    if (taken("(")) {
      RationalFunction<N> result = sum();
      if (!taken(")")) fail();
      return result;
    }
    if (place_ < text_.size() && std::isdigit(text_[place_]) != 0) {
      return RationalFunction<N>(integer());
    }
    const std::size_t variable =
        place_ < text_.size() ? variables_.find(text_[place_]) : std::string::npos;
    if (variable == std::string::npos) fail();
    ++place_;
    return RationalFunction<N>(MultivariatePolynomial<N>(static_cast<Variable>(variable)));
  }

  long integer() {
    std::size_t length = 0;
    const long result = std::stol(text_.substr(place_), &length);
    place_ += length;
    return result;
  }

  bool taken(const std::string& token) {
    const bool is_power = text_.compare(place_, 2, "**") == 0;
    if (text_.compare(place_, token.size(), token) != 0 || (is_power && token == "*")) {
      return false;
    }
    place_ += token.size();
    return true;
  }

  [[noreturn]] void fail() const {
    throw std::invalid_argument("cannot read " + text_ + " from character " +
                                std::to_string(place_));
  }

  std::string text_, variables_;
  std::size_t place_ = 0;
};

/// In the variables "uv", "st", "xyz", ..., one letter for each variable of the field.
template <std::size_t N>
RationalFunction<N> rational_function(const std::string& text, const std::string& variables) {
  return RationalExpression<N>(text, variables).value();
}

}  // namespace pn::test
