// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/bezier/circle_chart.hpp"

#include <algorithm>
#include <cmath>
#include <memory>

#include "pn/algebra/precision.hpp"
#include "pn/bezier/line_factor.hpp"
#include "pn/bezier/projective_change.hpp"
#include "pn/isotropic/along_curve.hpp"
#include "pn/isotropic/along_translation.hpp"
#include "pn/isotropic/seam.hpp"

namespace pn {
namespace {

using Eigen::Matrix2d;
using Eigen::Vector2d;
using Eigen::Vector3d;
using Parameters = std::array<double, 2>;

/// Circles on which the ends of the arcs are looked at.
constexpr int kSamples = 32;
/// The patch is wider than what was seen of the arcs by this part: their ends move between the
/// samples.
constexpr double kMargin = 1.0 / 50;

SphereCurve sphere_curve(const SphereParabola& c) {
  const Rational half = Rational(1L) / Rational(2L);
  const auto component = [&](std::size_t i) {
    return RationalPolynomial({c.start[i], c.first[i], half * c.second[i]});
  };
  return {{component(0), component(1), component(2)},
          -component(3),
          RationalPolynomial(std::vector<Rational>{Rational(1L)})};
}

/// A (1 0; rho 1) with rho = shear (t - 1/2), of the same degrees where those of A are (1, 0).
template <class C>
SpinorMatrix<C> sheared(SpinorMatrix<C> a, double shear) {
  if (shear == 0) return a;
  const C slope(shear);
  const Form<C> rho({C(-0.5) * slope, slope});
  for (auto& row : a.entry) row[0] += rho * row[1];
  return a;
}

/// The circles of c, and where its parameters lie in theirs.
class Circles {
 public:
  explicit Circles(const SphereParabola& c)
      : Circles(sphere_curve(c), tangent_direction(sphere_curve(c)).circles) {}

  const Envelope& envelope() const { return envelope_; }
  double parameter(double u) const { return parameter_->local_of(RealBall(u)).midpoint(); }
  /// The spinor A at u, nearly.
  Eigen::Matrix2cd spinor(double u) const { return value_at(spinor_, parameter(u)); }

  /// The shear that gives a normal at u = 0 the parameters of another at u = 1; zero where A would
  /// need a higher degree for it.
  double shear(const Vector3d& first, const Vector3d& last) const {
    if (spinor_.degree != std::array{1, 0}) return 0;
    const Vector2d a = parameter_of(spinor(0), first), b = parameter_of(spinor(1), last);
    const double shear = b(1) / b(0) - a(1) / a(0);
    return std::isfinite(shear) ? lines::short_double(shear) : 0;
  }
  Circles with_shear(double shear) const {
    Circles result = *this;
    result.spinor_ = sheared(spinor_, shear);
    return result;
  }

 private:
  Circles(const SphereCurve& curve, const CircleFamily& circles)
      : envelope_(along_curve(curve, circles)),
        spinor_(midpoint(envelope_.enclosure(kLeastPrecision).spinor)),
        parameter_(at_sufficient_precision([&](long bits) {
          return std::shared_ptr<const LocalParameter>(local_family(circles, bits).parameter);
        })) {}

  Envelope envelope_;
  SpinorMatrix<std::complex<double>> spinor_;
  std::shared_ptr<const LocalParameter> parameter_;
};

/// The normals of a sheet.
struct SheetNormals {
  FamilyInDoubles family;
  Sheet sheet;

  Vector3d operator()(double u, double v) const { return family.normal(sheet, u, v); }
};

/// Lines of short numbers, their columns beyond the ends of all arcs; s rises with v on the outer
/// sheet and falls on the inner one, so that S_t x S_s points along the normal. Nothing for arcs
/// too long.
std::optional<Matrix2d> lines_around(const Circles& circles, const SheetNormals& normal) {
  const Matrix2d even = even_factor(circles.spinor(0.5), normal(0.5, 0.5));
  // The angle of a spinor from the middle of the sheet.
  const auto angle = [&](double u, double v) {
    const Vector2d at = even.inverse() * parameter_of(circles.spinor(u), normal(u, v));
    return std::atan(at(1) / at(0));
  };
  double low = 0, high = 0;
  int rising = 0;
  for (int i = 0; i <= kSamples; ++i) {
    const double u = static_cast<double>(i) / kSamples, start = angle(u, 0), end = angle(u, 1);
    low = std::min({low, start, end});
    high = std::max({high, start, end});
    rising += start < end ? 1 : -1;
  }
  const double margin = kMargin * (high - low);
  // A quarter turn of spinors is half a turn of normals, whose weights are not positive. Where
  // angles wrap around, arcs seem to run in both directions.
  if (std::abs(rising) <= kSamples || !(high - low + 2 * margin < M_PI / 2)) return std::nullopt;
  const auto column = [&](double at) {
    return Vector2d(even * Vector2d(std::cos(at), std::sin(at)));
  };
  const bool is_upwards = (rising > 0) == (normal.sheet == Sheet::kOuter);
  Matrix2d lines;
  lines << column(is_upwards ? low - margin : high + margin),
      column(is_upwards ? high + margin : low - margin);
  return lines.unaryExpr([](double x) { return lines::short_double(x); });
}

/// A form in the first parameter.
TensorPolynomial<RealBall> along(const Form<RealBall>& form) {
  TensorPolynomial<RealBall> result(form.degree(), 0);
  for (int i = 0; i <= form.degree(); ++i) result(i, 0) = form[i];
  return result;
}

/// a (1 - s) + b s
TensorPolynomial<RealBall> across(const Form<RealBall>& a, const Form<RealBall>& b) {
  TensorPolynomial<RealBall> s(0, 1);
  s(0, 1) = RealBall(1);
  return along(a) + (along(b) - along(a)) * s;
}

/// w of the spinors B (1 - s, s).
IsotropicPolynomials<RealBall> isotropic_polynomials(const SpinorMatrix<ComplexBall>& b) {
  SpinorPolynomials<RealBall> spinor;
  for (std::size_t i = 0; i < 2; ++i) {
    const auto first = spinor::parts<RealBall>(b.entry[i][0], b.degree[0]),
               second = spinor::parts<RealBall>(b.entry[i][1], b.degree[0]);
    spinor.re[i] = across(first.re, second.re);
    spinor.im[i] = across(first.im, second.im);
  }
  return pn::isotropic_polynomials(spinor);
}

MinkowskiVector<RealBall> in_balls(const MinkowskiVector<Rational>& x, long bits) {
  return {RealBall(x[0], bits), RealBall(x[1], bits), RealBall(x[2], bits), RealBall(x[3], bits)};
}

SurfaceSections<RealBall> chart_sections(const Envelope& envelope, const SphereParabola& d,
                                         double shear, const Matrix2d& lines, long bits) {
  const IsotropicHypersurface<RealBall> gamma = envelope.enclosure(bits);
  const auto& c = std::get<SphereCurveForms<RealBall>>(gamma.carrier);
  const TranslatedCurve<RealBall> translated{
      {along(c.centre[0]), along(c.centre[1]), along(c.centre[2]), along(c.radius) * RealBall(-1)},
      along(c.denominator)};
  const TranslatingParabola<RealBall> translating{in_balls(d.second, bits), in_balls(d.first, bits),
                                                  in_balls(d.start, bits)};
  const auto factor = lines::constant_line(lines::short_doubles<RealBall>(lines));
  return sections(
      translated, translating,
      isotropic_polynomials(lines::lined<RealBall>(sheared(gamma.spinor, shear), factor)));
}

/// The patch with this shear.
std::optional<SkinPatch> patch_with_shear(const TranslationalFamily& family,
                                          const SheetNormals& normal, const Circles& plain,
                                          double shear) {
  const Circles circles = plain.with_shear(shear);
  const auto lines = lines_around(circles, normal);
  if (!lines) return std::nullopt;
  const auto sections = [envelope = circles.envelope(), d = family.d, shear, lines = *lines](
                            long bits) { return chart_sections(envelope, d, shear, lines, bits); };
  const SurfaceSections<RealBall> x = sections(kLeastPrecision);
  const std::array<int, 2> degree = {
      std::max(x.point[0].degree(Variable::kU), x.weight.degree(Variable::kU)),
      std::max(x.point[0].degree(Variable::kV), x.weight.degree(Variable::kV))};
  const TensorPolynomial<RealBall> weight =
      x.weight + TensorPolynomial<RealBall>(degree[0], degree[1]);
  if (!(least_ratio(weight) > 0)) return std::nullopt;
  const ProjectiveChange change = ProjectiveChange::evening(weight);
  return SkinPatch{
      degree,
      [sections, change, degree](long bits) {
        return change.applied(sections(bits), degree, bits);
      },
      [circles, normal, change, inverse = Matrix2d(lines->inverse())](const Parameters& uv) {
        const Vector2d at = inverse * parameter_of(circles.spinor(uv[0]), normal(uv[0], uv[1]));
        return change.place({circles.parameter(uv[0]), at(1) / (at(0) + at(1))});
      },
      normal.sheet, least_ratio(change.applied(x, degree, kLeastPrecision).weight)};
}

}  // namespace

std::optional<SkinPatch> circle_patch(const TranslationalFamily& family, Sheet sheet) {
  const auto is_zero = [](const Rational& x) { return x.is_zero(); };
  if (std::all_of(family.d.second.begin(), family.d.second.end(), is_zero)) return std::nullopt;
  const SheetNormals normal{FamilyInDoubles(quadratic_family(family)), sheet};
  const Circles circles(family.c);
  const double shear = circles.shear(normal(0, 0.5), normal(1, 0.5));
  std::optional<SkinPatch> patch = patch_with_shear(family, normal, circles, 0);
  if (shear == 0) return patch;
  std::optional<SkinPatch> other = patch_with_shear(family, normal, circles, shear);
  const bool is_better = other && (!patch || other->weight_ratio > patch->weight_ratio);
  return is_better ? other : patch;
}

}  // namespace pn
