// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/algebra/tensor_bernstein.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include "pn/algebra/bernstein.hpp"
#include "pn/algebra/roots.hpp"

namespace pn {
namespace {

/// Half a unit in the last place of 1: the relative error of one operation.
constexpr double kRounding = 0x1p-53;
/// An error so many times that of one rounding is worth rounding anew.
constexpr double kMuchLess = 0x1p10;
/// Covers the rounding of the error bounds themselves, a few dozen operations each.
constexpr double kUpwards = 1 + 0x1p-40;
/// Covers the underflow of a mean.
constexpr double kLeastError = std::numeric_limits<double>::min();

/// Bits for proofs about polynomials over Q: more than the doubles that they are rounded to lose.
constexpr long kProofBits = 256;
/// Parts of the square after which a proof is given up.
constexpr int kMostTiles = 20000;

std::size_t index(Variable variable) { return variable == Variable::kU ? 0 : 1; }

/// The part left of t, which ends there.
std::vector<RealBall> left_of(std::vector<RealBall> b, const RealBall& t) {
  const RealBall rest = RealBall(1L) - t;
  std::vector<RealBall> left;
  for (std::size_t n = b.size(); n > 0; --n) {
    left.push_back(b.front());
    for (std::size_t i = 0; i + 1 < n; ++i) {
      b[i] *= rest;
      b[i].add_product(b[i + 1], t);
    }
  }
  return left;
}

/// The part between two parameters.
std::vector<RealBall> between(std::vector<RealBall> b, double low, double high) {
  if (high < 1) b = left_of(std::move(b), RealBall(high));
  if (low == 0) return b;
  std::reverse(b.begin(), b.end());
  const long bits = b.front().precision();
  b = left_of(std::move(b), RealBall(1L) - RealBall(low).at_precision(bits) / RealBall(high));
  std::reverse(b.begin(), b.end());
  return b;
}

/// Replaces the coefficients along every line of one variable.
template <class T, class Change>
void change_lines(std::vector<T>& coefficients, std::size_t size_u, std::size_t size_v,
                  Variable variable, Change&& change) {
  const bool along_u = variable == Variable::kU;
  const std::size_t length = along_u ? size_u : size_v, stride = along_u ? size_v : 1;
  for (std::size_t line = 0; line < (along_u ? size_v : size_u); ++line) {
    const std::size_t first = line * (along_u ? 1 : size_v);
    std::vector<T> values(length);
    for (std::size_t i = 0; i < length; ++i) {
      values[i] = std::move(coefficients[first + i * stride]);
    }
    values = change(std::move(values));
    for (std::size_t i = 0; i < length; ++i) {
      coefficients[first + i * stride] = std::move(values[i]);
    }
  }
}

}  // namespace

double Rectangle::length(Variable variable) const {
  return high[index(variable)] - low[index(variable)];
}

double Rectangle::middle(Variable variable) const {
  return low[index(variable)] + length(variable) / 2;
}

std::array<Rectangle, 2> Rectangle::halved(Variable variable) const {
  std::array<Rectangle, 2> halves = {*this, *this};
  halves[0].high[index(variable)] = halves[1].low[index(variable)] = middle(variable);
  return halves;
}

TensorBernstein::TensorBernstein(const BivariatePolynomial& p, int degree_u, int degree_v,
                                 long bits)
    : degree_u_(degree_u), degree_v_(degree_v) {
  assert(degree_u >= p.degree(Variable::kU) && degree_v >= p.degree(Variable::kV));
  for (int i = 0; i <= degree_u; ++i) {
    for (int j = 0; j <= degree_v; ++j) coefficients_.emplace_back(p.coefficient(i, j), bits);
  }
  for (const Variable variable : {Variable::kU, Variable::kV}) {
    change_lines(coefficients_, static_cast<std::size_t>(degree_u_) + 1,
                 static_cast<std::size_t>(degree_v_) + 1, variable,
                 [](std::vector<RealBall> power) { return to_bernstein(std::move(power)); });
  }
}

int TensorBernstein::degree(Variable variable) const {
  return variable == Variable::kU ? degree_u_ : degree_v_;
}

const RealBall& TensorBernstein::coefficient(int i, int j) const {
  return coefficients_[static_cast<std::size_t>(i * (degree_v_ + 1) + j)];
}

TensorBernstein TensorBernstein::on(const Rectangle& rectangle) const {
  TensorBernstein result = *this;
  for (const Variable variable : {Variable::kU, Variable::kV}) {
    const double low = rectangle.low[index(variable)], high = rectangle.high[index(variable)];
    change_lines(result.coefficients_, static_cast<std::size_t>(degree_u_) + 1,
                 static_cast<std::size_t>(degree_v_) + 1, variable,
                 [&](std::vector<RealBall> line) { return between(std::move(line), low, high); });
  }
  return result;
}

TensorBernstein operator+(TensorBernstein a, const TensorBernstein& b) {
  assert(a.degree_u_ == b.degree_u_ && a.degree_v_ == b.degree_v_);
  for (std::size_t i = 0; i < a.coefficients_.size(); ++i) a.coefficients_[i] += b.coefficients_[i];
  return a;
}

TensorBernstein operator*(TensorBernstein a, const RealBall& factor) {
  for (RealBall& coefficient : a.coefficients_) coefficient *= factor;
  return a;
}

bool has_non_negative_coefficients(const BivariatePolynomial& p) {
  std::vector<Rational> coefficients;
  const int degree_u = p.degree(Variable::kU), degree_v = p.degree(Variable::kV);
  for (int i = 0; i <= degree_u; ++i) {
    for (int j = 0; j <= degree_v; ++j) coefficients.push_back(p.coefficient(i, j));
  }
  for (const Variable variable : {Variable::kU, Variable::kV}) {
    change_lines(coefficients, static_cast<std::size_t>(degree_u + 1),
                 static_cast<std::size_t>(degree_v + 1), variable,
                 [](std::vector<Rational> power) { return to_bernstein(std::move(power)); });
  }
  return std::all_of(coefficients.begin(), coefficients.end(),
                     [](const Rational& c) { return c.sign() >= 0; });
}

RoundedBernstein::RoundedBernstein(const TensorBernstein& enclosure)
    : size_u_(static_cast<std::size_t>(enclosure.degree(Variable::kU)) + 1),
      size_v_(static_cast<std::size_t>(enclosure.degree(Variable::kV)) + 1) {
  double radius = 0;
  for (const RealBall& coefficient : enclosure.coefficients()) {
    coefficients_.push_back(coefficient.midpoint());
    radius = std::max(radius, coefficient.radius());
  }
  const double rounding = magnitude() * kRounding;
  // An exact zero needs no digits.
  if (radius > rounding) throw Undecided("the coefficients of a polynomial, to all digits");
  error_ = (radius + rounding) * kUpwards + kLeastError;
}

double RoundedBernstein::coefficient(int i, int j) const {
  return coefficients_[static_cast<std::size_t>(i) * size_v_ + static_cast<std::size_t>(j)];
}

bool RoundedBernstein::is_positive() const {
  return std::all_of(coefficients_.begin(), coefficients_.end(),
                     [&](double c) { return c > error_; });
}

bool RoundedBernstein::has_corner_not_positive() const {
  const std::size_t last_row = coefficients_.size() - size_v_;
  for (const std::size_t corner :
       {std::size_t{0}, size_v_ - 1, last_row, coefficients_.size() - 1}) {
    if (coefficients_[corner] <= error_) return true;
  }
  return false;
}

bool RoundedBernstein::is_negative() const {
  return std::all_of(coefficients_.begin(), coefficients_.end(),
                     [&](double c) { return c < -error_; });
}

int RoundedBernstein::possible_sign() const {
  const auto [least, largest] = std::minmax_element(coefficients_.begin(), coefficients_.end());
  if (*least >= -error_) return 1;
  return *largest <= error_ ? -1 : 0;
}

bool RoundedBernstein::lacks_digits() const {
  if (is_positive() || is_negative() || possible_sign() == 0) return false;
  return error_ > kMuchLess * kRounding * magnitude();
}

std::array<RoundedBernstein, 2> RoundedBernstein::halved(Variable variable) const {
  const std::size_t length = size(variable), along = stride(variable);
  const bool along_u = variable == Variable::kU;
  const std::size_t lines = along_u ? size_v_ : size_u_, across = along_u ? 1 : size_v_;
  std::array<RoundedBernstein, 2> halves = {*this, *this};
  std::vector<double>&left = halves[0].coefficients_, &right = halves[1].coefficients_;
  // After each round `right` holds the means in its first places and the right half in its last.
  for (std::size_t round = 1; round < length; ++round) {
    for (std::size_t i = 0; i < length - round; ++i) {
      double* const here = right.data() + i * along;
      for (std::size_t k = 0; k < lines; ++k) {
        here[k * across] = 0.5 * (here[k * across] + here[k * across + along]);
      }
    }
    for (std::size_t k = 0; k < lines; ++k) left[round * along + k * across] = right[k * across];
  }
  const double rounds = static_cast<double>(length - 1);
  const double grown = error_ + rounds * (magnitude() * kRounding + kLeastError) * kUpwards;
  halves[0].error_ = halves[1].error_ = grown * kUpwards;
  return halves;
}

Variable RoundedBernstein::decisive_variable() const {
  if (const std::optional<Variable> bending = bending_variable()) return *bending;
  const std::size_t place = wrong_place();
  const bool along_u = change_through(place, Variable::kU).difference >
                       change_through(place, Variable::kV).difference;
  return along_u ? Variable::kU : Variable::kV;
}

std::optional<Variable> RoundedBernstein::bending_variable() const {
  const std::size_t place = wrong_place();
  const double by_u = change_through(place, Variable::kU).bend,
               by_v = change_through(place, Variable::kV).bend;
  const double wrong = std::abs(coefficients_[place]);
  if (wrong <= error_ || wrong >= std::max(by_u, by_v)) return std::nullopt;
  return by_u > by_v ? Variable::kU : Variable::kV;
}

std::size_t RoundedBernstein::wrong_place() const {
  const auto [least, largest] = std::minmax_element(coefficients_.begin(), coefficients_.end());
  const auto wrong = std::abs(*least) < std::abs(*largest) ? least : largest;
  return static_cast<std::size_t>(wrong - coefficients_.begin());
}

std::array<double, 2> RoundedBernstein::slope() const {
  std::array<double, 2> result = {0, 0};
  for (const Variable variable : {Variable::kU, Variable::kV}) {
    const std::size_t length = size(variable), along = stride(variable);
    if (length == 1) continue;
    const bool along_u = variable == Variable::kU;
    const std::size_t lines = along_u ? size_v_ : size_u_, across = along_u ? 1 : size_v_;
    // The sum of the differences along a line is that of its ends.
    for (std::size_t k = 0; k < lines; ++k) {
      const double* const line = coefficients_.data() + k * across;
      result[index(variable)] += line[(length - 1) * along] - line[0];
    }
    result[index(variable)] /= static_cast<double>(lines);
  }
  return result;
}

RoundedBernstein RoundedBernstein::minus(double factor, const RoundedBernstein& p) const {
  assert(size_u_ == p.size_u_ && size_v_ == p.size_v_);
  RoundedBernstein result = *this;
  for (std::size_t i = 0; i < coefficients_.size(); ++i) {
    result.coefficients_[i] -= factor * p.coefficients_[i];
  }
  const double size = std::abs(factor);
  const double rounding = 2 * kRounding * (magnitude() + 2 * size * p.magnitude());
  result.error_ = (error_ + size * p.error_ + rounding + kLeastError) * kUpwards;
  return result;
}

double RoundedBernstein::magnitude() const {
  double largest = 0;
  for (const double c : coefficients_) largest = std::max(largest, std::abs(c));
  return largest;
}

std::size_t RoundedBernstein::size(Variable variable) const {
  return variable == Variable::kU ? size_u_ : size_v_;
}

std::size_t RoundedBernstein::stride(Variable variable) const {
  return variable == Variable::kU ? size_v_ : 1;
}

RoundedBernstein::Change RoundedBernstein::change_through(std::size_t place,
                                                          Variable variable) const {
  const std::size_t length = size(variable), along = stride(variable);
  const std::size_t first = place - place / along % length * along;
  const auto at = [&](std::size_t i) { return coefficients_[first + i * along]; };
  double least = at(0), largest = at(0), bend = 0;
  for (std::size_t i = 1; i < length; ++i) {
    least = std::min(least, at(i));
    largest = std::max(largest, at(i));
    if (i + 1 < length) bend = std::max(bend, std::abs(at(i - 1) - 2 * at(i) + at(i + 1)));
  }
  // The polygon is at most degree / 8 of its second differences away from the polynomial.
  return {bend * static_cast<double>(length - 1) / 8, largest - least};
}

bool is_positive_on_square(const BivariatePolynomial& p) {
  if (p.is_zero()) return false;
  const TensorBernstein whole(p, p.degree(Variable::kU), p.degree(Variable::kV), kProofBits);
  std::vector<RoundedBernstein> open = {RoundedBernstein(whole)};
  for (int tiles = 0; !open.empty(); ++tiles) {
    const RoundedBernstein tile = std::move(open.back());
    open.pop_back();
    if (tile.is_positive()) continue;
    if (tiles == kMostTiles || tile.has_corner_not_positive()) return false;
    for (RoundedBernstein& half : tile.halved(tile.decisive_variable())) {
      open.push_back(std::move(half));
    }
  }
  return true;
}

}  // namespace pn
