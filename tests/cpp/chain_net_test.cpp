// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/bezier/chain_net.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "enclosures.hpp"
#include "pn/algebra/bernstein.hpp"
#include "pn/shapes/canal_surface.hpp"

using namespace pn;
using namespace pn::test;

namespace {

const Curve kSpine = Curve::bspline(
    {3, {0, 1, 3}, {4, 1, 4}, {{0, 0, 0}, {1, 0, 0}, {2, 3, 0}, {3, 1, 2}, {4, 0, 1}}, {}});

EnvelopeChain smooth_chain() { return canal_surface(kSpine, Law::constant(0.25)); }

/// A joint that turns by 1e-9 and is closed up.
EnvelopeChain mended_chain() {
  return canal_surface(
      Curve::bspline({1, {0, 1, 2}, {2, 1, 2}, {{0, 0, 0}, {1, 0, 0}, {2, 1e-9, 0}}, {}}),
      Law::constant(0.1));
}

/// The Bezier rows of a segment at this degree, for one column of the circle: homogeneous points.
std::vector<Homogeneous> bezier_rows(const LinedSegment& segment, int degree,
                                     const std::vector<Rational>& column) {
  const HomogeneousSections<RealBall>& forms = segment.sections;
  std::vector<Homogeneous> rows(static_cast<std::size_t>(degree) + 1);
  const auto set = [&](std::size_t i, const FormInU<RealBall>& q) {
    for (std::size_t k = 0; k < 3; ++k) {
      const auto bernstein = to_bernstein(q.coefficient[k].elevated(degree).coefficients());
      for (std::size_t r = 0; r < rows.size(); ++r) {
        rows[r].coordinate[i] += bernstein[r] * RealBall(column[k], 128);
      }
    }
  };
  for (std::size_t i = 0; i < 3; ++i) set(i, forms.point[i]);
  set(3, forms.weight);
  return rows;
}

}  // namespace

TEST_CASE(
    "The control rows are the Bezier rows of the segments, the joint a mean of its neighbours",
    "[chain_net]") {
  const EnvelopeChain chain = smooth_chain();
  const ChainNet net(chain, Lines::kEven, 128);
  const auto segments = lined_segments(chain, Lines::kEven, 128);
  REQUIRE(net.faces().size() == 1);
  const FaceNet& face = net.faces().front();
  const int degree = face.frame.u_degree;
  const std::size_t columns = face.frame.v_count();
  REQUIRE(face.poles.size() == face.frame.u_count() * columns);
  const int arcs = static_cast<int>(face.frame.v_knots.size()) - 1;
  const CircleColumns circle = circle_part(0, arcs, arcs, 2);

  for (const std::size_t j : {std::size_t{0}, std::size_t{2}, columns - 2}) {
    std::size_t row = 0;
    for (std::size_t s = 0; s < segments.size(); ++s) {
      const auto bezier = bezier_rows(segments[s], degree, circle.coefficients[j]);
      for (std::size_t r = s == 0 ? 0 : 1;
           r + 1 < bezier.size() || (s + 1 == segments.size() && r < bezier.size()); ++r, ++row) {
        const NetPole& pole = face.poles[row * columns + j];
        CHECK(pole.weight.overlaps(bezier[r].coordinate[3]));
        for (std::size_t i = 0; i < 3; ++i) {
          CHECK(pole.point[i].overlaps(bezier[r].coordinate[i] / bezier[r].coordinate[3]));
        }
      }
      if (s == 0) continue;
      // C1: (right - joint) / length is the same on both sides, homogeneously.
      const auto left = bezier_rows(segments[s - 1], degree, circle.coefficients[j]);
      const RealBall a(segments[s - 1].end - segments[s - 1].begin),
          b(segments[s].end - segments[s].begin);
      for (std::size_t i = 0; i < 4; ++i) {
        const RealBall &before = left[left.size() - 2].coordinate[i],
                       &joint = bezier[0].coordinate[i], &after = bezier[1].coordinate[i];
        CHECK(encloses_zero(left.back().coordinate[i] - joint, 1e-9));
        CHECK(encloses_zero((joint - before) * b - (after - joint) * a, 1e-9));
      }
    }
    CHECK(row == face.frame.u_count());
  }
}

TEST_CASE("A gap that was closed up is counted in the deviation, and the faces share their row",
          "[chain_net]") {
  const auto faces = ChainNet(mended_chain(), Lines::kEven, 128).section(0);
  REQUIRE(faces.size() == 2);
  const BSplineSurface &left = faces[0].surface, &right = faces[1].surface;
  const auto columns = static_cast<std::ptrdiff_t>(right.v_count());
  CHECK(std::equal(left.poles.end() - columns, left.poles.end(), right.poles.begin()));
  CHECK(std::equal(left.weights.end() - columns, left.weights.end(), right.weights.begin()));
  // The circles of radius 0.1 differ by the turn of 1e-9.
  const double deviation = std::max(faces[0].deviation, faces[1].deviation);
  CHECK(deviation >= 1e-10);
  CHECK(deviation < 1e-8);
}
