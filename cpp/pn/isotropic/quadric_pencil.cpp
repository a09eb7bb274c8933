// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/isotropic/quadric_pencil.hpp"

#include <algorithm>
#include <cmath>

namespace pn {
namespace {

using Eigen::Vector3d;
using BallForm = Form<RealBall>;

/// The number of a coordinate axis.
using Axis = std::size_t;

RealBall in_balls(const Rational& x, long precision) { return RealBall(x, precision); }

RealBall root_of(const Rational& x, long precision) {
  return x.is_zero() ? RealBall(0) : sqrt(in_balls(x, precision));
}

BallForm operator*(const RealBall& a, const BallForm& b) { return b * a; }

/// Quadratic forms s^2 and r^2 in the local parameter.
struct Squares {
  BallForm s, r;
};

/// s = t, r = 1 - t: from s = 0 at t = 0 to r = 0 at t = 1.
Squares between_poles() {
  return {BallForm({RealBall(0), RealBall(0), RealBall(1)}),
          BallForm({RealBall(1), RealBall(-2), RealBall(1)})};
}

/// s = t and r from one value at t = 0 to another one at t = 1.
Squares from_pole(const Rational& first, const Rational& last, long precision) {
  const Rational rise = last - first;
  return {BallForm({RealBall(0), RealBall(0), RealBall(1)}),
          BallForm({in_balls(first * first, precision),
                    in_balls(first * rise + first * rise, precision),
                    in_balls(rise * rise, precision)})};
}

/// T as a quotient of forms.
struct Quotient {
  BallForm numerator, denominator;
};

CircleForms<RealBall> no_circles(int degree) {
  const BallForm zero = BallForm::zero(degree);
  return {{zero, zero, zero}, zero};
}

/// The roots of D of a family between two poles: the ends, and s / r = +-i sqrt(k), +-i / sqrt(k).
/// k < 1.
DoubleRoots roots_between_poles(const RealBall& k) {
  DoubleRoots roots;
  roots.real = {{RealBall(0), 1}, {RealBall(1), 1}};
  for (const RealBall& size : {sqrt(k), RealBall(1) / sqrt(k)}) {
    const ComplexBall ratio(RealBall(0), size);
    roots.pairs.push_back({ratio / (ComplexBall(1.0) + ratio), 1});
  }
  return roots;
}

SphereCurveForms<RealBall> spheres_on(Axis axis, const BallForm& centre, const BallForm& radius,
                                      const BallForm& denominator) {
  const BallForm zero = BallForm::zero(denominator.degree());
  SphereCurveForms<RealBall> spheres{{zero, zero, zero}, radius, denominator};
  spheres.centre[axis] = centre;
  return spheres;
}

QuadricForms<RealBall> quadric_forms(int support_degree) {
  QuadricForms<RealBall> forms;
  forms.support.fill(BallForm::zero(support_degree));
  forms.denominator = BallForm::constant(RealBall(1));
  return forms;
}

/// t for s^2 : r^2 with s = t, r = 1 - t.
double between_poles_at(double s_squared, double r_squared) {
  const double s = std::sqrt(std::max(0.0, s_squared)), r = std::sqrt(std::max(0.0, r_squared));
  return s / (s + r);
}

/// The axes ordered by falling values.
template <std::size_t Size>
std::array<Axis, Size> by_size(std::array<Axis, Size> axes, const std::array<Rational, 3>& values) {
  std::stable_sort(axes.begin(), axes.end(), [&](Axis i, Axis j) { return values[j] < values[i]; });
  return axes;
}

/// Centre, radius 1: the circles of latitude, n_z = (s^2 - r^2) / (s^2 + r^2).
class SphereFamily : public QuadricFamily {
 public:
  explicit SphereFamily(const Rational& radius) : radius_(radius) {}

  LocalForms forms(long precision) const override {
    const auto [s, r] = between_poles();
    CircleForms<RealBall> circles = no_circles(2);
    circles.axis[2] = s + r;
    circles.level = r - s;
    DoubleRoots roots;
    roots.real = {{RealBall(0), 1}, {RealBall(1), 1}};
    const BallForm one = BallForm::constant(RealBall(1));
    return {spheres_on(2, BallForm::zero(0), one * in_balls(radius_, precision), one),
            std::move(circles), std::move(roots), true};
  }

  double parameter(const Vector3d& n) const override {
    const Vector3d pole = Vector3d::UnitZ();
    return between_poles_at((n + pole).squaredNorm(), (n - pole).squaredNorm());
  }

 private:
  Rational radius_;
};

/// What the ellipsoid and the hyperboloid have in common: three half-axes in order and T0.
struct OrderedAxes {
  std::array<Axis, 3> axis;
  std::array<Rational, 3> half;  ///< A, B, C
  std::array<double, 3> value;   ///< the same

  Rational square(std::size_t i) const { return half[i] * half[i]; }
  double at(const Vector3d& n, std::size_t i) const {
    return n(static_cast<Eigen::Index>(axis[i]));
  }
  /// sqrt(half_i^2 - half_j^2), i < j.
  double root_of_difference(std::size_t i, std::size_t j) const {
    return std::sqrt((value[i] - value[j]) * (value[i] + value[j]));
  }
  /// With these components along the first and the last axis.
  Vector3d vector(double first, double last) const {
    Vector3d v = Vector3d::Zero();
    v(static_cast<Eigen::Index>(axis[0])) = first;
    v(static_cast<Eigen::Index>(axis[2])) = last;
    return v;
  }
};

OrderedAxes ordered(const std::array<Axis, 3>& axes, const std::array<Rational, 3>& values) {
  const std::array<Rational, 3> half = {values[axes[0]], values[axes[1]], values[axes[2]]};
  return {axes, half, {half[0].to_double(), half[1].to_double(), half[2].to_double()}};
}

class EllipsoidFamily : public QuadricFamily {
 public:
  explicit EllipsoidFamily(const std::array<Rational, 3>& half_axes)
      : axes_(ordered(by_size<3>({0, 1, 2}, half_axes), half_axes)) {}

  LocalForms forms(long precision) const override {
    const auto [t, t0] = ruling(precision);
    const auto& [n, d] = t;
    const RealBall b = in_balls(axes_.half[1], precision);
    const RealBall g = root_of(axes_.square(0) - axes_.square(1), precision);
    const RealBall l = root_of(axes_.square(1) - axes_.square(2), precision);
    CircleForms<RealBall> circles = no_circles(4);
    circles.axis[axes_.axis[0]] = g * (d * d - n * n);
    circles.axis[axes_.axis[2]] = l * (d * d + n * n);
    circles.level = RealBall(-2) * b * (n * d);
    return {carrier(precision), std::move(circles),
            roots_between_poles(in_balls(axes_.half[2] / axes_.half[0], precision)), true};
  }

  double parameter(const Vector3d& n) const override {
    // T is a zero of f(T) = m T^2 + 2 b T - p, and f(T0) = b T0 |n - pole|^2, f(-T0) = -b T0 |n +
    // pole|^2: so the differences T0 - T and T0 + T keep all their digits at the poles.
    const auto [a, b, c] = axes_.value;
    const double g = axes_.root_of_difference(0, 1), l = axes_.root_of_difference(1, 2),
                 whole = axes_.root_of_difference(0, 2);
    const Vector3d pole = axes_.vector(g * c / (b * whole), l * a / (b * whole));
    const double h = Vector3d(a * axes_.at(n, 0), b * axes_.at(n, 1), c * axes_.at(n, 2)).norm();
    const double p = g * axes_.at(n, 0) + l * axes_.at(n, 2),
                 m = g * axes_.at(n, 0) - l * axes_.at(n, 2);
    const double t = p / (b + h), t0 = whole / (a + c);
    return between_poles_at((n + pole).squaredNorm() / (2 * b + m * (t - t0)),
                            (n - pole).squaredNorm() / (2 * b + m * (t + t0)));
  }

 private:
  struct Ruling {
    Quotient t;
    RealBall t0;
  };

  /// T = T0 (s^2 - r^2) / (s^2 + r^2).
  Ruling ruling(long precision) const {
    const Rational ratio = (axes_.half[0] - axes_.half[2]) / (axes_.half[0] + axes_.half[2]);
    const RealBall t0 = root_of(ratio, precision);
    const auto [s, r] = between_poles();
    return {{t0 * (s - r), s + r}, t0};
  }

  Carrier<RealBall> carrier(long precision) const {
    const auto [t, t0] = ruling(precision);
    const auto& [n, d] = t;
    const RealBall b = in_balls(axes_.half[1], precision);
    const RealBall g = root_of(axes_.square(0) - axes_.square(1), precision);
    const RealBall l = root_of(axes_.square(1) - axes_.square(2), precision);
    // Spheres on the axis of revolution, on the conic to which psi shrinks.
    if (l.is_zero()) {
      return spheres_on(axes_.axis[0], RealBall(2) * g * (n * d), b * (d * d - n * n),
                        d * d + n * n);
    }
    if (g.is_zero()) {
      return spheres_on(axes_.axis[2], RealBall(-2) * l * (n * d), b * (d * d + n * n),
                        d * d - n * n);
    }
    // S d = G n N1 - L n N3 + B d w4 and S n = G d N1 + L d N3 - B n w4; T0 d + n = 2 T0 s^2.
    const RealBall half = RealBall(1) / (RealBall(2) * t0);
    QuadricForms<RealBall> forms = quadric_forms(2);
    forms.support[axes_.axis[0]] = half * g * (t0 * n + d);
    forms.support[axes_.axis[2]] = half * l * (d - t0 * n);
    forms.support[3] = half * b * (t0 * d - n);
    forms.common_roots = {RealBall(0), RealBall(0)};
    for (std::size_t i = 0; i < 3; ++i) {
      forms.dual[axes_.axis[i]][axes_.axis[i]] = in_balls(axes_.square(i), precision);
    }
    forms.dual[3][3] = RealBall(1);
    return forms;
  }

  OrderedAxes axes_;
};

class TwoSheetHyperboloidFamily : public QuadricFamily {
 public:
  explicit TwoSheetHyperboloidFamily(const std::array<Rational, 3>& half_axes)
      : axes_(ordered(along_z(by_size<2>({0, 1}, half_axes)), half_axes)) {}

  LocalForms forms(long precision) const override {
    const auto [t, t0] = ruling(precision);
    const auto& [n, d] = t;
    const RealBall b = in_balls(axes_.half[1], precision);
    CircleForms<RealBall> circles = no_circles(4);
    circles.axis[axes_.axis[0]] = p(precision) * (d * d - n * n);
    circles.axis[axes_.axis[2]] = RealBall(2) * q(precision) * (n * d);
    circles.level = b * (d * d + n * n);
    const RealBall c = in_balls(axes_.half[2], precision);
    return {carrier(precision), std::move(circles), roots_between_poles(c / hypotenuse(precision)),
            true};
  }

  double parameter(const Vector3d& n) const override {
    const auto [a, b, c] = axes_.value;
    const double p = std::hypot(a, b), q = axes_.root_of_difference(1, 2), r = std::hypot(a, c);
    const double na = a * axes_.at(n, 0), nb = b * axes_.at(n, 1), nc = c * axes_.at(n, 2);
    const double h = std::sqrt(std::max(0.0, na * na - nb * nb - nc * nc));
    // T is the larger zero of f(T) = d T^2 + 2 q n3 T + (b + p n1), and f(T0) = b r / (r + c)
    // |n - pole|^2: so the difference T0 - T keeps all its digits at the pole.
    const Vector3d pole = axes_.vector(-p * c / (b * r), -q * a / (b * r));
    const double d = b - p * axes_.at(n, 0), skew = q * axes_.at(n, 2);
    const double t = (h - skew) / d, t0 = a / (r + c);
    const double at_end = b * r / (r + c) * (n - pole).squaredNorm();
    return between_poles_at(at_end / (h + skew + d * t0), t0 + t);
  }

 private:
  struct Ruling {
    Quotient t;
    RealBall t0;
  };

  static std::array<Axis, 3> along_z(const std::array<Axis, 2>& across) {
    return {2, across[0], across[1]};
  }

  RealBall p(long precision) const { return root_of(axes_.square(0) + axes_.square(1), precision); }
  RealBall q(long precision) const { return root_of(axes_.square(1) - axes_.square(2), precision); }
  RealBall hypotenuse(long precision) const {
    return root_of(axes_.square(0) + axes_.square(2), precision);
  }

  /// T = T0 (r^2 - s^2) / (s^2 + r^2).
  Ruling ruling(long precision) const {
    const RealBall c = in_balls(axes_.half[2], precision);
    const RealBall t0 = in_balls(axes_.half[0], precision) / (hypotenuse(precision) + c);
    const auto [s, r] = between_poles();
    return {{t0 * (r - s), s + r}, t0};
  }

  Carrier<RealBall> carrier(long precision) const {
    const auto [t, t0] = ruling(precision);
    const auto& [n, d] = t;
    const RealBall b = in_balls(axes_.half[1], precision);
    if (q(precision).is_zero()) {
      return spheres_on(axes_.axis[0], p(precision) * (d * d + n * n), b * (d * d - n * n),
                        RealBall(2) * (n * d));
    }
    // For -S: -S d = -P n N1 + Q d N3 + B n w4 and -S n = -P d N1 - Q n N3 - B d w4; T0 d - n = 2
    // T0 s^2.
    const RealBall half = RealBall(1) / (RealBall(2) * t0);
    QuadricForms<RealBall> forms = quadric_forms(2);
    forms.support[axes_.axis[0]] = half * p(precision) * (d - t0 * n);
    forms.support[axes_.axis[2]] = half * q(precision) * (t0 * d + n);
    forms.support[3] = half * b * (t0 * n + d);
    forms.common_roots = {RealBall(0), RealBall(0)};
    for (std::size_t i = 0; i < 3; ++i) {
      const RealBall square = in_balls(axes_.square(i), precision);
      forms.dual[axes_.axis[i]][axes_.axis[i]] = i == 0 ? -square : square;
    }
    forms.dual[3][3] = RealBall(1);
    return forms;
  }

  OrderedAxes axes_;
};

class EllipticParaboloidFamily : public QuadricFamily {
 public:
  EllipticParaboloidFamily(const std::array<Rational, 3>& half_axes,
                           const std::vector<Vector3d>& far_normals) {
    const auto [first, second] = by_size<2>({0, 1}, half_axes);
    axis_ = {first, second};
    const Rational twice = half_axes[2] + half_axes[2];
    square_ = {half_axes[first] * half_axes[first] / twice,
               half_axes[second] * half_axes[second] / twice};
    pole_ = Vector3d(0, 0, -std::sqrt((square_[1] / square_[0]).to_double()));
    pole_(static_cast<Eigen::Index>(second)) =
        std::sqrt(((square_[0] - square_[1]) / square_[0]).to_double());
    double far = 0;
    for (const Vector3d& n : far_normals) far = std::max(far, ratio(n));
    // The distance from the pole grows nearly as q / (1 - q^2), q = s / r. At the pole weights are
    // as r^6, at the end as (r^2 - s^2)^2 r^2: r is such that they are of one size.
    const double distance = kBeyond * far / (1 - far * far);
    last_ = (1 + std::sqrt(1 + 4 * distance * distance)) / (2 * distance);
    first_ = last_ * std::cbrt(1 - 1 / (last_ * last_));
  }

  LocalForms forms(long precision) const override {
    const Quotient t = ruling(precision);
    CircleForms<RealBall> circles = no_circles(2);
    circles.axis[axis_[1]] = gap(precision) * t.denominator;
    circles.axis[2] = t.numerator;
    circles.level = -root_of(square_[0], precision) * t.denominator;
    DoubleRoots roots;
    roots.real = {{RealBall(0), 1}};
    const Rational first = Rational::exactly(first_), rise = Rational::exactly(last_) - first;
    if (rise.is_zero()) {
      roots.infinite_copies = 1;
    } else {
      roots.real.push_back({in_balls(-first / rise, precision), 1});
    }
    return {carrier(precision), std::move(circles), std::move(roots), true};
  }

  double parameter(const Vector3d& n) const override {
    const double q = ratio(n);
    return first_ * q / (1 - (last_ - first_) * q);
  }

 private:
  RealBall gap(long precision) const { return root_of(square_[0] - square_[1], precision); }

  /// s / r of a normal. -T -+ sqrt(B) is sqrt(A) |n - e|^2 / 2 over -n3, with e the pole and its
  /// mirror image: so the ratio keeps all its digits at the pole.
  double ratio(const Vector3d& n) const {
    const Vector3d mirrored(pole_.x(), pole_.y(), -pole_.z());
    return (n - pole_).norm() / (n - mirrored).norm();
  }

  /// The family ends so much farther from the pole than the farthest normal.
  static constexpr double kBeyond = 1.125;

  /// T = -sqrt(B) (r^2 + s^2) / (r^2 - s^2).
  Quotient ruling(long precision) const {
    const auto [s, r] = from_pole(Rational::exactly(first_), Rational::exactly(last_), precision);
    return {-root_of(square_[1], precision) * (r + s), r - s};
  }

  Carrier<RealBall> carrier(long precision) const {
    const auto [n, d] = ruling(precision);
    const RealBall a = in_balls(square_[0], precision), root = root_of(square_[0], precision);
    const RealBall half(0.5);
    if (gap(precision).is_zero()) {
      return spheres_on(2, half * (n * n + a * (d * d)), -root * (n * d), d * d);
    }
    // S d = (-G n N2 + A d N3 - sqrt(A) n w4) / 2.
    QuadricForms<RealBall> forms = quadric_forms(2);
    forms.support[axis_[1]] = -half * gap(precision) * n;
    forms.support[2] = half * a * d;
    forms.support[3] = -half * root * n;
    forms.denominator = d;
    for (std::size_t i = 0; i < 2; ++i) {
      forms.dual[axis_[i]][axis_[i]] = in_balls(square_[i], precision);
    }
    forms.dual[2][3] = RealBall(1);
    forms.dual[3][2] = RealBall(-1);
    return forms;
  }

  std::array<Axis, 2> axis_;        ///< of A and B
  std::array<Rational, 2> square_;  ///< A and B
  Vector3d pole_;                   ///< the normal at t = 0
  double first_, last_;             ///< r at t = 0 and t = 1
};

}  // namespace

std::shared_ptr<const QuadricFamily> ellipsoid_family(const std::array<Rational, 3>& half_axes) {
  if (half_axes[0] == half_axes[1] && half_axes[1] == half_axes[2]) {
    return std::make_shared<SphereFamily>(half_axes[0]);
  }
  return std::make_shared<EllipsoidFamily>(half_axes);
}

std::shared_ptr<const QuadricFamily> two_sheet_hyperboloid_family(
    const std::array<Rational, 3>& half_axes) {
  return std::make_shared<TwoSheetHyperboloidFamily>(half_axes);
}

std::shared_ptr<const QuadricFamily> elliptic_paraboloid_family(
    const std::array<Rational, 3>& half_axes, const std::vector<Vector3d>& far_normals) {
  return std::make_shared<EllipticParaboloidFamily>(half_axes, far_normals);
}

}  // namespace pn
