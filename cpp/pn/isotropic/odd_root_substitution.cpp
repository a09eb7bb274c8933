// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/isotropic/odd_root_substitution.hpp"

#include <algorithm>
#include <optional>

namespace pn {
namespace {

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

/// t as a quotient of quadratic forms in the local parameter.
class Substitution : public LocalParameter {
 public:
  Substitution(const AdjacentRoots& odd, long precision)
      : precision_(precision),
        odd_(odd),
        start_(at(RealBall(0).at_precision(precision))),
        end_(at(RealBall(1).at_precision(precision))) {}

  /// p(t) times the denominator of t to the power `degree`, as a form of twice that degree.
  Form<RealBall> form(const RationalPolynomial& p, int degree) const override {
    const Form<RealBall> s({start_.s, end_.s - start_.s});
    const Form<RealBall> sigma({start_.sigma, end_.sigma - start_.sigma});
    const Form<RealBall> s2 = s * s, sigma2 = sigma * sigma;
    const bool both = odd_.below && odd_.above;
    const Form<RealBall> numerator = both         ? sigma2 * *odd_.below + s2 * *odd_.above
                                     : odd_.below ? sigma2 * *odd_.below + s2
                                                  : sigma2 * *odd_.above - s2;
    const Form<RealBall> denominator = both ? sigma2 + s2 : sigma2;
    // Horner's scheme in the quotient: after i steps the sum has i factors of either form.
    Form<RealBall> sum = Form<RealBall>::constant(RealBall(p.coefficient(degree), precision_));
    Form<RealBall> power = denominator;
    for (int i = degree - 1; i >= 0; --i) {
      sum = sum * numerator + power * RealBall(p.coefficient(i), precision_);
      power = power * denominator;
    }
    return sum;
  }

  bool is_substituted() const override { return true; }
  RealBall local_of(const RealBall& t) const override {
    if (t.is_zero() || (t - RealBall(1)).is_zero()) return t;
    const Place p = at(t);
    return (p.s * start_.sigma - p.sigma * start_.s) /
           (p.sigma * (end_.s - start_.s) - p.s * (end_.sigma - start_.sigma));
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

  long precision_;
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

/// t itself.
class Identity : public LocalParameter {
 public:
  explicit Identity(long precision) : precision_(precision) {}

  Form<RealBall> form(const RationalPolynomial& p, int degree) const override {
    std::vector<RealBall> result;
    result.reserve(static_cast<std::size_t>(degree) + 1);
    for (int i = 0; i <= degree; ++i) result.emplace_back(p.coefficient(i), precision_);
    return Form<RealBall>(std::move(result));
  }
  bool is_substituted() const override { return false; }
  RealBall local_of(const RealBall& t) const override { return t; }

 private:
  long precision_;
};

}  // namespace

LocalFamily local_family(const CircleFamily& circles, long precision) {
  const RootSet set = isolate_roots(circles.discriminant(), precision);
  const int formal_degree = 2 * circles.degree();
  if (!has_odd_real_root(set)) {
    return {std::make_unique<Identity>(precision), in_t(set, formal_degree)};
  }
  auto substitution = std::make_unique<Substitution>(adjacent_odd_roots(set), precision);
  DoubleRoots roots = substitution->roots(set, formal_degree);
  return {std::move(substitution), std::move(roots)};
}

}  // namespace pn
