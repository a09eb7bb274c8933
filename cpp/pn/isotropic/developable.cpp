// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/isotropic/developable.hpp"

#include <algorithm>

#include "pn/isotropic/along_rulings.hpp"

namespace pn {
namespace {

using Vector = std::array<RationalPolynomial, 3>;

Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

RationalPolynomial dot(const Vector& a, const Vector& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

bool is_zero(const Vector& a) { return a[0].is_zero() && a[1].is_zero() && a[2].is_zero(); }

Vector primitive(Vector a) {
  const RationalPolynomial common = gcd(gcd(a[0], a[1]), a[2]);
  for (RationalPolynomial& p : a) p = exact_quotient(p, common);
  return a;
}

Vector opposite(const Vector& a) { return {-a[0], -a[1], -a[2]}; }

/// The direction in which a directrix moves, times its denominator squared.
Vector motion(const SphereCurve& c) {
  Vector result;
  for (std::size_t i = 0; i < 3; ++i) {
    result[i] = c.centre[i].derivative() * c.denominator - c.centre[i] * c.denominator.derivative();
  }
  return result;
}

/// The change of parameter of the theorem, or none.
class StripParameter {
 public:
  StripParameter(const RationalPolynomial& double_cover, long precision) : precision_(precision) {
    if (double_cover.degree() != 2) return;
    const Rational middle = double_cover.coefficient(1) / Rational(-2);
    const Rational square = double_cover.coefficient(0) - middle * middle;
    centre_ = RealBall(middle, precision);
    scale_ = sqrt(RealBall(square, precision));
    const auto place = [&](long t) {
      const RealBall x = (RealBall(t) - centre_) / scale_;
      return x + sqrt(x * x + RealBall(1));
    };
    const RealBall start = place(0);
    s_ = Form<RealBall>({start, place(1) - start});
  }

  bool is_substituted() const { return s_.has_value(); }

  /// p at this formal degree, times (2 s)^degree where t is substituted.
  Form<RealBall> form(const RationalPolynomial& p, int degree) const {
    std::vector<RealBall> coefficients;
    for (int i = 0; i <= degree; ++i) coefficients.emplace_back(p.coefficient(i), precision_);
    if (!s_) return Form<RealBall>(std::move(coefficients));
    const Form<RealBall> square = *s_ * *s_, one({RealBall(1), RealBall(0), RealBall(0)});
    const Form<RealBall> denominator = s_->elevated(2) * RealBall(2);
    const Form<RealBall> numerator = denominator * centre_ + (square - one) * scale_;
    Form<RealBall> sum = Form<RealBall>::constant(coefficients.back());
    Form<RealBall> power = denominator;
    for (int i = degree - 1; i >= 0; --i) {
      sum = sum * numerator + power * coefficients[static_cast<std::size_t>(i)];
      power = power * denominator;
    }
    return sum;
  }

  /// sqrt(q) times 2 s: f (s^2 + 1); 1 without substitution.
  Form<RealBall> cover() const {
    if (!s_) return Form<RealBall>::constant(RealBall(1));
    const Form<RealBall> one({RealBall(1), RealBall(0), RealBall(0)});
    return (*s_ * *s_ + one) * scale_;
  }

 private:
  long precision_;
  RealBall centre_, scale_;
  std::optional<Form<RealBall>> s_;
};

SphereCurveForms<RealBall> curve_forms(const SphereCurve& c, int degree,
                                       const StripParameter& parameter) {
  SphereCurveForms<RealBall> forms;
  for (std::size_t i = 0; i < 3; ++i) forms.centre[i] = parameter.form(c.centre[i], degree);
  forms.radius = parameter.form(c.radius, degree);
  forms.denominator = parameter.form(c.denominator, degree);
  return forms;
}

/// The linear function that makes a positive form 1 at both ends, so that neighbours meet with the
/// same weights.
Form<RealBall> one_at_ends(const Form<RealBall>& form) {
  const RealBall start = RealBall(1) / form(RealBall(0)), end = RealBall(1) / form(RealBall(1));
  const RealBall rise = end - start;
  return rise.contains_zero() ? Form<RealBall>::constant(start) : Form<RealBall>({start, rise});
}

}  // namespace

std::optional<DevelopableStrip> developable_strip(const std::array<SphereCurve, 2>& directrices) {
  const Vector ruling = joined(directrices[0], directrices[1]).rulings.direction.axis;
  const Vector low = cross(motion(directrices[0]), ruling),
               high = cross(motion(directrices[1]), ruling);
  if (is_zero(low) && is_zero(high)) return std::nullopt;
  DevelopableStrip strip{directrices, primitive(is_zero(low) ? high : low), {}, {}, {}};
  const Rational middle = Rational(1) / Rational(2);
  const RationalPolynomial along = dot(strip.normal, is_zero(low) ? high : low);
  if (along(middle).sign() < 0) strip.normal = opposite(strip.normal);
  for (const Vector& side : {low, high}) {
    if (!is_positive_on_unit_interval(dot(strip.normal, side))) return std::nullopt;
  }
  const RationalPolynomial square = dot(strip.normal, strip.normal);
  strip.factor = square.coefficient(square.degree());
  strip.root = strip.double_cover = RationalPolynomial(1L);
  for (const SquarefreeFactor& factor : squarefree_factorization(square)) {
    for (int i = 0; i < factor.multiplicity / 2; ++i) strip.root *= factor.factor;
    if (factor.multiplicity % 2 != 0) strip.double_cover *= factor.factor;
  }
  if (strip.double_cover.degree() > 2) return std::nullopt;
  return strip;
}

LocalForms local_forms(const DevelopableStrip& strip, long precision) {
  const StripParameter parameter(strip.double_cover, precision);
  const int k = std::max(strip.directrices[0].degree(), strip.directrices[1].degree());
  const int h = strip.root.degree() + strip.double_cover.degree() / 2;
  DevelopableForms<RealBall> forms;
  for (std::size_t i = 0; i < 2; ++i) {
    forms.directrices[i] = curve_forms(strip.directrices[i], k, parameter);
  }
  const RationalPolynomial root =
      strip.root(Rational(1) / Rational(2)).sign() < 0 ? -strip.root : strip.root;
  const Form<RealBall> length = parameter.form(root, root.degree()) * parameter.cover() *
                                sqrt(RealBall(strip.factor, precision));
  const Form<RealBall> even = one_at_ends(length);
  forms.length = length * even;
  for (std::size_t i = 0; i < 3; ++i) forms.normal[i] = parameter.form(strip.normal[i], h) * even;
  return {std::move(forms), {}, {}, parameter.is_substituted()};
}

Envelope along_strip(const DevelopableStrip& strip) {
  return Envelope([=](long precision) { return local_forms(strip, precision); },
                  "the degree of both curves");
}

}  // namespace pn
