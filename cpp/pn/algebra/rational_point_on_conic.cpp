// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/algebra/rational_point_on_conic.hpp"

#include <flint/fmpz_factor.h>
#include <flint/fmpz_lll.h>
#include <flint/fmpz_mat.h>

#include <algorithm>
#include <cstdlib>
#include <optional>
#include <utility>
#include <vector>

namespace pn {
namespace {

using Vector = std::array<Rational, 3>;
using Matrix = std::array<Vector, 3>;

class Integer {
 public:
  Integer() { fmpz_init(value_); }
  explicit Integer(const fmpz* value) { fmpz_init_set(value_, value); }
  Integer(const Integer& other) : Integer(other.value_) {}
  Integer(Integer&& other) noexcept : Integer() { fmpz_swap(value_, other.value_); }
  Integer& operator=(Integer other) noexcept {
    fmpz_swap(value_, other.value_);
    return *this;
  }
  ~Integer() { fmpz_clear(value_); }
  fmpz* flint() { return value_; }
  const fmpz* flint() const { return value_; }
  Rational rational() const {
    Rational result;
    fmpq_set_fmpz(result.flint(), value_);
    return result;
  }

 private:
  fmpz_t value_;
};

struct PrimePower {
  Integer prime;
  ulong exponent;
};

/// Of |n|, n != 0; nothing when what trial division leaves is too large.
std::optional<std::vector<PrimePower>> prime_powers(const fmpz* n) {
  // The quadratic sieve needs 25 ms for 70 to 110 bits, 80 ms for 140 and 300 ms for 160: more than
  // the points of a family in balls, which do without it.
  constexpr flint_bitcnt_t kMostBits = 100;
  constexpr slong kTrialPrimes = 2000;
  fmpz_factor_t small, rest;
  fmpz_factor_init(small);
  fmpz_factor_init(rest);
  // Without a complete factorization the last factor is the cofactor.
  bool complete = fmpz_factor_trial(small, n, kTrialPrimes) != 0;
  std::vector<PrimePower> powers;
  slong count = small->num;
  if (!complete) {
    --count;
    Integer root(small->p + count);
    const int power = fmpz_is_perfect_power(root.flint(), small->p + count);
    const auto exponent = static_cast<ulong>(std::max(power, 1));
    if (power == 0) fmpz_set(root.flint(), small->p + count);
    complete = fmpz_bits(root.flint()) <= kMostBits || fmpz_is_probabprime(root.flint()) != 0;
    if (complete) {
      fmpz_factor(rest, root.flint());
      for (slong i = 0; i < rest->num; ++i) {
        powers.push_back({Integer(rest->p + i), rest->exp[i] * exponent});
      }
    }
  }
  for (slong i = 0; i < count; ++i) powers.push_back({Integer(small->p + i), small->exp[i]});
  fmpz_factor_clear(small);
  fmpz_factor_clear(rest);
  if (!complete) return std::nullopt;
  return powers;
}

Rational value(const Matrix& conic, const Vector& v, const Vector& w) {
  Rational sum;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) sum += v[i] * conic[i][j] * w[j];
  }
  return sum;
}

void scale(Vector& v, const Rational& factor) {
  for (Rational& x : v) x *= factor;
}

Vector combined(const Matrix& vectors, const Vector& factors) {
  Vector sum;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t k = 0; k < 3; ++k) sum[k] += factors[i] * vectors[i][k];
  }
  return sum;
}

PointOnConic found(Vector point) {
  const Rational content = gcd(gcd(point[0], point[1]), point[2]);
  scale(point, Rational(1) / content);
  return {RationalPoints::kExist, std::move(point)};
}

/// sum d_i x_i^2 for x = sum x_i axis_i; the d_i are integers, up to a common factor.
struct DiagonalForm {
  Matrix axis;
  std::array<std::vector<Integer>, 3> primes;  ///< of |d_i|, which is squarefree
  std::array<int, 3> sign;

  Rational coefficient(std::size_t i) const {
    Rational d(sign[i]);
    for (const Integer& p : primes[i]) d *= p.rational();
    return d;
  }
};

/// Conjugate axes by Gram and Schmidt; the last one found may be a point of the conic.
Matrix conjugate_axes(const Matrix& conic) {
  Matrix axes;
  for (std::size_t i = 0; i < 3; ++i) {
    Vector v;
    v[i] = Rational(1);
    for (std::size_t k = 0; k < i; ++k) {
      const Rational factor = value(conic, v, axes[k]) / value(conic, axes[k], axes[k]);
      for (std::size_t c = 0; c < 3; ++c) v[c] -= factor * axes[k][c];
    }
    axes[i] = v;
    if (value(conic, v, v).is_zero()) break;
  }
  return axes;
}

/// The primes that the square class of d contains; the axis is divided by the square.
std::optional<std::vector<Integer>> make_squarefree(const Rational& d, Vector& axis) {
  const auto above = prime_powers(fmpq_numref(d.flint()));
  const auto below = prime_powers(fmpq_denref(d.flint()));
  if (!above || !below) return std::nullopt;
  std::vector<Integer> primes;
  const auto take = [&](const std::vector<PrimePower>& powers, bool divide) {
    for (const auto& [prime, exponent] : powers) {
      Integer root;
      // d = p^-1 becomes p, d = p^1 stays.
      fmpz_pow_ui(root.flint(), prime.flint(), divide ? exponent / 2 : (exponent + 1) / 2);
      const Rational factor = root.rational();
      scale(axis, divide ? Rational(1) / factor : factor);
      if (exponent % 2 == 1) primes.push_back(prime);
    }
  };
  take(*above, true);
  take(*below, false);
  return primes;
}

bool contains(const std::vector<Integer>& primes, const Integer& p) {
  return std::any_of(primes.begin(), primes.end(),
                     [&](const Integer& q) { return fmpz_equal(p.flint(), q.flint()) != 0; });
}

void remove(std::vector<Integer>& primes, const Integer& p) {
  primes.erase(
      std::remove_if(primes.begin(), primes.end(),
                     [&](const Integer& q) { return fmpz_equal(p.flint(), q.flint()) != 0; }),
      primes.end());
}

/// A prime of all three coefficients is left out; of two of them it goes into the third one.
void make_coprime(DiagonalForm& form) {
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
    for (const Integer& p : std::vector<Integer>(form.primes[i])) {
      if (!contains(form.primes[j], p)) continue;
      remove(form.primes[i], p);
      remove(form.primes[j], p);
      if (contains(form.primes[k], p)) {
        remove(form.primes[k], p);
      } else {
        scale(form.axis[i], Rational(1) / p.rational());
        scale(form.axis[j], Rational(1) / p.rational());
        form.primes[k].push_back(p);
      }
    }
  }
}

/// r with r^2 = -c / b modulo a prime.
std::optional<Integer> slope_of_line(const Rational& b, const Rational& c, const Integer& prime) {
  Integer inverse, square, root;
  fmpz_invmod(inverse.flint(), fmpq_numref(b.flint()), prime.flint());
  fmpz_mul(square.flint(), inverse.flint(), fmpq_numref(c.flint()));
  fmpz_neg(square.flint(), square.flint());
  fmpz_mod(square.flint(), square.flint(), prime.flint());
  if (fmpz_sqrtmod(root.flint(), square.flint(), prime.flint()) == 0) return std::nullopt;
  return root;
}

/// A lattice of integral vectors; the rows are a basis.
class IntegralLattice {
 public:
  IntegralLattice() {
    fmpz_mat_init(basis_, 3, 3);
    fmpz_mat_one(basis_);
  }
  IntegralLattice(const IntegralLattice&) = delete;
  IntegralLattice& operator=(const IntegralLattice&) = delete;
  ~IntegralLattice() { fmpz_mat_clear(basis_); }

  /// To the vectors with x_j = slope x_k modulo a prime.
  void step_onto_line(std::size_t j, std::size_t k, const Integer& slope, const Integer& prime) {
    std::array<Integer, 3> off;
    std::size_t pivot = 3;
    for (std::size_t i = 0; i < 3; ++i) {
      fmpz_set(off[i].flint(), entry(i, j));
      fmpz_submul(off[i].flint(), slope.flint(), entry(i, k));
      fmpz_mod(off[i].flint(), off[i].flint(), prime.flint());
      if (fmpz_is_zero(off[i].flint()) == 0) pivot = i;
    }
    Integer inverse, ratio;
    fmpz_invmod(inverse.flint(), off[pivot].flint(), prime.flint());
    for (std::size_t i = 0; i < 3; ++i) {
      if (i != pivot) fmpz_mul(ratio.flint(), off[i].flint(), inverse.flint());
      for (std::size_t c = 0; c < 3; ++c) {
        if (i == pivot) continue;
        fmpz_submul(entry(i, c), ratio.flint(), entry(pivot, c));
      }
    }
    for (std::size_t c = 0; c < 3; ++c) fmpz_mul(entry(pivot, c), entry(pivot, c), prime.flint());
  }

  /// To a basis of nearly least lengths in the metric sum |d_i| x_i^2.
  void reduce(const Vector& d) {
    constexpr ulong kBitsOfRoots = 16;
    std::array<Integer, 3> weight;
    for (std::size_t c = 0; c < 3; ++c) {
      fmpz_abs(weight[c].flint(), fmpq_numref(d[c].flint()));
      fmpz_mul_2exp(weight[c].flint(), weight[c].flint(), 2 * kBitsOfRoots);
      fmpz_sqrt(weight[c].flint(), weight[c].flint());
      for (std::size_t i = 0; i < 3; ++i) {
        fmpz_mul(entry(i, c), entry(i, c), weight[c].flint());
      }
    }
    fmpz_lll_t settings;
    fmpz_lll_context_init_default(settings);
    fmpz_lll(basis_, nullptr, settings);
    for (std::size_t c = 0; c < 3; ++c) {
      for (std::size_t i = 0; i < 3; ++i) {
        fmpz_divexact(entry(i, c), entry(i, c), weight[c].flint());
      }
    }
  }

  Matrix rows() const {
    Matrix result;
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t c = 0; c < 3; ++c) {
        fmpq_set_fmpz(result[i][c].flint(),
                      fmpz_mat_entry(basis_, static_cast<slong>(i), static_cast<slong>(c)));
      }
    }
    return result;
  }

 private:
  fmpz* entry(std::size_t i, std::size_t c) {
    return fmpz_mat_entry(basis_, static_cast<slong>(i), static_cast<slong>(c));
  }

  fmpz_mat_t basis_;
};

/// Of a form that has points, by the least factors.
Vector point_by_small_factors(const Matrix& form) {
  for (long size = 1;; ++size) {
    for (long x = -size; x <= size; ++x) {
      for (long y = -size; y <= size; ++y) {
        const bool on_border = std::max(std::abs(x), std::abs(y)) == size;
        for (long z = -size; z <= size; z += on_border ? 1 : 2 * size) {
          const Vector v = {Rational(x), Rational(y), Rational(z)};
          if (value(form, v, v).is_zero()) return v;
        }
      }
    }
  }
}

std::optional<DiagonalForm> legendre_form(const Matrix& conic, const Matrix& axes) {
  DiagonalForm form{axes, {}, {}};
  for (std::size_t i = 0; i < 3; ++i) {
    const Rational d = value(conic, axes[i], axes[i]);
    form.sign[i] = d.sign();
    auto primes = make_squarefree(d, form.axis[i]);
    if (!primes) return std::nullopt;
    form.primes[i] = std::move(*primes);
  }
  make_coprime(form);
  return form;
}

}  // namespace

PointOnConic rational_point_on_conic(const Matrix& conic) {
  const Matrix axes = conjugate_axes(conic);
  for (const Vector& v : axes) {
    if (value(conic, v, v).is_zero()) return found(v);
  }
  const std::optional<DiagonalForm> form = legendre_form(conic, axes);
  if (!form) return {RationalPoints::kUnknown, {}};
  const auto& sign = form->sign;
  if (sign[0] == sign[1] && sign[1] == sign[2]) return {RationalPoints::kNone, {}};
  const Vector d = {form->coefficient(0), form->coefficient(1), form->coefficient(2)};
  IntegralLattice lattice;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
    for (const Integer& prime : form->primes[i]) {
      const std::optional<Integer> slope = slope_of_line(d[j], d[k], prime);
      if (!slope) return {RationalPoints::kNone, {}};
      lattice.step_onto_line(j, k, *slope, prime);
    }
  }
  lattice.reduce(d);
  const Matrix basis = lattice.rows();
  Matrix diagonal, reduced;
  for (std::size_t i = 0; i < 3; ++i) diagonal[i][i] = d[i];
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) reduced[i][j] = value(diagonal, basis[i], basis[j]);
  }
  const Vector in_axes = combined(basis, point_by_small_factors(reduced));
  return found(combined(form->axis, in_axes));
}

}  // namespace pn
