// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/isotropic/root_choice.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "pn/isotropic/seam.hpp"

namespace pn {
namespace {

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
  RootChoiceSearch(const CircleForms<RealBall>& circles, const DoubleRoots& roots)
      : roots_(roots), circles_(midpoint(circles)) {
    const auto h = hermitian_matrix(circles);
    matrix_ = {midpoint(h.h00), midpoint(h.h01), midpoint(h.h11)};
    for (const ConjugatePair& pair : roots_.pairs) pairs_.push_back(pair.value.midpoint());
    for (const DoubleRoots::Real& root : roots_.real) {
      fixed_.real.push_back({root.value.midpoint(), root.copies});
    }
    fixed_.infinite = roots_.infinite_copies;
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

  HalfRoots<std::complex<double>> chosen(const RootChoice& choice) const {
    HalfRoots<std::complex<double>> half = fixed_;
    for (std::size_t i = 0; i < pairs_.size(); ++i) {
      half.pairs.push_back({pairs_[i], choice[i], roots_.pairs[i].multiplicity - choice[i]});
    }
    return half;
  }

  Cost cost(const RootChoice& choice) const {
    try {
      const auto spinor = spinor_factorization(matrix_, chosen(choice));
      return {spinor.degree[0], twist_energy(circles_, spinor)};
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
  std::vector<std::complex<double>> pairs_;  ///< the upper roots
  HalfRoots<std::complex<double>> fixed_;    ///< what leaves no choice
  CircleForms<double> circles_;
  HermitianMatrix<std::complex<double>> matrix_;
};

}  // namespace

HermitianMatrix<ComplexBall> hermitian_matrix(const CircleForms<RealBall>& circles) {
  HermitianMatrix<ComplexBall> h;
  const int degree = circles.level.degree();
  h.h00 = h.h01 = h.h11 = Form<ComplexBall>::zero(degree);
  for (int i = 0; i <= degree; ++i) {
    h.h00[i] = ComplexBall(circles.level[i] + circles.axis[2][i]);
    h.h11[i] = ComplexBall(circles.level[i] - circles.axis[2][i]);
    h.h01[i] = ComplexBall(circles.axis[0][i], -circles.axis[1][i]);
  }
  return h;
}

HalfRoots<ComplexBall> half_roots(const DoubleRoots& roots, const RootChoice& choice) {
  HalfRoots<ComplexBall> half;
  for (std::size_t i = 0; i < roots.pairs.size(); ++i) {
    const auto& [root, multiplicity] = roots.pairs[i];
    half.pairs.push_back({root, choice[i], multiplicity - choice[i]});
  }
  for (const DoubleRoots::Real& root : roots.real) {
    half.real.push_back({ComplexBall(root.value), root.copies});
  }
  half.infinite = roots.infinite_copies;
  return half;
}

RootChoice best_root_choice(const CircleForms<RealBall>& circles, const DoubleRoots& roots) {
  return RootChoiceSearch(circles, roots).best();
}

RootChoice recognized(const DoubleRoots& roots, const std::vector<std::complex<double>>& chosen) {
  RootChoice choice(roots.pairs.size(), 0);
  for (const std::complex<double>& root : chosen) {
    const auto distance = [&](const ConjugatePair& pair) {
      return std::abs(pair.value.midpoint() - root);
    };
    const auto nearest = std::min_element(
        roots.pairs.begin(), roots.pairs.end(),
        [&](const ConjugatePair& a, const ConjugatePair& b) { return distance(a) < distance(b); });
    ++choice[static_cast<std::size_t>(nearest - roots.pairs.begin())];
  }
  return choice;
}

}  // namespace pn
