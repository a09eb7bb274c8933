// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/isotropic/reparametrization.hpp"

#include <catch2/catch.hpp>

#include "pn/geometry_error.hpp"
#include "pn/isotropic/along_surface.hpp"
#include "random_surfaces.hpp"

using namespace pn;
using namespace pn::test;

namespace {

const BivariateFunction u(BivariatePolynomial(Variable::kU)), v(BivariatePolynomial(Variable::kV));

BivariateFunction in_field(const TensorPolynomial<Rational>& p) { return {in_ring(p)}; }

IsotropicPolynomials<Rational> stereographic_polynomials() {
  IsotropicPolynomials<Rational> w;
  const IsotropicField field = stereographic_field();
  for (std::size_t i = 0; i < 4; ++i) w[i] = dense(field[i].numerator());
  return w;
}

ErrorCode refusal(const SphereSurface& f) {
  try {
    reparametrizations(f, stereographic_field());
  } catch (const GeometryError& error) {
    return error.code();
  }
  FAIL("not refused");
  return ErrorCode::kNotFinite;
}

}  // namespace

TEST_CASE("Quadratic families are touched where the linear equations say", "[reparametrization]") {
  for (unsigned seed = 0; seed < 20; ++seed) {
    RandomSurfaces random(seed);
    const PowerForm<Rational> form = random.power_form();
    const auto [a, b, e] = contact_of(form, stereographic_polynomials());
    const Reparametrization expected = {in_field(a) / in_field(e), in_field(b) / in_field(e)};
    CHECK(reparametrizations(surface_of(form), stereographic_field()) ==
          std::vector<Reparametrization>{expected});
  }
}

TEST_CASE("A change of the parameters of f changes nothing else", "[reparametrization]") {
  RandomSurfaces random(3);
  const SphereSurface f = surface_of(random.power_form());
  const Reparametrization original = reparametrizations(f, stereographic_field()).front();
  // The inverse of (u, v) -> (u + v^2, v / (1 + v)).
  const Reparametrization change = {u + v * v, v / (BivariateFunction(1L) + v)};
  const BivariateFunction inner = original.v / (BivariateFunction(1L) - original.v);
  const Reparametrization expected = {original.u - inner * inner, inner};
  CHECK(reparametrizations(change(f), stereographic_field()) ==
        std::vector<Reparametrization>{expected});
}

TEST_CASE("The tangent plane is spanned without factors and denominators", "[reparametrization]") {
  const SphereSurface f = {u * u * u, v * v * v, u * u, v};
  const auto [x, y] = tangent_plane(f);
  const BivariatePolynomial pu(Variable::kU), pv(Variable::kV), three(3L), two(2L);
  CHECK(two * x[0] == three * pu * x[2]);
  CHECK(y[1] == three * pv * pv * y[3]);
  for (const auto& zero : {x[1], x[3], y[0], y[2]}) CHECK(zero.is_zero());
  CHECK(x[2].is_constant());
  CHECK(y[3].is_constant());
}

TEST_CASE("Curves of spheres are refused, and general surfaces have no reparametrization",
          "[reparametrization]") {
  const BivariateFunction curve = u * v + v;
  CHECK(refusal({curve, curve * curve, curve + BivariateFunction(1L), curve}) ==
        ErrorCode::kZeroLength);
  CHECK(refusal({0L, 0L, 0L, 1L}) == ErrorCode::kZeroLength);
  const SphereSurface general = {u, v, u * u * u * v + v * v, u * v * v};
  CHECK(reparametrizations(general, stereographic_field()).empty());
}

TEST_CASE("Directions that are constant or run on a curve touch no surface",
          "[reparametrization]") {
  RandomSurfaces random(5);
  const SphereSurface f = surface_of(random.power_form());
  CHECK(reparametrizations(f, {0L, 0L, 1L, 1L}).empty());
  const SphereSurface in_hyperplane = {u, v, u * v, u * v};
  CHECK(reparametrizations(in_hyperplane, {0L, 0L, 1L, 1L}).empty());
  const BivariateFunction one(1L), two(2L);
  CHECK(reparametrizations(f, {two * u, 0L, one - u * u, one + u * u}).empty());
}

TEST_CASE("Sheets are developable where tangent planes depend on one parameter",
          "[reparametrization]") {
  RandomSurfaces random(2);
  const SphereSurface general = surface_of(random.power_form());
  CHECK_FALSE(has_developable_sheets(general));
  // Rulings of one direction, in parameters that do not show it.
  const BivariateFunction a = u + v * v;
  CHECK(has_developable_sheets({a * a + v, a - v, v, a * a * a + v}));
  CHECK_FALSE(has_developable_sheets({a * a + v, a - v, v * a, a * a * a + v}));
}
