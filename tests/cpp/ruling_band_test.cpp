// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/bezier/ruling_band.hpp"

#include <catch2/catch.hpp>

#include "enclosures.hpp"
#include "pn/isotropic/seam.hpp"
#include "rulings_between.hpp"

using namespace pn;
using namespace pn::test;

namespace {

IsotropicHypersurface<double> band() {
  RandomDirectrices random(41);
  return midpoint(along(random.lines(2, 3)).enclosure(128));
}

Eigen::Vector3d normal_of(const Eigen::Vector2cd& a) {
  const auto mixed = std::conj(a(0)) * a(1);
  return Eigen::Vector3d(2 * mixed.real(), 2 * mixed.imag(), std::norm(a(0)) - std::norm(a(1))) /
         a.squaredNorm();
}

const RulingForms<double>& rulings_of(const IsotropicHypersurface<double>& gamma) {
  return std::get<RulingForms<double>>(gamma.carrier);
}

}  // namespace

TEST_CASE("The target lines are normals of weight 1 beyond both directrices", "[ruling_band]") {
  constexpr double kMargin = 0.125;
  const auto gamma = band();
  const BandLines lines({gamma}, kMargin);
  for (const double t : {0.0, 0.3, 0.9}) {
    const Eigen::Matrix2cd a = value_at(gamma.spinor, t) * lines.at(0, t);
    CHECK(a.col(0).norm() == Approx(1));
    CHECK(a.col(1).norm() == Approx(1));
    // The directrices are as far inside as the margin says: with s = m / (1 + 2 m) on the chord.
    const auto& rulings = rulings_of(gamma);
    const Eigen::Vector2cd low = (1 + kMargin) * a.col(0) + kMargin * a.col(1),
                           high = kMargin * a.col(0) + (1 + kMargin) * a.col(1);
    CHECK((normal_of(low) - band_normal(rulings, t, 0)).norm() < 1e-10);
    CHECK((normal_of(high) - band_normal(rulings, t, 1)).norm() < 1e-10);
    // The short arc: the weight in its middle is the cosine of half the angle between the normals.
    const double cosine = std::sqrt((1 + normal_of(a.col(0)).dot(normal_of(a.col(1)))) / 2);
    CHECK(a.col(0).dot(a.col(1)).real() == Approx(cosine));
  }
}

TEST_CASE("A directrix lies where its tangent is orthogonal to the normal", "[ruling_band]") {
  const auto gamma = band();
  const BandLines lines({gamma}, 0.125);
  const auto w = isotropic_vector<double>(gamma.spinor);
  const auto forms = directrix_forms(rulings_of(gamma), w);
  for (const double t : {0.1, 0.5}) {
    // At this t the lines A F in place of A.
    const Eigen::Matrix2cd a = value_at(gamma.spinor, t) * lines.at(0, t);
    for (const std::size_t side : {0, 1}) {
      FormInU<double> there;
      const Eigen::Matrix2d f = lines.at(0, t);
      const auto value = [&](const Eigen::Vector2d& u, const Eigen::Vector2d& v) {
        const auto& c = forms[side].coefficient;
        return c[0](t) * u(0) * v(0) + c[1](t) * (u(0) * v(1) + u(1) * v(0)) +
               c[2](t) * u(1) * v(1);
      };
      for (const double q :
           {value(f.col(0), f.col(0)), value(f.col(0), f.col(1)), value(f.col(1), f.col(1))}) {
        there.coefficient.push_back(Form<double>::constant(q));
      }
      const double s = band_parameter(there, t);
      CHECK(s > 0);
      CHECK(s < 1);
      const Eigen::Vector3d n = normal_of(a.col(0) * (1 - s) + a.col(1) * s);
      CHECK((n - band_normal(rulings_of(gamma), t, static_cast<double>(side))).norm() < 1e-10);
    }
  }
}

TEST_CASE("Of two zeros the one nearer to the band", "[ruling_band]") {
  // (s - 1/4)(s - 3) and (s + 2)(s - 7/8) as Bernstein coefficients; a linear one too.
  const auto with = [](double q0, double q1, double q2) {
    FormInU<double> form;
    for (const double q : {q0, q1, q2}) form.coefficient.push_back(Form<double>::constant(q));
    return form;
  };
  const auto product = [&](double a, double b) {
    return with(a * b, a * b - (a + b) / 2, (1 - a) * (1 - b));
  };
  CHECK(band_parameter(product(0.25, 3), 0) == Approx(0.25));
  CHECK(band_parameter(product(-2, 0.875), 0) == Approx(0.875));
  CHECK(band_parameter(product(1e9, 0.5), 0) == Approx(0.5));
  CHECK(band_parameter(product(0, 5), 0) == Approx(0).margin(1e-15));
  CHECK(band_parameter(product(1, -4), 0) == Approx(1));
}

TEST_CASE("Two links that end at a torsal ruling share its lines and weights", "[ruling_band]") {
  // On the x-axis with rulings (., 4, z), z' = (2 t - 1) (t + 2): torsal at 1/2, where they meet.
  const RationalPolynomial z = RationalPolynomial(
      {Rational(1L), Rational(-2L), Rational(3L) / Rational(2L), Rational(2L) / Rational(3L)});
  const Rational half = Rational(1L) / Rational(2L);
  const auto link = [&](const Rational& origin) {
    const auto part = [&](const RationalPolynomial& p) { return p.on_interval(origin, half); };
    const Directrices curves = {
        SphereCurve{{part(polynomial({0, 5})), 0L, 0L}, 0L, 1L},
        SphereCurve{{part(polynomial({1, 7, 1})), RationalPolynomial(4L), part(z)}, 0L, 1L}};
    return along(curves, {half, true, true}).enclosure(192);
  };
  const auto left = link(0L), right = link(half);
  const auto frame = [](const IsotropicHypersurface<RealBall>& gamma, int end) {
    return torsal_frame(rulings_of(gamma), gamma.spinor, end);
  };
  const auto ratio = lines::operator*(lines::inverse(frame(right, 0)), frame(left, 1));
  const auto lined = lines::lined<RealBall>(right.spinor, lines::constant_line(ratio));
  const auto a = sections(left.carrier, isotropic_vector<RealBall>(left.spinor));
  const auto b = sections(right.carrier, isotropic_vector<RealBall>(lined));
  const auto same = [](const FormInU<RealBall>& f, const FormInU<RealBall>& g) {
    for (std::size_t j = 0; j < f.coefficient.size(); ++j) {
      CHECK(encloses_zero(f.coefficient[j](RealBall(1)) - g.coefficient[j](RealBall(0)), 1e-20));
    }
  };
  same(a.weight, b.weight);
  for (std::size_t i = 0; i < 3; ++i) {
    same(a.point[i], b.point[i]);
    same(a.direction[i], b.direction[i]);
  }
}
