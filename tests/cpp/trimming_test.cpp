// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/bezier/trimming.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "pn/bezier/evaluation.hpp"
#include "pn/shapes/canal_surface.hpp"
#include "pn/shapes/ruled_surface.hpp"

using namespace pn;

namespace {

using Point = std::array<double, 3>;

/// C1 quadratics over the same knots: three spans, three faces.
const std::vector<double> kKnots = {0, 1, 2, 4};
const BSplineData<3> kFirst{
    2, kKnots, {3, 1, 1, 3}, {{0, 0, 0}, {2, 0, 0}, {4, 1, 0}, {7, 1, 1}, {9, 0, 1}}, {}};
const BSplineData<3> kSecond{
    2, kKnots, {3, 1, 1, 3}, {{0, 4, 1}, {2, 5, 2}, {5, 4, 4}, {7, 4, 5}, {9, 5, 8}}, {}};

Point value(const Curve& curve, double t) {
  const auto& f = curve.function();
  std::size_t i = 0;
  while (i + 2 < f.breaks.size() && f.breaks[i + 1] < Rational::exactly(t)) ++i;
  const Rational local = (Rational::exactly(t) - f.breaks[i]) / (f.breaks[i + 1] - f.breaks[i]);
  Point result;
  for (std::size_t c = 0; c < 3; ++c) {
    result[c] = (f.spans[i].numerator[c](local) / f.spans[i].denominator(local)).to_double();
  }
  return result;
}

double distance(const Point& a, const Point& b) {
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

struct Band {
  Curve first = Curve::bspline(kFirst), second = Curve::bspline(kSecond);
  EnvelopeChain chain = ruled_surface(first, second);
  ChainNet net{chain, Lines::kEven, 128};
  std::vector<TrimmedFace> trimmed = trimmed_faces(chain, net);
  std::vector<RoundedFace> faces = net.section(0);
};

}  // namespace

TEST_CASE("Every face of a band has one loop, closed bit for bit", "[trimming]") {
  const Band band;
  REQUIRE(band.trimmed.size() == band.net.faces().size());
  REQUIRE(band.trimmed.size() > 1);
  for (const TrimmedFace& face : band.trimmed) {
    REQUIRE(face.loops.size() == 1);
    const std::vector<TrimLoop> loops = curves_of(face);
    REQUIRE(loops.size() == 1);
    for (std::size_t k = 0; k < loops[0].size(); ++k) {
      CHECK(loops[0][k].poles.back() == loops[0][(k + 1) % loops[0].size()].poles.front());
    }
    double area = 0;  // counterclockwise: positive
    for (const ParameterCurve& curve : loops[0]) {
      for (int step = 0; step < 50; ++step) {
        const auto a = evaluate(curve, step / 50.0), b = evaluate(curve, (step + 1) / 50.0);
        area += (a[0] * b[1] - b[0] * a[1]) / 2;
      }
    }
    CHECK(area > 0);
  }
}

TEST_CASE("Neighbours share their corners bit for bit", "[trimming]") {
  const Band band;
  for (std::size_t i = 0; i + 1 < band.trimmed.size(); ++i) {
    const auto &left = band.trimmed[i].loops[0], &right = band.trimmed[i + 1].loops[0];
    const double joint = band.faces[i].surface.u_knots.back();
    const auto side_at = [&](const TrimEdgeLoop& loop) {
      for (const TrimEdge& edge : loop) {
        const auto &a = edge.curve.poles.front(), &b = edge.curve.poles.back();
        if (!edge.path && a[0] == joint && b[0] == joint) {
          return std::pair{std::min(a[1], b[1]), std::max(a[1], b[1])};
        }
      }
      return std::pair<double, double>{NAN, NAN};
    };
    CHECK(side_at(left) == side_at(right));
  }
}

TEST_CASE("The edges lie on the directrices", "[trimming]") {
  const Band band;
  for (std::size_t i = 0; i < band.trimmed.size(); ++i) {
    const BSplineSurface& surface = band.faces[i].surface;
    for (const TrimEdge& edge : band.trimmed[i].loops[0]) {
      if (!edge.path) continue;
      const bool is_low = edge.curve.poles.front()[0] < edge.curve.poles.back()[0];
      for (const double part : {0.0, 0.17, 0.5, 0.83, 1.0}) {
        const auto [u, v] = evaluate(edge.curve, part);
        const Point expected = value(is_low ? band.first : band.second, u);
        CHECK(distance(evaluate(surface, u, v), expected) < 1e-10);
        CHECK(v > 0);
        CHECK(v < 1);
      }
    }
    CHECK(trim_deviation(surface, band.trimmed[i]) < 1e-10);
  }
}

TEST_CASE("The deviation is how far edges leave their paths", "[trimming]") {
  const Band band;
  TrimmedFace moved = band.trimmed[0];
  constexpr double kShift = 1e-6;
  for (TrimEdge& edge : moved.loops[0]) {
    for (auto& pole : edge.curve.poles) pole[1] += kShift;
  }
  // The band is about four wide and one high in its parameter.
  const double deviation = trim_deviation(band.faces[0].surface, moved);
  CHECK(deviation > kShift);
  CHECK(deviation < 100 * kShift);
}

TEST_CASE("Whole faces have no trims", "[trimming]") {
  const EnvelopeChain pipe =
      canal_surface(Curve::bezier({{0, 0, 0}, {1, 1, 0}, {2, 0, 1}}), Law::constant(0.25));
  const ChainNet net(pipe, Lines::kEven, 128);
  for (const TrimmedFace& face : trimmed_faces(pipe, net)) {
    CHECK(face.loops.empty());
    CHECK(trim_deviation(net.section(0)[0].surface, face) == 0);
  }
}
