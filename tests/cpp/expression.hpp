// SPDX-License-Identifier: LGPL-2.1-or-later
// Formulas of the literature as text, evaluated in any ring: +, -, *, / and ** with integers,
// parentheses and names, as in "-(s**2 + t**2 - t + 1)/s".
#pragma once

#include <array>
#include <cctype>
#include <map>
#include <stdexcept>
#include <string>

#include "pn/algebra/rational_polynomial.hpp"

namespace pn::test {

template <class T>
T divided(const T& a, const T& b) {
  return a / b;
}
inline RationalPolynomial divided(const RationalPolynomial& a, const RationalPolynomial& b) {
  return exact_quotient(a, b);
}

template <class T>
class Expression {
 public:
  Expression(std::string text, const std::map<std::string, T>& names)
      : text_(std::move(text)), names_(names) {}

  /// Throws std::invalid_argument when the text is no formula of these names.
  T value() {
    const T result = sum();
    if (here() != '\0') fail();
    return result;
  }

 private:
  T sum() {
    T result = product();
    while (here() == '+' || here() == '-') {
      if (taken('+'))
        result = result + product();
      else if (taken('-'))
        result = result - product();
    }
    return result;
  }

  T product() {
    T result = signed_power();
    while (true) {
      if (taken('*'))
        result = result * signed_power();
      else if (taken('/'))
        result = divided(result, signed_power());
      else
        return result;
    }
  }

  T signed_power() {
    if (taken('-')) return -signed_power();
    const T base = atom();
    here();
    if (text_.compare(place_, 2, "**") != 0) return base;
    place_ += 2;
    T result(1L);
    for (long exponent = integer(); exponent > 0; --exponent) result = result * base;
    return result;
  }

  T atom() {
    if (taken('(')) {
      const T result = sum();
      if (!taken(')')) fail();
      return result;
    }
    return std::isdigit(here()) != 0 ? T(integer()) : names_.at(name());
  }

  long integer() {
    return std::stol(word([](unsigned char c) { return std::isdigit(c) != 0; }));
  }
  std::string name() {
    return word([](unsigned char c) { return std::isalnum(c) != 0; });
  }

  template <class Belongs>
  std::string word(Belongs belongs) {
    here();
    const std::size_t begin = place_;
    while (place_ < text_.size() && belongs(static_cast<unsigned char>(text_[place_]))) ++place_;
    if (place_ == begin) fail();
    return text_.substr(begin, place_ - begin);
  }

  /// The next character that is no space; '\0' at the end.
  char here() {
    while (place_ < text_.size() && text_[place_] == ' ') ++place_;
    return place_ < text_.size() ? text_[place_] : '\0';
  }
  bool taken(char c) {
    if (here() != c) return false;
    ++place_;
    return true;
  }
  [[noreturn]] void fail() const {
    throw std::invalid_argument("no formula at " + std::to_string(place_) + ": " + text_);
  }

  std::string text_;
  const std::map<std::string, T>& names_;
  std::size_t place_ = 0;
};

template <class T>
T value(const std::string& text, const std::map<std::string, T>& names) {
  return Expression<T>(text, names).value();
}

/// As many as the array has.
template <std::size_t N, class T, class Texts>
std::array<T, N> values(const Texts& texts, const std::map<std::string, T>& names) {
  if (texts.size() != N) throw std::invalid_argument("another number of formulas");
  std::array<T, N> result;
  for (std::size_t i = 0; i < N; ++i) result[i] = value<T>(texts[i], names);
  return result;
}

}  // namespace pn::test
