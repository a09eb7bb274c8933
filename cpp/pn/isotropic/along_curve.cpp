// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/isotropic/along_curve.hpp"

#include "pn/algebra/precision.hpp"
#include "pn/isotropic/root_choice.hpp"

namespace pn {
namespace {

SpinorMatrix<ComplexBall> factorize(const LocalForms& local, const RootChoice& choice) {
  return spinor_factorization(hermitian_matrix(local.curve), half_roots(local.roots, choice));
}

}  // namespace

AlongCurve::AlongCurve(SphereCurve curve, CircleFamily circles)
    : curve_(std::move(curve)), circles_(std::move(circles)) {
  at_sufficient_precision([&](long precision) { choose_roots(precision); });
}

void AlongCurve::require_degree(int degree) const {
  if (degree <= kLargestDegree) return;
  throw GeometryError(
      ErrorCode::kDegreeTooHigh,
      "The exact surface would have degree " + std::to_string(degree) +
          " along the spine; CAD systems stop at " + std::to_string(kLargestDegree) + ". " +
          (substituted_
               ? "The quick change of the radius doubles it: let the radius change more slowly, "
                 "or lower the degree of spine and radius (now "
               : "Lower the degree of spine and radius (now ") +
          std::to_string(curve_.degree()) + "), for instance by a cubic B-spline");
}

void AlongCurve::choose_roots(long precision) {
  LocalForms local = local_forms(curve_, circles_, precision);
  substituted_ = local.curve.level.degree() != circles_.degree();
  require_degree(local.curve.denominator.degree() + 2 * ((local.curve.level.degree() + 1) / 2));
  const RootChoice choice = best_root_choice(local);
  chosen_roots_.clear();
  for (const ComplexBall& root : half_roots(local.roots, choice).complex) {
    chosen_roots_.push_back(root.midpoint());
  }
  SpinorMatrix<ComplexBall> spinor = factorize(local, choice);
  degree_ = local.curve.denominator.degree() + 2 * spinor.degree[0];
  require_degree(degree_);
  first_enclosure_ = {std::move(local.curve), std::move(spinor)};
  first_precision_ = precision;
}

IsotropicHypersurface<RealBall> AlongCurve::enclosure(long precision) const {
  if (precision <= first_precision_) return first_enclosure_;
  LocalForms local = local_forms(curve_, circles_, precision);
  const RootChoice choice = recognized(local.roots, chosen_roots_);
  SpinorMatrix<ComplexBall> spinor = factorize(local, choice);
  return {std::move(local.curve), std::move(spinor)};
}

}  // namespace pn
