// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/bezier/conic_points.hpp"

namespace pn {
namespace {

Form<RealBall> ball_form(const RationalPolynomial& p, int degree, long precision) {
  std::vector<RealBall> balls;
  for (const Rational& c : coefficients(p, degree)) balls.emplace_back(c, precision);
  return Form<RealBall>(std::move(balls));
}

}  // namespace

HomogeneousConic<double> midpoint(const HomogeneousConic<RealBall>& x) {
  HomogeneousConic<double> result;
  for (std::size_t c = 0; c < 4; ++c) {
    for (const Form<RealBall>& form : x[c].coefficient) {
      result[c].coefficient.push_back(midpoint(form));
    }
  }
  return result;
}

ConicPoints::ConicPoints(const MovingConic& conic) : ConicPoints(conic, family_of(conic)) {}

ConicPoints::ConicPoints(const MovingConic& conic, const ConicFamily& family)
    : ConicPoints(conic, family, interval_substitution(family, Rational(0), Rational(1))) {}

ConicPoints::ConicPoints(const MovingConic& conic, const ConicFamily& family,
                         const IntervalSubstitution& substitution)
    : family_(substituted(family, substitution)), conics_(family_), substitution_(substitution) {
  for (std::size_t j = 0; j < 3; ++j) {
    frame_degree_[j] = family.degree[j] * substitution.degree;
    for (std::size_t c = 0; c < 4; ++c) {
      frame_[c][j] = substitution(conic.frame[c][j], family.degree[j]);
    }
  }
}

RationalPolynomial ConicPoints::ellipticity() const {
  const Matrix3<RationalPolynomial> minors = adjugate(family_.matrix);
  RationalPolynomial sum;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) sum += frame_[3][i] * minors[i][j] * frame_[3][j];
  }
  for (const SingularFactor& singular : singular_conics(family_).finite) {
    for (int k = 0; k + 1 < singular.type.a; k += 2) {
      sum = exact_quotient(sum, singular.factor * singular.factor);
    }
  }
  return sum;
}

double ConicPoints::t_at(double s) const {
  const Rational at = Rational::exactly(s);
  return (substitution_.numerator(at) / substitution_.denominator(at)).to_double();
}

HomogeneousConic<RealBall> ConicPoints::operator()(long precision) const {
  const QuadraticPoints y = conics_.points(precision);
  HomogeneousConic<RealBall> x;
  for (std::size_t c = 0; c < 4; ++c) {
    x[c].coefficient.assign(3, Form<RealBall>::zero(degree()));
    for (std::size_t i = 0; i < 3; ++i) {
      const Form<RealBall> b = ball_form(frame_[c][i], frame_degree_[i], precision);
      for (std::size_t k = 0; k < 3; ++k) x[c].coefficient[k].add_product(b, y.coordinate[i][k]);
    }
    // u0 u1 has the binomial 2.
    x[c].coefficient[1] = x[c].coefficient[1] * RealBall(0.5);
  }
  const bool is_negative = x[3].coefficient[0](RealBall(0.5)).midpoint() < 0;
  if (is_negative) {
    for (FormInU<RealBall>& component : x) component = -std::move(component);
  }
  return x;
}

}  // namespace pn
