// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/conics/conic_normal_form.hpp"

#include <Eigen/Dense>
#include <algorithm>

namespace pn {
namespace {

/// V^T M V
Matrix3<RealBall> transformed(const Matrix3<RealBall>& m, const Matrix3<RealBall>& v) {
  Matrix3<RealBall> result;
  for (std::size_t a = 0; a < 3; ++a) {
    for (std::size_t b = 0; b < 3; ++b) {
      for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = 0; j < 3; ++j) result[a][b] += v[i][a] * m[i][j] * v[j][b];
      }
    }
  }
  return result;
}

/// Nearly orthogonal columns, exact doubles, in which the conic is nearly diagonal.
Matrix3<RealBall> approximate_axes(const Matrix3<RealBall>& conic) {
  Eigen::Matrix3d m;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      m(i, j) = conic[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)].midpoint();
    }
  }
  const Eigen::Matrix3d axes = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(m).eigenvectors();
  Matrix3<RealBall> result;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      result[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)] = RealBall(axes(i, j));
    }
  }
  return result;
}

void subtract_multiple(Matrix3<RealBall>& v, std::size_t column, const RealBall& factor,
                       std::size_t of) {
  for (auto& row : v) row[column] -= factor * row[of];
}

}  // namespace

std::optional<QuadraticColumns> points_of_constant_conic(const Matrix3<RealBall>& conic) {
  Matrix3<RealBall> v = approximate_axes(conic);
  // Gram and Schmidt make the axes exactly conjugate.
  constexpr std::array<std::array<std::size_t, 2>, 3> kPairs = {{{0, 1}, {0, 2}, {1, 2}}};
  for (const auto& [i, j] : kPairs) {
    const Matrix3<RealBall> m = transformed(conic, v);
    if (m[i][i].contains_zero()) return std::nullopt;
    subtract_multiple(v, j, m[i][j] / m[i][i], i);
  }
  const Matrix3<RealBall> diagonal = transformed(conic, v);
  std::array<std::size_t, 3> order = {0, 1, 2};
  std::array<int, 3> sign{};
  for (std::size_t i = 0; i < 3; ++i) {
    const RealBall& d = diagonal[i][i];
    sign[i] = d.is_positive() ? 1 : d.is_negative() ? -1 : 0;
    if (sign[i] == 0) return std::nullopt;
  }
  const int sum = sign[0] + sign[1] + sign[2];
  if (sum == 3 || sum == -3) return std::nullopt;
  std::sort(order.begin(), order.end(),
            [&](std::size_t i, std::size_t j) { return sign[i] * sum > sign[j] * sum; });
  QuadraticColumns points;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto axis = [&](std::size_t k) {
      return v[i][order[k]] / sqrt(abs(diagonal[order[k]][order[k]]));
    };
    const RealBall x = axis(0), y = axis(1), z = axis(2);
    points[i] = {z + x, y + y, z - x};
  }
  return points;
}

Matrix3<Rational> points_of_constant_conic(const Matrix3<Rational>& conic,
                                           const Vector3<Rational>& point) {
  Vector3<Rational> tangent;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) tangent[i] += conic[i][j] * point[j];
  }
  // w2 = e_k is off the tangent; w1 is on it, and not the point, whose coordinate j is not zero.
  std::size_t k = 0;
  while (tangent[k].is_zero()) ++k;
  std::size_t i = (k + 1) % 3, j = (k + 2) % 3;
  if (point[j].is_zero()) std::swap(i, j);
  Vector3<Rational> w1, w2;
  w1[i] = tangent[k];
  w1[k] = -tangent[i];
  w2[k] = Rational(1);
  const auto q = [&](const Vector3<Rational>& v, const Vector3<Rational>& w) {
    Rational sum;
    for (std::size_t a = 0; a < 3; ++a) {
      for (std::size_t b = 0; b < 3; ++b) sum += v[a] * conic[a][b] * w[b];
    }
    return Form<Rational>::constant(sum);
  };
  UnbalancedLattice<Rational> lattice{{}, tangent[k], q(w1, w1)[0], q(w1, w2), q(w2, w2)};
  for (std::size_t row = 0; row < 3; ++row) {
    lattice.basis[row] = {Form<Rational>::constant(point[row]), Form<Rational>::constant(w1[row]),
                          Form<Rational>::constant(w2[row])};
  }
  Matrix3<Rational> points;
  const Matrix3<Form<Rational>> forms = points_of_unbalanced_lattice(lattice);
  for (std::size_t row = 0; row < 3; ++row) {
    for (std::size_t column = 0; column < 3; ++column) {
      points[row][column] = forms[row][column][0];
    }
  }
  return points;
}

}  // namespace pn
