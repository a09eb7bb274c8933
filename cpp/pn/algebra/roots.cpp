// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/algebra/roots.hpp"

#include <acb_poly.h>
#include <arb_fmpz_poly.h>
#include <flint/fmpz_poly.h>
#include <flint/fmpz_poly_factor.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <optional>

#include "pn/algebra/bernstein.hpp"
#include "pn/algebra/common_factor.hpp"

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

class AcbPolynomial {
 public:
  AcbPolynomial(const RationalPolynomial& p, slong precision) {
    acb_poly_init(value_);
    acb_poly_set_fmpq_poly(value_, p.flint(), precision);
  }
  AcbPolynomial(const AcbPolynomial&) = delete;
  AcbPolynomial& operator=(const AcbPolynomial&) = delete;
  ~AcbPolynomial() { acb_poly_clear(value_); }
  const acb_poly_struct* get() const { return value_; }

 private:
  acb_poly_t value_;
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

/// Whether all radii are below half the bits of the precision, seen from the largest root: less
/// than the conditioning of the roots costs, more than is left where the iteration was still under
/// way.
bool are_narrow(AcbVector& roots, slong n, slong precision) {
  double size = 0, radius = 0;
  for (slong i = 0; i < n; ++i) {
    for (const arb_struct* part : {acb_realref(roots[i]), acb_imagref(roots[i])}) {
      size = std::max(size, std::abs(arf_get_d(arb_midref(part), ARF_RND_UP)));
      radius = std::max(radius, mag_get_d(arb_radref(part)));
    }
  }
  return radius <= std::ldexp(size, static_cast<int>(-precision / 2));
}

/// The roots of p if double-precision starting values lead to n disjoint and narrow inclusions.
std::optional<RootSet> isolated_from_approximations(const RationalPolynomial& p, long precision) {
  const slong n = p.degree();
  const auto start = approximate_roots(p);
  AcbVector initial(n), roots(n);
  for (slong i = 0; i < n; ++i) {
    const auto z = start[static_cast<std::size_t>(i)];
    if (!std::isfinite(z.real()) || !std::isfinite(z.imag())) return std::nullopt;
    acb_set_d_d(initial[i], z.real(), z.imag());
  }
  const AcbPolynomial polynomial(p, precision);
  constexpr slong kRefinements =
      6;  // quadratic convergence from 40 bits reaches any working precision
  if (acb_poly_find_roots(roots.data(), polynomial.get(), initial.data(), kRefinements, precision) <
          n ||
      !are_narrow(roots, n, precision) ||
      !acb_poly_validate_real_roots(roots.data(), polynomial.get(), precision)) {
    return std::nullopt;
  }
  for (slong i = 0; i < n; ++i) {
    if (arb_contains_zero(acb_imagref(roots[i]))) arb_zero(acb_imagref(roots[i]));
  }
  return sorted_out(roots, n, 1, precision);
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
    return a.value.midpoint() < b.value.midpoint();
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
