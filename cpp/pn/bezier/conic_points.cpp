// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/bezier/conic_points.hpp"

#include <algorithm>

#include "pn/algebra/roots.hpp"

namespace pn {
namespace {

Form<RealBall> ball_form(const RationalPolynomial& p, int degree, long precision) {
  std::vector<RealBall> balls;
  for (const Rational& c : coefficients(p, degree)) balls.emplace_back(c, precision);
  return Form<RealBall>(std::move(balls));
}

/// b.y, whose entries have the degrees of y and of b up to that of the sum.
FormInU<RealBall> contracted(const Vector3<RationalPolynomial>& b, const Vector3<int>& degree,
                             const QuadraticPoints& y, long precision) {
  FormInU<RealBall> sum;
  sum.coefficient.assign(3, Form<RealBall>());
  for (std::size_t i = 0; i < 3; ++i) {
    const Form<RealBall> factor = ball_form(b[i], degree[i], precision);
    for (std::size_t k = 0; k < 3; ++k) {
      sum.coefficient[k].add_product(factor, y.coordinate[i][k]);
    }
  }
  // u0 u1 has the binomial 2.
  sum.coefficient[1] = sum.coefficient[1] * RealBall(0.5);
  return sum;
}

RationalPolynomial product(const Vector3<RationalPolynomial>& a,
                           const Matrix3<RationalPolynomial>& m,
                           const Vector3<RationalPolynomial>& b) {
  RationalPolynomial sum;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) sum += a[i] * m[i][j] * b[j];
  }
  return sum;
}

}  // namespace

FormInU<double> midpoint(const FormInU<RealBall>& form) {
  FormInU<double> result;
  for (const Form<RealBall>& c : form.coefficient) result.coefficient.push_back(midpoint(c));
  return result;
}

ConicForms<double> midpoint(const ConicForms<RealBall>& x) {
  return {{midpoint(x.point[0]), midpoint(x.point[1]), midpoint(x.point[2]), midpoint(x.point[3])},
          midpoint(x.cut)};
}

ConicPoints::ConicPoints(const ConicSpan& span) : ConicPoints(span, family_of(span.conic)) {}

ConicPoints::ConicPoints(const ConicSpan& span, const ConicFamily& family)
    : ConicPoints(span, family, interval_substitution(family, Rational(0), Rational(1))) {}

ConicPoints::ConicPoints(const ConicSpan& span, const ConicFamily& family,
                         const IntervalSubstitution& substitution)
    : family_(substituted(family, substitution)),
      conics_(family_),
      substitution_(substitution),
      cut_(span.cut) {
  int cut_degree = 0;
  for (std::size_t j = 0; j < 3; ++j) {
    frame_degree_[j] = family.degree[j] * substitution.degree;
    for (std::size_t c = 0; c < 4; ++c) {
      frame_[c][j] = substitution(span.conic.frame[c][j], family.degree[j]);
    }
    if (cut_) cut_degree = std::max(cut_degree, (*cut_)[j].degree() - family.degree[j]);
  }
  if (!cut_) return;
  for (std::size_t j = 0; j < 3; ++j) {
    (*cut_)[j] = substitution((*cut_)[j], cut_degree + family.degree[j]);
  }
  cut_degree_ = cut_degree * substitution.degree;
}

LineInvariants ConicPoints::invariants() const {
  const Matrix3<RationalPolynomial> minors = adjugate(family_.matrix);
  RationalPolynomial squares(1L);
  for (const SingularFactor& singular : singular_conics(family_).finite) {
    for (int k = 0; k + 1 < singular.type.a; k += 2) squares *= singular.factor * singular.factor;
  }
  const auto invariant = [&](const Vector3<RationalPolynomial>& a,
                             const Vector3<RationalPolynomial>& b) {
    return exact_quotient(product(a, minors, b), squares);
  };
  const Vector3<RationalPolynomial>& infinity = frame_[3];
  if (!cut_) return {invariant(infinity, infinity), {}, {}};
  return {invariant(infinity, infinity), invariant(*cut_, infinity), invariant(*cut_, *cut_)};
}

bool ConicPoints::has_rational_ends() const {
  const std::vector<SquarefreeFactor> factors = squarefree_factorization(invariants().cut);
  return std::all_of(factors.begin(), factors.end(),
                     [](const SquarefreeFactor& factor) { return factor.multiplicity % 2 == 0; });
}

double ConicPoints::t_at(double s) const {
  const Rational at = Rational::exactly(s);
  return (substitution_.numerator(at) / substitution_.denominator(at)).to_double();
}

ConicForms<RealBall> ConicPoints::operator()(long precision) const {
  const QuadraticPoints y = conics_.points(precision);
  ConicForms<RealBall> x;
  for (std::size_t c = 0; c < 4; ++c) {
    x.point[c] = contracted(frame_[c], frame_degree_, y, precision);
  }
  if (cut_) {
    Vector3<int> degree = frame_degree_;
    for (int& d : degree) d += cut_degree_;
    x.cut = contracted(*cut_, degree, y, precision);
  }
  const RealBall sign = definite_form(x, RealBall(0.5))[0];
  if (sign.contains_zero()) throw Undecided("the sign of a conic's weight");
  if (sign.is_negative()) {
    for (FormInU<RealBall>& component : x.point) component = -std::move(component);
    x.cut = -std::move(x.cut);
  }
  return x;
}

}  // namespace pn
