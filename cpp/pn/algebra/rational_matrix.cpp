// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/algebra/rational_matrix.hpp"

#include <flint/fmpq_mat.h>

#include <algorithm>
#include <stdexcept>

namespace pn {

namespace {

class FlintMatrix {
 public:
  FlintMatrix(std::size_t rows, std::size_t columns) {
    fmpq_mat_init(value_, static_cast<slong>(rows), static_cast<slong>(columns));
  }
  explicit FlintMatrix(const RationalMatrix& matrix)
      : FlintMatrix(matrix.size(), matrix.empty() ? 0 : matrix.front().size()) {
    for (std::size_t i = 0; i < matrix.size(); ++i) {
      for (std::size_t j = 0; j < matrix[i].size(); ++j)
        fmpq_set(entry(i, j), matrix[i][j].flint());
    }
  }
  FlintMatrix(const FlintMatrix&) = delete;
  FlintMatrix& operator=(const FlintMatrix&) = delete;
  ~FlintMatrix() { fmpq_mat_clear(value_); }

  fmpq_mat_struct* flint() { return value_; }

  /// The first rows.
  RationalMatrix rows(std::size_t count) {
    const auto columns = static_cast<std::size_t>(fmpq_mat_ncols(value_));
    RationalMatrix result(count, std::vector<Rational>(columns));
    for (std::size_t i = 0; i < count; ++i) {
      for (std::size_t j = 0; j < columns; ++j) fmpq_set(result[i][j].flint(), entry(i, j));
    }
    return result;
  }

 private:
  fmpq* entry(std::size_t i, std::size_t j) {
    return fmpq_mat_entry(value_, static_cast<slong>(i), static_cast<slong>(j));
  }

  fmpq_mat_t value_;
};

std::size_t leading_place(const std::vector<Rational>& row) {
  const auto leading =
      std::find_if(row.begin(), row.end(), [](const Rational& x) { return !x.is_zero(); });
  return static_cast<std::size_t>(leading - row.begin());
}

}  // namespace

RationalMatrix row_echelon_form(const RationalMatrix& matrix) {
  FlintMatrix reduced(matrix);
  const slong rank = fmpq_mat_rref(reduced.flint(), reduced.flint());
  return reduced.rows(static_cast<std::size_t>(rank));
}

RationalMatrix null_space(const RationalMatrix& matrix, std::size_t length) {
  const RationalMatrix echelon = row_echelon_form(matrix);
  std::vector<bool> leads(length, false);
  for (const auto& row : echelon) leads[leading_place(row)] = true;
  RationalMatrix basis;
  for (std::size_t free = 0; free < length; ++free) {
    if (leads[free]) continue;
    std::vector<Rational> x(length);
    x[free] = Rational(1L);
    for (const auto& row : echelon) x[leading_place(row)] = -row[free];
    basis.push_back(std::move(x));
  }
  return basis;
}

RationalMatrix inverse(const RationalMatrix& matrix) {
  FlintMatrix result(matrix);
  if (fmpq_mat_inv(result.flint(), result.flint()) == 0)
    throw std::domain_error("The matrix is singular.");
  return result.rows(matrix.size());
}

}  // namespace pn
