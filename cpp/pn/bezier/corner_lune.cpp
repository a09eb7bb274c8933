// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/bezier/corner_lune.hpp"

#include <cmath>
#include <complex>
#include <memory>

#include "pn/bezier/ruling_band.hpp"
#include "pn/bezier/skin_patch.hpp"
#include "pn/bezier/stereographic.hpp"
#include "pn/geometry_error.hpp"

namespace pn {
namespace {

using Complex = std::complex<double>;
using Eigen::Vector3d;
using Parameters = std::array<double, 2>;

/// Middle poles of z0 and z1, and of l: of these short numbers weights are even over all lunes.
constexpr double kMiddle = 11.0 / 16, kBulge = 1.25;
/// The widest lune.
constexpr double kMostAngle = 3;

/// The lune as (a + c b), c = z1 l / z0.
struct LuneCircles {
  Spinor a, b;
  std::array<Complex, 3> l;  ///< poles

  /// c of the circle point with this normal.
  Complex ratio(const Vector3d& normal) const {
    const Spinor x = spinor_of(normal);
    return (a.a0 * x.a1 - a.a1 * x.a0) / (x.a0 * b.a1 - x.a1 * b.a0);
  }

  /// x with z1 / z0 = |c|.
  static double across(double c) {
    FormInU<double> difference;
    for (const double pole : {c, kMiddle * (c - 1), -1.0}) {
      difference.coefficient.push_back(Form<double>::constant(pole));
    }
    return band_parameter(difference, 0);
  }
};

Vector3d normal_of(const Spinor& x) {
  const Complex mixed = std::conj(x.a0) * x.a1;
  return Vector3d(2 * mixed.real(), 2 * mixed.imag(), std::norm(x.a0) - std::norm(x.a1))
      .normalized();
}

LuneCircles circles_between(const QuadraticFamily& family, std::size_t edge) {
  const std::size_t next = (edge + 1) % 3;
  const NormalArc before = end_arc(family, edge, 1), after = end_arc(family, next, 0);
  LuneCircles lune{spinor_of(before(0)), spinor_of(before(1)), {}};
  const double from = std::arg(lune.ratio(before(0.5)));
  double turn = std::arg(lune.ratio(after(0.5)) / std::polar(1.0, from));
  // Of both lunes between the circles that outside both edges: there the sphere is extreme against
  // both ways into the triangle.
  const FamilyInDoubles doubles(family);
  const Parameters corner = on_edge(next, 0), back = on_edge(edge, 0), forth = on_edge(next, 1);
  const auto is_outside = [&](const Vector3d& n) {
    for (const Parameters& to : {back, forth}) {
      const Eigen::Vector4d f = (to[0] - corner[0]) * doubles.by_u(corner[0], corner[1]) +
                                (to[1] - corner[1]) * doubles.by_v(corner[0], corner[1]);
      if (n.dot(f.head<3>()) > f(3)) return false;
    }
    return true;
  };
  const Complex middle = std::polar(1.0, from + turn / 2);
  if (!is_outside(normal_of({lune.a.a0 + middle * lune.b.a0, lune.a.a1 + middle * lune.b.a1}))) {
    turn += turn > 0 ? -2 * M_PI : 2 * M_PI;
  }
  if (!(std::abs(turn) < kMostAngle)) {
    throw GeometryError(ErrorCode::kWeightsNotPositive,
                        "The edges at a corner run nearly in one line: the sphere there has no "
                        "patch with positive weights.");
  }
  lune.l = {std::polar(1.0, from), std::polar(kBulge, from + turn / 2),
            std::polar(1.0, from + turn)};
  return lune;
}

using Polynomial = TensorPolynomial<Rational>;

/// A quadratic with these Bernstein coefficients in one of the variables.
Polynomial quadratic(Variable variable, double b0, double b1, double b2) {
  const Rational p = Rational::exactly(b0), q = Rational::exactly(b1), r = Rational::exactly(b2),
                 two(2L);
  const bool is_u = variable == Variable::kU;
  Polynomial result(is_u ? 2 : 0, is_u ? 0 : 2);
  const auto put = [&](int k, const Rational& c) { result(is_u ? k : 0, is_u ? 0 : k) = c; };
  put(0, p);
  put(1, two * (q - p));
  put(2, p - two * q + r);
  return result;
}

IsotropicPolynomials<Rational> isotropic_polynomials(const LuneCircles& lune) {
  const Polynomial z0 = quadratic(Variable::kV, 1, kMiddle, 0),
                   z1 = quadratic(Variable::kV, 0, kMiddle, 1);
  const auto& [l0, l1, l2] = lune.l;
  const Polynomial re = quadratic(Variable::kU, l0.real(), l1.real(), l2.real()) * z1,
                   im = quadratic(Variable::kU, l0.imag(), l1.imag(), l2.imag()) * z1;
  SpinorPolynomials<Rational> spinor;
  const auto set = [&](std::size_t i, const Complex& a, const Complex& b) {
    const Rational x = Rational::exactly(b.real()), y = Rational::exactly(b.imag());
    spinor.re[i] = z0 * Rational::exactly(a.real()) + re * x - im * y;
    spinor.im[i] = z0 * Rational::exactly(a.imag()) + im * x + re * y;
  };
  set(0, lune.a.a0, lune.b.a0);
  set(1, lune.a.a1, lune.b.a1);
  return pn::isotropic_polynomials(spinor);
}

}  // namespace

ExactPatch corner_lune(const QuadraticFamily& family, std::size_t edge) {
  const LuneCircles lune = circles_between(family, edge);
  constexpr std::array<std::size_t, 3> kCornerAfter = {0, 2, 5};
  const MinkowskiVector<Rational> sphere = family.control()[kCornerAfter[edge]];
  const auto w =
      std::make_shared<const IsotropicPolynomials<Rational>>(isotropic_polynomials(lune));
  const auto sections_at = [sphere, w](long bits) {
    SurfaceSections<RealBall> result;
    const auto in_balls = [bits](const Polynomial& p) {
      return p.mapped([bits](const Rational& c) { return RealBall(c, bits); });
    };
    for (std::size_t c = 0; c < 3; ++c) {
      result.point[c] = in_balls((*w)[3] * sphere[c] - (*w)[c] * sphere[3]);
      result.direction[c] = in_balls((*w)[c]);
    }
    result.weight = in_balls((*w)[3]);
    return result;
  };
  const auto side = [&](double y, const NormalArc& arc, bool is_forward) -> ParameterPath {
    return [=](double at) -> Parameters {
      const double along = is_forward ? at : 1 - at;
      if (along == 0 || along == 1) return {y, along};
      return {y, LuneCircles::across(std::abs(lune.ratio(arc(along))))};
    };
  };
  return {{4, 4},
          sections_at,
          {{{}, {0, 0}, {1, 0}},
           {side(1, end_arc(family, (edge + 1) % 3, 0), true), {}, {}},
           {{}, {1, 1}, {0, 1}},
           {side(0, end_arc(family, edge, 1), false), {}, {}}}};
}

}  // namespace pn
