// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/conics/rational_conic_family.hpp"

#include <algorithm>
#include <random>

#include "pn/algebra/precision.hpp"
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

/// The steps over Q, by a few choices where nothing else is free; the one of least degree.
RationalSteps best_rational_steps(const ConicFamily& family, const SingularConics& singular,
                                  int least_degree) {
  constexpr int kAttempts = 8;
  const auto steps = [&](const ChooseLattice& choose) {
    return rational_steps(family, singular, choose, MultipleIrrational::kTakeBoth);
  };
  RationalSteps best = steps(lower_degrees);
  const auto is_final = [&] {
    return best.choices == 0 || !best.left.empty() || highest(best.lattice) == least_degree;
  };
  std::mt19937 generator;
  const auto any = [&](const RationalLattice&, const RationalLattice&) {
    return static_cast<int>(generator() % 2);
  };
  for (int attempt = 1; attempt < kAttempts && !is_final(); ++attempt) {
    RationalSteps other = steps(any);
    if (highest(other.lattice) < highest(best.lattice)) best = std::move(other);
  }
  return best;
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

/// Written with the degree n in t.
template <class T>
void elevate(Matrix3<Form<T>>& points, int degree, const Vector3<int>& row_degree) {
  for (std::size_t i = 0; i < 3; ++i) {
    for (Form<T>& entry : points[i]) entry = entry.elevated(std::max(degree - row_degree[i], -1));
  }
}

/// The choice number `attempt`: the first lines, then with another one at the last real place,
/// which changes the parity, then any.
LineChoice line_choice(const std::vector<LinePair>& pairs, unsigned attempt) {
  LineChoice choice;
  for (const LinePair& pair : pairs) choice.push_back(pair.multiplicity);
  if (attempt == 1) {
    const auto real = std::find_if(pairs.rbegin(), pairs.rend(), [](const LinePair& pair) {
      return pair.kind == LinePair::Kind::kRealLines;
    });
    if (real != pairs.rend()) --choice[static_cast<std::size_t>(pairs.rend() - real) - 1];
  } else if (attempt > 1) {
    std::mt19937 generator(attempt);
    for (int& conditions : choice) {
      conditions = static_cast<int>(generator() % static_cast<unsigned>(conditions + 1));
    }
  }
  return choice;
}

struct DecidedChoice {
  LineChoice choice;
  int degree;
};

/// A choice of lines of degree m, or m + 1 if the parity is odd. Throws Undecided.
DecidedChoice best_line_choice(const RationalSteps& steps, const LineConditions& conditions) {
  constexpr unsigned kAttempts = 32;
  const int m = conditions.least_degree();
  const LineChoice first = line_choice(conditions.pairs(), 0);
  if (conditions.balanced_points(first)) return {first, m};
  const bool is_odd = !conditions.has_real_places() && parity_of_splitting(steps.lattice, m) == 1;
  for (unsigned attempt = 0; attempt < kAttempts; ++attempt) {
    const LineChoice choice = line_choice(conditions.pairs(), attempt);
    if (is_odd ? conditions.unbalanced_points(choice) : conditions.balanced_points(choice)) {
      return {choice, is_odd ? m + 1 : m};
    }
  }
  throw Undecided("the degree of a family of conics");
}

}  // namespace

RationalConicFamily::RationalConicFamily(const ConicFamily& family) {
  if (const auto interval = interval_without_real_points(family)) {
    refuse_without_real_points(*interval);
  }
  const SingularConics singular = singular_conics(family);
  least_degree_ = pn::least_degree(family, singular);
  RationalSteps steps = best_rational_steps(family, singular, least_degree_);
  if (!steps.left.empty()) {
    at_sufficient_precision([&](long precision) { choose_lines(steps, precision); });
    return;
  }
  if (highest(steps.lattice) > least_degree_ && steps.double_points > 0 &&
      choose_lines_for_lower_degree(family, singular, highest(steps.lattice))) {
    return;
  }
  degree_ = highest(steps.lattice);
  if (degree_ > least_degree_) {
    rational_points_ = points_of_unbalanced_lattice(unbalanced(steps.lattice));
    elevate(*rational_points_, degree_, steps.lattice.row_degree());
  }
  steps_ = std::make_shared<const RationalSteps>(std::move(steps));
}

void RationalConicFamily::choose_lines(const RationalSteps& steps, long precision) {
  const LineConditions conditions(steps, line_pairs(steps, precision), precision);
  const DecidedChoice best = best_line_choice(steps, conditions);
  chosen_ = places_of(conditions.pairs(), best.choice);
  degree_ = best.degree;
  steps_ = std::make_shared<const RationalSteps>(steps);
}

/// Both irrational lines at once are rational, but one of them may give a lower degree. No theorem
/// says so, so one precision must do.
bool RationalConicFamily::choose_lines_for_lower_degree(const ConicFamily& family,
                                                        const SingularConics& singular,
                                                        int degree) {
  try {
    choose_lines(rational_steps(family, singular, lower_degrees, MultipleIrrational::kLeave),
                 2 * kLeastPrecision);
    if (degree_ < degree) return true;
  } catch (const Undecided&) {
    // No choice of lower degree was proved; the rational one stands.
  }
  chosen_.clear();
  return false;
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
  QuadraticPoints result =
      chosen_.empty() ? points_of_constant(precision) : points_of_choice(precision);
  elevate(result.coordinate, degree_, steps_->lattice.row_degree());
  return result;
}

QuadraticPoints RationalConicFamily::points_of_choice(long precision) const {
  const LineConditions conditions(*steps_, line_pairs(*steps_, precision), precision);
  const LineChoice choice = recognized(conditions.pairs(), chosen_);
  const auto points = degree_ == least_degree_ ? conditions.balanced_points(choice)
                                               : conditions.unbalanced_points(choice);
  if (!points) throw Undecided("the points of a family of conics");
  return *points;
}

QuadraticPoints RationalConicFamily::points_of_constant(long precision) const {
  const RationalLattice& lattice = steps_->lattice;
  Matrix3<RealBall> conic;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      conic[i][j] = RealBall(lattice.conic()[i][j].coefficient(0), precision);
    }
  }
  const auto columns = points_of_constant_conic(conic);
  if (!columns) throw Undecided("the signs of a constant conic");
  QuadraticPoints result{{}, degree_};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      const Form<Rational> w =
          form(lattice.basis()[i][j], lattice.degree()[j] - lattice.row_degree()[i]);
      std::vector<RealBall> balls;
      for (const Rational& c : w.coefficients()) balls.emplace_back(c, precision);
      const Form<RealBall> column(std::move(balls));
      for (std::size_t k = 0; k < 3; ++k) {
        result.coordinate[i][k] += column * (*columns)[j][k];
      }
    }
  }
  return result;
}

}  // namespace pn
