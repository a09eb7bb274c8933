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

template <class Combine>
Vector4 each(const Vector4& a, const Vector4& b, const Combine& combine) {
  return {combine(a[0], b[0]), combine(a[1], b[1]), combine(a[2], b[2]), combine(a[3], b[3])};
}

int degree(const Vector4& a) {
  return std::max({a[0].degree(), a[1].degree(), a[2].degree(), a[3].degree()});
}

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
  const double q = c.denominator(t), rate = c.denominator.derivative()(t) / q;
  const std::array<Form<double>, 3> slope = {c.centre[0].derivative(), c.centre[1].derivative(),
                                             c.centre[2].derivative()};
  return {(value(slope, t) - rate * value(c.centre, t)) / q,
          (c.radius.derivative()(t) - rate * c.radius(t)) / q};
}

NormalPlane mean(const NormalPlane& a, const NormalPlane& b, double v) {
  return {(1 - v) * a.axis + v * b.axis, (1 - v) * a.level + v * b.level};
}

/// Places on a span at which <w, g'> is looked at for its sign, which is the same all over it.
constexpr int kSignSamples = 5;

/// The sign of <w, g'>, freed of torsal roots, at the normals half-way between the directrices.
double side_of(const RulingForms<double>& f) {
  double largest = 0;
  for (int i = 0; i < kSignSamples; ++i) {
    const double t = (i + 0.5) / kSignSamples;
    const Vector3d n = band_normal(f, t, 0.5);
    double q = n.x() * f.axis_slope[0](t) + n.y() * f.axis_slope[1](t) +
               n.z() * f.axis_slope[2](t) + f.level_slope(t);
    for (const double torsal : f.torsal_roots) q /= t - torsal;
    if (std::abs(q) > std::abs(largest)) largest = q;
  }
  return largest < 0 ? -1 : 1;
}

/// The linear function by which sections divided by t - t* for every torsal ruling have to be
/// multiplied to continue those of neighbours, which are not. Where a torsal ruling is the joint
/// itself both neighbours divide, and 1 / length makes it the same in the designer's parameter.
Form<RealBall> neighbours_scale(const std::vector<RealBall>& torsal, const RealBall& length) {
  if (torsal.empty()) return Form<RealBall>::constant(RealBall(1));
  RealBall start(1), end(1);
  for (const RealBall& t : torsal) {
    const RealBall from_end = RealBall(1) - t;
    start *= t.is_zero() ? RealBall(1) / length : abs(t);
    end *= from_end.is_zero() ? RealBall(1) / length : abs(from_end);
  }
  return Form<RealBall>({start, end - start});
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
  const NormalPlane motion =
      mean(motion_plane(rulings.directrices[0], t), motion_plane(rulings.directrices[1], t), v);
  const Vector3d across = motion.axis.cross(g.axis);
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
  const RationalPolynomial common =
      common_divisor(direction.level, {direction.axis.begin(), direction.axis.end()});
  if (common.is_zero()) return {{first, {}}, common};
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

RationalPolynomial torsion(const Rulings& rulings) {
  const Vector4 a = motion(rulings.point), g = vector_of(rulings.direction), turn = slope(g);
  return common_divisor(determinant(a, g, turn, 0, 1, 2),
                        {determinant(a, g, turn, 0, 1, 3), determinant(a, g, turn, 0, 2, 3),
                         determinant(a, g, turn, 1, 2, 3)});
}

std::vector<RealBall> torsal_roots(const Rulings& rulings, long precision) {
  RationalPolynomial turn = torsion(rulings);
  std::vector<RealBall> roots;
  for (const long end : {0L, 1L}) {
    if (!turn(Rational(end)).is_zero()) continue;
    roots.emplace_back(end);
    turn = turn.without_root(Rational(end));
  }
  if (turn.degree() == 0) return roots;
  for (const RealRoot& root : isolate_roots(turn, precision).real) {
    const RealBall from_end = RealBall(1) - root.value;
    if (root.value.is_negative() || from_end.is_negative()) continue;
    if (!root.value.is_positive() || !from_end.is_positive()) {
      throw Undecided("the place of a torsal ruling");
    }
    roots.push_back(root.value);
  }
  return roots;
}

LocalForms local_forms(const Rulings& rulings, const std::array<SphereCurve, 2>& directrices,
                       const Rational& length, long precision) {
  LocalFamily family = local_family(rulings.direction, precision);
  const LocalParameter& t = *family.parameter;
  const SphereCurveForms<RealBall> a = curve_forms(rulings.point, t);
  CircleForms<RealBall> g = circle_forms(rulings.direction, t);
  const RealBall rate(Rational(1) / length, precision);
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
  f.torsal_roots = torsal_roots(rulings, precision);
  f.scale = neighbours_scale(f.torsal_roots, RealBall(length, precision));
  f.degree = t.is_substituted() ? 2 * a.denominator.degree() + g.level.degree() - 2
                                : excess_degree(rulings);
  for (const DoubleRoots::Real& root : family.roots.real) {
    f.common_roots.insert(f.common_roots.end(), root.copies, root.value);
  }
  f.common_at_infinity = family.roots.infinite_copies;
  const double side = side_of(std::get<RulingForms<double>>(midpoint(Carrier<RealBall>(f))));
  return {turned(std::move(f), side), std::move(g), std::move(family.roots), t.is_substituted()};
}

Envelope along_rulings(const Rulings& rulings, const std::array<SphereCurve, 2>& directrices,
                       const Rational& length) {
  return Envelope(
      [=](long precision) { return local_forms(rulings, directrices, length, precision); },
      "the degree of both curves (now " +
          std::to_string(std::max(directrices[0].degree(), directrices[1].degree())) +
          "), for instance by cubic B-splines");
}

}  // namespace pn
