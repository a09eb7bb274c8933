// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/isotropic/along_curve.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "pn/algebra/precision.hpp"
#include "pn/isotropic/seam.hpp"

namespace pn {
namespace {

/// The roots of D in the local parameter: pairs of any multiplicity, real roots of multiplicity 2q.
struct DoubleRoots {
  struct Real {
    RealBall value;
    int copies;  ///< q
  };
  std::vector<ConjugatePair> pairs;
  std::vector<Real> real;
  int infinite_copies = 0;
};

struct LocalForms {
  SphereCurveForms<RealBall> curve;
  DoubleRoots roots;
};

/// The odd real roots of D next to [0, 1]; nothing stands for infinity.
struct AdjacentRoots {
  std::optional<RealBall> below, above;
};

bool has_odd_real_root(const RootSet& roots) {
  return std::any_of(roots.real.begin(), roots.real.end(),
                     [](const RealRoot& root) { return root.multiplicity % 2 != 0; });
}

AdjacentRoots adjacent_odd_roots(const RootSet& roots) {
  AdjacentRoots adjacent;
  for (const RealRoot& root : roots.real) {
    if (root.multiplicity % 2 == 0) continue;
    if (root.value.is_negative()) {
      adjacent.below = root.value;
    } else if ((root.value - RealBall(1)).is_positive()) {
      if (!adjacent.above) adjacent.above = root.value;
    } else {
      throw Undecided("the place of a real root of D");
    }
  }
  return adjacent;
}

RealBall positive_root(const RealBall& x) {
  if (!x.is_positive()) throw Undecided("the distance of a real root of D");
  return sqrt(x);
}

/// t as a quotient of quadratic forms in the local parameter, which runs from 0 to 1 as t does.
///
/// (s : sigma) moves on the chord between its values at t = 0 and t = 1. With both roots finite
/// these are taken on the unit circle, (sqrt(t - r1), sqrt(r2 - t)) / sqrt(r2 - r1), so that the
/// denominator s^2 + sigma^2 stays between 1/2 and 1; otherwise sigma = 1.
class Substitution {
 public:
  Substitution(const AdjacentRoots& odd, long precision)
      : odd_(odd),
        start_(at(RealBall(0).at_precision(precision))),
        end_(at(RealBall(1).at_precision(precision))) {}

  /// p(t) times the denominator of t to the power `degree`, as a form of twice that degree.
  Form<RealBall> composed(const RationalPolynomial& p, int degree, long precision) const {
    const Form<RealBall> s({start_.s, end_.s - start_.s});
    const Form<RealBall> sigma({start_.sigma, end_.sigma - start_.sigma});
    const Form<RealBall> s2 = s * s, sigma2 = sigma * sigma;
    const bool both = odd_.below && odd_.above;
    const Form<RealBall> numerator = both         ? sigma2 * *odd_.below + s2 * *odd_.above
                                     : odd_.below ? sigma2 * *odd_.below + s2
                                                  : sigma2 * *odd_.above - s2;
    const Form<RealBall> denominator = both ? sigma2 + s2 : sigma2;
    // Horner's scheme in the quotient: after i steps the sum has i factors of either form.
    Form<RealBall> sum = Form<RealBall>::constant(RealBall(p.coefficient(degree), precision));
    Form<RealBall> power = denominator;
    for (int i = degree - 1; i >= 0; --i) {
      sum = sum * numerator + power * RealBall(p.coefficient(i), precision);
      power = power * denominator;
    }
    return sum;
  }

  DoubleRoots roots(const RootSet& in_t, int formal_degree) const;

 private:
  struct Place {
    RealBall s, sigma;
  };

  Place at(const RealBall& t) const {
    if (odd_.below && odd_.above) {
      const RealBall scale = positive_root(*odd_.above - *odd_.below);
      return {positive_root(t - *odd_.below) / scale, positive_root(*odd_.above - t) / scale};
    }
    const RealBall one(1);
    if (odd_.below) return {positive_root(t - *odd_.below), one};
    return {-positive_root(*odd_.above - t), one};
  }

  /// s^2 / sigma^2 at t.
  ComplexBall square_at(const ComplexBall& t) const {
    if (odd_.below && odd_.above) return (t - *odd_.below) / (ComplexBall(*odd_.above) - t);
    return odd_.below ? t - ComplexBall(*odd_.below) : ComplexBall(*odd_.above) - t;
  }

  /// The local parameter of (s : 1).
  ComplexBall local(const ComplexBall& s) const {
    const ComplexBall rise(end_.s - start_.s), fall(end_.sigma - start_.sigma);
    return (s * ComplexBall(start_.sigma) - ComplexBall(start_.s)) / (rise - s * fall);
  }
  /// The local parameter of (1 : 0), where sigma vanishes.
  RealBall local_of_infinity() const { return start_.sigma / (start_.sigma - end_.sigma); }

  AdjacentRoots odd_;
  Place start_, end_;
};

int total_degree(const RootSet& roots) {
  int degree = 0;
  for (const RealRoot& root : roots.real) degree += root.multiplicity;
  for (const ConjugatePair& pair : roots.pairs) degree += 2 * pair.multiplicity;
  return degree;
}

ConjugatePair upper(const ComplexBall& z, int multiplicity) {
  const RealBall imaginary = z.imag();
  if (imaginary.contains_zero()) throw Undecided("a root of D is real or not");
  return {imaginary.is_positive() ? z : conj(z), multiplicity};
}

bool is_same(const std::optional<RealBall>& a, const RealBall& b) { return a && a->overlaps(b); }

DoubleRoots Substitution::roots(const RootSet& in_t, int formal_degree) const {
  DoubleRoots result;
  int below = 0, above = 0;
  for (const RealRoot& root : in_t.real) {
    if (is_same(odd_.below, root.value)) {
      below = root.multiplicity;
      continue;
    }
    if (is_same(odd_.above, root.value)) {
      above = root.multiplicity;
      continue;
    }
    const RealBall square = square_at(ComplexBall(root.value)).real();
    if (square.contains_zero()) throw Undecided("a root of D is real or not");
    const RealBall s = sqrt(abs(square));
    if (square.is_positive()) {
      for (const RealBall& side : {s, -s}) {
        result.real.push_back({local(ComplexBall(side)).real(), root.multiplicity / 2});
      }
    } else {
      result.pairs.push_back(upper(local(ComplexBall(RealBall(0), s)), root.multiplicity));
    }
  }
  for (const ConjugatePair& pair : in_t.pairs) {
    const ComplexBall s = sqrt(square_at(pair.value));
    result.pairs.push_back(upper(local(s), pair.multiplicity));
    result.pairs.push_back(upper(local(-s), pair.multiplicity));
  }
  const int at_infinity = formal_degree - total_degree(in_t);
  if (odd_.below && odd_.above) {
    result.real.push_back({local(ComplexBall(RealBall(0))).real(), below});
    result.real.push_back({local_of_infinity(), above});
    if (at_infinity > 0) {
      result.pairs.push_back(upper(local(ComplexBall(RealBall(0), RealBall(1))), at_infinity));
    }
  } else {
    result.real.push_back({local(ComplexBall(RealBall(0))).real(), odd_.below ? below : above});
    result.infinite_copies = at_infinity;
  }
  return result;
}

DoubleRoots in_t(const RootSet& set, int formal_degree) {
  DoubleRoots roots;
  roots.pairs = set.pairs;
  for (const RealRoot& root : set.real) roots.real.push_back({root.value, root.multiplicity / 2});
  roots.infinite_copies = (formal_degree - total_degree(set)) / 2;
  return roots;
}

Form<RealBall> in_balls(const RationalPolynomial& p, int degree, long precision) {
  std::vector<RealBall> result;
  result.reserve(static_cast<std::size_t>(degree) + 1);
  for (int i = 0; i <= degree; ++i) result.emplace_back(p.coefficient(i), precision);
  return Form<RealBall>(std::move(result));
}

template <class FormOf>
SphereCurveForms<RealBall> forms(const SphereCurve& curve, const CircleFamily& circles,
                                 FormOf&& form_of) {
  const int k = curve.degree(), h = circles.degree();
  SphereCurveForms<RealBall> result;
  for (std::size_t i = 0; i < 3; ++i) {
    result.centre[i] = form_of(curve.centre[i], k);
    result.axis[i] = form_of(circles.axis[i], h);
  }
  result.radius = form_of(curve.radius, k);
  result.denominator = form_of(curve.denominator, k);
  result.level = form_of(circles.level, h);
  return result;
}

LocalForms local_forms(const SphereCurve& curve, const CircleFamily& circles, long precision) {
  const RootSet set = isolate_roots(circles.discriminant(), precision);
  const int formal_degree = 2 * circles.degree();
  if (!has_odd_real_root(set)) {
    return {forms(curve, circles,
                  [&](const RationalPolynomial& p, int n) { return in_balls(p, n, precision); }),
            in_t(set, formal_degree)};
  }
  const Substitution substitution(adjacent_odd_roots(set), precision);
  return {forms(curve, circles,
                [&](const RationalPolynomial& p, int n) {
                  return substitution.composed(p, n, precision);
                }),
          substitution.roots(set, formal_degree)};
}

HermitianMatrix<ComplexBall> hermitian_matrix(const SphereCurveForms<RealBall>& curve) {
  HermitianMatrix<ComplexBall> h;
  const int degree = curve.level.degree();
  h.h00 = h.h01 = h.h11 = Form<ComplexBall>::zero(degree);
  for (int i = 0; i <= degree; ++i) {
    h.h00[i] = ComplexBall(curve.level[i] + curve.axis[2][i]);
    h.h11[i] = ComplexBall(curve.level[i] - curve.axis[2][i]);
    h.h01[i] = ComplexBall(curve.axis[0][i], -curve.axis[1][i]);
  }
  return h;
}

Form<double> midpoint(const Form<RealBall>& form) {
  Form<double> result = Form<double>::zero(form.degree());
  for (int i = 0; i <= form.degree(); ++i) result[i] = form[i].midpoint();
  return result;
}

Form<std::complex<double>> midpoint(const Form<ComplexBall>& form) {
  auto result = Form<std::complex<double>>::zero(form.degree());
  for (int i = 0; i <= form.degree(); ++i) result[i] = form[i].midpoint();
  return result;
}

SphereCurveForms<double> midpoint(const SphereCurveForms<RealBall>& curve) {
  SphereCurveForms<double> result;
  for (std::size_t i = 0; i < 3; ++i) {
    result.centre[i] = midpoint(curve.centre[i]);
    result.axis[i] = midpoint(curve.axis[i]);
  }
  result.radius = midpoint(curve.radius);
  result.denominator = midpoint(curve.denominator);
  result.level = midpoint(curve.level);
  return result;
}

/// For every pair the number of copies of the upper root; the rest are of the lower one.
using RootChoice = std::vector<int>;

template <class C, class Convert>
HalfRoots<C> half_roots(const DoubleRoots& roots, const RootChoice& upper_copies,
                        Convert&& convert) {
  HalfRoots<C> half;
  for (std::size_t i = 0; i < roots.pairs.size(); ++i) {
    const C root = convert(roots.pairs[i].value);
    for (int copy = 0; copy < roots.pairs[i].multiplicity; ++copy) {
      half.complex.push_back(copy < upper_copies[i] ? root : conj(root));
    }
  }
  for (const DoubleRoots::Real& root : roots.real) {
    for (int copy = 0; copy < root.copies; ++copy)
      half.real.push_back(convert(ComplexBall(root.value)));
  }
  half.infinite = roots.infinite_copies;
  return half;
}

/// What a root choice costs: the larger column degree, then the twist of the lines.
struct Cost {
  int degree = std::numeric_limits<int>::max();
  double twist = std::numeric_limits<double>::infinity();
  bool operator<(const Cost& other) const {
    return degree != other.degree ? degree < other.degree : twist < other.twist;
  }
};

/// Compares root choices in doubles.
class RootChoiceSearch {
 public:
  RootChoiceSearch(const LocalForms& local) : roots_(local.roots), curve_(midpoint(local.curve)) {
    const auto h = hermitian_matrix(local.curve);
    matrix_ = {midpoint(h.h00), midpoint(h.h01), midpoint(h.h11)};
  }

  RootChoice best() const {
    return choice_count() <= kMostEnumerated ? best_of_all() : best_of_neighbours();
  }

 private:
  /// Beyond this many choices the search descends from one choice to a better neighbour.
  static constexpr double kMostEnumerated = 64;

  double choice_count() const {
    double count = 1;
    for (const ConjugatePair& pair : roots_.pairs) count *= pair.multiplicity + 1;
    return count;
  }

  Cost cost(const RootChoice& choice) const {
    const auto half = half_roots<std::complex<double>>(
        roots_, choice, [](const ComplexBall& root) { return root.midpoint(); });
    try {
      const IsotropicHypersurface<double> gamma{curve_, spinor_factorization(matrix_, half)};
      return {gamma.spinor.degree[0], twist_energy(gamma)};
    } catch (const Undecided&) {
      return {};  // Doubles cannot follow this choice: it is the last one to take.
    }
  }

  RootChoice best_of_all() const {
    RootChoice best(roots_.pairs.size(), 0);
    Cost least;
    for (int index = 0; index < choice_count(); ++index) {
      const RootChoice choice = numbered(index);
      const Cost candidate = cost(choice);
      if (candidate < least) {
        least = candidate;
        best = choice;
      }
    }
    return best;
  }

  /// The digits of the index, pair by pair.
  RootChoice numbered(int index) const {
    RootChoice choice;
    for (const ConjugatePair& pair : roots_.pairs) {
      choice.push_back(index % (pair.multiplicity + 1));
      index /= pair.multiplicity + 1;
    }
    return choice;
  }

  RootChoice best_of_neighbours() const {
    RootChoice best;
    for (const ConjugatePair& pair : roots_.pairs) best.push_back(pair.multiplicity);
    Cost least = cost(best);
    for (bool improved = true; improved;) {
      improved = false;
      for (std::size_t i = 0; i < best.size(); ++i) {
        RootChoice candidate = best;
        candidate[i] = (candidate[i] + 1) % (roots_.pairs[i].multiplicity + 1);
        const Cost candidate_cost = cost(candidate);
        if (candidate_cost < least) {
          least = candidate_cost;
          best = candidate;
          improved = true;
        }
      }
    }
    return best;
  }

  const DoubleRoots& roots_;
  SphereCurveForms<double> curve_;
  HermitianMatrix<std::complex<double>> matrix_;
};

/// The upper copies of each pair in a remembered choice: the pairs are recognised by their places.
RootChoice recognized(const DoubleRoots& roots, const std::vector<std::complex<double>>& chosen) {
  RootChoice choice(roots.pairs.size(), 0);
  for (const std::complex<double>& root : chosen) {
    const std::complex<double> place(root.real(), std::abs(root.imag()));
    const auto distance = [&](const ConjugatePair& pair) {
      return std::abs(pair.value.midpoint() - place);
    };
    const auto nearest = std::min_element(
        roots.pairs.begin(), roots.pairs.end(),
        [&](const ConjugatePair& a, const ConjugatePair& b) { return distance(a) < distance(b); });
    if (root.imag() > 0) ++choice[static_cast<std::size_t>(nearest - roots.pairs.begin())];
  }
  return choice;
}

SpinorMatrix<ComplexBall> factorize(const LocalForms& local, const RootChoice& choice) {
  return spinor_factorization(
      hermitian_matrix(local.curve),
      half_roots<ComplexBall>(local.roots, choice, [](const ComplexBall& root) { return root; }));
}

}  // namespace

AlongCurve::AlongCurve(SphereCurve curve, CircleFamily circles)
    : curve_(std::move(curve)), circles_(std::move(circles)) {
  at_sufficient_precision([&](long precision) { choose_roots(precision); });
}

void AlongCurve::require_degree(int degree) const {
  if (degree <= kLargestDegree) return;
  throw GeometryError(
      ErrorCode::kDegreeTooHigh,
      "The exact surface would have degree " + std::to_string(degree) +
          " along the spine; CAD systems stop at " + std::to_string(kLargestDegree) + ". " +
          (substituted_
               ? "The quick change of the radius doubles it: let the radius change more slowly, "
                 "or lower the degree of spine and radius (now "
               : "Lower the degree of spine and radius (now ") +
          std::to_string(curve_.degree()) + "), for instance by a cubic B-spline");
}

void AlongCurve::choose_roots(long precision) {
  LocalForms local = local_forms(curve_, circles_, precision);
  substituted_ = local.curve.level.degree() != circles_.degree();
  require_degree(local.curve.denominator.degree() + 2 * ((local.curve.level.degree() + 1) / 2));
  const RootChoice choice = RootChoiceSearch(local).best();
  chosen_roots_.clear();
  for (const std::complex<double>& root :
       half_roots<std::complex<double>>(local.roots, choice, [](const ComplexBall& z) {
         return z.midpoint();
       }).complex) {
    chosen_roots_.push_back(root);
  }
  SpinorMatrix<ComplexBall> spinor = factorize(local, choice);
  degree_ = local.curve.denominator.degree() + 2 * spinor.degree[0];
  require_degree(degree_);
  first_enclosure_ = {std::move(local.curve), std::move(spinor)};
  first_precision_ = precision;
}

IsotropicHypersurface<RealBall> AlongCurve::enclosure(long precision) const {
  if (precision <= first_precision_) return first_enclosure_;
  LocalForms local = local_forms(curve_, circles_, precision);
  const RootChoice choice = recognized(local.roots, chosen_roots_);
  SpinorMatrix<ComplexBall> spinor = factorize(local, choice);
  return {std::move(local.curve), std::move(spinor)};
}

IsotropicHypersurface<double> midpoint(const IsotropicHypersurface<RealBall>& gamma) {
  IsotropicHypersurface<double> result{midpoint(gamma.curve), {}};
  for (int i = 0; i < 2; ++i) {
    for (int j = 0; j < 2; ++j) result.spinor.entry[i][j] = midpoint(gamma.spinor.entry[i][j]);
  }
  result.spinor.degree = gamma.spinor.degree;
  return result;
}

}  // namespace pn
