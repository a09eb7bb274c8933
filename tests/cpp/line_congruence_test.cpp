// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/minkowski/line_congruence.hpp"

#include <catch2/catch.hpp>

#include "minkowski_cases.hpp"
#include "pn/algebra/rational_matrix.hpp"

using namespace pn;
using namespace pn::test;
using nlohmann::json;

namespace {

using Line = LineCoordinates<Rational>;

/// Where a formula of the case, in u and v, has the direction w(s, t) on its line.
Line line_of_case(const json& example, const Rational& s, const Rational& t) {
  const std::map<std::string, Rational> st = {{"s", s}, {"t", t}};
  const std::map<std::string, Rational> uv = {{"u", value<Rational>(example["u"], st)},
                                              {"v", value<Rational>(example["v"], st)}};
  return values<6>(example["normal_lines"], uv);
}

/// The complexes with all the lines of the case.
std::vector<Line> complexes_of_case(const json& example, RandomRationals& random) {
  RationalMatrix lines;
  for (int i = 0; i < 12; ++i) {
    const Line l = values<6>(example["normal_lines"],
                             std::map<std::string, Rational>{{"u", random()}, {"v", random()}});
    lines.push_back({l[3], l[4], l[5], l[0], l[1], l[2]});
  }
  std::vector<Line> complexes;
  for (const auto& c : null_space(lines, 6))
    complexes.push_back({c[0], c[1], c[2], c[3], c[4], c[5]});
  return complexes;
}

std::array<RationalPolynomial, 4> curve_of(const json& texts) {
  const RationalPolynomial t(std::vector<Rational>{0L, 1L});
  return values<4>(texts, std::map<std::string, RationalPolynomial>{{"t", t}, {"u", t}});
}

std::array<PlaneAtInfinity<Rational>, 2> planes_of(const json& rows) {
  std::array<PlaneAtInfinity<Rational>, 2> planes;
  for (std::size_t i = 0; i < 2; ++i) {
    for (std::size_t j = 0; j < 4; ++j) planes[i][j] = Rational(rows[i][j].get<long>());
  }
  return planes;
}

CubicChords chords_of(const std::array<RationalPolynomial, 4>& cubic) {
  std::array<MinkowskiVector<Rational>, 4> coefficients;
  for (int k = 0; k < 4; ++k) {
    for (std::size_t i = 0; i < 4; ++i) {
      coefficients[static_cast<std::size_t>(k)][i] = cubic[i].coefficient(k);
    }
  }
  return CubicChords(coefficients);
}

MinkowskiVector<Rational> at(const std::array<RationalPolynomial, 4>& curve, const Rational& t) {
  return {curve[0](t), curve[1](t), curve[2](t), curve[3](t)};
}

/// Of a line through x: where it meets a plane.
MinkowskiVector<Rational> other_point(const Line& line, const MinkowskiVector<Rational>& x,
                                      RandomRationals& random) {
  // The line is dual to the meet of planes, so its meet with a plane is a null point.
  const Line dual = {line[3], line[4], line[5], line[0], line[1], line[2]};
  return translated(null_plane(dual, random.vector()), random(), x);
}

template <class Congruence>
void check_lines_of_case(const Congruence& congruence, const json& example,
                         RandomRationals& random) {
  for (int i = 0; i < 8; ++i) {
    const Rational s = random() + Rational(100L), t = random() - Rational(50L);
    const auto w = RandomRationals::isotropic(s, t);
    const Line line = congruence.line_through(w);
    CHECK(incident(line, w));
    CHECK(proportional(line, line_of_case(example, s, t)));
  }
}

}  // namespace

TEST_CASE("Nets, cubics and axes with conics find the lines of the worked examples",
          "[minkowski]") {
  RandomRationals random(8);
  for (const json& example : minkowski_cases()["families"]) {
    INFO(example["id"]);
    const auto complexes = complexes_of_case(example, random);
    if (complexes.size() == 2) {
      check_lines_of_case(LineNet{complexes[0], complexes[1]}, example, random);
    } else if (example.contains("focal_axis_planes")) {
      check_lines_of_case(AxisCurveCongruence(planes_of(example["focal_axis_planes"]),
                                              curve_of(example["focal_curve"])),
                          example, random);
    } else if (example.contains("focal_curve")) {
      check_lines_of_case(chords_of(curve_of(example["focal_curve"])), example, random);
    } else {
      CHECK(example["id"] == "quadratic-example-2");  // case 5 again
    }
  }
}

TEST_CASE("Lines of a net belong to both complexes, whatever its axes are", "[minkowski]") {
  RandomRationals random(9);
  for (int i = 0; i < 10; ++i) {
    const auto p = random.vector(), q = random.vector();
    const LineNet net = {{random(), random(), random(), random(), random(), random()},
                         i % 2 == 0 ? join(p, q) : join(q, random.vector())};
    const auto x = random.vector();
    const Line line = net.line_through(x);
    CHECK(incident(line, x));
    CHECK(klein(line, line).is_zero());
    CHECK(klein(line, net.a).is_zero());
    CHECK(klein(line, net.b).is_zero());
    // Every other point of the line finds the same line.
    const auto y = other_point(line, x, random);
    CHECK(proportional(net.line_through(y), line));
  }
}

TEST_CASE("Lines of a star meet its vertex", "[minkowski]") {
  RandomRationals random(10);
  const LineStar star = {random.vector()};
  const auto x = random.vector();
  CHECK(incident(star.line_through(x), x));
  CHECK(incident(star.line_through(x), star.vertex));
}

TEST_CASE("The line through a point of a chord is this chord", "[minkowski]") {
  RandomRationals random(11);
  for (int i = 0; i < 10; ++i) {
    std::array<RationalPolynomial, 4> cubic;
    for (auto& c : cubic) c = RationalPolynomial({random(), random(), random(), random()});
    const CubicChords chords = chords_of(cubic);
    const auto a = at(cubic, random()), b = at(cubic, random() + Rational(70L));
    CHECK(proportional(chords.line_through(translated(a, Rational(3L), b)), join(a, b)));
    const Rational t = random();
    MinkowskiVector<Rational> slope;
    for (std::size_t k = 0; k < 4; ++k) slope[k] = cubic[k].derivative()(t);
    CHECK(proportional(chords.line_through(translated(at(cubic, t), Rational(2L), slope)),
                       join(at(cubic, t), slope)));
    for (const Rational& zero : chords.line_through(a)) CHECK(zero.is_zero());
  }
  const RationalPolynomial t(std::vector<Rational>{0L, 1L});
  CHECK_THROWS_AS(chords_of({RationalPolynomial(1L), t, t * t, t + t * t}), std::domain_error);
}

TEST_CASE("Lines of a (1, n) congruence meet its axis and its curve", "[minkowski]") {
  RandomRationals random(12);
  const json& example = minkowski_cases()["congruence_1_3"];
  check_lines_of_case(
      AxisCurveCongruence(planes_of(example["axis_planes"]), curve_of(example["curve"])), example,
      random);

  const json& quartic = minkowski_cases()["congruence_1_4"];
  const auto planes = planes_of(quartic["axis_planes"]);
  const auto curve = curve_of(quartic["curve"]);
  const AxisCurveCongruence congruence(planes, curve);
  for (int i = 0; i < 8; ++i) {
    const auto x = random.vector();
    const Line line = congruence.line_through(x);
    CHECK(incident(line, x));
    CHECK(klein(line, meet(planes[0], planes[1])).is_zero());
    // The line is the same from each of its points on the curve's side.
    const auto c = at(curve, random() + Rational(50L));
    const MinkowskiVector<Rational> on_axis = {random(), random(), 0L, 0L};
    CHECK(proportional(congruence.line_through(translated(c, random() + Rational(40L), on_axis)),
                       join(c, on_axis)));
  }
}

TEST_CASE("A curve that meets the axis too seldom is refused", "[minkowski]") {
  const json& quartic = minkowski_cases()["congruence_1_4"];
  auto curve = curve_of(quartic["curve"]);
  curve[2] += RationalPolynomial(1L);
  CHECK_THROWS_AS(AxisCurveCongruence(planes_of(quartic["axis_planes"]), curve), std::domain_error);
}
