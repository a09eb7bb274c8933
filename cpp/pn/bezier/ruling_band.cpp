// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/bezier/ruling_band.hpp"

#include <cmath>

#include "pn/isotropic/seam.hpp"

namespace pn {

using Eigen::Matrix2cd;
using Eigen::Matrix2d;
using Eigen::Vector2d;
using Eigen::Vector3d;

namespace {

template <class T>
FormInU<T> directrix_form(const SphereCurveForms<T>& c, const std::vector<T>& torsal,
                          const IsotropicVector<T>& w) {
  const auto wronskian = [&](const Form<T>& p) {
    return p.derivative() * c.denominator - p * c.denominator.derivative();
  };
  return divided_by_roots(
      contracted({wronskian(c.centre[0]), wronskian(c.centre[1]), wronskian(c.centre[2])},
                 wronskian(c.radius), w),
      torsal);
}

template <class T>
T fourth_root(const T& x) {
  using std::sqrt;
  return sqrt(sqrt(x));
}

/// Both solutions of q0 (1 - s)^2 + 2 q1 (1 - s) s + q2 s^2 = 0, without cancellation.
std::array<double, 2> zeros(double q0, double q1, double q2) {
  const double root = std::sqrt(std::max(0.0, q1 * q1 - q0 * q2));
  const double larger = q1 < 0 ? q1 - root : q1 + root;
  return {q0 / (q0 - larger), larger / (larger - q2)};
}

/// At a torsal ruling all normals are one; so far beside it they are not, and the target is near.
constexpr double kAside = 1e-4;

}  // namespace

template <class T>
DirectrixForms<T> directrix_forms(const RulingForms<T>& rulings, const IsotropicVector<T>& w) {
  return {directrix_form(rulings.directrices[0], rulings.torsal_roots, w),
          directrix_form(rulings.directrices[1], rulings.torsal_roots, w)};
}

template DirectrixForms<double> directrix_forms(const RulingForms<double>&,
                                                const IsotropicVector<double>&);
template DirectrixForms<RealBall> directrix_forms(const RulingForms<RealBall>&,
                                                  const IsotropicVector<RealBall>&);

template <class T>
lines::Matrix<T> torsal_frame(const RulingForms<T>& rulings,
                              const SpinorMatrix<ComplexOf<T>>& pinched, int end) {
  const IsotropicVector<T> w = isotropic_vector<T>(pinched);
  const DirectrixForms<T> forms = directrix_forms(rulings, w);
  const T t(static_cast<double>(end));
  lines::Matrix<T> rows;
  for (std::size_t i = 0; i < 2; ++i) {
    const T q = rulings.directrices[i].denominator(t);
    const T scale = T(1.0) / (q * q);
    // l d with l = (0, 1): the square of the first coordinate of u is missing.
    const std::vector<Form<T>>& c = forms[i].coefficient;
    rows[i] = {T(2.0) * c[1](t) * scale, c[2](t) * scale};
  }
  const lines::Matrix<T> points = lines::inverse(rows);
  const T weight = value(sections(rulings, w).weight, t, points[0][0] - points[0][1],
                         points[1][0] - points[1][1]);
  return lines::scaled(rows, fourth_root(weight));
}

template lines::Matrix<double> torsal_frame(const RulingForms<double>&,
                                            const SpinorMatrix<std::complex<double>>&, int);
template lines::Matrix<RealBall> torsal_frame(const RulingForms<RealBall>&,
                                              const SpinorMatrix<ComplexBall>&, int);

double band_parameter(const FormInU<double>& directrix, double t) {
  const auto [a, b] =
      zeros(directrix.coefficient[0](t), directrix.coefficient[1](t), directrix.coefficient[2](t));
  return std::abs(a - 0.5) < std::abs(b - 0.5) ? a : b;
}

BandLines::BandLines(std::vector<IsotropicHypersurface<double>> links, double margin)
    : links_(std::move(links)), margin_(margin) {
  choose_signs(links_.size());
}

double BandLines::beside_torsal_rulings(std::size_t link, double t) const {
  const auto& rulings = std::get<RulingForms<double>>(links_[link].carrier);
  for (const double torsal : rulings.torsal_roots) {
    if (std::abs(t - torsal) < kAside) return torsal < 0.5 ? torsal + kAside : torsal - kAside;
  }
  return t;
}

Matrix2d BandLines::factor(std::size_t link, double place) const {
  const auto& rulings = std::get<RulingForms<double>>(links_[link].carrier);
  const double t = beside_torsal_rulings(link, place);
  const Matrix2cd a = value_at(links_[link].spinor, t);
  const Vector2d low = parameter_of(a, band_normal(rulings, t, 0));
  const Vector2d turned = parameter_of(a, band_normal(rulings, t, 1));
  const bool is_short_arc = (a * low).dot(a * turned).real() > 0;
  const Vector2d high = is_short_arc ? turned : Vector2d(-turned);
  const Vector2d before = low - margin_ * (high - low), after = high + margin_ * (high - low);
  Matrix2d factor;
  factor << before / (a * before).norm(), after / (a * after).norm();
  return factor;
}

}  // namespace pn
