// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/algebra/roots.hpp"

#include <arb_fmpz_poly.h>
#include <arb_poly.h>
#include <flint/fmpz_poly.h>
#include <flint/fmpz_poly_factor.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <optional>

#include "pn/algebra/bernstein.hpp"
#include "pn/algebra/common_factor.hpp"
#include "pn/algebra/form.hpp"

namespace pn {
namespace {

/// A vector of complex numbers for FLINT's functions.
class AcbVector {
 public:
  explicit AcbVector(slong size) : data_(_acb_vec_init(size)), size_(size) {}
  AcbVector(const AcbVector&) = delete;
  AcbVector& operator=(const AcbVector&) = delete;
  ~AcbVector() { _acb_vec_clear(data_, size_); }
  acb_ptr data() { return data_; }
  acb_ptr operator[](slong i) { return data_ + i; }

 private:
  acb_ptr data_;
  slong size_;
};

/// Simultaneous iteration (Durand and Kerner) in doubles: starting values only, nothing is claimed.
std::vector<std::complex<double>> approximate_roots(const RationalPolynomial& p) {
  const int n = p.degree();
  const Rational lead = p.coefficient(n);
  std::vector<double> monic;
  double bound = 0;
  for (int i = 0; i <= n; ++i) {
    monic.push_back((p.coefficient(i) / lead).to_double());
    if (i < n) bound = std::max(bound, std::pow(std::abs(monic.back()), 1.0 / (n - i)));
  }
  std::vector<std::complex<double>> z;
  for (int i = 0; i < n; ++i) z.push_back(std::polar(bound, (2 * M_PI * i + 0.7) / n));
  constexpr int kMostIterations = 100;
  for (int iteration = 0; iteration < kMostIterations; ++iteration) {
    double largest_step = 0;
    for (int i = 0; i < n; ++i) {
      std::complex<double> value = 1, others = 1;
      for (int j = n - 1; j >= 0; --j) value = value * z[i] + monic[j];
      for (int j = 0; j < n; ++j) {
        if (j != i) others *= z[i] - z[j];
      }
      const std::complex<double> step = value / others;
      if (!std::isfinite(std::abs(step))) return z;
      z[i] -= step;
      largest_step = std::max(largest_step, std::abs(step) / std::abs(z[i]));
    }
    if (largest_step < 1e-12) break;
  }
  return z;
}

RealBall ball(const arb_struct* x, long precision) {
  ArbBall result;
  arb_set(result.get(), x);
  return RealBall(result, precision);
}

/// The n isolated roots of this multiplicity, sorted into real ones and pairs.
RootSet sorted_out(AcbVector& roots, slong n, int multiplicity, long precision) {
  RootSet set;
  for (slong i = 0; i < n; ++i) {
    const RealBall real = ball(acb_realref(roots[i]), precision);
    if (arb_is_zero(acb_imagref(roots[i]))) {
      set.real.push_back({real, multiplicity});
    } else if (arb_is_positive(acb_imagref(roots[i]))) {
      const RealBall imaginary = ball(acb_imagref(roots[i]), precision);
      set.pairs.push_back({ComplexBall(real, imaginary), multiplicity});
    }
  }
  return set;
}

/// Bounds in doubles are rounded a few times.
constexpr double kUpwards = 1 + 1e-15;

RealBall at_precision(const RealBall& x, long bits) { return x.at_precision(bits); }
ComplexBall at_precision(const ComplexBall& z, long bits) {
  return {z.real().at_precision(bits), z.imag().at_precision(bits)};
}
RealBall centre(const RealBall& x) { return x.centre(); }
ComplexBall centre(const ComplexBall& z) { return {z.real().centre(), z.imag().centre()}; }
double magnitude_upper(const RealBall& x) { return x.magnitude_upper(); }
double magnitude_upper(const ComplexBall& z) {
  return std::hypot(z.real().magnitude_upper(), z.imag().magnitude_upper()) * kUpwards;
}

/// At least one root of a polynomial is as near to a point.
template <class Ball>
struct Inclusion {
  Ball centre;
  double radius;
};

/// A real polynomial that is evaluated with many bits, for a value of few.
class AccuratePolynomial {
 public:
  AccuratePolynomial(const RationalPolynomial& p, slong precision) : precision_(precision) {
    arb_poly_init(value_);
    arb_poly_set_fmpq_poly(value_, p.flint(), precision);
  }
  AccuratePolynomial(const AccuratePolynomial&) = delete;
  AccuratePolynomial& operator=(const AccuratePolynomial&) = delete;
  ~AccuratePolynomial() { arb_poly_clear(value_); }

  RealBall operator()(const RealBall& x) const {
    ArbBall result;
    arb_poly_evaluate(result.get(), value_, x.arb().get(), precision_);
    return RealBall(std::move(result), kBitsOfValue);
  }
  ComplexBall operator()(const ComplexBall& z) const {
    AcbVector result(1);
    acb_set_arb_arb(result[0], z.real().arb().get(), z.imag().arb().get());
    arb_poly_evaluate_acb(result[0], value_, result[0], precision_);
    return {ball(acb_realref(result[0]), kBitsOfValue), ball(acb_imagref(result[0]), kBitsOfValue)};
  }

  static constexpr long kBitsOfValue = DoubleWordBall::kPrecision;

 private:
  arb_poly_t value_;
  slong precision_;
};

/// A polynomial for the search of roots: near them its value, but not its slope, needs many bits.
class RefinedPolynomial {
 public:
  RefinedPolynomial(const RationalPolynomial& p, long precision)
      : precision_(precision), value_(p, precision + kGuardBits) {
    std::vector<RealBall> coefficients;
    for (int i = 0; i <= p.degree(); ++i) {
      coefficients.emplace_back(p.coefficient(i), AccuratePolynomial::kBitsOfValue);
    }
    complex_ = Form<ComplexBall>({coefficients.begin(), coefficients.end()});
    real_ = Form<RealBall>(std::move(coefficients));
  }

  /// Newton's iteration until the inclusion has the bits of the precision or does not get better.
  template <class Ball>
  Inclusion<Ball> inclusion(const Ball& start) const {
    constexpr double kProgress = 1.0 / 16;
    const double sufficient = std::ldexp(magnitude_upper(start), static_cast<int>(-precision_));
    // From the digits of a double to those of two.
    Ball z = centre(at_precision(start, precision_) -
                    short_form(start)(start) / short_form(start).slope(start));
    Inclusion<Ball> best{z, INFINITY};
    for (;;) {
      const Ball step = value_(z) / short_form(z).slope(z);
      // The nearest root is at most n |p / p'| away.
      const double radius = real_.degree() * magnitude_upper(step) * kUpwards;
      const bool improves = radius < best.radius * kProgress;
      if (radius < best.radius) best = {z, radius};
      if (!improves || radius <= sufficient) return best;
      z = centre(z - step);
    }
  }

 private:
  /// What the conditioning of roots mostly costs: with it 104 bits become two words of Arb's.
  static constexpr long kGuardBits = 24;

  /// In double words: more bits would not speed the iteration up.
  const Form<RealBall>& short_form(const RealBall&) const { return real_; }
  const Form<ComplexBall>& short_form(const ComplexBall&) const { return complex_; }

  long precision_;
  AccuratePolynomial value_;
  Form<RealBall> real_;
  Form<ComplexBall> complex_;
};

/// Disks with at least one root each, and what they prove of the roots.
///
/// A polynomial of degree n has a root at most n |p(z) / p'(z)| away from z (E. Laguerre; P.
/// Henrici, Applied and Computational Complex Analysis I, 1974, 6.4). So n disjoint disks have one
/// root each, and if p is real, the root of a disk around a real point is real.
class Disks {
 public:
  Disks(const RationalPolynomial& p, long precision)
      : polynomial_(p, precision), degree_(p.degree()), precision_(precision) {}

  /// The disks to which Newton's iteration leads from a real point, or from one and its conjugate.
  void add_real(double start) {
    const auto [centre, radius] = polynomial_.inclusion(RealBall(start));
    const RealBall root = enclosed(centre, radius);
    roots_.real.push_back({root, 1});
    disks_.push_back({root, enclosed(0, radius)});
    measure(std::abs(start), radius);
  }
  void add_pair(const std::complex<double>& start) {
    const auto [centre, radius] = polynomial_.inclusion(ComplexBall(start));
    const ComplexBall root(enclosed(centre.real(), radius), enclosed(centre.imag(), radius));
    roots_.pairs.push_back({root, 1});
    disks_.insert(disks_.end(), {root, conj(root)});
    measure(std::abs(start), radius);
  }

  /// All roots, if the disks are as many, disjoint and narrow.
  std::optional<RootSet> roots() const {
    const bool are_all = static_cast<int>(disks_.size()) == degree_;
    if (!are_all || !are_narrow() || !are_disjoint()) return std::nullopt;
    return roots_;
  }

 private:
  RealBall enclosed(const RealBall& centre, double radius) const {
    return centre.at_precision(precision_) + RealBall::between(-radius, radius, precision_);
  }

  void measure(double magnitude, double radius) {
    size_ = std::max(size_, magnitude);
    widest_ = std::max(widest_, radius);
  }

  /// Half the bits of the precision are less than the conditioning of the roots costs, and more
  /// than is left where the iteration was still under way.
  bool are_narrow() const {
    return widest_ <= std::ldexp(size_, static_cast<int>(-precision_ / 2));
  }

  bool are_disjoint() const {
    for (std::size_t i = 0; i < disks_.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        if ((disks_[i] - disks_[j]).contains_zero()) return false;
      }
    }
    return true;
  }

  RefinedPolynomial polynomial_;
  int degree_;
  long precision_;
  RootSet roots_;
  std::vector<ComplexBall> disks_;
  double size_ = 0, widest_ = 0;
};

/// The roots of p if Newton's iteration from double-precision starting values proves them.
std::optional<RootSet> isolated_from_approximations(const RationalPolynomial& p, long precision) {
  // Starting values this near to the real line are taken for real.
  constexpr double kNearlyReal = 1e-10;
  Disks disks(p, precision);
  for (const std::complex<double>& start : approximate_roots(p)) {
    if (!std::isfinite(start.real()) || !std::isfinite(start.imag())) return std::nullopt;
    if (std::abs(start.imag()) <= kNearlyReal * std::abs(start.real())) {
      disks.add_real(start.real());
    } else if (start.imag() > 0) {
      disks.add_pair(start);
    }
  }
  return disks.roots();
}

RootSet isolated_squarefree(const fmpz_poly_struct* p, int multiplicity, long precision) {
  const slong n = fmpz_poly_degree(p);
  AcbVector roots(n);
  arb_fmpz_poly_complex_roots(roots.data(), p, 0, precision);
  return sorted_out(roots, n, multiplicity, precision);
}

/// The root of a linear polynomial, exact where it is a short dyadic number.
RootSet root_of_linear(const fmpz_poly_struct* p, int multiplicity, long precision) {
  Rational root;
  fmpq_set_fmpz_frac(root.flint(), fmpz_poly_get_coeff_ptr(p, 0), fmpz_poly_get_coeff_ptr(p, 1));
  return {{{RealBall(-root, precision), multiplicity}}, {}};
}

RootSet united(const std::vector<RootSet>& sets) {
  RootSet all;
  for (const RootSet& set : sets) {
    all.real.insert(all.real.end(), set.real.begin(), set.real.end());
    all.pairs.insert(all.pairs.end(), set.pairs.begin(), set.pairs.end());
  }
  return all;
}

/// Multiple roots are rare and mostly rational, so their factors are split into irreducible ones:
/// the exact place of a root decides what no ball can.
RootSet isolated_by_factors(const RationalPolynomial& p, long precision) {
  std::vector<RootSet> sets;
  for (const SquarefreeFactor& squarefree : squarefree_factorization(p)) {
    fmpz_poly_t integral;
    fmpz_poly_init(integral);
    fmpq_poly_get_numerator(integral, squarefree.factor.flint());
    fmpz_poly_factor_t factors;
    fmpz_poly_factor_init(factors);
    if (squarefree.multiplicity > 1) {
      fmpz_poly_factor(factors, integral);
    } else {
      fmpz_poly_factor_insert(factors, integral, 1);
    }
    for (slong i = 0; i < factors->num; ++i) {
      const fmpz_poly_struct* factor = factors->p + i;
      const bool linear = fmpz_poly_degree(factor) == 1 && !fmpz_is_zero(factor->coeffs);
      sets.push_back(linear ? root_of_linear(factor, squarefree.multiplicity, precision)
                            : isolated_squarefree(factor, squarefree.multiplicity, precision));
    }
    fmpz_poly_factor_clear(factors);
    fmpz_poly_clear(integral);
  }
  return united(sets);
}

/// The signs of the Bernstein coefficients on [0, 1].
std::vector<int> bernstein_signs(const RationalPolynomial& p) {
  std::vector<int> signs;
  for (const Rational& b : to_bernstein(coefficients(p, std::max(p.degree(), 0)))) {
    signs.push_back(b.sign());
  }
  return signs;
}

/// A number between two balls that do not overlap; nothing when they do.
std::optional<Rational> number_between(const RealBall& low, const RealBall& high) {
  const RealBall gap = high - low;
  if (!gap.is_positive()) return std::nullopt;
  return (low.exact_midpoint() + high.exact_midpoint()) / Rational(2L);
}

/// +1, -1 for a root certainly above, below x; 0 when its ball contains x.
int side_of(const RealBall& root, long x) {
  const RealBall difference = root - RealBall(x);
  return difference.is_positive() ? 1 : difference.is_negative() ? -1 : 0;
}

RealBall value(const RationalPolynomial& p, const RealBall& t, long precision) {
  RealBall sum(0);
  for (int i = p.degree(); i >= 0; --i) sum = sum * t + RealBall(p.coefficient(i), precision);
  return sum;
}

/// By a Sturm chain, which costs less than to isolate the roots.
bool has_real_roots(const RationalPolynomial& squarefree) {
  fmpz_poly_t integral;
  fmpz_poly_init(integral);
  fmpq_poly_get_numerator(integral, squarefree.flint());
  const slong count = fmpz_poly_num_real_roots(integral);
  fmpz_poly_clear(integral);
  return count > 0;
}

}  // namespace

RootSet isolate_roots(const RationalPolynomial& p, long precision) {
  if (p.degree() < 1) return {};
  std::optional<RootSet> simple = isolated_from_approximations(p, precision);
  RootSet roots = simple ? std::move(*simple) : isolated_by_factors(p, precision);
  std::sort(roots.real.begin(), roots.real.end(), [](const RealRoot& a, const RealRoot& b) {
    return a.value.exact_midpoint() < b.value.exact_midpoint();
  });
  return roots;
}

std::vector<Rational> numbers_between_real_roots(const RationalPolynomial& p) {
  RationalPolynomial squarefree(1L);
  for (const SquarefreeFactor& part : squarefree_factorization(p)) squarefree *= part.factor;
  if (!has_real_roots(squarefree)) return {Rational(0)};
  // Different roots, so some precision separates them with room to spare.
  for (long precision = 128;; precision *= 2) {
    const std::vector<RealRoot> roots = isolate_roots(squarefree, precision).real;
    std::vector<Rational> between = {Rational::exactly(roots.front().value.lower()) - Rational(1)};
    bool separated = true;
    for (std::size_t i = 1; i < roots.size() && separated; ++i) {
      const auto middle = number_between(roots[i - 1].value, roots[i].value);
      separated = middle.has_value();
      if (separated) between.push_back(*middle);
    }
    if (!separated) continue;
    between.push_back(Rational::exactly(roots.back().value.upper()) + Rational(1));
    return between;
  }
}

std::vector<RealRoot> roots_in_unit_interval(const RationalPolynomial& p, long least_precision) {
  std::vector<RealRoot> inside;
  RationalPolynomial rest = p;
  for (const long end : {0L, 1L}) {
    const RationalPolynomial without = rest.without_root(Rational(end));
    const int multiplicity = rest.degree() - without.degree();
    if (multiplicity > 0) inside.push_back({RealBall(end), multiplicity});
    rest = without;
  }
  // Without a change of sign, and not zero at the ends, the rest has no root in between.
  const std::vector<int> signs = bernstein_signs(rest);
  const auto opposite = [&](int sign) { return sign == -signs.front(); };
  if (std::none_of(signs.begin(), signs.end(), opposite)) return inside;
  // The remaining roots differ from 0 and 1, so some precision separates them from both.
  for (long precision = least_precision;; precision *= 2) {
    const RootSet roots = isolate_roots(rest, precision);
    const bool separated = std::all_of(roots.real.begin(), roots.real.end(), [](const RealRoot& r) {
      return side_of(r.value, 0) != 0 && side_of(r.value, 1) != 0;
    });
    if (!separated) continue;
    for (const RealRoot& root : roots.real) {
      if (side_of(root.value, 0) > 0 && side_of(root.value, 1) < 0) inside.push_back(root);
    }
    return inside;
  }
}

std::vector<RealRoot> roots_in_unit_interval_without_positive(const RationalPolynomial& p,
                                                              const RationalPolynomial& other) {
  const std::vector<RealRoot> common = roots_in_unit_interval(gcd(p, other));
  const RationalPolynomial rest = without_common_roots(p, other);
  // Where `other` is not zero some precision decides its sign.
  for (long precision = 128;; precision *= 2) {
    std::vector<RealRoot> found = common;
    bool decided = true;
    for (const RealRoot& root : roots_in_unit_interval(rest, precision)) {
      const RealBall x = value(other, root.value, precision);
      decided = decided && !x.contains_zero();
      if (x.is_negative()) found.push_back(root);
    }
    if (decided) return found;
  }
}

bool is_positive_on_unit_interval(const RationalPolynomial& p) {
  const std::vector<int> signs = bernstein_signs(p);
  const auto positive = [](int sign) { return sign > 0; };
  if (std::all_of(signs.begin(), signs.end(), positive)) return true;
  if (!positive(signs.front()) || !positive(signs.back())) return false;
  return roots_in_unit_interval(p).empty();
}

}  // namespace pn
