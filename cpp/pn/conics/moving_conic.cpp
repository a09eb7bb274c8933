// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/conics/moving_conic.hpp"

#include <algorithm>
#include <optional>
#include <vector>

#include "pn/conics/column_reduction.hpp"
#include "pn/geometry_error.hpp"

namespace pn {
namespace {

using Polynomial = RationalPolynomial;
using Point = Vector4OfPolynomials;

LeadingTerm leading_term(const Point& p) {
  std::size_t row = 0;
  for (std::size_t i = 1; i < 4; ++i) {
    if (p[i].degree() >= p[row].degree()) row = i;
  }
  return {row, p[row].degree(), p[row].coefficient(p[row].degree())};
}

void add_multiple(Point& p, const Polynomial& factor, const Point& q) {
  for (std::size_t i = 0; i < 4; ++i) p[i] += factor * q[i];
}

/// The multiple of b of which the leading coefficient is minus that of a.
Polynomial cancelling_factor(const Polynomial& a, const Polynomial& b) {
  return Polynomial(-(a.coefficient(a.degree()) / b.coefficient(b.degree()))) *
         power_of_t(a.degree() - b.degree());
}

/// Columns with the incidences g.w by which Euclid's algorithm goes on until only one is not zero:
/// the others span the plane.
std::vector<Point> spanning_points(const Point& plane) {
  std::vector<Point> columns(4);
  for (std::size_t i = 0; i < 4; ++i) columns[i][i] = Polynomial(1L);
  Point incidence = plane;
  for (;;) {
    std::optional<std::size_t> high, low;
    for (std::size_t i = 0; i < 4; ++i) {
      if (incidence[i].is_zero()) continue;
      if (!high || incidence[i].degree() > incidence[*high].degree()) high = i;
    }
    for (std::size_t i = 0; i < 4; ++i) {
      if (i != *high && !incidence[i].is_zero()) low = i;
    }
    if (!low) {
      columns.erase(columns.begin() + static_cast<std::ptrdiff_t>(*high));
      return columns;
    }
    const Polynomial factor = cancelling_factor(incidence[*high], incidence[*low]);
    incidence[*high] += factor * incidence[*low];
    add_multiple(columns[*high], factor, columns[*low]);
  }
}

}  // namespace

ConicFamily family_of(const MovingConic& conic) {
  Vector3<int> degree{};
  for (std::size_t j = 0; j < 3; ++j) {
    for (const auto& row : conic.frame) degree[j] = std::max(degree[j], row[j].degree());
  }
  return conic_family(conic.conic, degree);
}

std::array<Vector3<Polynomial>, 4> plane_basis(const Point& plane) {
  std::vector<Point> columns = spanning_points(plane);
  reduce_columns(
      columns.size(), [&](std::size_t j) { return leading_term(columns[j]); },
      [&](std::size_t i, const Polynomial& factor, std::size_t j) {
        add_multiple(columns[i], factor, columns[j]);
      });
  std::array<Vector3<Polynomial>, 4> basis;
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = 0; j < 3; ++j) basis[i][j] = columns[j][i];
  }
  return basis;
}

Point join(const Point& a, const Point& b, const Point& c) {
  Point plane;
  for (std::size_t left_out = 0; left_out < 4; ++left_out) {
    Matrix3<Polynomial> rest;
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t row = i + (i >= left_out);
      rest[i] = {a[row], b[row], c[row]};
    }
    plane[left_out] = left_out % 2 == 0 ? determinant(rest) : -determinant(rest);
  }
  return plane;
}

Point kernel_of(const Matrix4OfPolynomials& matrix, const std::string& name) {
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (matrix[i][j] != matrix[j][i]) {
        throw GeometryError(ErrorCode::kWrongShape, name + " is not symmetric.");
      }
    }
  }
  // A column of the adjugate: what three rows have in common.
  for (std::size_t k = 0; k < 4; ++k) {
    Point kernel = join(matrix[(k + 1) % 4], matrix[(k + 2) % 4], matrix[(k + 3) % 4]);
    Polynomial common, det;
    for (std::size_t i = 0; i < 4; ++i) {
      common = gcd(common, kernel[i]);
      det += matrix[k][i] * kernel[i];
    }
    if (!det.is_zero()) {
      throw GeometryError(ErrorCode::kWrongShape, name + " has rank 4, not 3.");
    }
    if (common.is_zero()) continue;
    for (Polynomial& x : kernel) x = exact_quotient(x, common);
    return kernel;
  }
  throw GeometryError(ErrorCode::kSingularConics, name + " has a rank below 3 for all t.");
}

MovingConic conic_of_tangent_planes(const Matrix4OfPolynomials& d) {
  const Point plane = kernel_of(d, "The matrix of the tangent planes");
  MovingConic result;
  result.frame = plane_basis(plane);
  // Without the row in which the plane is not zero, the basis stays regular.
  std::size_t left_out = 0;
  while (plane[left_out].is_zero()) ++left_out;
  Matrix3<Polynomial> rows, dual;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t row = i + (i >= left_out);
    rows[i] = result.frame[row];
    for (std::size_t j = 0; j < 3; ++j) dual[i][j] = d[row][j + (j >= left_out)];
  }
  const Matrix3<Polynomial> points = adjugate(dual);
  for (std::size_t a = 0; a < 3; ++a) {
    for (std::size_t b = 0; b < 3; ++b) {
      for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = 0; j < 3; ++j) {
          result.conic[a][b] += rows[i][a] * points[i][j] * rows[j][b];
        }
      }
    }
  }
  return result;
}

}  // namespace pn
