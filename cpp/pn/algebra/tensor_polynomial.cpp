// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/algebra/tensor_polynomial.hpp"

namespace pn {

BivariatePolynomial in_ring(const TensorPolynomial<Rational>& p) {
  std::vector<std::vector<Rational>> rows;
  for (int i = 0; i <= p.degree(Variable::kU); ++i) {
    rows.emplace_back();
    for (int j = 0; j <= p.degree(Variable::kV); ++j) rows.back().push_back(p(i, j));
  }
  return BivariatePolynomial(rows);
}

TensorPolynomial<Rational> dense(const BivariatePolynomial& p) {
  TensorPolynomial<Rational> result(std::max(p.degree(Variable::kU), 0),
                                    std::max(p.degree(Variable::kV), 0));
  for (int i = 0; i <= result.degree(Variable::kU); ++i) {
    for (int j = 0; j <= result.degree(Variable::kV); ++j) result(i, j) = p.coefficient(i, j);
  }
  return result;
}

}  // namespace pn
