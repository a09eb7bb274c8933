// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/isotropic/envelope.hpp"

#include <cmath>

#include "pn/algebra/precision.hpp"
#include "pn/isotropic/root_choice.hpp"
#include "pn/isotropic/torsal_ruling.hpp"

namespace pn {
namespace {

/// The normal of a developable strip needs no factorization: it comes with the strip.
bool brings_its_normal(const Carrier<RealBall>& carrier) {
  return std::holds_alternative<DevelopableForms<RealBall>>(carrier);
}

double length_of_column(const SpinorMatrix<ComplexBall>& a, std::size_t j, const ComplexBall& t) {
  return std::hypot(std::abs(a.entry[0][j](t).midpoint()), std::abs(a.entry[1][j](t).midpoint()));
}

/// A C with a constant real C, a choice in doubles: in the middle both columns get the length 1 and
/// a right angle, nearly. So doubles can follow A along a short span, far from its roots.
SpinorMatrix<ComplexBall> balanced(SpinorMatrix<ComplexBall> a) {
  const ComplexBall middle(0.5);
  for (int pass = 0; pass < 2; ++pass) {
    for (std::size_t j = 0; j < 2; ++j) {
      const ComplexBall scale(std::ldexp(1.0, -std::ilogb(length_of_column(a, j, middle))));
      for (auto& row : a.entry) row[j] = row[j] * scale;
    }
    double dot = 0, square = 0;
    for (const auto& row : a.entry) {
      const std::complex<double> x = row[0](middle).midpoint(), y = row[1](middle).midpoint();
      dot += (std::conj(y) * x).real();
      square += std::norm(y);
    }
    for (auto& row : a.entry)
      row[0] = row[0] + row[1].elevated(row[0].degree()) * ComplexBall(-dot / square);
  }
  return a;
}

SpinorMatrix<ComplexBall> factorize(const LocalForms& local, const RootChoice& choice) {
  if (brings_its_normal(local.carrier)) return {};
  SpinorMatrix<ComplexBall> spinor =
      spinor_factorization(hermitian_matrix(local.circles), half_roots(local.roots, choice));
  const auto* rulings = std::get_if<RulingForms<RealBall>>(&local.carrier);
  return rulings ? pinched_at_torsal_rulings(balanced(std::move(spinor)), *rulings) : spinor;
}

}  // namespace

CircleForms<RealBall> circle_forms(const CircleFamily& circles, const LocalParameter& parameter) {
  const int h = circles.degree();
  CircleForms<RealBall> result;
  for (std::size_t i = 0; i < 3; ++i) result.axis[i] = parameter.form(circles.axis[i], h);
  result.level = parameter.form(circles.level, h);
  return result;
}

Envelope::Envelope(std::function<LocalForms(long)> forms, std::string advice)
    : forms_(std::move(forms)), advice_(std::move(advice)) {
  at_sufficient_precision([&](long precision) { choose_roots(precision); });
}

void Envelope::require_degree(int degree) const {
  if (degree <= kLargestDegree) return;
  throw GeometryError(ErrorCode::kDegreeTooHigh,
                      "The exact surface would have degree " + std::to_string(degree) +
                          "; CAD systems stop at " + std::to_string(kLargestDegree) + ". " +
                          (substituted_ ? "The quick change of the radius doubles it: let the "
                                          "radius change more slowly, or lower "
                                        : "Lower ") +
                          advice_);
}

void Envelope::choose_roots(long precision) {
  LocalForms local = forms_(precision);
  substituted_ = local.is_substituted;
  degree_around_ = section_degree_around(local.carrier);
  // No choice of roots does better than this, and the search for one takes time.
  const int least = brings_its_normal(local.carrier) ? 0 : (local.circles.level.degree() + 1) / 2;
  require_degree(section_degree(local.carrier, least));
  const RootChoice choice =
      local.roots.pairs.empty() ? RootChoice{} : best_root_choice(local.circles, local.roots);
  chosen_roots_.clear();
  for (std::size_t i = 0; i < choice.size(); ++i) {
    const std::complex<double> upper = local.roots.pairs[i].value.midpoint();
    chosen_roots_.insert(chosen_roots_.end(), static_cast<std::size_t>(choice[i]), upper);
  }
  SpinorMatrix<ComplexBall> spinor = factorize(local, choice);
  degree_ = section_degree(local.carrier, spinor.degree[0]);
  require_degree(degree_);
  first_enclosure_ = {std::move(local.carrier), std::move(local.circles), std::move(spinor)};
  first_precision_ = precision;
}

IsotropicHypersurface<RealBall> Envelope::enclosure(long precision) const {
  if (precision <= first_precision_) return first_enclosure_;
  LocalForms local = forms_(precision);
  const RootChoice choice = recognized(local.roots, chosen_roots_);
  SpinorMatrix<ComplexBall> spinor = factorize(local, choice);
  return {std::move(local.carrier), std::move(local.circles), std::move(spinor)};
}

}  // namespace pn
