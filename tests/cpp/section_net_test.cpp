// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/bezier/section_net.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "enclosures.hpp"
#include "pn/algebra/bernstein.hpp"
#include "pn/algebra/roots.hpp"
#include "pn/bezier/evaluation.hpp"
#include "pn/shapes/canal_surface.hpp"

using namespace pn;
using namespace pn::test;

namespace {

const Curve kSpine = Curve::bspline(
    {3, {0, 1, 3}, {4, 1, 4}, {{0, 0, 0}, {1, 0, 0}, {2, 3, 0}, {3, 1, 2}, {4, 0, 1}}, {}});

EnvelopeChain smooth_chain() { return canal_surface(kSpine, Law::constant(0.25)); }

/// Three links, the middle one a zone of a sphere.
EnvelopeChain cornered_chain() {
  return canal_surface(
      Curve::bspline({1, {0, 1, 2}, {2, 1, 2}, {{0, 0, 0}, {3, 0, 0}, {3, 4, 1}}, {}}),
      Law::constant(0.5));
}

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
    "[section_net]") {
  const EnvelopeChain chain = smooth_chain();
  const SectionNet net(chain, Lines::kEven, 128);
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

TEST_CASE("Every weight is positive and every pole is known to the last place", "[section_net]") {
  const std::vector<SectionNet> nets = {SectionNet(smooth_chain(), Lines::kEven, 128),
                                        SectionNet(cornered_chain(), Lines::kEven, 128),
                                        SectionNet(cornered_chain(), Lines::kLowestDegree, 128)};
  for (const SectionNet& net : nets) {
    for (const FaceNet& face : net.faces()) {
      for (const NetPole& pole : face.poles) {
        CHECK(pole.weight.is_positive());
        CHECK(pole.weight.rounded());
      }
    }
  }
}

TEST_CASE("Poles of a section are P + d V, rounded to within one unit in the last place",
          "[section_net]") {
  const SectionNet net(smooth_chain(), Lines::kEven, 128);
  const double d = 0.3;
  const auto face = net.section(d).front();
  const auto& poles = net.faces().front().poles;
  REQUIRE(face.surface.poles.size() == poles.size());
  for (std::size_t i = 0; i < poles.size(); ++i) {
    for (std::size_t c = 0; c < 3; ++c) {
      const double x = face.surface.poles[i][c];
      const RealBall error = poles[i].point[c] + RealBall(d) * poles[i].direction[c] - RealBall(x);
      const double unit = std::nextafter(std::abs(x), INFINITY) - std::abs(x);
      CHECK(error.magnitude_upper() <= std::max(unit, 1e-28));
    }
    CHECK(poles[i].weight.rounded() == face.surface.weights[i]);
  }
}

TEST_CASE("The certificate bounds the distance to the surface of the net itself", "[section_net]") {
  for (const EnvelopeChain& chain : {smooth_chain(), cornered_chain(), mended_chain()}) {
    const SectionNet net(chain, Lines::kEven, 128);
    const auto rounded = net.section(0.125);
    for (std::size_t f = 0; f < rounded.size(); ++f) {
      const BSplineSurface& surface = rounded[f].surface;
      const FaceNet& face = net.faces()[f];
      // The true net: where a neighbour's row was taken over, the face's own.
      std::vector<NetPole> own = face.poles;
      std::copy(face.replaced_first.begin(), face.replaced_first.end(), own.begin());
      std::copy(face.replaced_last.begin(), face.replaced_last.end(),
                own.end() - static_cast<std::ptrdiff_t>(face.replaced_last.size()));
      const double u = (surface.u_knots.front() + surface.u_knots.back()) / 2 * 0.99, v = 1.3;
      for (const double at : {surface.u_knots.front(), u, surface.u_knots.back()}) {
        std::vector<Homogeneous> poles;
        for (const NetPole& pole : own) {
          Homogeneous h{{pole.point[0] + RealBall(0.125) * pole.direction[0],
                         pole.point[1] + RealBall(0.125) * pole.direction[1],
                         pole.point[2] + RealBall(0.125) * pole.direction[2], RealBall(1)}};
          poles.push_back(h * pole.weight);
        }
        const auto truth = enclosed_point(surface, poles, at, v, 128);
        const auto exported = enclosed_point(surface, at, v, 128);
        RealBall squares;
        for (std::size_t c = 0; c < 3; ++c)
          squares += (exported[c] - truth[c]) * (exported[c] - truth[c]);
        CHECK(sqrt(abs(squares)).upper() <= rounded[f].deviation);
      }
    }
  }
}

TEST_CASE("A gap that was closed up is counted in the deviation, and the faces share their row",
          "[section_net]") {
  const auto faces = SectionNet(mended_chain(), Lines::kEven, 128).section(0);
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

TEST_CASE("Normals are unit vectors on the sphere, in doubles", "[section_net]") {
  const SectionNet net(smooth_chain(), Lines::kEven, 128);
  const BSplineSurface normals = net.normals().front();
  for (const double u : {0.0, 0.6, 1.0, 2.9}) {
    for (const double v : {0.0, 1.5, 3.2}) {
      const auto n = evaluate(normals, u, v);
      CHECK(std::hypot(n[0], n[1], n[2]) == Approx(1).epsilon(1e-12));
    }
  }
}

TEST_CASE("Too little precision is undecided, not wrong", "[section_net]") {
  // Coordinates of 1e-24 mm beside some of 1 mm ask for more than 128 bits.
  constexpr double kTiny = 1e-24;
  const EnvelopeChain chain =
      canal_surface(Curve::bezier({{0, 0, 0}, {1, 0.5, kTiny}, {2, 0, -kTiny}, {3, 1, kTiny}}),
                    Law::constant(0.2));
  CHECK_THROWS_AS(SectionNet(chain, Lines::kEven, 128).section(-0.2), Undecided);
  CHECK_NOTHROW(SectionNet(chain, Lines::kEven, 256).section(-0.2));
}
