// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/bezier/exact_patch.hpp"

#include <catch2/catch.hpp>

#include "pn/algebra/roots.hpp"

using namespace pn;

namespace {

/// The plane z = 0 over the unit square, with its normal and weight one; of raised degree.
ExactPatch square(double weight) {
  const auto sections = [weight](long bits) {
    const auto constant = [bits](double x) {
      return TensorPolynomial<RealBall>::constant(RealBall(x).at_precision(bits));
    };
    const auto linear = [bits](double u, double v) {
      const RealBall zero = RealBall(0.0).at_precision(bits);
      return TensorPolynomial<RealBall>::linear(zero, RealBall(u), RealBall(v));
    };
    SurfaceSections<RealBall> x;
    x.point = {linear(weight, 0), linear(0, weight), constant(0)};
    x.direction = {constant(0), constant(0), constant(weight)};
    x.weight = constant(weight);
    return x;
  };
  const auto path = [](std::array<double, 2> a, std::array<double, 2> b) -> ParameterPath {
    return [=](double at) {
      return std::array{a[0] + at * (b[0] - a[0]), a[1] + at * (b[1] - a[1])};
    };
  };
  return {{2, 3}, sections, {path({0, 0}, {1, 0}), path({1, 0}, {0, 1}), path({0, 1}, {0, 0})}};
}

class Squares : public PatchSource {
 public:
  explicit Squares(double weight) : PatchSource({square(1), square(weight)}, {"note"}) {}
  OffsetRange regular_range() const override { return {-1, 1}; }
};

}  // namespace

TEST_CASE("Patches become faces side by side in the first parameter", "[exact_patch]") {
  const Squares squares(2);
  CHECK(squares.degree() == std::array{2, 3});
  CHECK(squares.notes() == std::vector<std::string>{"note"});
  const TrimmableNet net = squares.net(Lines::kEven, 128);
  const auto faces = net.net->section(0.5);
  REQUIRE(faces.size() == 2);
  for (std::size_t k = 0; k < 2; ++k) {
    const BSplineSurface& face = faces[k].surface;
    CHECK(face.u_knots == std::vector<double>{static_cast<double>(k), static_cast<double>(k + 1)});
    CHECK(face.poles.size() == 12);
    CHECK(face.poles.back() == std::array{1.0, 1.0, 0.5});
    CHECK(face.weights == std::vector<double>(12, 0.5));  // of 1 and 2, by powers of two
  }
  const auto trims = net.trimmed_faces();
  REQUIRE(trims.size() == 2);
  CHECK(trims[1].loops[0][0].curve.poles.front() == std::array{1.0, 0.0});
}

TEST_CASE("Weights that are not positive are not exported", "[exact_patch]") {
  CHECK_THROWS_AS(Squares(-1).net(Lines::kEven, 128), Undecided);
}

TEST_CASE("A part of a path runs between its parameters", "[exact_patch]") {
  const ParameterPath path = square(1).boundary[1];
  const ParameterPath part = part_of(path, 0.25, 0.75);
  CHECK(part(0) == path(0.25));
  CHECK(part(1) == path(0.75));
}
