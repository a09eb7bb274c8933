// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/conics/rational_conic_family.hpp"

#include <algorithm>

#include "pn/algebra/precision.hpp"
#include "pn/algebra/rational_point_on_conic.hpp"
#include "pn/algebra/roots.hpp"
#include "pn/conics/conic_normal_form.hpp"
#include "pn/conics/nappe_transport.hpp"

namespace pn {
namespace {

using Polynomial = RationalPolynomial;

/// The columns of a lattice, by degree.
Vector3<std::size_t> ascending(const Vector3<int>& degree) {
  Vector3<std::size_t> order = {0, 1, 2};
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t i, std::size_t j) { return degree[i] < degree[j]; });
  return order;
}

int highest(const RationalLattice& lattice) {
  return *std::max_element(lattice.degree().begin(), lattice.degree().end());
}

int squares_of_degrees(const RationalLattice& lattice) {
  const Vector3<int>& e = lattice.degree();
  return e[0] * e[0] + e[1] * e[1] + e[2] * e[2];
}

/// The lattice of lower degrees.
int lower_degrees(const RationalLattice& a, const RationalLattice& b) {
  return squares_of_degrees(a) <= squares_of_degrees(b) ? 0 : 1;
}

Vector3<Polynomial> lowest_column(const RationalLattice& lattice) {
  const std::size_t low = ascending(lattice.degree()).front();
  const auto& p = lattice.basis();
  return {p[0][low], p[1][low], p[2][low]};
}

/// At each place the line on which the point does not lie, as long as its degree stays below m + 1.
ChooseLattice away_from(const Vector3<Polynomial>& point, int m) {
  return [=](const RationalLattice& a, const RationalLattice& b) {
    const int degree_in_a = in_lattice(a, point).degree, degree_in_b = in_lattice(b, point).degree;
    if (degree_in_a == degree_in_b) return lower_degrees(a, b);
    const int farther = degree_in_a > degree_in_b ? 0 : 1;
    return std::max(degree_in_a, degree_in_b) <= m ? farther : 1 - farther;
  };
}

/// The steps over Q. If they lead to a > 0 their lowest column tells how to turn the choices
/// (line_conditions.hpp); conjugate zeros turn together here.
RationalSteps least_rational_steps(const ConicFamily& family, const SingularConics& singular,
                                   int m) {
  RationalSteps steps = rational_steps(family, singular, lower_degrees, Leave::kOddIrrational);
  if (!steps.left.empty() || steps.choices == 0 || highest(steps.lattice) == m) return steps;
  RationalSteps turned = rational_steps(
      family, singular, away_from(lowest_column(steps.lattice), m), Leave::kOddIrrational);
  return highest(turned.lattice) < highest(steps.lattice) ? turned : steps;
}

Form<Rational> form(const Polynomial& p, int degree) {
  return degree < 0 ? Form<Rational>() : Form<Rational>(coefficients(p, degree));
}

UnbalancedLattice<Rational> unbalanced(const RationalLattice& lattice) {
  const auto [low, middle, high] = ascending(lattice.degree());
  const Vector3<int>& e = lattice.degree();
  const auto& q = lattice.conic();
  UnbalancedLattice<Rational> result;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vector3<std::size_t> order = {low, middle, high};
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t j = order[k];
      result.basis[i][k] = form(lattice.basis()[i][j], e[j] - lattice.row_degree()[i]);
    }
  }
  result.alpha = q[low][high].coefficient(0);
  result.beta = q[middle][middle].coefficient(0);
  result.q12 = form(q[middle][high], e[middle] + e[high] + lattice.twist());
  result.q22 = form(q[high][high], 2 * e[high] + lattice.twist());
  return result;
}

Matrix3<Rational> constant_conic(const RationalLattice& lattice) {
  Matrix3<Rational> conic;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) conic[i][j] = lattice.conic()[i][j].coefficient(0);
  }
  return conic;
}

/// Points of the lattice from those of a constant conic; `number` makes a T of a rational number.
template <class T, class Number>
Matrix3<Form<T>> times_columns(const RationalLattice& lattice, const Matrix3<T>& columns,
                               const Number& number) {
  Matrix3<Form<T>> points;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      std::vector<T> column;
      const int degree = lattice.degree()[j] - lattice.row_degree()[i];
      const Form<Rational> exact = form(lattice.basis()[i][j], degree);
      for (const Rational& c : exact.coefficients()) column.push_back(number(c));
      for (std::size_t k = 0; k < 3; ++k) points[i][k] += Form<T>(column) * columns[j][k];
    }
  }
  return points;
}

/// Of a lattice that is rational to the end, if they are over Q.
std::optional<Matrix3<Form<Rational>>> points_over_rationals(const RationalLattice& lattice,
                                                             int m) {
  if (highest(lattice) > m) return points_of_unbalanced_lattice(unbalanced(lattice));
  const Matrix3<Rational> conic = constant_conic(lattice);
  const PointOnConic found = rational_point_on_conic(conic);
  if (found.points != RationalPoints::kExist) return std::nullopt;
  return times_columns(lattice, points_of_constant_conic(conic, found.point),
                       [](const Rational& x) { return x; });
}

/// Written with the degree n in t.
template <class T>
void elevate(Matrix3<Form<T>>& points, int degree, const Vector3<int>& row_degree) {
  for (std::size_t i = 0; i < 3; ++i) {
    for (Form<T>& entry : points[i]) entry = entry.elevated(std::max(degree - row_degree[i], -1));
  }
}

std::optional<QuadraticPoints> points_of(const LineConditions& conditions, const LineChoice& choice,
                                         int splitting) {
  return splitting == 0 ? conditions.balanced_points(choice)
                        : conditions.unbalanced_points(choice, splitting);
}

/// A choice of lines and its points, which prove the degree.
struct ProvedChoice {
  LineChoice choice;
  QuadraticPoints points;
};

ProvedChoice proved(const LineConditions& conditions, const LineChoice& choice, int splitting) {
  auto points = points_of(conditions, choice, splitting);
  if (!points) throw Undecided("the degree of a family of conics");
  return {choice, std::move(*points)};
}

SingularConics at_real_places(const SingularConics& singular) {
  SingularConics real{{}, singular.at_infinity};
  for (const SingularFactor& part : singular.finite) {
    for (const Polynomial& factor : irreducible_factors(part.factor)) {
      if (numbers_between_real_roots(factor).size() > 1) real.finite.push_back({factor, part.type});
    }
  }
  return real;
}

/// Steps at nonreal places do not change the parity, but make long numbers of short ones. So they
/// are left out, unless that could change the choices at real ones.
int parity_of(const ConicFamily& family, const SingularConics& singular, const RationalSteps& steps,
              int m) {
  const RationalSteps real =
      rational_steps(family, at_real_places(singular), lower_degrees, Leave::kOddIrrational);
  return parity_of_splitting(real.choices == 0 ? real.lattice : steps.lattice, m);
}

/// Where a place of odd multiplicity has irrational lines: a = 0, or a = 1 with odd parity. Throws
/// Undecided.
ProvedChoice balanced_choice(const ConicFamily& family, const SingularConics& singular,
                             const RationalSteps& steps, const LineConditions& conditions) {
  LineChoice first;
  for (const LinePair& pair : conditions.pairs()) first.push_back(pair.multiplicity);
  if (const auto points = conditions.balanced_points(first)) return {first, *points};
  const int parity = conditions.has_real_lines()
                         ? 0
                         : parity_of(family, singular, steps, conditions.least_degree());
  if (parity == 1) {
    if (const auto points = conditions.unbalanced_points(first, 1)) return {first, *points};
  }
  const TurnedChoice turned = conditions.turned_away(first, conditions.lowest_column(first));
  return proved(conditions, turned.choice, parity);
}

/// Where a curve runs on the conics, over Q: the least a of all choices at single zeros, or nothing
/// if it is not below `splitting`. Throws Undecided.
std::optional<ProvedChoice> choice_away_from(const LatticePoint& curve,
                                             const LineConditions& conditions, int splitting) {
  const PointInBalls w = conditions.in_balls(curve);
  const TurnedChoice turned = conditions.turned_away(conditions.choice_through(w), w);
  if (turned.splitting >= splitting) return std::nullopt;
  return proved(conditions, turned.choice, turned.splitting);
}

}  // namespace

RationalConicFamily::RationalConicFamily(const ConicFamily& family) {
  if (const auto interval = interval_without_real_points(family)) {
    refuse_without_real_points(*interval);
  }
  const SingularConics singular = singular_conics(family);
  least_degree_ = pn::least_degree(family, singular);
  RationalSteps steps = least_rational_steps(family, singular, least_degree_);
  if (!steps.left.empty()) {
    choose_irrational_lines(family, singular, std::move(steps));
  } else if (highest(steps.lattice) == least_degree_ ||
             !choose_lines_for_lower_degree(family, singular, steps)) {
    set_rational_steps(std::move(steps));
  }
}

/// No point is rational. The parity is free if any place has real lines, be they rational.
void RationalConicFamily::choose_irrational_lines(const ConicFamily& family,
                                                  const SingularConics& singular,
                                                  RationalSteps steps) {
  const auto choose = [&](RationalSteps from) {
    steps_ = std::make_shared<const RationalSteps>(std::move(from));
    at_sufficient_precision([&](long precision) {
      const LineConditions conditions(*steps_, line_pairs(*steps_, precision), precision);
      ProvedChoice found = balanced_choice(family, singular, *steps_, conditions);
      in_balls_ = {std::move(found.points), precision, places_of(conditions.pairs(), found.choice)};
    });
    degree_ = in_balls_->points.degree;
  };
  const bool may_be_turned = steps.choices + steps.double_points > 0;
  choose(std::move(steps));
  if (degree_ == least_degree_ || !may_be_turned) return;
  RationalSteps all = rational_steps(family, singular, lower_degrees, Leave::kEveryChoice);
  const bool has_real_lines = at_sufficient_precision([&](long precision) {
    return LineConditions(all, line_pairs(all, precision), precision).has_real_lines();
  });
  if (has_real_lines) choose(std::move(all));
}

/// Other lines at single zeros than at their conjugates may give a lower degree, but no longer over
/// Q.
bool RationalConicFamily::choose_lines_for_lower_degree(const ConicFamily& family,
                                                        const SingularConics& singular,
                                                        const RationalSteps& rational) {
  if (rational.choices + rational.double_points == 0) return false;
  auto steps = std::make_shared<const RationalSteps>(
      rational_steps(family, singular, lower_degrees, Leave::kEveryChoice));
  const LatticePoint curve = in_lattice(steps->lattice, lowest_column(rational.lattice));
  return at_sufficient_precision([&](long precision) {
    const LineConditions conditions(*steps, line_pairs(*steps, precision), precision);
    auto found = choice_away_from(curve, conditions, highest(rational.lattice) - least_degree_);
    if (!found) return false;
    in_balls_ = {std::move(found->points), precision, places_of(conditions.pairs(), found->choice)};
    steps_ = steps;
    degree_ = in_balls_->points.degree;
    return true;
  });
}

void RationalConicFamily::set_rational_steps(RationalSteps steps) {
  degree_ = highest(steps.lattice);
  rational_points_ = points_over_rationals(steps.lattice, least_degree_);
  if (rational_points_) elevate(*rational_points_, degree_, steps.lattice.row_degree());
  steps_ = std::make_shared<const RationalSteps>(std::move(steps));
}

QuadraticPoints RationalConicFamily::points(long precision) const {
  if (rational_points_) {
    QuadraticPoints result{{}, degree_};
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t k = 0; k < 3; ++k) {
        std::vector<RealBall> balls;
        for (const Rational& c : (*rational_points_)[i][k].coefficients()) {
          balls.emplace_back(c, precision);
        }
        result.coordinate[i][k] = Form<RealBall>(std::move(balls));
      }
    }
    return result;
  }
  QuadraticPoints result = in_balls_ ? points_of_choice(precision) : points_of_constant(precision);
  elevate(result.coordinate, degree_, steps_->lattice.row_degree());
  return result;
}

QuadraticPoints RationalConicFamily::points_of_choice(long precision) const {
  if (precision <= in_balls_->precision) return in_balls_->points;
  const LineConditions conditions(*steps_, line_pairs(*steps_, precision), precision);
  const auto points = points_of(conditions, recognized(conditions.pairs(), in_balls_->chosen),
                                degree_ - least_degree_);
  if (!points) throw Undecided("the points of a family of conics");
  return *points;
}

QuadraticPoints RationalConicFamily::points_of_constant(long precision) const {
  const RationalLattice& lattice = steps_->lattice;
  const Matrix3<Rational> exact = constant_conic(lattice);
  Matrix3<RealBall> conic;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) conic[i][j] = RealBall(exact[i][j], precision);
  }
  const auto columns = points_of_constant_conic(conic);
  if (!columns) throw Undecided("the signs of a constant conic");
  return {
      times_columns(lattice, *columns, [&](const Rational& x) { return RealBall(x, precision); }),
      degree_};
}

}  // namespace pn
