// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/bezier/target_lines.hpp"

#include <catch2/catch.hpp>
#include <cmath>

using namespace pn;
using Eigen::Matrix2d;

namespace {

/// A rotation that turns by several right angles, with a sign that jumps about.
class Turning : public TargetLines {
 public:
  Turning() { choose_signs(2); }

 private:
  Matrix2d factor(std::size_t link, double t) const override {
    const double sign = std::sin(1000 * t) < 0 ? -1 : 1;
    return sign * Eigen::Rotation2Dd(static_cast<double>(link + 3) * t).toRotationMatrix();
  }
};

}  // namespace

TEST_CASE("The sign is continuous along a link", "[target_lines]") {
  const Turning lines;
  for (std::size_t link = 0; link < 2; ++link) {
    Matrix2d before = lines.at(link, 0);
    for (int i = 1; i <= 500; ++i) {
      const Matrix2d next = lines.at(link, i / 500.0);
      CHECK((next - before).norm() < 0.02);
      before = next;
    }
  }
}

TEST_CASE("The derivative is nearly that of the lines", "[target_lines]") {
  const Turning lines;
  for (const double t : {0.0, 0.3, 0.5, 1.0}) {
    Matrix2d quarter;
    quarter << 0, -1, 1, 0;
    const Matrix2d expected = 4 * lines.at(1, t) * quarter;
    CHECK((lines.derivative(1, t) - expected).norm() < 1e-4);
  }
}
