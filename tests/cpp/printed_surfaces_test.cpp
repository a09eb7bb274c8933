// SPDX-License-Identifier: LGPL-2.1-or-later
// The surfaces of spheres that are printed in the literature, equal as rational functions.
//
// data/printed_surfaces.json has them with their source, and with misprints corrected: the surface,
// a fibration with its support functions, u(s, t), v(s, t), the envelope, its degree with the
// number of parameter values of a point, an implicit equation, or both sheets in u and v.
#include <algorithm>
#include <catch2/catch.hpp>

#include "envelope_sheets.hpp"
#include "pn/algebra/elimination.hpp"
#include "pn/isotropic/supported_fibration.hpp"
#include "rational_expression.hpp"
#include "test_data.hpp"

using namespace pn;
using namespace pn::test;

namespace {

using nlohmann::json;
using Point = std::array<BivariateFunction, 3>;

const std::vector<json>& cases() {
  static const auto all = test_data("printed_surfaces.json").get<std::vector<json>>();
  return all;
}

template <std::size_t Count>
std::array<BivariateFunction, Count> functions(const json& texts, const std::string& variables) {
  REQUIRE(texts.size() == Count);
  std::array<BivariateFunction, Count> result;
  for (std::size_t i = 0; i < Count; ++i) result[i] = rational_function<2>(texts[i], variables);
  return result;
}

SphereSurface surface_of(const json& example) { return functions<4>(example["surface"], "uv"); }

SupportedFibration fibration_of(const json& fibration) {
  return {functions<4>(fibration["c"], "uv"), functions<4>(fibration["d"], "uv"),
          rational_function<2>(fibration["a"], "uv"), rational_function<2>(fibration["b"], "uv")};
}

IsotropicField field_of(const json& example) {
  return example.contains("w") ? functions<4>(example["w"], "st") : stereographic_field();
}

/// x0 : x1 : x2 : x3 without a common factor.
std::array<BivariatePolynomial, 4> homogeneous(const Point& x) {
  BivariatePolynomial weight(1L);
  for (const BivariateFunction& c : x) {
    weight *= *quotient(c.denominator(), gcd(weight, c.denominator()));
  }
  std::array<BivariatePolynomial, 4> result = {weight};
  for (std::size_t i = 0; i < 3; ++i) {
    result[i + 1] = x[i].numerator() * *quotient(weight, x[i].denominator());
  }
  return result;
}

/// The parameters in which a surface meets a general line, base points left out: what two
/// resultants of three general planes do not have in common.
int intersections_with_a_line(const Point& x) {
  const auto coordinates = homogeneous(x);
  // The planes and the axes of the parameters are general, by any numbers that are not special.
  const std::array<std::array<long, 4>, 3> planes = {
      {{3, -7, 5, 11}, {-2, 9, 4, 7}, {8, 1, -5, 3}}};
  const BivariatePolynomial u(Variable::kU), v(Variable::kV);
  std::array<BivariatePolynomial, 3> sections;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t c = 0; c < 4; ++c) {
      sections[i] += BivariatePolynomial(planes[i][c]) * coordinates[c];
    }
    sections[i] = sections[i].composed(u + BivariatePolynomial(3L) * v, v - u);
  }
  const auto first = resultant(sections[0], sections[1], Variable::kU),
             second = resultant(sections[0], sections[2], Variable::kU);
  return first.degree(Variable::kV) - gcd(first, second).degree(Variable::kV);
}

/// w / w4
Point unit_normal(const IsotropicField& w) { return {w[0] / w[3], w[1] / w[3], w[2] / w[3]}; }

/// m - f4 n
Point touched(const SphereSurface& f, const Point& n) {
  return {f[0] - f[3] * n[0], f[1] - f[3] * n[1], f[2] - f[3] * n[2]};
}

void check_points(const json& example, const Point& computed, const Point& printed) {
  CHECK(computed == printed);
  if (example.contains("degree")) {
    const int degree = example["degree"], values = example["values_per_point"];
    CHECK(intersections_with_a_line(computed) == degree * values);
  }
  if (example.contains("implicit")) {
    const auto equation = rational_function<3>(example["implicit"], "xyz");
    CHECK(equation.composed<2>(computed).is_zero());
  }
}

}  // namespace

TEST_CASE("Surfaces of spheres have the printed reparametrizations and envelopes",
          "[printed_surfaces]") {
  REQUIRE_FALSE(cases().empty());
  for (const json& example : cases()) {
    DYNAMIC_SECTION(example["name"].get<std::string>() << ", " << example["source"]) {
      const SphereSurface f = surface_of(example);
      if (example.contains("fibration")) {
        CHECK(supported_surface(fibration_of(example["fibration"])) == f);
      }
      if (example.contains("sheets")) {
        const RationalEnvelope envelope = rational_envelope(f);
        CHECK(envelope.spheres == f);
        for (const json& printed : example["sheets"]) {
          const Point n = unit_normal(functions<4>(printed["w"], "uv"));
          const auto& [first, second] = envelope.sheets;
          CHECK(((first.normal == n) != (second.normal == n)));
          const OrientedSurface& sheet = first.normal == n ? first : second;
          check_points(example, sheet.point, functions<3>(printed["envelope"], "uv"));
        }
      } else if (example.contains("u")) {
        const IsotropicField w = field_of(example);
        const Reparametrization printed = {rational_function<2>(example["u"], "st"),
                                           rational_function<2>(example["v"], "st")};
        const auto found = reparametrizations(f, w);
        CHECK(std::count(found.begin(), found.end(), printed) == 1);
        // A special w(s, t) may touch the surface more than once.
        CHECK((found.size() == 1 || example.contains("w")));
        for (const Reparametrization& each : found) {
          const SphereSurface spheres = each(f);
          const OrientedSurface sheet = {touched(spheres, unit_normal(w)), unit_normal(w)},
                                other = other_sheet(sheet, spheres);
          CHECK(is_pn_surface(sheet, 2L));
          CHECK(is_envelope(sheet, spheres));
          CHECK(is_pn_surface(other, 2L));
          CHECK(is_envelope(other, spheres));
          CHECK(sheet.normal != other.normal);
        }
        check_points(example, touched(printed(f), unit_normal(w)),
                     functions<3>(example["envelope"], "st"));
      }
    }
  }
}
