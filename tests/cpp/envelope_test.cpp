// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/isotropic/envelope.hpp"

#include <catch2/catch.hpp>

#include "enclosures.hpp"
#include "error_code.hpp"
#include "pn/algebra/roots.hpp"
#include "pn/isotropic/along_curve.hpp"
#include "pn/isotropic/seam.hpp"
#include "rulings_between.hpp"

using namespace pn;
using namespace pn::test;

namespace {

const SphereCurve kSpine{
    {polynomial({0, 5, 1}), polynomial({1, 0, 3, 1}), polynomial({2, -1, 0, 4})},
    polynomial({1, 1, -1}),
    1L};

}  // namespace

TEST_CASE("The degrees are those of the sections", "[envelope]") {
  RandomDirectrices random(31);
  const Directrices curves = random.lines(2, 3);
  for (const Envelope& envelope :
       {along_curve(kSpine, tangent_direction(kSpine).circles), along(curves)}) {
    const auto gamma = envelope.enclosure(128);
    const auto forms = sections(gamma.carrier, isotropic_vector<RealBall>(gamma.spinor));
    CHECK(envelope.degree() == forms.weight.coefficient[0].degree());
    CHECK(envelope.degree_around() == forms.weight.degree());
    CHECK(envelope.degree_per_line() == forms.weight.degree());
  }
}

TEST_CASE("Forms that need more precision are asked for it", "[envelope]") {
  const CircleFamily circles = tangent_direction(kSpine).circles;
  std::vector<long> asked;
  const Envelope envelope(
      [&](long precision) {
        asked.push_back(precision);
        if (precision < 300) throw Undecided("at first");
        return local_forms(kSpine, circles, precision);
      },
      "nothing");
  CHECK(asked == std::vector<long>{104, 128, 256, 512});
  CHECK(envelope.degree() == along_curve(kSpine, circles).degree());
  // What is known at the precision of the choice is not computed again below it.
  envelope.enclosure(256);
  CHECK(asked.size() == 4);
  envelope.enclosure(1024);
  CHECK(asked.back() == 1024);
}

TEST_CASE("A degree above 25 is refused with advice", "[envelope]") {
  RandomDirectrices random(32);
  const Directrices curves = random.lines(7, 7);
  CHECK(code_of([&] { along(curves); }) == ErrorCode::kDegreeTooHigh);
  try {
    along(curves);
  } catch (const GeometryError& error) {
    CHECK_THAT(error.what(), Catch::Contains("29") && Catch::Contains("now 7"));
  }
}

TEST_CASE("The spinors along rulings are balanced, over short spans too", "[envelope]") {
  RandomDirectrices random(33);
  const Directrices whole = random.lines(3, 3);
  for (const long parts : {1L, 1000L}) {
    const auto part = [&](const SphereCurve& c) {
      SphereCurve result = c;
      for (RationalPolynomial& p : result.centre) {
        p = p.on_interval(Rational(1L) / Rational(3L), Rational(1L) / Rational(parts + 1));
      }
      return result;
    };
    const auto gamma = midpoint(along({part(whole[0]), part(whole[1])}).enclosure(128));
    const Eigen::Matrix2cd a = value_at(gamma.spinor, 0.5);
    for (const Eigen::Index j : {0, 1}) {
      CHECK(a.col(j).norm() > 0.5);
      CHECK(a.col(j).norm() < 2);
    }
    CHECK(std::abs(a.col(0).dot(a.col(1)).real()) < 1e-9);
  }
}
