// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/bezier/projective_change.hpp"

#include <cmath>

#include "pn/bezier/line_factor.hpp"

namespace pn {
namespace {

/// p with x = xi / (xi + mu (1 - xi)) for one variable x, times (xi + mu (1 - xi))^degree.
TensorPolynomial<RealBall> changed(const TensorPolynomial<RealBall>& p, Variable variable,
                                   const RealBall& mu) {
  const int n = p.degree(variable);
  const bool is_u = variable == Variable::kU;
  TensorPolynomial<RealBall> x(is_u ? 1 : 0, is_u ? 0 : 1), denominator = x;
  (is_u ? x(1, 0) : x(0, 1)) = RealBall(1);
  (is_u ? denominator(1, 0) : denominator(0, 1)) = RealBall(1) - mu;
  denominator(0, 0) = mu;
  TensorPolynomial<RealBall> sum = p.slice(variable, n),
                             power = TensorPolynomial<RealBall>::constant(RealBall(1));
  for (int k = n - 1; k >= 0; --k) {
    power = power * denominator;
    sum = sum * x + p.slice(variable, k) * power;
  }
  return sum;
}

}  // namespace

ProjectiveChange ProjectiveChange::evening(const TensorPolynomial<RealBall>& weight) {
  const int m = weight.degree(Variable::kU), n = weight.degree(Variable::kV);
  const std::vector<RealBall> w = to_bernstein(weight);
  // Slopes of the best plane through the logarithms; i and j from their means are orthogonal.
  double along = 0, around = 0, squares_along = 0, squares_around = 0;
  for (int i = 0; i <= m; ++i) {
    for (int j = 0; j <= n; ++j) {
      const double value =
          std::log(std::abs(w[static_cast<std::size_t>(i * (n + 1) + j)].midpoint()));
      const double x = i - m / 2.0, y = j - n / 2.0;
      along += x * value;
      around += y * value;
      squares_along += x * x;
      squares_around += y * y;
    }
  }
  return {m == 0 ? 1 : lines::short_double(std::exp(along / squares_along)),
          n == 0 ? 1 : lines::short_double(std::exp(around / squares_around))};
}

std::array<double, 2> ProjectiveChange::place(const std::array<double, 2>& ts) const {
  const auto change = [](double x, double factor) { return factor * x / (1 - x + factor * x); };
  return {change(ts[0], mu), change(ts[1], nu)};
}

SurfaceSections<RealBall> ProjectiveChange::applied(SurfaceSections<RealBall> sections,
                                                    const std::array<int, 2>& degree,
                                                    long bits) const {
  const auto apply = [&](TensorPolynomial<RealBall>& p) {
    p += TensorPolynomial<RealBall>(degree[0], degree[1]);
    p = changed(changed(p, Variable::kU, RealBall(mu).at_precision(bits)), Variable::kV,
                RealBall(nu).at_precision(bits));
  };
  for (std::size_t i = 0; i < 3; ++i) {
    apply(sections.point[i]);
    apply(sections.direction[i]);
  }
  apply(sections.weight);
  return sections;
}

}  // namespace pn
