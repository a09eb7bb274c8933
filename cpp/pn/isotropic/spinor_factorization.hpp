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
// lo the other. One step per root c of the chosen half of D: L = t - c (or s at infinity), and A
// changes so that A* H A becomes divisible by L L~, where ~ conjugates coefficients. For that a
// step asks for v, which spans the kernel of A* H A over what it is divisible by already, at c. If
// H(c) w = 0, then v = adj(A(c)) w at the first visit of c. So no polynomial is divided, which
// takes more work and widens balls; only a root that comes again needs the quotient.
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
  /// c and conj(c) so often, together the multiplicity of the pair in D.
  struct Pair {
    C root;
    int copies, conjugates;
  };
  /// A real root of multiplicity 2q of D, q times.
  struct Real {
    C root;
    int copies;
  };
  std::vector<Pair> pairs;
  std::vector<Real> real;
  int infinite = 0;  ///< q for a root of multiplicity 2q at infinity
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
/// Far enough from zero to divide by it without the loss of half the digits of a double.
template <class C>
bool is_clearly_nonzero(const C& z) {
  return std::abs(midpoint(z)) > kNegligible && is_certainly_nonzero(z);
}
inline bool is_certainly_zero(const std::complex<double>& z) { return std::abs(z) <= kNegligible; }
inline bool is_certainly_zero(const ComplexBall& z) { return z.is_zero(); }
inline std::complex<double> real_part(const std::complex<double>& z) { return z.real(); }
inline ComplexBall real_part(const ComplexBall& z) { return ComplexBall(z.real()); }
inline std::complex<double> root(const std::complex<double>& z) { return std::sqrt(z.real()); }
inline ComplexBall root(const ComplexBall& z) { return ComplexBall(sqrt(z.real())); }
inline double size(const std::complex<double>& z) {
  return std::abs(z.real()) + std::abs(z.imag());
}
inline double size(const ComplexBall& z) { return size(z.midpoint()); }

template <class C>
using Vector = std::array<C, 2>;

template <class C>
using Matrix = std::array<Vector<C>, 2>;  ///< by rows

/// A point (t : s) of the projective line.
template <class C>
struct Point {
  std::optional<C> finite;  ///< t / s; nothing at infinity
  bool is_real = true;
  int number = 0;  ///< of a root of D: that of the root, or of the pair of conjugates

  C value_of(const Form<C>& form) const { return finite ? form(*finite) : form.at_infinity(); }
};

template <class C>
Point<C> conj(const Point<C>& c) {
  return c.finite ? Point<C>{conj(*c.finite), c.is_real, c.number} : c;
}

template <class C>
Form<C> divided(const Form<C>& form, const Point<C>& c) {
  if (!c.finite) return divided_by_infinity(form);
  return divided_by_root(form, *c.finite, size(*c.finite) > 1);
}

template <class C>
Form<C> linear_form(const Point<C>& c) {
  return c.finite ? Form<C>({-*c.finite, C(1.0)}) : Form<C>({C(1.0), C(0.0)});
}

/// The form of this degree with value `value` at c whose coefficients have the least sum of
/// squares.
template <class C>
Form<C> interpolating_form(const Point<C>& c, const C& value, int degree) {
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

template <class C>
Matrix<C> value_of(const HermitianMatrix<C>& h, const Point<C>& t) {
  return {{{t.value_of(h.h00), t.value_of(h.h01)}, {t.value_of(conj(h.h01)), t.value_of(h.h11)}}};
}

/// A vector of the kernel of a matrix of rank 1.
template <class C>
Vector<C> kernel(const Matrix<C>& m) {
  const bool upper = size(m[0][0]) + size(m[0][1]) >= size(m[1][0]) + size(m[1][1]);
  return upper ? Vector<C>{-m[0][1], m[0][0]} : Vector<C>{-m[1][1], m[1][0]};
}

/// The same times a power of two, of size about 1.
template <class C>
Vector<C> scaled(const Vector<C>& v) {
  const double length = size(v[0]) + size(v[1]);
  if (!std::isfinite(length) || length == 0) throw Undecided("the rank at a root of D");
  const C scale(std::exp2(-std::ilogb(length)));
  return {v[0] * scale, v[1] * scale};
}

/// x* m y
template <class C>
C sesquilinear(const Vector<C>& x, const Matrix<C>& m, const Vector<C>& y) {
  return conj(x[0]) * (m[0][0] * y[0] + m[0][1] * y[1]) +
         conj(x[1]) * (m[1][0] * y[0] + m[1][1] * y[1]);
}

/// The unit vector, in doubles, of the larger eigenvalue of a Hermitian matrix.
template <class C>
Vector<std::complex<double>> eigenvector(const Matrix<C>& m) {
  const double m00 = midpoint(m[0][0]).real(), m11 = midpoint(m[1][1]).real();
  const std::complex<double> m01 = midpoint(m[0][1]);
  const double half = (m00 - m11) / 2, spread = std::hypot(half, std::abs(m01));
  // (m - the other eigenvalue) e_k, with the larger of its two columns.
  const Vector<std::complex<double>> v =
      half >= 0 ? Vector<std::complex<double>>{half + spread, std::conj(m01)}
                : Vector<std::complex<double>>{m01, spread - half};
  const double length = std::hypot(std::abs(v[0]), std::abs(v[1]));
  return {v[0] / length, v[1] / length};
}

/// Real points: infinity, zero, 1, -1, and then further out and in; at least so many.
template <class C>
std::vector<Point<C>> real_points(int count) {
  std::vector<Point<C>> points = {{std::nullopt}, {C(0.0)}, {C(1.0)}, {C(-1.0)}};
  for (double t = 2; static_cast<int>(points.size()) < count; t += 1) {
    for (const double x : {t, -t, 1 / t, -1 / t}) points.push_back({C(x)});
  }
  return points;
}

/// The form of degree n with these values at n + 1 points.
template <class C>
Form<C> interpolating_form(const std::vector<Point<C>>& points, const std::vector<C>& values) {
  Form<C> sum = Form<C>::zero(static_cast<int>(points.size()) - 1);
  for (std::size_t i = 0; i < points.size(); ++i) {
    Form<C> term = Form<C>::constant(values[i]);
    for (std::size_t j = 0; j < points.size(); ++j) {
      if (j == i) continue;
      const Form<C> linear = linear_form(points[j]);
      term = term * linear * (C(1.0) / points[i].value_of(linear));
    }
    sum += term;
  }
  return sum;
}

/// The state of the algorithm: A, its degrees, and the roots taken so far.
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
  bool step(const Point<C>& c) {
    const Vector<C> v = kernel_at(c);
    if (is_balanced()) {
      step_balanced(c, v);
      return true;
    }
    if (is_clearly_nonzero(v[hi()])) {
      step_up_low_column(c, v);
      return true;
    }
    if (!c.is_real) {
      const Point<C> conjugate = conj(c);
      const Vector<C> other = kernel_at(conjugate);
      if (is_clearly_nonzero(other[hi()])) {
        step_up_low_column(conjugate, other);
        return true;
      }
    }
    if (is_certainly_nonzero(v[hi()])) {
      step_up_low_column(c, v);
      return true;
    }
    if (!is_certainly_zero(v[hi()])) return false;
    step_up_high_column(c);
    return true;
  }

  SpinorMatrix<C> normalized() const {
    return is_balanced() ? normalized_balanced() : normalized_unbalanced();
  }

 private:
  int hi() const { return degree_[0] >= degree_[1] ? 0 : 1; }
  int lo() const { return 1 - hi(); }

  Matrix<C> a_at(const Point<C>& t) const {
    return {{{t.value_of(a_[0][0]), t.value_of(a_[0][1])},
             {t.value_of(a_[1][0]), t.value_of(a_[1][1])}}};
  }

  /// The kernel of A* H A / (product of L L~ of the roots taken) at c.
  Vector<C> kernel_at(const Point<C>& c) const {
    const auto visits = std::count_if(taken_.begin(), taken_.end(), [&](const Point<C>& other) {
      return other.number == c.number;
    });
    if (visits > 0) return scaled(kernel(value_of(divided_product(c, visits), c)));
    const Vector<C> w = kernel(value_of(h_, c));
    const Matrix<C> a = a_at(c);
    return scaled(Vector<C>{a[1][1] * w[0] - a[0][1] * w[1], a[0][0] * w[1] - a[1][0] * w[0]});
  }

  /// A* H A / (L L~)^visits for a root visited so often.
  HermitianMatrix<C> divided_product(const Point<C>& c, long visits) const {
    const auto quotient = [&](int j, int k) {
      Form<C> form = product(j, k);
      for (long i = 0; i < visits; ++i) form = divided(divided(form, c), conj(c));
      return form;
    };
    return {quotient(0, 0), quotient(0, 1), quotient(1, 1)};
  }

  /// The entry of row j and column k of A* H A.
  Form<C> product(int j, int k) const {
    Form<C> sum = conj(a_[0][j]) * h_.h00 * a_[0][k];
    sum += conj(a_[0][j]) * h_.h01 * a_[1][k];
    sum += conj(a_[1][j]) * conj(h_.h01) * a_[0][k];
    sum += conj(a_[1][j]) * h_.h11 * a_[1][k];
    return sum;
  }

  /// (a) equal degrees: A <- [A v, L A w] with w orthogonal to v.
  void step_balanced(const Point<C>& c, const Vector<C>& v) {
    const Vector<C> w = {-conj(v[1]), conj(v[0])};
    const Form<C> linear = linear_form(c);
    for (auto& row : a_) {
      const Form<C> first = row[0] * v[0] + row[1] * v[1];
      row[1] = (row[0] * w[0] + row[1] * w[1]) * linear;
      row[0] = first;
    }
    ++degree_[1];
    taken_.push_back(c);
  }

  /// (b) a_hi <- a_hi + rho a_lo with rho(c) = v_lo / v_hi, then a_lo <- L a_lo.
  void step_up_low_column(const Point<C>& c, const Vector<C>& v) {
    const int high = hi(), low = lo();
    const Form<C> rho = interpolating_form(c, v[low] / v[high], degree_[high] - degree_[low]);
    const Form<C> linear = linear_form(c);
    for (auto& row : a_) {
      row[high] += rho * row[low];
      row[low] = row[low] * linear;
    }
    ++degree_[low];
    taken_.push_back(c);
  }

  /// (c) the low column itself spans the kernel: a_hi <- L a_hi.
  void step_up_high_column(const Point<C>& c) {
    const int high = hi();
    const Form<C> linear = linear_form(c);
    for (auto& row : a_) row[high] = row[high] * linear;
    ++degree_[high];
    taken_.push_back(c);
  }

  /// How far a real point is from the roots taken: the product of |L|^2 for coordinates of
  /// length 1.
  double distance_from_roots(const Point<C>& t) const {
    const auto square = [](const Point<C>& point) {
      return point.finite ? std::norm(midpoint(*point.finite)) + 1 : 1;
    };
    double result = 1;
    for (const Point<C>& c : taken_) {
      result *= std::norm(midpoint(t.value_of(linear_form(c)))) / (square(t) * square(c));
    }
    return result;
  }

  /// So many real points, those farthest from the roots: a choice in doubles.
  std::vector<Point<C>> points_far_from_roots(int count) const {
    // Enough to leave a choice.
    constexpr int kMore = 3;
    std::vector<Point<C>> points = real_points<C>(count + kMore);
    const auto end = points.begin() + count;
    std::partial_sort(points.begin(), end, points.end(), [&](const Point<C>& a, const Point<C>& b) {
      return distance_from_roots(a) > distance_from_roots(b);
    });
    points.erase(end, points.end());
    return points;
  }

  /// K = A* H A / (product of L L~ of the roots taken) at a real point.
  Matrix<C> quotient_at(const Point<C>& t) const {
    const Matrix<C> a = a_at(t), h = value_of(h_, t);
    C divisor(1.0);
    for (const Point<C>& c : taken_) {
      const C linear = t.value_of(linear_form(c));
      divisor *= real_part(linear * conj(linear));
    }
    Matrix<C> k;
    for (int i = 0; i < 2; ++i) {
      const Vector<C> image = {h[0][0] * a[0][i] + h[0][1] * a[1][i],
                               h[1][0] * a[0][i] + h[1][1] * a[1][i]};
      for (int j = 0; j < 2; ++j) {
        k[j][i] = (conj(a[0][j]) * image[0] + conj(a[1][j]) * image[1]) / divisor;
      }
    }
    return k;
  }

  /// K is a constant of signature (1, 1): a basis in which it is diagonal turns it into J. Near the
  /// eigenvectors, chosen in doubles, that costs few digits.
  SpinorMatrix<C> normalized_balanced() const {
    const Matrix<C> k = quotient_at(points_far_from_roots(1).front());
    const Vector<std::complex<double>> unit = eigenvector(k);
    const Vector<C> x = {C(unit[0]), C(unit[1])}, z = {-conj(x[1]), conj(x[0])};
    const C xx = real_part(sesquilinear(x, k, x)), xz = sesquilinear(x, k, z);
    const C ratio = xz / xx;
    const Vector<C> y = {z[0] - ratio * x[0], z[1] - ratio * x[1]};
    const C yy = real_part(sesquilinear(z, k, z) - conj(xz) * ratio);
    const C half(0.5), i(0.0, 1.0), f = root(half / xx), g = root(-half / yy);
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

  /// K_ll = 0, K_hl is a constant and K_hh a real form, which a real multiple of a_lo removes.
  SpinorMatrix<C> normalized_unbalanced() const {
    const int high = hi(), low = lo();
    const std::vector<Point<C>> points = points_far_from_roots(degree_[high] - degree_[low] + 1);
    const C constant = quotient_at(points.front())[high][low];
    std::vector<C> values;
    for (const Point<C>& t : points) values.push_back(real_part(quotient_at(t)[high][high]));
    const Form<C> rho = interpolating_form(points, values) * (C(-0.5) / constant);
    const C factor = C(0.0, 1.0) / constant;
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
  std::vector<Point<C>> taken_;
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
  using Root = spinor::Point<C>;
  std::vector<Root> real(roots.infinite, {std::nullopt, true, 0}), complex;
  int number = 0;
  for (const auto& [c, copies] : roots.real) real.insert(real.end(), copies, {c, true, ++number});
  for (const auto& [c, copies, conjugates] : roots.pairs) {
    const Root root{c, false, ++number};
    complex.insert(complex.end(), copies, root);
    complex.insert(complex.end(), conjugates, conj(root));
  }

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
  return factorization.normalized();
}

}  // namespace pn
