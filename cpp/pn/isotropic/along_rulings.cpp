// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/isotropic/along_rulings.hpp"

#include <algorithm>
#include <cmath>

namespace pn {

using Eigen::Vector3d;

namespace {

/// A vector of R^{3,1} with polynomial coordinates.
using Vector4 = std::array<RationalPolynomial, 4>;

Vector4 numerator(const SphereCurve& c) {
  return {c.centre[0], c.centre[1], c.centre[2], -c.radius};
}

Vector4 vector_of(const CircleFamily& g) { return {g.axis[0], g.axis[1], g.axis[2], -g.level}; }

/// The coordinates of a ^ b.
std::vector<RationalPolynomial> bivector(const Vector4& a, const Vector4& b) {
  std::vector<RationalPolynomial> result;
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = i + 1; j < 4; ++j) result.push_back(a[i] * b[j] - a[j] * b[i]);
  }
  return result;
}

/// The greatest common divisor of q and of all these polynomials.
RationalPolynomial common_divisor(RationalPolynomial q,
                                  const std::vector<RationalPolynomial>& polynomials) {
  for (const RationalPolynomial& p : polynomials) {
    if (q.degree() == 0) return RationalPolynomial(1L);
    q = gcd(q, p);
  }
  return q;
}

/// k with a + k g = 0 modulo q, where g is coprime and a ^ g = 0 modulo q.
RationalPolynomial multiple_that_cancels(const Vector4& a, const Vector4& g,
                                         const RationalPolynomial& q) {
  // Coordinate by coordinate g gets a combination that is invertible modulo more of q.
  RationalPolynomial divisor = q, sum;
  for (std::size_t i = 0; i < 4 && divisor.degree() > 0; ++i) {
    const BezoutIdentity bezout = extended_gcd(divisor, g[i]);
    // divisor x + g_i y = gcd: the combination so far is worth `divisor` modulo q, g_i y the rest.
    sum = remainder(sum * bezout.x - a[i] * bezout.y, q);
    divisor = bezout.gcd;
  }
  return sum;
}

/// The wronskian p' q - p q'.
RationalPolynomial wronskian(const RationalPolynomial& p, const RationalPolynomial& q) {
  return p.derivative() * q - p * q.derivative();
}

/// e of the theorem, without substitution.
int excess_degree(const Rulings& rulings) {
  const int m = rulings.point.denominator.degree(), h = rulings.direction.degree();
  int line = m + h;
  for (const RationalPolynomial& b :
       bivector(numerator(rulings.point), vector_of(rulings.direction))) {
    line = std::max(line, b.degree());
  }
  return line == m + h ? 2 * m + h - 2 : m + line - 1;
}

SphereCurveForms<RealBall> curve_forms(const SphereCurve& curve, const LocalParameter& t) {
  const int k = curve.degree();
  SphereCurveForms<RealBall> forms;
  for (std::size_t i = 0; i < 3; ++i) forms.centre[i] = t.form(curve.centre[i], k);
  forms.radius = t.form(curve.radius, k);
  forms.denominator = t.form(curve.denominator, k);
  return forms;
}

RationalPolynomial determinant(const Vector4& a, const Vector4& b, const Vector4& c, std::size_t i,
                               std::size_t j, std::size_t k) {
  return a[i] * (b[j] * c[k] - b[k] * c[j]) - a[j] * (b[i] * c[k] - b[k] * c[i]) +
         a[k] * (b[i] * c[j] - b[j] * c[i]);
}

Vector4 motion(const SphereCurve& point) {
  Vector4 result = numerator(point);
  for (RationalPolynomial& p : result) p = wronskian(p, point.denominator);
  return result;
}

Vector4 slope(const Vector4& g) {
  return {g[0].derivative(), g[1].derivative(), g[2].derivative(), g[3].derivative()};
}

/// The normals n with n.axis + level = 0.
struct NormalPlane {
  Vector3d axis;
  double level;
};

Vector3d value(const std::array<Form<double>, 3>& forms, double t) {
  return {forms[0](t), forms[1](t), forms[2](t)};
}

/// <(n, 1), g> = 0.
NormalPlane ruling_plane(const RulingForms<double>& f, double t) {
  return {value(f.axis, t), f.level(t)};
}

/// <(n, 1), c'> = 0 for a curve of spheres c.
NormalPlane motion_plane(const SphereCurveForms<double>& c, double t) {
  const double q = c.denominator(t), rate = c.denominator.slope(t) / q;
  const Vector3d slope(c.centre[0].slope(t), c.centre[1].slope(t), c.centre[2].slope(t));
  return {(slope - rate * value(c.centre, t)) / q, (c.radius.slope(t) - rate * c.radius(t)) / q};
}

/// <(n, 1), c'> = 0 for the curve at v between the directrices.
NormalPlane motion_plane(const RulingForms<double>& f, double t, double v) {
  const NormalPlane a = motion_plane(f.directrices[0], t), b = motion_plane(f.directrices[1], t);
  return {(1 - v) * a.axis + v * b.axis, (1 - v) * a.level + v * b.level};
}

/// The direction from the other sheet, whose normals are in the same planes, to the wanted one.
Vector3d towards_band(const RulingForms<double>& f, double t, double v) {
  return motion_plane(f, t, v).axis.cross(ruling_plane(f, t).axis);
}

/// Places on a span at which <w, g'> is looked at for its sign, which is the same all over it.
constexpr int kSignSamples = 5;

/// The sign of <w, g'>, freed of the roots that are divided out of the sections, at the normals
/// half-way between the directrices: where <w, g'> is largest, which is beside those roots.
double side_of(const RulingForms<double>& f) {
  double largest = 0, side = 1;
  for (int i = 0; i < kSignSamples; ++i) {
    const double t = (i + 0.5) / kSignSamples;
    const Vector3d n = band_normal(f, t, 0.5);
    const double q = n.x() * f.axis_slope[0](t) + n.y() * f.axis_slope[1](t) +
                     n.z() * f.axis_slope[2](t) + f.level_slope(t);
    if (!(std::abs(q) > largest)) continue;
    largest = std::abs(q);
    side = q < 0 ? -1 : 1;
    for (const double root : f.torsal_roots) side = t < root ? -side : side;
    for (const double root : f.common_roots) side = t < root ? -side : side;
  }
  return side;
}

/// What the sections of a span have to be multiplied by at its ends to continue those of
/// neighbours.
struct EndFactors {
  RealBall start{1}, end{1};

  /// Divided by t - root. Where a torsal root is the joint itself both neighbours divide, and 1 /
  /// length makes it the same in the designer's parameter.
  void divided_by(const RealBall& root, const RealBall& length) {
    const RealBall from_end = RealBall(1) - root;
    start *= root.is_zero() ? RealBall(1) / length : abs(root);
    end *= from_end.is_zero() ? RealBall(1) / length : abs(from_end);
  }
};

/// The linear function that takes these factors at the ends where neighbours meet the span.
Form<RealBall> neighbours_scale(const EndFactors& factors, const SpanPlace& place) {
  const RealBall start = place.meets_before ? factors.start : RealBall(1);
  const RealBall rise = (place.meets_after ? factors.end : RealBall(1)) - start;
  return rise.is_zero() ? Form<RealBall>::constant(start) : Form<RealBall>({start, rise});
}

/// dt / ds at s for the t of the local parameter s.
RealBall speed(const LocalParameter& parameter, const RealBall& s) {
  const Form<RealBall> t = parameter.form(RationalPolynomial({Rational(0), Rational(1)}), 1);
  const Form<RealBall> one = parameter.form(RationalPolynomial(1L), 1);
  return (t.derivative()(s) * one(s) - t(s) * one.derivative()(s)) / (one(s) * one(s));
}

/// The minors of a', g, g' without each of the coordinates.
Vector4 minors(const Rulings& rulings) {
  const Vector4 a = motion(rulings.point), g = vector_of(rulings.direction), turn = slope(g);
  return {determinant(a, g, turn, 1, 2, 3), determinant(a, g, turn, 0, 2, 3),
          determinant(a, g, turn, 0, 1, 3), determinant(a, g, turn, 0, 1, 2)};
}

/// The zeros of a polynomial in the span, exact at joints.
std::vector<RealBall> roots_on_span(RationalPolynomial p, const SpanPlace& place, long precision) {
  std::vector<RealBall> roots;
  for (const long end : {0L, 1L}) {
    if (!p(Rational(end)).is_zero()) continue;
    roots.emplace_back(end);
    p = p.without_root(Rational(end));
  }
  if (p.degree() == 0) return roots;
  const TorsalRange range = torsal_range(place);
  const RealBall low(range.low, precision), high(range.high, precision);
  for (const RealRoot& root : isolate_roots(p, precision).real) {
    const RealBall from_low = root.value - low, from_high = high - root.value;
    if (from_low.is_negative() || from_high.is_negative()) continue;
    if (!from_low.is_positive() || !from_high.is_positive()) {
      throw Undecided("the place of a torsal ruling");
    }
    // Double roots inside are the caller's to refuse; beyond an end they do not matter.
    if (root.multiplicity == 1) roots.push_back(root.value);
  }
  return roots;
}

RationalPolynomial minkowski_square(const Vector4& m) {
  return m[0] * m[0] + m[1] * m[1] + m[2] * m[2] - m[3] * m[3];
}

/// Where a', g and g' are dependent, and where their normal is isotropic and that of the wanted
/// sheet.
std::vector<RealBall> torsal_roots(const Rulings& rulings, const RulingForms<double>& forms,
                                   const LocalParameter& parameter, const SpanPlace& place,
                                   long precision) {
  const RulingNormal normal = ruling_normal(rulings);
  const Vector4& m = normal.coprime;
  // The two sheets are on both sides of the plane of the ruling and its motion.
  const auto is_of_wanted_sheet = [&](const RealBall& root) {
    const Rational t = Rational::exactly(root.midpoint());
    const Vector3d n(m[0](t).to_double(), -m[1](t).to_double(), m[2](t).to_double());
    const double local = parameter.local_of(root).midpoint();
    return n.dot(towards_band(forms, local, 0.5)) * m[3](t).sign() > 0;
  };
  std::vector<RealBall> roots = roots_on_span(normal.torsion, place, precision);
  for (const RealBall& root : roots_on_span(minkowski_square(m), place, precision)) {
    if (is_of_wanted_sheet(root)) roots.push_back(root);
  }
  for (RealBall& root : roots) root = parameter.local_of(root);
  return roots;
}

EndFactors end_factors(const RulingForms<RealBall>& f, const LocalParameter& t,
                       const RealBall& length) {
  EndFactors factors;
  for (const RealBall& root : f.torsal_roots) factors.divided_by(root, length);
  for (const RealBall& root : f.common_roots) factors.divided_by(root, length);
  if (!t.is_substituted()) return factors;
  // The sections hold one slope, which the substitution took by its own parameter.
  factors.start /= speed(t, RealBall(0));
  factors.end /= speed(t, RealBall(1));
  return factors;
}

RulingForms<RealBall> turned(RulingForms<RealBall> f, double factor) {
  const RealBall scale(factor);
  for (std::size_t i = 0; i < 3; ++i) {
    f.point_wronskian[i] = f.point_wronskian[i] * scale;
    f.axis_slope[i] = f.axis_slope[i] * scale;
  }
  f.radius_wronskian = f.radius_wronskian * scale;
  f.level_slope = f.level_slope * scale;
  return f;
}

}  // namespace

Vector3d band_normal(const RulingForms<double>& rulings, double t, double v) {
  const NormalPlane g = ruling_plane(rulings, t);
  const NormalPlane motion = motion_plane(rulings, t, v);
  const Vector3d across = towards_band(rulings, t, v);
  const double determinant = across.squaredNorm();
  const double gg = g.axis.squaredNorm(), gm = g.axis.dot(motion.axis),
               mm = motion.axis.squaredNorm();
  // The point of the line of both planes that is nearest to the origin.
  const double x = (-g.level * mm + motion.level * gm) / determinant;
  const double y = (-motion.level * gg + g.level * gm) / determinant;
  const Vector3d nearest = x * g.axis + y * motion.axis;
  return nearest + std::sqrt(std::max(0.0, 1 - nearest.squaredNorm())) * across.normalized();
}

JoinedRulings joined(const SphereCurve& first, const SphereCurve& second) {
  const bool same = first.denominator == second.denominator;
  const RationalPolynomial one(1L);
  const RationalPolynomial& p = same ? one : first.denominator;
  const RationalPolynomial& q = same ? one : second.denominator;
  JoinedRulings result{{first, {}}, same ? RationalPolynomial(first.denominator) : one};
  CircleFamily& direction = result.rulings.direction;
  for (std::size_t i = 0; i < 3; ++i) {
    direction.axis[i] = second.centre[i] * p - first.centre[i] * q;
  }
  direction.level = second.radius * p - first.radius * q;
  RationalPolynomial common =
      common_divisor(direction.level, {direction.axis.begin(), direction.axis.end()});
  if (common.is_zero()) return {{first, {}}, common};
  // Divided by a positive content the direction still leads from the first sphere to the second.
  if (common(Rational(1) / Rational(2)).sign() < 0) common = -common;
  if (common.degree() > 0) {
    for (RationalPolynomial& m : direction.axis) m = exact_quotient(m, common);
    direction.level = exact_quotient(direction.level, common);
    result.content *= common;
  }
  return result;
}

Rulings with_least_denominator(const Rulings& rulings) {
  const Vector4 a = numerator(rulings.point), g = vector_of(rulings.direction);
  const RationalPolynomial& q = rulings.point.denominator;
  const RationalPolynomial reducible = common_divisor(q, bivector(a, g));
  if (reducible.degree() <= 0) return rulings;
  const RationalPolynomial k = multiple_that_cancels(a, g, reducible);
  // A constant denominator becomes 1, so that neighbouring spans have the same.
  const RationalPolynomial rest = exact_quotient(q, reducible);
  const RationalPolynomial divisor = rest.degree() == 0 ? q : reducible;
  const auto shifted = [&](std::size_t i) { return exact_quotient(a[i] + k * g[i], divisor); };
  return {{{shifted(0), shifted(1), shifted(2)}, -shifted(3), exact_quotient(q, divisor)},
          rulings.direction};
}

TorsalRange torsal_range(const SpanPlace& place) {
  const Rational beyond = Rational(1) / Rational(16);
  return {place.meets_before ? Rational(0) : -beyond,
          place.meets_after ? Rational(1) : Rational(1) + beyond};
}

RulingNormal ruling_normal(const Rulings& rulings) {
  RulingNormal result{{}, minors(rulings)};
  Vector4& m = result.coprime;
  result.torsion = common_divisor(m[0], {m[1], m[2], m[3]});
  if (result.torsion.is_zero()) return result;
  for (RationalPolynomial& p : m) p = exact_quotient(p, result.torsion);
  return result;
}

RationalPolynomial torsal_polynomial(const RulingNormal& normal) {
  return normal.torsion * minkowski_square(normal.coprime);
}

LocalForms local_forms(const Rulings& rulings, const std::array<SphereCurve, 2>& directrices,
                       const SpanPlace& place, long precision) {
  LocalFamily family = local_family(rulings.direction, precision);
  const LocalParameter& t = *family.parameter;
  const SphereCurveForms<RealBall> a = curve_forms(rulings.point, t);
  CircleForms<RealBall> g = circle_forms(rulings.direction, t);
  const RealBall rate(Rational(1) / place.length, precision);
  const auto slope_of = [&](const Form<RealBall>& p) { return p.derivative() * rate; };
  const auto wronskian_of = [&](const Form<RealBall>& p) {
    return slope_of(p) * a.denominator - p * slope_of(a.denominator);
  };
  RulingForms<RealBall> f;
  f.point = a.centre;
  f.radius = a.radius;
  f.denominator = a.denominator;
  f.axis = g.axis;
  f.level = g.level;
  for (std::size_t i = 0; i < 3; ++i) {
    f.point_wronskian[i] = wronskian_of(a.centre[i]);
    f.axis_slope[i] = slope_of(g.axis[i]);
  }
  f.radius_wronskian = wronskian_of(a.radius);
  f.level_slope = slope_of(g.level);
  f.directrices = {curve_forms(directrices[0], t), curve_forms(directrices[1], t)};
  f.scale = Form<RealBall>::constant(RealBall(1));
  f.torsal_roots = torsal_roots(
      rulings, std::get<RulingForms<double>>(midpoint(Carrier<RealBall>(f))), t, place, precision);
  f.degree = t.is_substituted() ? 2 * a.denominator.degree() + g.level.degree() - 2
                                : excess_degree(rulings);
  for (const DoubleRoots::Real& root : family.roots.real) {
    f.common_roots.insert(f.common_roots.end(), root.copies, root.value);
  }
  f.common_at_infinity = family.roots.infinite_copies;
  f.scale = neighbours_scale(end_factors(f, t, RealBall(place.length, precision)), place);
  const double side = side_of(std::get<RulingForms<double>>(midpoint(Carrier<RealBall>(f))));
  return {turned(std::move(f), side), std::move(g), std::move(family.roots), t.is_substituted()};
}

int degree_of_lines(const Rulings& rulings) {
  return excess_degree(rulings) + 4 * ((rulings.direction.degree() + 1) / 2);
}

Envelope along_rulings(const Rulings& rulings, const std::array<SphereCurve, 2>& directrices,
                       const SpanPlace& place) {
  return Envelope(
      [=](long precision) { return local_forms(rulings, directrices, place, precision); },
      "the degree of both curves (now " +
          std::to_string(std::max(directrices[0].degree(), directrices[1].degree())) +
          "), for instance by cubic B-splines");
}

}  // namespace pn
