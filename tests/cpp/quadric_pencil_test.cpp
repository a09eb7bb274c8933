// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/isotropic/quadric_pencil.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "pn/isotropic/seam.hpp"
#include "surface_concept.hpp"

using namespace pn;
using namespace pn::test;

namespace {

using HalfAxes = std::array<Rational, 3>;
using Family = std::shared_ptr<const QuadricFamily>;

HalfAxes half_axes(long a, long b, long c) { return {Rational(a), Rational(b), Rational(c)}; }

/// A quadric by its family and its equation, as a form in (x, y, z, 1).
struct Case {
  Family family;
  std::function<RealBall(const std::array<RealBall, 3>&)> equation;
  double last;  ///< of t, up to which circles stay away from infinity
};

Case ellipsoid(const HalfAxes& half) {
  return {ellipsoid_family(half),
          [=](const std::array<RealBall, 3>& x) {
            RealBall sum(-1);
            for (std::size_t i = 0; i < 3; ++i) {
              const RealBall ratio = x[i] / RealBall(half[i], 256);
              sum += ratio * ratio;
            }
            return sum;
          },
          1};
}

Case hyperboloid(const HalfAxes& half) {
  return {two_sheet_hyperboloid_family(half),
          [=](const std::array<RealBall, 3>& x) {
            const auto square = [&](std::size_t i) {
              const RealBall ratio = x[i] / RealBall(half[i], 256);
              return ratio * ratio;
            };
            return square(2) - square(0) - square(1) - RealBall(1);
          },
          0.15};
}

/// The family of a paraboloid up to steep normals in all directions.
Family paraboloid_family(const HalfAxes& half) {
  std::vector<Eigen::Vector3d> far;
  for (const double angle : {0.0, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0}) {
    far.push_back(Eigen::Vector3d(std::cos(angle), std::sin(angle), -0.5).normalized());
  }
  return elliptic_paraboloid_family(half, far);
}

Case paraboloid(const HalfAxes& half) {
  return {paraboloid_family(half),
          [=](const std::array<RealBall, 3>& x) {
            const auto square = [&](std::size_t i) {
              const RealBall ratio = x[i] / RealBall(half[i], 256);
              return ratio * ratio;
            };
            return x[2] - RealBall(half[2], 256) * (square(0) + square(1));
          },
          0.9};
}

std::vector<Case> cases() {
  std::vector<Case> result;
  // Three half-axes, two equal in every place, b^2 = ac, all equal.
  for (const HalfAxes& half : {half_axes(3, 2, 1), half_axes(1, 5, 4), half_axes(3, 3, 1),
                               half_axes(3, 1, 1), half_axes(4, 2, 1), half_axes(2, 2, 2)}) {
    result.push_back(ellipsoid(half));
    result.push_back(hyperboloid(half));
    result.push_back(paraboloid(half));
  }
  return result;
}

Envelope envelope_of(const Family& family) {
  return Envelope([family](long precision) { return family->forms(precision); }, "nothing");
}

constexpr std::array<std::array<double, 2>, 5> kDirections = {
    {{1, 0}, {0, 1}, {1, 1}, {2, -1}, {-1, 3}}};

}  // namespace

TEST_CASE("The roots of D are those of the closed form", "[quadric_pencil]") {
  for (const Case& quadric : cases()) {
    const LocalForms forms = quadric.family->forms(256);
    const auto& [axis, level] = forms.circles;
    const Form<RealBall> d =
        axis[0] * axis[0] + axis[1] * axis[1] + axis[2] * axis[2] - level * level;
    int count = 2 * forms.roots.infinite_copies;
    for (const DoubleRoots::Real& root : forms.roots.real) {
      count += 2 * root.copies;
      CHECK(encloses_zero(d(root.value), kNarrow));
      CHECK(encloses_zero(d.derivative()(root.value), kNarrow));
    }
    for (const ConjugatePair& pair : forms.roots.pairs) {
      count += 2 * pair.multiplicity;
      ComplexBall value(d[d.degree()]);
      for (int i = d.degree(); i-- > 0;) value = value * pair.value + ComplexBall(d[i]);
      CHECK(value.contains_zero());
    }
    CHECK(count == d.degree());
  }
}

TEST_CASE("Points satisfy the equation, normals are those of the surface", "[quadric_pencil]") {
  for (const Case& quadric : cases()) {
    const IsotropicHypersurface<RealBall> gamma = envelope_of(quadric.family).enclosure(256);
    const auto forms = sections(gamma.carrier, isotropic_vector<RealBall>(gamma.spinor));
    for (const double part : {0.1, 0.5, 0.9}) {
      const RealBall t(part * quadric.last);
      for (const auto& [u0, u1] : kDirections) {
        const EnclosedContact at = contact(forms, t, RealBall(u0), RealBall(u1));
        CHECK(encloses_zero(quadric.equation(at.point), kNarrow));
        check_identities(forms, t, RealBall(u0), RealBall(u1));
      }
    }
  }
}

TEST_CASE("The parameter of a normal is where its circle is", "[quadric_pencil]") {
  for (const Case& quadric : cases()) {
    const auto gamma = midpoint(envelope_of(quadric.family).enclosure(128));
    for (const double part : {0.02, 0.3, 0.6, 0.97}) {
      const double t = part * quadric.last;
      const Eigen::Matrix2cd a = value_at(gamma.spinor, t);
      for (const auto& [u0, u1] : kDirections) {
        const Eigen::Vector2cd spinor = a * Eigen::Vector2d(u0, u1);
        const double size = spinor.squaredNorm();
        const std::complex<double> mixed = std::conj(spinor(0)) * spinor(1);
        const Eigen::Vector3d normal(2 * mixed.real() / size, 2 * mixed.imag() / size,
                                     (std::norm(spinor(0)) - std::norm(spinor(1))) / size);
        CHECK(quadric.family->parameter(normal) == Approx(t).margin(1e-7));
      }
    }
  }
}

TEST_CASE("At a pole all points are one umbilic", "[quadric_pencil]") {
  const IsotropicHypersurface<RealBall> gamma =
      envelope_of(ellipsoid_family(half_axes(3, 2, 1))).enclosure(256);
  const auto forms = sections(gamma.carrier, isotropic_vector<RealBall>(gamma.spinor));
  for (const long end : {0L, 1L}) {
    for (const auto& [u0, u1] : kDirections) {
      const auto [point, normal] = contact(forms, RealBall(end), RealBall(u0), RealBall(u1));
      // x^2 = a^2 (a^2 - b^2) / (a^2 - c^2), y = 0, z^2 = c^2 (b^2 - c^2) / (a^2 - c^2).
      CHECK(encloses_zero(point[0] * point[0] - RealBall(45) / RealBall(8), kNarrow));
      CHECK(encloses_zero(point[1], kNarrow));
      CHECK(encloses_zero(point[2] * point[2] - RealBall(3) / RealBall(8), kNarrow));
    }
  }
}

TEST_CASE("Degrees are those of the theorem", "[quadric_pencil]") {
  const auto degrees = [](const Family& family) {
    const Envelope envelope = envelope_of(family);
    return std::array<int, 2>{envelope.degree(), envelope.degree_around()};
  };
  using Degrees = std::array<int, 2>;
  CHECK(degrees(ellipsoid_family(half_axes(3, 2, 1))) == Degrees{8, 4});
  CHECK(degrees(ellipsoid_family(half_axes(4, 2, 1))) == Degrees{8, 4});
  CHECK(degrees(ellipsoid_family(half_axes(3, 3, 1))) == Degrees{8, 2});
  CHECK(degrees(ellipsoid_family(half_axes(2, 2, 2))) == Degrees{2, 2});
  CHECK(degrees(two_sheet_hyperboloid_family(half_axes(3, 2, 1))) == Degrees{8, 4});
  CHECK(degrees(two_sheet_hyperboloid_family(half_axes(2, 2, 1))) == Degrees{8, 2});
  CHECK(degrees(paraboloid_family(half_axes(3, 2, 1))) == Degrees{6, 4});
  CHECK(degrees(paraboloid_family(half_axes(2, 2, 1))) == Degrees{6, 2});
}

TEST_CASE("Next to a pole the parameter of a normal keeps its digits", "[quadric_pencil]") {
  // Beside an umbilic t grows as the distance of the normals, along every direction.
  for (const Case& quadric : cases()) {
    const CircleForms<double> circles = midpoint(quadric.family->forms(128).circles);
    const Eigen::Vector3d axis(circles.axis[0](0), circles.axis[1](0), circles.axis[2](0));
    const Eigen::Vector3d pole = -axis / circles.level(0);
    const Eigen::Vector3d aside = any_perpendicular(pole);
    for (const double turn : {0.0, 1.0, 2.0}) {
      const Eigen::Vector3d e = Eigen::AngleAxisd(turn, pole) * aside;
      const auto at = [&](double angle) {
        return quadric.family->parameter(std::cos(angle) * pole + std::sin(angle) * e);
      };
      CHECK(at(1e-7) / at(1e-5) == Approx(1e-2).epsilon(1e-4));
      CHECK(at(1e-5) / at(1e-3) == Approx(1e-2).epsilon(1e-2));
    }
  }
}

TEST_CASE("A paraboloid's family ends somewhat beyond the farthest normal", "[quadric_pencil]") {
  for (const double height : {-2.0, -0.5, -0.01}) {
    const Eigen::Vector3d far = Eigen::Vector3d(1, 1, height).normalized();
    const Family family = elliptic_paraboloid_family(half_axes(3, 2, 1), {far});
    CHECK(family->parameter(far) > 0.5);
    CHECK(family->parameter(far) < 0.999);
  }
}
