// SPDX-License-Identifier: LGPL-2.1-or-later
// The spinor factorization: all rational unit normals along a family of circles on the unit sphere.
//
// THEOREM. Let M = (M1, M2, M3) and R be coprime polynomials in t of formal degree h with
// D = |M|^2 - R^2 >= 0 on the real line, D not zero, and let
//
//     H = R + M.sigma = [[R + M3, M1 - i M2], [M1 + i M2, R - M3]],          det H = -D.
//
// There is a matrix A of polynomials over C, det A of degree h, with
//
//     A* H A = (D / lc D) J,      J = [[0, i], [-i, 0]].
//
// For real (u0, u1) the spinor a = A (u0, u1)^T satisfies a* H a = 0, and
//
//     n = (2 Re(conj(a0) a1), 2 Im(conj(a0) a1), |a0|^2 - |a1|^2) / (|a0|^2 + |a1|^2)
//
// runs over all unit vectors with n.M + R = 0: rational, of degree 2 in u, and a* a > 0 everywhere.
// Replacing a root c of D by conj(c) in the construction changes A by a real factor of u; a
// suitable choice reaches column degrees (ceil(h/2), floor(h/2)) whenever D has no real zero, and
// that is least possible. Sources: M. Peternell, dissertation TU Wien 1997, 2.5 and 4.5; D. Gruber,
// diploma thesis TU Wien 2008, Satz 2; the matrix form is the factorization of a Hermitian matrix
// along a lattice chain at the roots of D.
//
// NOTATION. A has columns a_0, a_1 of formal degrees d_0, d_1; hi is the column of larger degree,
// lo the other. One step per root c of the chosen half of D: v spans the kernel of H(c), L = t - c
// (or s at infinity), ~ conjugates coefficients. H is updated with A so that A* H A stays
// divisible.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <optional>
#include <utility>
#include <vector>

#include "pn/algebra/form.hpp"
#include "pn/algebra/roots.hpp"

namespace pn {

/// H = [[h00, h01], [conj h01, h11]] with h00, h11 real.
template <class C>
struct HermitianMatrix {
  Form<C> h00, h01, h11;
};

/// The half of the roots of D that the factorization takes: h steps in all.
template <class C>
struct HalfRoots {
  std::vector<C> complex;  ///< c or conj(c) for every pair, as often as its multiplicity
  std::vector<C> real;     ///< each real root of multiplicity 2q of D, q times
  int infinite = 0;        ///< q for a root of multiplicity 2q at infinity
};

/// A: entry[i][j] is row i of column j, of formal degree degree[j]; degree[0] >= degree[1].
template <class C>
struct SpinorMatrix {
  std::array<std::array<Form<C>, 2>, 2> entry;
  std::array<int, 2> degree{0, 0};
};

namespace spinor {

// What the algorithm asks of a scalar. In doubles an answer is an estimate, good for comparing root
// choices; in balls it is a proof.

/// Below this part of a unit vector a component computed in doubles counts as zero: the square root
/// of the rounding unit, since the vector stems from values that cancel.
inline constexpr double kNegligible = 1e-8;

inline std::complex<double> midpoint(const std::complex<double>& z) { return z; }
inline std::complex<double> midpoint(const ComplexBall& z) { return z.midpoint(); }
inline bool is_certainly_nonzero(const std::complex<double>& z) {
  return std::abs(z) > kNegligible;
}
inline bool is_certainly_nonzero(const ComplexBall& z) { return !z.contains_zero(); }
inline bool is_certainly_zero(const std::complex<double>& z) { return std::abs(z) <= kNegligible; }
inline bool is_certainly_zero(const ComplexBall& z) { return z.is_zero(); }
inline std::complex<double> real_part(const std::complex<double>& z) { return z.real(); }
inline ComplexBall real_part(const ComplexBall& z) { return ComplexBall(z.real()); }
inline std::complex<double> root(const std::complex<double>& z) { return std::sqrt(z.real()); }
inline ComplexBall root(const ComplexBall& z) { return ComplexBall(sqrt(z.real())); }
inline std::complex<double> imaginary_unit(const std::complex<double>&) { return {0, 1}; }
inline ComplexBall imaginary_unit(const ComplexBall&) {
  return ComplexBall(RealBall(), RealBall(1));
}
inline double size(const std::complex<double>& z) {
  return std::abs(z.real()) + std::abs(z.imag());
}
inline double size(const ComplexBall& z) { return size(z.midpoint()); }

template <class C>
using Vector = std::array<C, 2>;

/// A point of the projective line at which D vanishes.
template <class C>
struct Root {
  std::optional<C> finite;  ///< nothing: the point at infinity
  bool is_real = true;

  C value_of(const Form<C>& form) const { return finite ? form(*finite) : form.at_infinity(); }
};

template <class C>
Form<C> divided(const Form<C>& form, const Root<C>& c) {
  if (!c.finite) return divided_by_infinity(form);
  return divided_by_root(form, *c.finite, size(*c.finite) > 1);
}

template <class C>
Form<C> divided_by_conjugate(const Form<C>& form, const Root<C>& c) {
  return divided(form, c.finite ? Root<C>{conj(*c.finite), c.is_real} : c);
}

template <class C>
Form<C> linear_form(const Root<C>& c) {
  return c.finite ? Form<C>({-*c.finite, C(1.0)}) : Form<C>({C(1.0), C(0.0)});
}

template <class C>
Form<C> real_form(Form<C> form) {
  for (int i = 0; i <= form.degree(); ++i) form[i] = real_part(form[i]);
  return form;
}

/// The form of this degree with value `value` at c whose coefficients have the least sum of
/// squares.
template <class C>
Form<C> interpolating_form(const Root<C>& c, const C& value, int degree) {
  Form<C> rho = Form<C>::zero(degree);
  if (!c.finite) {
    rho[degree] = value;
    return rho;
  }
  const C conjugate = conj(*c.finite);
  C power(1.0), sum(0.0), norm = *c.finite * conjugate, norm_power(1.0);
  for (int i = 0; i <= degree; ++i) {
    rho[i] = value * power;
    sum += norm_power;
    power *= conjugate;
    norm_power *= norm;
  }
  return rho * (C(1.0) / sum);
}

/// The state of the algorithm: A, its degrees, and H = A* H_0 A divided by the steps done so far.
template <class C>
class Factorization {
 public:
  explicit Factorization(HermitianMatrix<C> h) : h_(std::move(h)) {
    for (int i = 0; i < 2; ++i) {
      for (int j = 0; j < 2; ++j) a_[i][j] = Form<C>::constant(C(i == j ? 1.0 : 0.0));
    }
  }

  bool is_balanced() const { return degree_[0] == degree_[1]; }

  /// Takes a root, or for a nonreal one its conjugate, which serves the same pair. False, with
  /// nothing done, when it cannot be decided whether the kernel leaves the lower column.
  bool step(const Root<C>& c) {
    const Vector<C> v = kernel(c);
    if (is_balanced()) {
      step_balanced(c, v);
      return true;
    }
    if (is_certainly_nonzero(v[hi()])) {
      step_up_low_column(c, v);
      return true;
    }
    if (!c.is_real) {
      const Root<C> conjugate{conj(*c.finite), false};
      const Vector<C> other = kernel(conjugate);
      if (is_certainly_nonzero(other[hi()])) {
        step_up_low_column(conjugate, other);
        return true;
      }
    }
    if (!is_certainly_zero(v[hi()])) return false;
    step_up_high_column(c);
    return true;
  }

  SpinorMatrix<C> normalized() && {
    return is_balanced() ? std::move(*this).normalized_balanced()
                         : std::move(*this).normalized_unbalanced();
  }

 private:
  int hi() const { return degree_[0] >= degree_[1] ? 0 : 1; }
  int lo() const { return 1 - hi(); }

  /// H_jk, the entry of row j and column k.
  Form<C> h(int j, int k) const {
    if (j == k) return j == 0 ? h_.h00 : h_.h11;
    return j == 0 ? h_.h01 : conj(h_.h01);
  }

  void set_h(int high, Form<C> hh, Form<C> hl, Form<C> ll) {
    h_.h01 = high == 0 ? std::move(hl) : conj(hl);
    h_.h00 = high == 0 ? hh : ll;
    h_.h11 = high == 0 ? std::move(ll) : std::move(hh);
  }

  /// A vector of the kernel of H(c), which has rank 1, of size about 1.
  Vector<C> kernel(const Root<C>& c) const {
    const C h00 = c.value_of(h_.h00), h01 = c.value_of(h_.h01);
    const C h10 = c.value_of(conj(h_.h01)), h11 = c.value_of(h_.h11);
    const bool upper = size(h00) + size(h01) >= size(h10) + size(h11);
    Vector<C> v = upper ? Vector<C>{-h01, h00} : Vector<C>{-h11, h10};
    if (!is_finite_and_positive(size(v[0]) + size(v[1])))
      throw Undecided("the rank at a root of D");
    const C scale(std::exp2(-std::ilogb(size(v[0]) + size(v[1]))));
    return {v[0] * scale, v[1] * scale};
  }

  static bool is_finite_and_positive(double x) { return std::isfinite(x) && x > 0; }

  /// (a) equal degrees: A <- [A v, L A w] with w orthogonal to v.
  void step_balanced(const Root<C>& c, const Vector<C>& v) {
    const Vector<C> w = {-conj(v[1]), conj(v[0])};
    const Form<C> linear = linear_form(c);
    for (auto& row : a_) {
      const Form<C> first = row[0] * v[0] + row[1] * v[1];
      row[1] = (row[0] * w[0] + row[1] * w[1]) * linear;
      row[0] = first;
    }
    Form<C> vv = sesquilinear(v, v), vw = sesquilinear(v, w), ww = sesquilinear(w, w);
    h_.h00 = real_form(divided_by_conjugate(divided(vv, c), c));
    h_.h01 = divided_by_conjugate(vw, c);
    h_.h11 = real_form(std::move(ww));
    ++degree_[1];
  }

  Form<C> sesquilinear(const Vector<C>& x, const Vector<C>& y) const {
    Form<C> sum = h_.h00 * (conj(x[0]) * y[0]);
    sum += h_.h01 * (conj(x[0]) * y[1]);
    sum += conj(h_.h01) * (conj(x[1]) * y[0]);
    sum += h_.h11 * (conj(x[1]) * y[1]);
    return sum;
  }

  /// (b) a_hi <- a_hi + rho a_lo with rho(c) = v_lo / v_hi, then a_lo <- L a_lo.
  void step_up_low_column(const Root<C>& c, const Vector<C>& v) {
    const int high = hi(), low = lo();
    const Form<C> rho = interpolating_form(c, v[low] / v[high], degree_[high] - degree_[low]);
    const Form<C> linear = linear_form(c);
    for (auto& row : a_) {
      row[high] += rho * row[low];
      row[low] = row[low] * linear;
    }
    const Form<C> rho_conjugate = conj(rho);
    const Form<C> ll = h(low, low);
    const Form<C> hl = h(high, low) + rho_conjugate * ll;
    const Form<C> hh = h(high, high) + rho * h(high, low) + rho_conjugate * conj(hl);
    set_h(high, real_form(divided_by_conjugate(divided(hh, c), c)), divided_by_conjugate(hl, c),
          ll);
    ++degree_[low];
  }

  /// (c) the low column itself spans the kernel: a_hi <- L a_hi.
  void step_up_high_column(const Root<C>& c) {
    const int high = hi(), low = lo();
    const Form<C> linear = linear_form(c);
    for (auto& row : a_) row[high] = row[high] * linear;
    set_h(high, h(high, high), divided(h(high, low), c),
          real_form(divided_by_conjugate(divided(h(low, low), c), c)));
    ++degree_[high];
  }

  /// H is a constant of signature (1, 1): its eigenvectors turn it into J.
  SpinorMatrix<C> normalized_balanced() && {
    const C k00 = h_.h00[0], k01 = h_.h01[0], k11 = h_.h11[0], half(0.5);
    const C mean = (k00 + k11) * half, difference = (k00 - k11) * half;
    const C spread = root(difference * difference + k01 * conj(k01));
    const C positive = mean + spread, negative = mean - spread;
    Vector<C> x = size(positive - k00) >= size(positive - k11)
                      ? Vector<C>{k01, positive - k00}
                      : Vector<C>{positive - k11, conj(k01)};
    const C norm = root(x[0] * conj(x[0]) + x[1] * conj(x[1]));
    x = {x[0] / norm, x[1] / norm};
    const Vector<C> y = {-conj(x[1]), conj(x[0])};
    const C f = root(half / positive), g = root(-half / negative);
    const C i = imaginary_unit(f);
    const Vector<C> p = {x[0] * f + y[0] * g, x[1] * f + y[1] * g};
    const Vector<C> q = {(x[0] * f - y[0] * g) * i, (x[1] * f - y[1] * g) * i};
    SpinorMatrix<C> result;
    for (int row = 0; row < 2; ++row) {
      result.entry[row][0] = a_[row][0] * p[0] + a_[row][1] * p[1];
      result.entry[row][1] = a_[row][0] * q[0] + a_[row][1] * q[1];
    }
    result.degree = degree_;
    return result;
  }

  /// H_ll = 0, H_hl is a constant and H_hh a real form, which a real multiple of a_lo removes.
  SpinorMatrix<C> normalized_unbalanced() && {
    const int high = hi(), low = lo();
    const C constant = h(high, low)[0];
    const Form<C> rho = h(high, high) * (C(-0.5) / constant);
    const C factor = imaginary_unit(constant) / constant;
    SpinorMatrix<C> result;
    for (int row = 0; row < 2; ++row) {
      result.entry[row][0] = a_[row][high] + rho * a_[row][low];
      result.entry[row][1] = a_[row][low] * factor;
    }
    result.degree = {degree_[high], degree_[low]};
    return result;
  }

  std::array<std::array<Form<C>, 2>, 2> a_;
  std::array<int, 2> degree_{0, 0};
  HermitianMatrix<C> h_;
};

}  // namespace spinor

/// A for the matrix H, whose entries have no common root, and the chosen half of the roots of D.
///
/// In balls every decision is proved; throws Undecided when the precision does not suffice. In
/// doubles the result is an estimate. The order of the steps only changes A by a constant real
/// factor of u, so real roots are taken while the degrees are equal, where no decision is needed,
/// and a root that cannot be decided waits for the others.
template <class C>
SpinorMatrix<C> spinor_factorization(HermitianMatrix<C> h, const HalfRoots<C>& roots) {
  using Root = spinor::Root<C>;
  std::vector<Root> real, complex;
  for (int i = 0; i < roots.infinite; ++i) real.push_back({std::nullopt, true});
  for (const C& c : roots.real) real.push_back({c, true});
  for (const C& c : roots.complex) complex.push_back({c, false});

  spinor::Factorization<C> factorization(std::move(h));
  const auto take_one = [&](std::vector<Root>& from) {
    const auto taken = std::find_if(from.begin(), from.end(),
                                    [&](const Root& root) { return factorization.step(root); });
    if (taken == from.end()) return false;
    from.erase(taken);
    return true;
  };
  while (!real.empty() || !complex.empty()) {
    const bool real_first = factorization.is_balanced();
    if (take_one(real_first ? real : complex) || take_one(real_first ? complex : real)) continue;
    throw Undecided("the kernel at a root of D");
  }
  return std::move(factorization).normalized();
}

}  // namespace pn
