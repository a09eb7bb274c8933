// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/algebra/bernstein.hpp"

#include "pn/algebra/ball_vector.hpp"

namespace pn {

BernsteinOfBalls::BernsteinOfBalls(int degree, long precision) {
  const auto n = static_cast<std::size_t>(degree);
  factorial_.assign(n + 1, RealBall(1).at_precision(precision));
  falling_ = factorial_;
  for (std::size_t i = 1; i <= n; ++i) {
    factorial_[i] = factorial_[i - 1] * RealBall(static_cast<long>(i));
    falling_[n - i] = falling_[n - i + 1] * RealBall(static_cast<long>(n - i + 1));
  }
  const RealBall inverse = RealBall(1) / (factorial_[n] * factorial_[n]);
  for (const RealBall& factorial : factorial_) scale_.push_back(factorial * inverse);
}

std::vector<RealBall> BernsteinOfBalls::operator()(std::vector<RealBall> power) const {
  for (std::size_t i = 0; i < power.size(); ++i) power[i] *= factorial_[power.size() - 1 - i];
  std::vector<RealBall> bernstein(power.size());
  add_product(bernstein, power, falling_);
  for (std::size_t j = 0; j < power.size(); ++j) bernstein[j] *= scale_[j];
  return bernstein;
}

}  // namespace pn
