// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/algebra/ball_vector.hpp"

#include <algorithm>

namespace pn {
namespace {

/// Balls side by side, as Arb takes vectors: lent where they are Arb's already.
class ArbVector {
 public:
  explicit ArbVector(const std::vector<RealBall>& balls) {
    own_.reserve(balls.size());
    numbers_.reserve(balls.size());
    for (const RealBall& ball : balls) {
      if (ball.words()) own_.push_back(ball.arb());
      numbers_.push_back(ball.words() ? *own_.back().get() : *ball.long_ball());
    }
  }
  ArbVector(const ArbVector&) = delete;
  ArbVector& operator=(const ArbVector&) = delete;

  arb_srcptr operator[](std::size_t i) const { return &numbers_[i]; }
  slong size() const { return static_cast<slong>(numbers_.size()); }

 private:
  std::vector<ArbBall> own_;
  std::vector<arb_struct> numbers_;
};

long precision_of(const std::vector<RealBall>& balls) {
  long precision = RealBall::kFloor;
  for (const RealBall& ball : balls) precision = std::max(precision, ball.precision());
  return precision;
}

/// The coefficients a_i b_(k - i), first <= i < end, of t^k in a product of polynomials.
struct Terms {
  std::size_t first, end;
};

template <class Ball>
Terms terms_of(std::size_t k, const std::vector<Ball>& a, const std::vector<Ball>& b) {
  return {k < b.size() ? 0 : k - b.size() + 1, std::min(k + 1, a.size())};
}

/// How many coefficients of a product of polynomials are wanted and not zero.
template <class Ball>
std::size_t count_of(const std::vector<Ball>& sum, const std::vector<Ball>& a,
                     const std::vector<Ball>& b) {
  return std::min(sum.size(), a.size() + b.size() - 1);
}

bool are_double_words(const std::vector<RealBall>& balls) {
  return std::all_of(balls.begin(), balls.end(), [](const RealBall& x) { return x.words(); });
}

PN_WITH_FUSED_MULTIPLY_ADD
void add_in_double_words(std::vector<RealBall>& sum, const std::vector<RealBall>& a,
                         const std::vector<RealBall>& b, long precision) {
  for (std::size_t k = 0; k < count_of(sum, a, b); ++k) {
    const auto [first, end] = terms_of(k, a, b);
    DoubleWordSum words(*sum[k].words());
    for (std::size_t i = first; i < end; ++i) words.add_product(*a[i].words(), *b[k - i].words());
    if (const auto result = words.result()) {
      sum[k] = RealBall(*result, precision);
    } else {
      for (std::size_t i = first; i < end; ++i) sum[k].add_product(a[i], b[k - i]);
    }
  }
}

RealBall dot_in_arb(const std::vector<RealBall>& a, const std::vector<RealBall>& b,
                    long precision) {
  const ArbVector x(a), y(b);
  ArbBall sum;
  arb_dot(sum.get(), nullptr, 0, x[0], 1, y[0], 1, x.size(), precision);
  return RealBall(std::move(sum), precision);
}

void add_in_arb(std::vector<RealBall>& sum, const std::vector<RealBall>& a,
                const std::vector<RealBall>& b, long precision) {
  const ArbVector x(a), y(b);
  for (std::size_t k = 0; k < count_of(sum, a, b); ++k) {
    const auto [first, end] = terms_of(k, a, b);
    ArbBall result = sum[k].arb();
    arb_dot(result.get(), result.get(), 0, x[first], 1, y[k - first], -1,
            static_cast<slong>(end - first), precision);
    sum[k] = RealBall(std::move(result), precision);
  }
}

}  // namespace

PN_WITH_FUSED_MULTIPLY_ADD
RealBall dot(const std::vector<RealBall>& a, const std::vector<RealBall>& b) {
  DoubleWordSum sum({});
  long precision = RealBall::kFloor;
  bool short_terms = true;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const DoubleWordBall *x = a[i].words(), *y = b[i].words();
    precision = std::max({precision, a[i].precision(), b[i].precision()});
    short_terms = short_terms && x && y;
    if (short_terms) sum.add_product(*x, *y);
  }
  if (short_terms) {
    if (const auto result = sum.result()) return RealBall(*result, precision);
  }
  return dot_in_arb(a, b, precision);
}

void add_product(std::vector<RealBall>& sum, const std::vector<RealBall>& a,
                 const std::vector<RealBall>& b) {
  const long precision = std::max({precision_of(sum), precision_of(a), precision_of(b)});
  if (are_double_words(sum) && are_double_words(a) && are_double_words(b)) {
    add_in_double_words(sum, a, b, precision);
  } else {
    add_in_arb(sum, a, b, precision);
  }
}

void add_product(std::vector<ComplexBall>& sum, const std::vector<ComplexBall>& a,
                 const std::vector<ComplexBall>& b) {
  for (std::size_t k = 0; k < count_of(sum, a, b); ++k) {
    const auto [first, end] = terms_of(k, a, b);
    for (std::size_t i = first; i < end; ++i) sum[k].add_product(a[i], b[k - i]);
  }
}

std::vector<RealBall> normalized(std::vector<RealBall> numbers) {
  ArbBall largest;
  for (const RealBall& x : numbers) {
    const ArbBall ball = x.arb();
    if (arf_cmpabs(arb_midref(ball.get()), arb_midref(largest.get())) > 0) largest = ball;
  }
  if (arf_is_special(arb_midref(largest.get()))) return numbers;
  const long exponent = fmpz_get_si(ARF_EXPREF(arb_midref(largest.get())));
  for (RealBall& x : numbers) x = scaled(x, -exponent);
  return numbers;
}

}  // namespace pn
