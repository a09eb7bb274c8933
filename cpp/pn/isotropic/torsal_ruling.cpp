// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/isotropic/torsal_ruling.hpp"

#include <cmath>

#include "pn/algebra/roots.hpp"
#include "pn/isotropic/along_rulings.hpp"
#include "pn/isotropic/seam.hpp"

namespace pn {
namespace {

/// A quadratic form q00 u0^2 + 2 q01 u0 u1 + q11 u1^2.
struct Quadratic {
  RealBall q00, q01, q11;

  double size() const {
    return std::abs(q00.midpoint()) + std::abs(q01.midpoint()) + std::abs(q11.midpoint());
  }
};

Quadratic value_at(const FormInU<RealBall>& form, const RealBall& t) {
  return {form.coefficient[0](t), form.coefficient[1](t), form.coefficient[2](t)};
}

using Direction = std::array<RealBall, 2>;

double cosine_squared(const Direction& u, const Eigen::Vector2d& near) {
  const Eigen::Vector2d v(u[0].midpoint(), u[1].midpoint());
  return std::pow(v.normalized().dot(near.normalized()), 2);
}

/// The zero of the form that is nearer to a direction. Of the two ways to write it, the one whose
/// coordinates do not cancel is taken.
Direction zero_near(const Quadratic& q, const Eigen::Vector2d& near) {
  const RealBall discriminant = q.q01 * q.q01 - q.q00 * q.q11;
  if (!discriminant.is_positive()) throw Undecided("the normal of a torsal ruling");
  const RealBall root = sqrt(discriminant);
  const RealBall larger = q.q01.midpoint() < 0 ? q.q01 - root : q.q01 + root;
  const Direction a = {-larger, q.q00}, b = {q.q11, -larger};
  return cosine_squared(a, near) > cosine_squared(b, near) ? a : b;
}

/// A place near a torsal ruling where the tangent plane does turn, but little.
constexpr double kAside = 1e-4;

/// The parameter u of the normal of the ruling at t.
Direction common_normal(const SpinorMatrix<ComplexBall>& spinor,
                        const RulingForms<RealBall>& rulings, const RealBall& t) {
  const IsotropicVector<RealBall> w = isotropic_vector<RealBall>(spinor);
  const Quadratic motion =
      value_at(contracted(rulings.point_wronskian, rulings.radius_wronskian, w), t);
  const Quadratic turn = value_at(contracted(rulings.axis_slope, rulings.level_slope, w), t);
  const double place = t.midpoint();
  const double aside = place < 0.5 ? place + kAside : place - kAside;
  const auto estimate = std::get<RulingForms<double>>(midpoint(Carrier<RealBall>(rulings)));
  const Eigen::Vector2d near =
      parameter_of(value_at(midpoint(spinor), aside), band_normal(estimate, aside, 0.5));
  return zero_near(motion.size() > turn.size() ? motion : turn, near);
}

SpinorMatrix<ComplexBall> pinched(const SpinorMatrix<ComplexBall>& a, const Direction& e0,
                                  const RealBall& t) {
  const ComplexBall x(e0[0]), y(e0[1]);
  const Form<ComplexBall> linear({ComplexBall(-t), ComplexBall(1.0)});
  SpinorMatrix<ComplexBall> result;
  const int degree = a.degree[0];
  for (int i = 0; i < 2; ++i) {
    const Form<ComplexBall> first = a.entry[i][0].elevated(degree),
                            second = a.entry[i][1].elevated(degree);
    result.entry[i][0] = (second * x - first * y) * linear;
    result.entry[i][1] = first * x + second * y;
  }
  result.degree = {degree + 1, degree};
  return result;
}

}  // namespace

SpinorMatrix<ComplexBall> pinched_at_torsal_rulings(SpinorMatrix<ComplexBall> spinor,
                                                    const RulingForms<RealBall>& rulings) {
  for (const RealBall& t : rulings.torsal_roots) {
    spinor = pinched(spinor, common_normal(spinor, rulings, t), t);
  }
  return spinor;
}

}  // namespace pn
