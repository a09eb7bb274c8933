// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/bezier/circle_chart.hpp"

#include <algorithm>
#include <cmath>
#include <memory>

#include "pn/algebra/precision.hpp"
#include "pn/bezier/line_factor.hpp"
#include "pn/bezier/projective_change.hpp"
#include "pn/isotropic/along_translation.hpp"
#include "pn/isotropic/contact_circles.hpp"
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
/// An arc takes at least this part of the width of the patch. Where d is nearly a line and c is
/// not, arcs are narrow and drift far, and poles would lie as far beyond them.
constexpr double kLeastPart = 1.0 / 32;

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

/// F(t) = (1 0; rho(t) 1) basis columns. The basis is of short numbers and holds the middle of the
/// sheet; the columns, seen from there, have all digits: arcs may be as narrow as doubles tell.
struct ChartLines {
  double shear;
  Matrix2d basis, columns;

  /// A F at this precision.
  SpinorMatrix<ComplexBall> lined(const SpinorMatrix<ComplexBall>& a, long bits) const {
    const auto balls = [bits](const Matrix2d& m) {
      const auto entry = [&](int i, int j) { return RealBall(m(i, j)).at_precision(bits); };
      return lines::Matrix<RealBall>{{{entry(0, 0), entry(0, 1)}, {entry(1, 0), entry(1, 1)}}};
    };
    using lines::operator*;
    return lines::lined<RealBall>(sheared(a, shear),
                                  lines::constant_line(balls(basis) * balls(columns)));
  }
};

/// <w, x> for a constant x.
FormInU<double> product(const IsotropicVector<RealBall>& w, const MinkowskiVector<Rational>& x) {
  const auto constant = [](const Rational& a) {
    return Form<RealBall>::constant(RealBall(a, kLeastPrecision));
  };
  const FormInU<RealBall> sum =
      contracted({constant(x[0]), constant(x[1]), constant(x[2])}, constant(-x[3]), w);
  FormInU<double> result;
  for (const Form<RealBall>& c : sum.coefficient) result.coefficient.push_back(midpoint(c));
  return result;
}

/// Where the normals of (u, v) lie on the lines of a chart: the zeros of P + v Q, quadratic in s.
/// Rounded no earlier than here, they are right in parts of the width of the chart.
class Contacts {
 public:
  Contacts(const SpinorMatrix<ComplexBall>& lined, const SphereParabola& d)
      : Contacts(isotropic_vector<RealBall>(lined), d) {}

  /// Both z = s / (1 - s); P + v Q falls with z at the first and rises at the second.
  std::array<double, 2> zeros(double t, double v) const {
    const std::array<double, 3> q = coefficients(t, v);
    const double root = std::sqrt(std::max(0.0, q[1] * q[1] - q[0] * q[2]));
    return q[1] > 0 ? std::array{(-q[1] - root) / q[2], q[0] / (-q[1] - root)}
                    : std::array{q[0] / (-q[1] + root), (-q[1] + root) / q[2]};
  }

 private:
  Contacts(const IsotropicVector<RealBall>& w, const SphereParabola& d)
      : p_(product(w, d.first)), q_(product(w, d.second)) {}

  std::array<double, 3> coefficients(double t, double v) const {
    const auto at = [&](std::size_t j) { return p_.coefficient[j](t) + v * q_.coefficient[j](t); };
    return {at(0), at(1), at(2)};
  }

  FormInU<double> p_, q_;
};

/// The shear that gives a normal at u = 0 the parameters of another at u = 1; zero where A would
/// need a higher degree for it.
double shear_between(const ContactCircles& circles, const Vector3d& first, const Vector3d& last) {
  if (circles.spinor().degree != std::array{1, 0}) return 0;
  const auto a = midpoint(circles.spinor());
  const Vector2d x = parameter_of(value_at(a, 0), first), y = parameter_of(value_at(a, 1), last);
  const double shear = y(1) / y(0) - x(1) / x(0);
  return std::isfinite(shear) ? shear : 0;
}

/// A chart, and which of both zeros is on its sheet.
struct CircleChart {
  ChartLines lines;
  std::size_t zero;
};

/// What the arcs of all circles take of the lines, as angles of spinors from the middle of the
/// sheet.
struct Sweep {
  double low = HUGE_VAL, high = -HUGE_VAL, narrowest = HUGE_VAL;
  int upwards = 0;  ///< arcs along which the angle rises with v, less those along which it falls

  Sweep(const ContactCircles& circles, const Contacts& contacts, std::size_t zero) {
    for (int i = 0; i <= kSamples; ++i) {
      const double t = circles.parameter(static_cast<double>(i) / kSamples);
      const double start = std::atan(contacts.zeros(t, 0)[zero]),
                   end = std::atan(contacts.zeros(t, 1)[zero]);
      low = std::min({low, start, end});
      high = std::max({high, start, end});
      narrowest = std::min(narrowest, std::abs(end - start));
      upwards += start < end ? 1 : -1;
    }
  }

  double margin() const { return kMargin * (high - low); }

  /// A quarter turn of spinors is half a turn of normals, whose weights are not positive. Where
  /// angles wrap around, arcs seem to run in both directions.
  bool fits() const {
    return std::abs(upwards) > kSamples && high - low + 2 * margin() < M_PI / 2 &&
           narrowest > kLeastPart * (high - low);
  }
};

/// Columns of short numbers around a normal, of the circle at the middle of c.
Matrix2d middle_basis(const ContactCircles& circles, const Vector3d& middle, double shear) {
  const auto spinor = midpoint(sheared(circles.spinor(), shear));
  return even_factor(value_at(spinor, circles.parameter(0.5)), middle).unaryExpr([](double x) {
    return lines::short_double(x);
  });
}

/// The chart with a basis around the middle normal of a sheet. S_t x S_s points along the normal: s
/// rises with v on the outer sheet and falls on the inner one. Nothing for arcs too long or too
/// narrow.
std::optional<CircleChart> chart_around(const ContactCircles& circles, const SphereParabola& d,
                                        Sheet sheet, const Vector3d& middle, double shear) {
  ChartLines lines{shear, middle_basis(circles, middle, shear), Matrix2d::Identity()};
  const Contacts contacts(lines.lined(circles.spinor(), kLeastPrecision), d);
  const auto [falling, rising] = contacts.zeros(circles.parameter(0.5), 0.5);
  const std::size_t zero = std::abs(falling) < std::abs(rising) ? 0 : 1;
  const Sweep sweep(circles, contacts, zero);
  if (!sweep.fits()) return std::nullopt;
  const bool is_upwards = (sweep.upwards > 0) == (sheet == Sheet::kOuter);
  const double low = sweep.low - sweep.margin(), high = sweep.high + sweep.margin(),
               first = is_upwards ? low : high, last = is_upwards ? high : low;
  lines.columns << std::cos(first), std::cos(last), std::sin(first), std::sin(last);
  return CircleChart{lines, is_upwards ? zero : 1 - zero};
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
                                         const ChartLines& lines, long bits) {
  const IsotropicHypersurface<RealBall> gamma = envelope.enclosure(bits);
  const auto& c = std::get<SphereCurveForms<RealBall>>(gamma.carrier);
  const TranslatedCurve<RealBall> translated{
      {along(c.centre[0]), along(c.centre[1]), along(c.centre[2]), along(c.radius) * RealBall(-1)},
      along(c.denominator)};
  const TranslatingParabola<RealBall> translating{in_balls(d.second, bits), in_balls(d.first, bits),
                                                  in_balls(d.start, bits)};
  return sections(translated, translating, isotropic_polynomials(lines.lined(gamma.spinor, bits)));
}

/// The patch of a chart; nothing without positive weights.
std::optional<SkinPatch> patch_of(const ContactCircles& circles, const SphereParabola& d,
                                  Sheet sheet, const CircleChart& chart) {
  const auto sections = [envelope = circles.envelope(), d, lines = chart.lines](long bits) {
    return chart_sections(envelope, d, lines, bits);
  };
  const SurfaceSections<RealBall> x = sections(kLeastPrecision);
  const std::array<int, 2> degree = {
      std::max(x.point[0].degree(Variable::kU), x.weight.degree(Variable::kU)),
      std::max(x.point[0].degree(Variable::kV), x.weight.degree(Variable::kV))};
  const TensorPolynomial<RealBall> weight =
      x.weight + TensorPolynomial<RealBall>(degree[0], degree[1]);
  if (!(least_ratio(weight) > 0)) return std::nullopt;
  const ProjectiveChange change = ProjectiveChange::evening(weight);
  const Contacts contacts(chart.lines.lined(circles.spinor(), kLeastPrecision), d);
  return SkinPatch{degree,
                   [sections, change, degree](long bits) {
                     return change.applied(sections(bits), degree, bits);
                   },
                   [circles, contacts, change, zero = chart.zero](const Parameters& uv) {
                     const double t = circles.parameter(uv[0]), z = contacts.zeros(t, uv[1])[zero];
                     return change.place({t, z / (1 + z)});
                   },
                   sheet, least_ratio(change.applied(x, degree, kLeastPrecision).weight)};
}

}  // namespace

std::optional<SkinPatch> circle_patch(const TranslationalFamily& family, Sheet sheet) {
  const auto& [c, d] = family;
  const auto is_zero = [](const Rational& x) { return x.is_zero(); };
  if (std::all_of(d.second.begin(), d.second.end(), is_zero)) return std::nullopt;
  const FamilyInDoubles doubles(quadratic_family(family));
  const auto normal = [&](double u) { return doubles.normal(sheet, u, 0.5); };
  const ContactCircles circles(sphere_curve(c));
  std::optional<SkinPatch> best;
  for (const double shear : {0.0, shear_between(circles, normal(0), normal(1))}) {
    const auto chart = chart_around(circles, d, sheet, normal(0.5), shear);
    if (!chart) continue;
    std::optional<SkinPatch> patch = patch_of(circles, d, sheet, *chart);
    if (patch && (!best || patch->weight_ratio > best->weight_ratio)) best = std::move(patch);
  }
  return best;
}

}  // namespace pn
