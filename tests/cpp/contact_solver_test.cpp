// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/bezier/contact_solver.hpp"

#include <catch2/catch.hpp>
#include <cmath>

using namespace pn;

namespace {

using Polynomial = TensorPolynomial<Rational>;

/// u = (p + p q) / (1 + q), v = q^2 / (1 + q), times a large number.
Contact<Rational> example() {
  Contact<Rational> contact{Polynomial(1, 1), Polynomial(0, 2), Polynomial(0, 1)};
  const Rational large = Rational::exactly(std::ldexp(1.0, 1000));
  contact.a(1, 0) = contact.a(1, 1) = contact.b(0, 2) = contact.e(0, 0) = contact.e(0, 1) =
      large * large;
  return contact;
}

}  // namespace

TEST_CASE("The solution has the contact that was asked for, whatever the scale",
          "[contact_solver]") {
  const ContactSolver solver(example());
  const auto [p, q] = solver.solution({0.3, 0.25 / 1.5}, {0.1, 0.9});
  CHECK(p == Approx(0.3).epsilon(1e-14));
  CHECK(q == Approx(0.5).epsilon(1e-14));
}

TEST_CASE("Where there is no solution nothing is made up", "[contact_solver]") {
  const ContactSolver solver(example());
  const auto [p, q] = solver.solution({NAN, 0.1}, {0.1, 0.5});
  CHECK_FALSE(std::isfinite(p));
  CHECK_FALSE(std::isfinite(q));
}
