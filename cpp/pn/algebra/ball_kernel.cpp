// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/algebra/ball_kernel.hpp"

#include <cmath>
#include <numeric>
#include <utility>

namespace pn {
namespace {

using Matrix = std::vector<std::vector<RealBall>>;

struct Pivot {
  std::size_t row, column;
};

/// The largest entry from this row and column on.
Pivot largest_entry(const Matrix& matrix, const std::vector<std::size_t>& column,
                    std::size_t from) {
  Pivot best{from, from};
  double largest = -1;
  for (std::size_t i = from; i < matrix.size(); ++i) {
    for (std::size_t j = from; j < column.size(); ++j) {
      const double size = std::abs(matrix[i][column[j]].midpoint());
      if (size > largest) {
        largest = size;
        best = {i, j};
      }
    }
  }
  return best;
}

}  // namespace

std::optional<Matrix> kernel(Matrix matrix, std::size_t rank) {
  const std::size_t n = matrix.empty() ? 0 : matrix.front().size();
  std::vector<std::size_t> column(n);
  std::iota(column.begin(), column.end(), std::size_t{0});
  for (std::size_t k = 0; k < rank; ++k) {
    const Pivot pivot = largest_entry(matrix, column, k);
    std::swap(matrix[k], matrix[pivot.row]);
    std::swap(column[k], column[pivot.column]);
    const std::vector<RealBall>& row = matrix[k];
    if (row[column[k]].contains_zero()) return std::nullopt;
    for (std::size_t i = k + 1; i < matrix.size(); ++i) {
      const RealBall factor = -matrix[i][column[k]] / row[column[k]];
      if (factor.is_zero()) continue;
      for (std::size_t j = k + 1; j < n; ++j) {
        matrix[i][column[j]].add_product(factor, row[column[j]]);
      }
    }
  }
  Matrix basis;
  for (std::size_t free = rank; free < n; ++free) {
    std::vector<RealBall> vector(n);
    vector[column[free]] = RealBall(1);
    for (std::size_t k = rank; k-- > 0;) {
      RealBall sum = matrix[k][column[free]];
      for (std::size_t j = k + 1; j < rank; ++j) {
        sum.add_product(matrix[k][column[j]], vector[column[j]]);
      }
      vector[column[k]] = -sum / matrix[k][column[k]];
    }
    basis.push_back(std::move(vector));
  }
  return basis;
}

}  // namespace pn
