// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/shapes/sphere_spans.hpp"

#include <catch2/catch.hpp>

using namespace pn;

namespace {

Rational part(long numerator, long denominator) {
  return Rational(numerator) / Rational(denominator);
}

const BSplineData<3> kCurve{
    2, {0, 1, 3}, {3, 1, 3}, {{0, 0, 0}, {1, 2, 0}, {3, 1, 1}, {4, 4, 2}}, {}};

template <std::size_t Dimension>
Rational value(const PiecewiseRational<Dimension>& function, const Rational& t, std::size_t c) {
  std::size_t i = 0;
  while (i + 2 < function.breaks.size() && !(t < function.breaks[i + 1])) ++i;
  const Rational local = (t - function.breaks[i]) / (function.breaks[i + 1] - function.breaks[i]);
  return function.spans[i].numerator[c](local) / function.spans[i].denominator(local);
}

/// The spheres of every span are those of curve and law there.
void check_spheres(const Curve& curve, const Law& law, const std::vector<SphereSpan>& spans) {
  const auto& centre = curve.function();
  const auto radius = law.over(centre.breaks.front(), centre.breaks.back());
  for (const SphereSpan& span : spans) {
    for (const Rational& local : {part(0, 1), part(1, 3), part(7, 8)}) {
      const Rational t = span.begin + local * (span.end - span.begin);
      const Rational q = span.spheres.denominator(local);
      for (std::size_t c = 0; c < 3; ++c) {
        CHECK(span.spheres.centre[c](local) / q == value(centre, t, c));
      }
      CHECK(span.spheres.radius(local) / q == value(radius, t, 0));
    }
  }
}

}  // namespace

TEST_CASE("Breaks are united exactly", "[sphere_spans]") {
  const std::vector<Rational> a = {part(0, 1), part(1, 3), part(1, 1)},
                              b = {part(0, 1), part(1, 3), part(1, 2), part(1, 1)};
  CHECK(united_breaks(a, b) == b);
  const std::vector<Rational> near = {part(0, 1), Rational::exactly(1.0 / 3), part(1, 1)};
  CHECK(united_breaks(a, near).size() == 4);  // a third is no double
  CHECK(united_breaks(a, {}) == a);
}

TEST_CASE("Spans between the breaks of curve, law and more", "[sphere_spans]") {
  const Curve curve = Curve::bspline(kCurve);
  const Law law = Law::bspline({1, {0, 2, 3}, {2, 1, 2}, {{1}, {2}, {1.5}}, {}});
  const auto spans = sphere_spans(curve, law, {part(1, 3), part(1, 1)});
  const std::vector<Rational> expected = {part(0, 1), part(1, 3), part(1, 1), part(2, 1),
                                          part(3, 1)};
  REQUIRE(spans.size() + 1 == expected.size());
  for (std::size_t i = 0; i < spans.size(); ++i) {
    CHECK(spans[i].begin == expected[i]);
    CHECK(spans[i].end == expected[i + 1]);
  }
  check_spheres(curve, law, spans);
}

TEST_CASE("Weights: the common denominator where they are the same, else the product",
          "[sphere_spans]") {
  BSplineData<3> data = kCurve;
  data.weights = {1, 2, 1, 3};
  const Curve curve = Curve::bspline(data);
  BSplineData<1> radius{2, data.knots, data.multiplicities, {{1}, {2}, {1}, {3}}, data.weights};
  const auto same = sphere_spans(curve, Law::bspline(radius));
  CHECK(same[0].spheres.denominator.degree() == 2);
  check_spheres(curve, Law::bspline(radius), same);
  radius.weights = {1, 2, 1, 2};  // the same on the first span only
  const auto other = sphere_spans(curve, Law::bspline(radius));
  for (const SphereSpan& span : other) CHECK(span.spheres.denominator.degree() == 4);
  check_spheres(curve, Law::bspline(radius), other);
  CHECK(meets(other[0], other[1], 1));
}

TEST_CASE("Spans meet up to the order in which their curve is smooth", "[sphere_spans]") {
  const auto spans_of = [](int degree, int multiplicity) {
    BSplineData<3> data{degree, {0, 1, 3}, {degree + 1, multiplicity, degree + 1}, {}, {}};
    for (int i = 0; i <= degree + multiplicity; ++i) {
      data.poles.push_back({double(i), double(i * i % 5), double(i * i % 3)});
    }
    return sphere_spans(Curve::bspline(data), Law::constant(1));
  };
  for (int degree = 1; degree <= 4; ++degree) {
    for (int multiplicity = 1; multiplicity <= degree; ++multiplicity) {
      const auto spans = spans_of(degree, multiplicity);
      INFO("degree " << degree << ", multiplicity " << multiplicity);
      CHECK(meets(spans[0], spans[1], degree - multiplicity));
      CHECK_FALSE(meets(spans[0], spans[1], degree - multiplicity + 1));
    }
  }
}

TEST_CASE("Numbers in sentences", "[sphere_spans]") {
  CHECK(show(0.5) == "0.5");
  CHECK(show(1.0 / 3) == "0.333333");
}
