// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/algebra/rational_function.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace pn {
namespace {

template <std::size_t N>
MultivariatePolynomial<N> exact_quotient(const MultivariatePolynomial<N>& a,
                                         const MultivariatePolynomial<N>& b) {
  return *quotient(a, b);
}

/// 1, p, p^2, ..., p^n
template <std::size_t N>
std::vector<MultivariatePolynomial<N>> powers(const MultivariatePolynomial<N>& p, int n) {
  std::vector<MultivariatePolynomial<N>> result = {1L};
  for (int i = 0; i < n; ++i) result.push_back(result.back() * p);
  return result;
}

/// b^d p(a / b) for polynomials of formal degrees d, with one quotient a / b for each variable.
template <std::size_t N, std::size_t M>
class Homogenization {
 public:
  Homogenization(const std::array<RationalFunction<M>, N>& functions,
                 const std::array<int, N>& degrees)
      : degrees_(degrees) {
    for (std::size_t i = 0; i < N; ++i) {
      numerators_[i] = powers(functions[i].numerator(), degrees[i]);
      denominators_[i] = powers(functions[i].denominator(), degrees[i]);
    }
  }

  MultivariatePolynomial<M> operator()(const MultivariatePolynomial<N>& p) const {
    MultivariatePolynomial<M> sum;
    const slong terms = fmpq_mpoly_length(p.flint(), p.ring());
    for (slong term = 0; term < terms; ++term) {
      Rational coefficient;
      std::array<ulong, N> exponents;
      fmpq_mpoly_get_term_coeff_fmpq(coefficient.flint(), p.flint(), term, p.ring());
      fmpq_mpoly_get_term_exp_ui(exponents.data(), p.flint(), term, p.ring());
      MultivariatePolynomial<M> product(coefficient);
      for (std::size_t i = 0; i < N; ++i) {
        product *= numerators_[i][exponents[i]];
        product *= denominators_[i][static_cast<std::size_t>(degrees_[i]) - exponents[i]];
      }
      sum += product;
    }
    return sum;
  }

 private:
  std::array<int, N> degrees_;
  std::array<std::vector<MultivariatePolynomial<M>>, N> numerators_, denominators_;
};

}  // namespace

template <std::size_t N>
RationalFunction<N>::RationalFunction(Polynomial numerator, Polynomial denominator)
    : numerator_(std::move(numerator)), denominator_(std::move(denominator)) {
  if (denominator_.is_zero()) throw std::domain_error("division by zero");
  const Polynomial common =
      gcd(numerator_, denominator_) * Polynomial(leading_coefficient(denominator_));
  numerator_ = exact_quotient(numerator_, common);
  denominator_ = exact_quotient(denominator_, common);
}

template <std::size_t N>
Rational RationalFunction<N>::at(const std::array<Rational, N>& values) const {
  return numerator_.at(values) / denominator_.at(values);
}

template <std::size_t N>
RationalFunction<N> RationalFunction<N>::derivative(Variable variable) const {
  return {numerator_.derivative(variable) * denominator_ -
              numerator_ * denominator_.derivative(variable),
          denominator_ * denominator_};
}

template <std::size_t N>
template <std::size_t M>
RationalFunction<M> RationalFunction<N>::composed(
    const std::array<RationalFunction<M>, N>& functions) const {
  std::array<int, N> degrees;
  for (std::size_t i = 0; i < N; ++i) {
    const auto variable = static_cast<Variable>(i);
    degrees[i] = std::max({numerator_.degree(variable), denominator_.degree(variable), 0});
  }
  const Homogenization<N, M> homogenized(functions, degrees);
  return {homogenized(numerator_), homogenized(denominator_)};
}

template <std::size_t N>
RationalFunction<N>& RationalFunction<N>::operator+=(const RationalFunction& other) {
  const Polynomial common = gcd(denominator_, other.denominator_);
  const Polynomial cofactor = exact_quotient(denominator_, common);
  return *this = {
             numerator_ * exact_quotient(other.denominator_, common) + other.numerator_ * cofactor,
             cofactor * other.denominator_};
}

template <std::size_t N>
RationalFunction<N>& RationalFunction<N>::operator*=(const RationalFunction& other) {
  return *this = {numerator_ * other.numerator_, denominator_ * other.denominator_};
}

template <std::size_t N>
RationalFunction<N>& RationalFunction<N>::operator/=(const RationalFunction& other) {
  return *this = {numerator_ * other.denominator_, denominator_ * other.numerator_};
}

template <std::size_t N>
RationalFunction<N> RationalFunction<N>::operator-() const {
  RationalFunction result = *this;
  result.numerator_ = -numerator_;
  return result;
}

template <std::size_t N>
std::optional<RationalFunction<N>> square_root(const RationalFunction<N>& f) {
  // In lowest terms with a leading coefficient 1 below, a square has squares above and below.
  const auto numerator = square_root(f.numerator()), denominator = square_root(f.denominator());
  if (!numerator || !denominator) return std::nullopt;
  return RationalFunction<N>(*numerator, *denominator);
}

#define PN_INSTANTIATE_COMPOSED(N, M)                            \
  template RationalFunction<M> RationalFunction<N>::composed<M>( \
      const std::array<RationalFunction<M>, N>&) const;
#define PN_INSTANTIATE(N)                                                              \
  template class RationalFunction<N>;                                                  \
  template std::optional<RationalFunction<N>> square_root(const RationalFunction<N>&); \
  PN_INSTANTIATE_COMPOSED(N, 2) PN_INSTANTIATE_COMPOSED(N, 3) PN_INSTANTIATE_COMPOSED(N, 4)

PN_INSTANTIATE(2)
PN_INSTANTIATE(3)
PN_INSTANTIATE(4)

}  // namespace pn
