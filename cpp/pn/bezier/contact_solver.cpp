// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/bezier/contact_solver.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

namespace pn {
namespace {

/// Starts are good to a few digits at least; more steps mean that there is no solution.
constexpr int kMostSteps = 20;
/// A step that moves by less is the last one: its own error is the square of that.
constexpr double kLastStep = 1e-9;

double number(const Rational& x) { return x.to_double(); }
double number(const RealBall& x) { return x.midpoint(); }

/// In 2 p - 1 and 2 q - 1, divided by the largest coefficient of e.
template <class T>
Contact<double> centred(const Contact<T>& contact) {
  const T half = T(1L) / T(2L);
  const auto moved = [&](const TensorPolynomial<T>& p) {
    return p.substituted(Variable::kU, half, half).substituted(Variable::kV, half, half);
  };
  const TensorPolynomial<T> e = moved(contact.e);
  T largest = e.coefficients().front();
  for (const T& c : e.coefficients()) {
    // Quotients, since the coefficients themselves may be too large for doubles.
    if (vanishes(largest) || (!vanishes(c) && std::abs(number(c / largest)) > 1)) largest = c;
  }
  const auto converted = [&](const TensorPolynomial<T>& p) {
    return p.mapped([&](const T& c) { return number(c / largest); });
  };
  return {converted(moved(contact.a)), converted(moved(contact.b)), converted(e)};
}

}  // namespace

ContactSolver::ContactSolver(const Contact<Rational>& contact) : ContactSolver(centred(contact)) {}
ContactSolver::ContactSolver(const Contact<RealBall>& contact) : ContactSolver(centred(contact)) {}
ContactSolver::ContactSolver(const Contact<double>& centred)
    : a_(centred.a), b_(centred.b), e_(centred.e) {}

std::array<double, 2> ContactSolver::solution(const std::array<double, 2>& uv,
                                              const std::array<double, 2>& start) const {
  using Eigen::Vector2d;
  Vector2d x(2 * start[0] - 1, 2 * start[1] - 1);
  for (int step = 0; step < kMostSteps; ++step) {
    const auto at = [&](const TensorPolynomial<double>& p) { return p.at(x(0), x(1)); };
    const double e = at(e_.value), e_u = at(e_.by_u), e_v = at(e_.by_v);
    const Vector2d residue(at(a_.value) - uv[0] * e, at(b_.value) - uv[1] * e);
    Eigen::Matrix2d slopes;
    slopes << at(a_.by_u) - uv[0] * e_u, at(a_.by_v) - uv[0] * e_v, at(b_.by_u) - uv[1] * e_u,
        at(b_.by_v) - uv[1] * e_v;
    const Vector2d move = slopes.inverse() * residue;
    x -= move;
    if (!(move.norm() > kLastStep)) break;
  }
  return {(x(0) + 1) / 2, (x(1) + 1) / 2};
}

}  // namespace pn
