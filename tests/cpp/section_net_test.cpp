// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/bezier/section_net.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "enclosures.hpp"
#include "pn/algebra/precision.hpp"
#include "pn/algebra/roots.hpp"
#include "pn/bezier/chain_net.hpp"
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

/// A bilinear face, still without its four poles.
FaceNet bilinear_face() {
  FaceNet face;
  face.frame.u_degree = face.frame.v_degree = 1;
  face.frame.u_knots = face.frame.v_knots = {0, 1};
  face.frame.u_multiplicities = face.frame.v_multiplicities = {2, 2};
  face.stands_still = false;
  return face;
}

}  // namespace

TEST_CASE("Every weight is positive and every pole is known to the last place", "[section_net]") {
  const std::vector<ChainNet> nets = {ChainNet(smooth_chain(), Lines::kEven, 128),
                                      ChainNet(cornered_chain(), Lines::kEven, 128),
                                      ChainNet(cornered_chain(), Lines::kLowestDegree, 128)};
  for (const ChainNet& net : nets) {
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
  const ChainNet net(smooth_chain(), Lines::kEven, 128);
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
    const ChainNet net(chain, Lines::kEven, 128);
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

TEST_CASE("The certificate counts what rounded weights move", "[section_net]") {
  // Poles that are doubles, and weights that are none.
  FaceNet face = bilinear_face();
  std::vector<Homogeneous> controls;
  for (const long i : {0L, 1L, 2L, 3L}) {
    const RealBall weight(Rational(1L) / Rational(3 + 2 * i), 256);
    NetPole pole{{RealBall(i % 2), RealBall(i / 2), RealBall(i * i)}, {}, weight};
    controls.push_back(Homogeneous{{pole.point[0], pole.point[1], pole.point[2], RealBall(1)}} *
                       weight);
    face.poles.push_back(std::move(pole));
  }
  const auto rounded = SectionNet({face}, 256).section(0).front();
  const auto truth = enclosed_point(rounded.surface, controls, 0.3, 0.6, 256);
  const auto exported = enclosed_point(rounded.surface, 0.3, 0.6, 256);
  RealBall squares;
  for (std::size_t c = 0; c < 3; ++c)
    squares += (exported[c] - truth[c]) * (exported[c] - truth[c]);
  CHECK(sqrt(squares).lower() > 0);
  CHECK(sqrt(squares).upper() <= rounded.deviation);
}

TEST_CASE("Weights rounded up at one end and down at the other move the middle by the bound",
          "[section_net]") {
  FaceNet face = bilinear_face();
  // Nearly half-way between neighbouring doubles.
  const Rational unit = Rational::exactly(0x1p-52), part = Rational(499L) / Rational(1000L) * unit;
  const RealBall weights[] = {{Rational(1L) + part, 256}, {Rational(1L) + unit - part, 256}};
  std::vector<Homogeneous> controls;
  for (const long i : {0L, 1L, 0L, 1L}) {
    face.poles.push_back({{RealBall(i), RealBall(0), RealBall(0)}, {}, weights[i]});
    controls.push_back(Homogeneous{{RealBall(i), RealBall(0), RealBall(0), RealBall(1)}} *
                       weights[i]);
  }
  const auto rounded = SectionNet({face}, 256).section(0).front();
  const RealBall error = abs(enclosed_point(rounded.surface, 0.5, 0.5, 256)[0] -
                             enclosed_point(rounded.surface, controls, 0.5, 0.5, 256)[0]);
  CHECK(error.upper() <= rounded.deviation);
  CHECK(error.lower() > 0.99 * rounded.deviation);
}

TEST_CASE("Normals are unit vectors on the sphere, in doubles", "[section_net]") {
  const ChainNet net(smooth_chain(), Lines::kEven, 128);
  const BSplineSurface normals = net.normals().front();
  for (const double u : {0.0, 0.6, 1.0, 2.9}) {
    for (const double v : {0.0, 1.5, 3.2}) {
      const auto n = evaluate(normals, u, v);
      CHECK(std::hypot(n[0], n[1], n[2]) == Approx(1).epsilon(1e-12));
    }
  }
}

TEST_CASE("Too little precision is undecided, not wrong", "[section_net]") {
  // Coordinates of 1e-17 mm beside some of 1 mm ask for more bits.
  constexpr double kTiny = 1e-17;
  const EnvelopeChain chain =
      canal_surface(Curve::bezier({{0, 0, 0}, {1, 0.5, kTiny}, {2, 0, -kTiny}, {3, 1, kTiny}}),
                    Law::constant(0.2));
  CHECK_THROWS_AS(ChainNet(chain, Lines::kEven, kLeastPrecision).section(-0.2), Undecided);
  CHECK_NOTHROW(ChainNet(chain, Lines::kEven, 2 * kLeastPrecision).section(-0.2));
}
