// SPDX-License-Identifier: LGPL-2.1-or-later
// Certified roots of polynomials over Q.
//
// Contract: every root is enclosed in a ball that contains no other root of the same squarefree
// factor, and its multiplicity and realness are proved. A real root is a real ball; nonreal roots
// come in conjugate pairs and the one in the upper half plane stands for both.
//
// Method: approximations from simultaneous iteration are validated by an inclusion test (E. Durand,
// I. Kerner; the test is Arb's, radius n |p / p'|). Pairwise disjoint inclusions prove at once that
// p is squarefree. Otherwise the squarefree factors over Q are isolated one by one, by subdivision
// of the precision until it succeeds.
#pragma once

#include <stdexcept>
#include <vector>

#include "pn/algebra/ball.hpp"
#include "pn/algebra/rational_polynomial.hpp"

namespace pn {

/// A decision could not be proved at the working precision. Whoever chose the precision raises it.
class Undecided : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

struct RealRoot {
  RealBall value;
  int multiplicity;
};

/// The roots value and conj(value), Im value > 0, each of this multiplicity.
struct ConjugatePair {
  ComplexBall value;
  int multiplicity;
};

struct RootSet {
  std::vector<RealRoot> real;  ///< ascending
  std::vector<ConjugatePair> pairs;
};

/// All complex roots of p, which is not zero, in balls of about this precision in bits.
RootSet isolate_roots(const RationalPolynomial& p, long precision);

/// One rational number in each of the open intervals that the real roots of p, which is not zero,
/// leave on the line; ascending.
std::vector<Rational> numbers_between_real_roots(const RationalPolynomial& p);

/// The real roots of p in the closed interval [0, 1], decided exactly, those at its ends first and
/// exact; in balls of at least this precision.
std::vector<RealRoot> roots_in_unit_interval(const RationalPolynomial& p, long precision = 128);

/// Those among them at which another polynomial is not positive, decided exactly.
std::vector<RealRoot> roots_in_unit_interval_without_positive(const RationalPolynomial& p,
                                                              const RationalPolynomial& other);

/// p(t) > 0 for all t in [0, 1], decided exactly.
bool is_positive_on_unit_interval(const RationalPolynomial& p);

}  // namespace pn
