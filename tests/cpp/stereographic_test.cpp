// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/bezier/stereographic.hpp"

#include <catch2/catch.hpp>
#include <cmath>

using namespace pn;
using Eigen::Vector3d;

namespace {

Vector3d normal_of(const Spinor& a) {
  const std::complex<double> mixed = std::conj(a.a0) * a.a1;
  return Vector3d(2 * mixed.real(), 2 * mixed.imag(), std::norm(a.a0) - std::norm(a.a1)) /
         (std::norm(a.a0) + std::norm(a.a1));
}

const std::array<Vector3d, 5> kNormals = {Vector3d(0, 0, 1), Vector3d(0, 0, -1),
                                          Vector3d(0.6, 0, -0.8), Vector3d(-2, 3, 6) / 7,
                                          Vector3d(2, -6, -3) / 7};

}  // namespace

TEST_CASE("The spinor of a normal has that normal", "[stereographic]") {
  for (const Vector3d& n : kNormals) CHECK((normal_of(spinor_of(n)) - n).norm() < 1e-15);
}

TEST_CASE("The chart is centred at its normal, and its spinors give every normal back",
          "[stereographic]") {
  for (const Vector3d& centre : kNormals) {
    const Stereographic chart(centre);
    CHECK(std::abs(chart.projected(centre)) < 1e-3);
    const Spinor x = chart.north(), y = chart.south();
    for (const Vector3d& n : kNormals) {
      if ((n + centre).norm() < 1e-6) continue;  // the antipode
      const std::complex<double> z = chart.projected(n);
      CHECK((normal_of({x.a0 + z * y.a0, x.a1 + z * y.a1}) - n).norm() < 1e-14);
    }
  }
}

TEST_CASE("Shortened numbers are near and have few bits", "[stereographic]") {
  const double x = shortened(0.7123456789, 0.7, 12);
  CHECK(std::abs(x - 0.7123456789) <= std::ldexp(1, -13));
  CHECK(std::ldexp(x, 12) == std::round(std::ldexp(x, 12)));
  CHECK(shortened(1e-9, 1, 12) == 0);
}
