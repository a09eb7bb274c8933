// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/isotropic/rational_sections.hpp"

#include <catch2/catch.hpp>
#include <stdexcept>

using namespace pn;

namespace {

using Polynomial = BivariatePolynomial;

const Polynomial kU(Variable::kU), kV(Variable::kV), kOne(1L);
const Rational kHalf = Rational(1L) / Rational(2L), kThird = Rational(1L) / Rational(3L);

/// The plane z = 0 over the weight 1 + u, with a normal of length sqrt(2).
RationalSections plane(const Polynomial& factor) {
  const Polynomial weight = (kOne + kU) * factor;
  return rational_sections({kU * weight, kV * weight, Polynomial()}, {Polynomial(), weight, weight},
                           weight, Rational(2L));
}

}  // namespace

TEST_CASE("Common factors are divided out, and the weight is positive", "[rational_sections]") {
  for (const Polynomial& factor : {kOne, kU * kV - Polynomial(2L), kU - Polynomial(3L)}) {
    const SurfaceSections<Rational> x = plane(factor).sections;
    CHECK(in_ring(x.point[0]) == kU);
    CHECK(in_ring(x.point[1]) == kV);
    CHECK(in_ring(x.direction[2]) == kOne);
    CHECK(in_ring(x.weight) == kOne);
  }
  CHECK_THROWS_AS(rational_sections({kU, kV, kOne}, {kOne, kOne, kOne}, Polynomial(), {}),
                  std::domain_error);
}

TEST_CASE("A negative weight becomes positive, and the points stay", "[rational_sections]") {
  const Polynomial weight = -(kOne + kU * kU);
  const SurfaceSections<Rational> x =
      rational_sections({kU, kV, kOne}, {kU, kV, kOne}, weight, std::nullopt).sections;
  CHECK(x.weight.at(kHalf, kHalf).sign() > 0);
  CHECK(x.point[0].at(kHalf, kThird) / x.weight.at(kHalf, kThird) == kHalf / weight(kHalf, kThird));
}

TEST_CASE("A part has the points of the whole", "[rational_sections]") {
  const RationalSections whole = rational_sections({kU * kV, kV * kV, kU + kOne}, {kU, kV, kOne},
                                                   kOne + kU * kU, std::nullopt);
  const RationalSections part = part_of(whole, {kThird, Rational(0L)}, {Rational(1L), kHalf});
  const Rational u = kThird + kHalf * (Rational(1L) - kThird), v = kHalf * kHalf;
  CHECK(part.sections.weight.at(kHalf, kHalf) == whole.sections.weight.at(u, v));
  for (std::size_t i = 0; i < 3; ++i) {
    CHECK(part.sections.point[i].at(kHalf, kHalf) == whole.sections.point[i].at(u, v));
    CHECK(part.sections.direction[i].at(kHalf, kHalf) == whole.sections.direction[i].at(u, v));
  }
}

TEST_CASE("Enclosed normals have length 1", "[rational_sections]") {
  const SurfaceSections<RealBall> x = enclosed(plane(kOne), 128);
  const RealBall y = x.direction[1](0, 0), z = x.direction[2](0, 0);
  CHECK((y * y + z * z).contains(Rational(1L)));
  CHECK(std::abs((y * y + z * z - RealBall(1)).magnitude_upper()) < 1e-30);
}
