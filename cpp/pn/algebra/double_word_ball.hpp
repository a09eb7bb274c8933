// SPDX-License-Identifier: LGPL-2.1-or-later
// Double-word balls: the numbers within `radius` of high + low, where high is the double nearest to
// that sum.
//
// A sum of two doubles, and a product, is again a sum of two doubles, and both are found by a few
// operations of the processor. So numbers with twice the digits of a double cost tens of
// instructions, several times less than those of any length. (T. J. Dekker, A floating-point
// technique for extending the available precision, Numer. Math. 18, 1971; M. Joldes, J.-M. Muller,
// V. Popescu, Tight and rigorous error bounds for basic building blocks of double-word arithmetic,
// ACM TOMS 44, 2017.)
//
// What does not fit into two doubles is found exactly, too, and goes into the radius: an operation
// contains the exact result for all numbers of its operands, and is exact where that fits. High and
// low are zero or within a range in which no product or its error underflows. What leaves it has no
// double-word ball, and the operation gives nothing.
#pragma once

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <limits>
#include <optional>

/// Marks a function that is compiled twice for x86-64: for processors with a fused multiply-add,
/// and for those that may lack it, where every std::fma is a call. The loader takes the one that
/// fits; both give the same bits. The sanitizers' loaders cannot choose yet.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && \
    !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define PN_WITH_FUSED_MULTIPLY_ADD __attribute__((target_clones("fma", "default")))
#else
#define PN_WITH_FUSED_MULTIPLY_ADD
#endif

namespace pn {

// Error-free transformations need every operation rounded to a double, once.
static_assert(FLT_EVAL_METHOD == 0, "doubles are computed with excess precision");

struct DoubleWordBall {
  double high = 0, low = 0, radius = 0;

  /// Bits that an operation keeps of its result.
  static constexpr long kPrecision = 104;

  bool is_zero() const { return high == 0 && radius == 0; }
  /// Every number of the ball is > 0.
  bool is_positive() const;
  bool is_negative() const { return (-*this).is_positive(); }
  /// The greatest double that no number of the ball is below, the least that none is above.
  double lower() const;
  double upper() const { return -(-*this).lower(); }

  DoubleWordBall operator-() const { return {-high, -low, radius}; }
};

namespace double_word {

/// Products of numbers of 53 bits in this range have errors of at least 2^-1006, which are doubles.
inline constexpr double kLargest = 0x1p450, kSmallest = 0x1p-450;
/// A radius is zero or at least this, so that its products do not underflow.
inline constexpr double kSmallestRadius = 0x1p-500;
/// Thousands of roundings of a radius.
inline constexpr double kUpwards = 1 + 0x1p-40;

struct WithError {
  double value, error;
};

/// a + b = value + error.
inline WithError sum(double a, double b) {
  const double s = a + b, t = s - a;
  return {s, (a - (s - t)) + (b - t)};
}

/// a b = value + error.
inline WithError product(double a, double b) {
  const double p = a * b;
  return {p, std::fma(a, b, -p)};
}

inline bool is_in_range(double x) {
  return x == 0 || (std::abs(x) >= kSmallest && std::abs(x) <= kLargest);
}

inline std::optional<DoubleWordBall> in_range(const DoubleWordBall& x) {
  if (!is_in_range(x.high) || !is_in_range(x.low) || !(x.radius <= kLargest)) return std::nullopt;
  return DoubleWordBall{x.high, x.low, x.radius == 0 ? 0 : std::max(x.radius, kSmallestRadius)};
}

inline DoubleWordBall unchecked_sum(const DoubleWordBall& a, const DoubleWordBall& b) {
  const WithError high = sum(a.high, b.high), low = sum(a.low, b.low);
  const WithError carry = sum(high.error, low.value);
  const WithError result = sum(high.value, carry.value);
  const double lost = std::abs(carry.error) + std::abs(low.error);
  return {result.value, result.error, (a.radius + b.radius + lost) * kUpwards};
}

/// How far the products of numbers of two balls may be from that of their midpoints.
inline double spread(const DoubleWordBall& a, const DoubleWordBall& b) {
  return std::abs(a.high) * b.radius + (std::abs(b.high) + b.radius) * a.radius;
}

inline DoubleWordBall unchecked_product(const DoubleWordBall& a, const DoubleWordBall& b) {
  const WithError high = product(a.high, b.high);
  const WithError first = product(a.high, b.low), second = product(a.low, b.high);
  const WithError mixed = sum(first.value, second.value), low = sum(high.error, mixed.value);
  const WithError result = sum(high.value, low.value);
  const double lost = std::abs(a.low * b.low) + std::abs(first.error) + std::abs(second.error) +
                      std::abs(mixed.error) + std::abs(low.error);
  return {result.value, result.error, (lost + spread(a, b)) * kUpwards};
}

/// A double that no |x| of the ball exceeds, and one that none falls short of.
inline double most(const DoubleWordBall& x) { return (std::abs(x.high) + x.radius) * kUpwards; }
inline double least(const DoubleWordBall& x) {
  return std::abs(x.high) * (1 - 0x1p-50) - x.radius * kUpwards;
}

/// The ball around first + second of all numbers q for which rest(first + second) encloses the
/// difference that q makes, times at least `slope`.
template <class Rest>
std::optional<DoubleWordBall> corrected(double first, double second, double slope, Rest&& rest) {
  const WithError q = sum(first, is_in_range(second) ? second : 0);
  const DoubleWordBall left = rest({q.value, q.error, 0});
  if (left.is_zero()) return in_range({q.value, q.error, 0});
  return in_range({q.value, q.error, std::max(most(left) / slope * kUpwards, kSmallestRadius)});
}

}  // namespace double_word

/// x + a_0 b_0 + a_1 b_1 + ..., for which the parts beside the highest are summed as doubles. (T.
/// Ogita, S. M. Rump, S. Oishi, Accurate sum and dot product, SIAM J. Sci. Comput. 26, 2005.)
///
/// Of n terms with the parts beside the highest at most `size` together, every partial sum of those
/// rounds by half a unit of at most that size, and so do all other roundings of a term together, at
/// most five times.
class DoubleWordSum {
 public:
  explicit DoubleWordSum(const DoubleWordBall& x)
      : high_(x.high), low_(x.low), size_(std::abs(x.low)), radius_(x.radius) {}

  void add_product(const DoubleWordBall& a, const DoubleWordBall& b) {
    const double_word::WithError product = double_word::product(a.high, b.high);
    const double_word::WithError high = double_word::sum(high_, product.value);
    const double first = a.high * b.low, second = a.low * b.high;
    high_ = high.value;
    low_ += (high.error + product.error) + (first + second);
    size_ +=
        (std::abs(high.error) + std::abs(product.error)) + (std::abs(first) + std::abs(second));
    radius_ += std::abs(a.low * b.low) + double_word::spread(a, b);
    roundings_ += 1;
  }

  std::optional<DoubleWordBall> result() const {
    const double_word::WithError words = double_word::sum(high_, low_);
    const double lost = roundings_ * kHalfUnit * size_;
    return double_word::in_range(
        {words.value, words.error, (radius_ + lost) * double_word::kUpwards});
  }

 private:
  static constexpr double kHalfUnit = 0x1p-53;

  double high_, low_, size_, radius_, roundings_ = 5;
};

inline double DoubleWordBall::lower() const {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  const double_word::WithError down = double_word::sum(radius, -low);
  const double below = down.error > 0 ? std::nextafter(down.value, kInfinity) : down.value;
  const double_word::WithError bound = double_word::sum(high, -below);
  return bound.error < 0 ? std::nextafter(bound.value, -kInfinity) : bound.value;
}

inline bool DoubleWordBall::is_positive() const {
  if (high <= 0) return false;
  return double_word::least(*this) > 0 || lower() > 0;
}

inline std::optional<DoubleWordBall> sum(const DoubleWordBall& a, const DoubleWordBall& b) {
  return double_word::in_range(double_word::unchecked_sum(a, b));
}

inline std::optional<DoubleWordBall> difference(const DoubleWordBall& a, const DoubleWordBall& b) {
  return sum(a, -b);
}

inline std::optional<DoubleWordBall> product(const DoubleWordBall& a, const DoubleWordBall& b) {
  return double_word::in_range(double_word::unchecked_product(a, b));
}

/// Nothing also where b is not certainly different from zero.
///
/// With a quotient q in doubles, a / b - q = (a - q b) / b, and the numerator is found in double
/// words.
inline std::optional<DoubleWordBall> quotient(const DoubleWordBall& a, const DoubleWordBall& b) {
  using namespace double_word;
  const double divisor = least(b), first = a.high / b.high;
  if (!(divisor >= kSmallest) || !is_in_range(first)) return std::nullopt;
  const auto rest = [&](const DoubleWordBall& q) {
    return unchecked_sum(a, -unchecked_product(q, b));
  };
  return corrected(first, rest({first, 0, 0}).high / b.high, divisor, rest);
}

/// The root >= 0; nothing also where x is not certainly positive.
///
/// With a root q in doubles, |sqrt(x) - q| = |x - q^2| / (sqrt(x) + q) <= |x - q^2| / q.
inline std::optional<DoubleWordBall> root(const DoubleWordBall& x) {
  using namespace double_word;
  if (x.high < 0 || !(least(x) >= kSmallest)) return std::nullopt;
  const auto rest = [&](const DoubleWordBall& q) {
    return unchecked_sum(x, -unchecked_product(q, q));
  };
  const double first = std::sqrt(x.high);
  return corrected(first, rest({first, 0, 0}).high / (2 * first), first / 2, rest);
}

}  // namespace pn
