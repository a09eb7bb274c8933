// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/bezier/translational_skin.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "pn/bezier/evaluation.hpp"
#include "pn/bezier/pn_surface.hpp"
#include "pn/bezier/skin.hpp"
#include "random_translational_families.hpp"

using namespace pn;
using namespace pn::test;

namespace {

using Spheres = std::array<std::array<double, 4>, 3>;

const Spheres kArch = {{{0, 0, 0, 1}, {5, 0, 2, 1.25}, {10, 0, 0, 1}}},
              kAcross = {{{0, 0, 0, 1}, {0, 5, 1, 1}, {0, 10, -0.5, 1.5}}};

std::vector<Rational> unit() { return {Rational(0L), Rational(1L)}; }

/// The family as a spline of one span each.
TranslationalSpline spline_of(const TranslationalFamily& family) {
  return {{unit(), {family.c}}, {unit(), {family.d}}};
}

PNSurface skin(const TranslationalSpline& spline, Sheet sheet) {
  return PNSurface(
      std::make_shared<const TranslationalSkin>(spline, sheet, std::vector<std::string>{"note"}));
}

std::array<double, 3> at(const BSplineSurface& face, const std::array<double, 2>& place) {
  return SurfaceEvaluation(face)(place[0], place[1]);
}

double distance(const std::array<double, 3>& a, const std::array<double, 3>& b) {
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

}  // namespace

TEST_CASE("Skins of two parabolas are one face of bidegree (8, 6)", "[translational_skin]") {
  for (const Sheet sheet : {Sheet::kOuter, Sheet::kInner}) {
    const PNSurface surface = skin(spline_of(family_of(kArch, kAcross)), sheet);
    CHECK(surface.degree() == std::array{8, 6});
    const Certificate certificate = surface.certificate(Lines::kEven);
    CHECK(certificate.exact);
    CHECK(certificate.notes == std::vector<std::string>{"note"});
    CHECK(certificate.bidegree == std::array{8, 6});
    CHECK(certificate.poles == 63);
    CHECK(certificate.deviation < 1e-13);
    CHECK(certificate.trim_deviation < 1e-10);
    REQUIRE(surface.faces(Lines::kEven).size() == 1);
    CHECK(surface.faces(Lines::kEven)[0].trims.at(0).size() == 4);
    CHECK_FALSE(surface.self_intersection());
  }
}

TEST_CASE("Neighbours meet along whole edges, in one parameter, with one normal",
          "[translational_skin]") {
  TranslationalSpline spline = spline_of(family_of(kArch, kAcross));
  // The second span continues the first one with another curvature.
  SphereParabola next = spline.c.spans[0];
  next.start = {Rational(10L), Rational(0L), Rational(0L), Rational(-1L)};
  next.first = spline.c.spans[0].slope(1L);
  next.second = {Rational(1L), Rational(2L), Rational(-3L), Rational(1L)};
  spline.c.breaks.push_back(2L);
  spline.c.spans.push_back(next);
  for (const Sheet sheet : {Sheet::kOuter, Sheet::kInner}) {
    const PNSurface surface = skin(spline, sheet).offset(0.5);
    const auto faces = surface.faces(Lines::kEven);
    REQUIRE(faces.size() == 2);
    // u = 1 of the first face is side 1 of its square, and u = 0 of the second one side 3; on the
    // inner sheet they are 2 and 0.
    const bool is_outer = sheet == Sheet::kOuter;
    const ParameterCurve &end = faces[0].trims[0][is_outer ? 1 : 2],
                         &start = faces[1].trims[0][is_outer ? 3 : 0];
    for (const double part : {0.0, 0.3, 0.7, 1.0}) {
      const auto a = evaluate(end, part), b = evaluate(start, 1 - part);
      CHECK(distance(at(faces[0], a), at(faces[1], b)) < 1e-11);
      // The parameter at which one face ends and the next begins is that of the next.
      const double before = std::min(a[0], std::nextafter(1.0, 0.0)), after = std::max(b[0], 1.0);
      const auto points = surface.evaluate({before, after}, {a[1], b[1]});
      CHECK(distance(points[0].normal, points[1].normal) < 1e-11);
    }
  }
}

TEST_CASE("Flat sheets are faces of bidegree (2, 2)", "[translational_skin]") {
  const Spheres line = {{{0, 0, 0, 1}, {5, 0, 1, 1}, {10, 0, 2, 1}}},
                across = {{{0, 0, 0, 1}, {0, 5, 0, 1.5}, {0, 10, 0, 2}}};
  const PNSurface surface = skin(spline_of(family_of(line, across)), Sheet::kInner);
  CHECK(surface.degree() == std::array{2, 2});
  CHECK(surface.faces(Lines::kEven).size() == 1);
}

TEST_CASE("Curves that turn far are halved until weights are even", "[translational_skin]") {
  const Spheres narrow = {{{0, 0, 0, 1}, {5, 0, 40, 1}, {10, 0, 0, 1}}};
  const PNSurface surface = skin(spline_of(family_of(narrow, kAcross)), Sheet::kOuter);
  const auto faces = surface.faces(Lines::kEven);
  CHECK(faces.size() > 1);
  for (const BSplineSurface& face : faces) {
    const auto [least, largest] = std::minmax_element(face.weights.begin(), face.weights.end());
    CHECK(*least > kEvenWeights * *largest);
  }
}

TEST_CASE("The regular range is that of both triangles of the square", "[translational_skin]") {
  const TranslationalFamily family = family_of(kArch, kAcross);
  const OffsetRange range = TranslationalSkin(spline_of(family), Sheet::kOuter, {}).regular_range();
  const auto [low, high] = triangles(family);
  const OffsetRange a = regular_range(low), b = regular_range(high);
  CHECK(range.lower == std::max(a.lower, b.lower));
  CHECK(range.upper == std::min(a.upper, b.upper));
  CHECK(range.lower < 0);
  CHECK(range.upper > 0);
}
