// SPDX-License-Identifier: LGPL-2.1-or-later
// Families of conics x^T C(t) x = 0, and where they are singular.
//
// C is a symmetric 3x3 matrix over Q[t]. The coordinates x belong to a basis of degrees f_i: of a
// fixed plane all f_i = 0, of a moving plane they are the degrees of three spanning points. Then
// C_ij is a form of formal degree f_i + f_j + twist.
//
// SMITH TYPE. At a point c of the projective line the matrix is diag(1, tau^a, tau^b) up to
// invertible changes of both bases, tau the local parameter, 0 <= a <= b: a is the multiplicity of
// c in the gcd of all 2x2 minors, a + b the one in det C. At infinity multiplicities are counted
// from the formal degrees.
//
// DEGREE. With D(c) = b + (a mod 2), every rational parametrization, quadratic in u, of all conics
// has degree at least m = (sum of D(c) - twist) / 2 in t, an integer.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "pn/algebra/rational_polynomial.hpp"

namespace pn {

template <class T>
using Vector3 = std::array<T, 3>;
/// entry [i][j] is row i of column j.
template <class T>
using Matrix3 = std::array<std::array<T, 3>, 3>;

struct ConicFamily {
  Matrix3<RationalPolynomial> matrix;
  Vector3<int> degree{0, 0, 0};  ///< of the basis of x
  int twist = 0;
};

/// The family without common factors of its entries, with the least twist. Throws GeometryError
/// when the matrix is not symmetric or its determinant is zero for all t.
ConicFamily conic_family(Matrix3<RationalPolynomial> matrix,
                         const Vector3<int>& degree = {0, 0, 0});

RationalPolynomial determinant(const Matrix3<RationalPolynomial>& m);
/// The transposed matrix of the cofactors.
Matrix3<RationalPolynomial> adjugate(const Matrix3<RationalPolynomial>& m);

/// diag(1, tau^a, tau^b).
struct SmithType {
  int a = 0, b = 0;
  bool is_regular() const { return b == 0; }
};

/// The type at every root of a monic, squarefree polynomial.
struct SingularFactor {
  RationalPolynomial factor;
  SmithType type;
};

struct SingularConics {
  std::vector<SingularFactor> finite;
  SmithType at_infinity;
};

SingularConics singular_conics(const ConicFamily& family);

/// The bound m of the theorem.
int least_degree(const ConicFamily& family, const SingularConics& singular);

/// An open interval of the line; without an end it is unbounded there. The ends are roots of det C,
/// rounded.
struct OpenInterval {
  std::optional<double> begin, end;
};

/// The first interval between roots of det C that meets [begin, end] and whose conics have no real
/// points, decided exactly; nothing when all conics between roots have real points.
std::optional<OpenInterval> interval_without_real_points(const ConicFamily& family,
                                                         const Rational& begin,
                                                         const Rational& end);
/// The same on the whole line.
std::optional<OpenInterval> interval_without_real_points(const ConicFamily& family);

/// Such as "between t = 1 and 2", "for t > 3", "for all t".
std::string description(const OpenInterval& interval);

/// Throws GeometryError kNoRealPoints with a sentence that names the interval.
[[noreturn]] void refuse_without_real_points(const OpenInterval& interval);

}  // namespace pn
