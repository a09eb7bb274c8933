// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/shapes/ruled_surface.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "error_code.hpp"
#include "pn/bezier/pn_surface.hpp"

using namespace pn;
using namespace pn::test;

namespace {

using Point = std::array<double, 3>;

constexpr double kRounding = 1e-12;

/// The parameters of a face along and inside its band.
std::vector<SurfacePoint> samples(const PNSurface& surface, double end) {
  std::vector<double> t, v;
  for (int i = 0; i <= 8; ++i) {
    for (int j = 0; j <= 8; ++j) {
      t.push_back(end * i / 8);
      v.push_back(j / 8.0);
    }
  }
  return surface.evaluate(t, v);
}

const std::vector<Point> kCubic = {{0, 0, 0}, {1, 2, 0}, {3, 2, 1}, {4, 0, 3}};

template <class Map>
Curve mapped(const std::vector<Point>& poles, const Map& map) {
  std::vector<Point> result;
  for (const Point& p : poles) result.push_back(map(p));
  return Curve::bezier(result);
}

/// Four quarter circles in the cylinder of this radius from the angle turn pi / 2, in the plane z =
/// height + tilt x.
Curve circle(double radius, int turn, double height, double tilt = 0) {
  const std::array<std::array<double, 2>, 8> square = {
      {{1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}, {0, -1}, {1, -1}}};
  BSplineData<3> data{2, {0, 1, 2, 3, 4}, {3, 2, 2, 2, 3}, {}, {1, 1, 2, 1, 1, 1, 2, 1, 1}};
  for (int i = 0; i <= 8; ++i) {
    const auto& p = square[static_cast<std::size_t>((i + 2 * turn) % 8)];
    data.poles.push_back({radius * p[0], radius * p[1], height + tilt * radius * p[0]});
  }
  return Curve::bspline(data);
}

std::optional<ErrorCode> refusal(const Curve& a, const Curve& b) {
  return code_of([&] { ruled_surface(a, b); });
}

std::vector<std::size_t> torsal_counts(const EnvelopeChain& chain) {
  std::vector<std::size_t> counts;
  for (const ChainLink& link : chain.links) {
    const auto carrier = link.envelope.enclosure(128).carrier;
    counts.push_back(std::get<RulingForms<RealBall>>(carrier).torsal_roots.size());
  }
  return counts;
}

using Counts = std::vector<std::size_t>;

}  // namespace

TEST_CASE("The hyperbolic paraboloid z = x y and its offsets", "[ruled_surface]") {
  const PNSurface surface(
      ruled_surface(Curve::bezier({{0, 0, 0}, {1, 0, 0}}), Curve::bezier({{0, 1, 0}, {1, 1, 1}})));
  CHECK(surface.degree() == std::array<int, 2>{5, 4});
  for (const double d : {0.0, 0.25, -0.5}) {
    for (const auto& [x, n] : samples(surface.offset(d), 1)) {
      Point foot;
      for (std::size_t c = 0; c < 3; ++c) foot[c] = x[c] - d * n[c];
      CHECK(foot[2] == Approx(foot[0] * foot[1]).margin(kRounding));
      // c_t x c_v points along (-y, -x, 1).
      const double size = std::hypot(foot[0], foot[1], 1.0);
      CHECK(n[0] == Approx(-foot[1] / size).margin(kRounding));
      CHECK(n[1] == Approx(-foot[0] / size).margin(kRounding));
      CHECK(n[2] == Approx(1 / size).margin(kRounding));
    }
  }
}

TEST_CASE("The hyperboloid between two turned circles", "[ruled_surface]") {
  // Rulings from angle a at z = -2 to a + 90 degrees at z = 2: x^2 + y^2 = 2 + z^2 / 2 for
  // radius 2.
  const PNSurface surface(ruled_surface(circle(2, 0, -2), circle(2, 1, 2)));
  for (const auto& [x, n] : samples(surface, 4)) {
    CHECK(x[0] * x[0] + x[1] * x[1] == Approx(2 + x[2] * x[2] / 2).epsilon(kRounding));
    CHECK(x[0] * n[0] + x[1] * n[1] > 0);
  }
  for (const auto& [x, n] : samples(surface.offset(0.5), 4)) {
    double square = 0, height = 0;
    for (const std::size_t c : {0, 1}) square += std::pow(x[c] - 0.5 * n[c], 2);
    height = x[2] - 0.5 * n[2];
    CHECK(square == Approx(2 + height * height / 2).epsilon(kRounding));
  }
}

TEST_CASE("Cones of revolution between the spheres of two lines", "[ruled_surface]") {
  // Every section touches the sphere of its t and v: x - d n - r n is the centre, on the rulings.
  const Curve first = Curve::bezier({{0, 0, 0}, {6, 0, 1}}),
              second = Curve::bezier({{0, 4, 0}, {6, 4, 3}});
  const PNSurface surface(
      cone_envelope(first, Law::bezier({1, 0.75}), second, Law::bezier({0.5, 0.5})));
  for (const double d : {0.0, 0.5}) {
    for (const auto& [x, n] : samples(surface.offset(d), 1)) {
      CHECK(std::hypot(n[0], n[1], n[2]) == Approx(1).epsilon(kRounding));
      // At parameter t the centre is (6 t, 4 v, t + 2 t v) and the radius 1 - t / 4 - v (1/2 - t /
      // 4). From x = centre + (r + d) n two coordinates give t and v, the third is the check.
      double t = 0.5, v = 0.5;
      for (int step = 0; step < 60; ++step) {
        const double r = 1 - t / 4 - v * (0.5 - t / 4) + d;
        t = (x[0] - r * n[0]) / 6;
        v = (x[1] - r * n[1]) / 4;
      }
      const double r = 1 - t / 4 - v * (0.5 - t / 4) + d;
      CHECK(x[2] - r * n[2] == Approx(t + 2 * t * v).margin(1e-11));
    }
  }
}

TEST_CASE("Cones of equal spheres are the offset of the ruled surface", "[ruled_surface]") {
  const Curve a = Curve::bezier(kCubic), b = mapped(kCubic, [](const Point&p) {
                                           return Point{p[0], p[1] + 4, p[0] / 2};
                                         });
  const Law half = Law::constant(0.5);
  const auto offset = PNSurface(ruled_surface(a, b)).offset(0.5).faces(Lines::kEven);
  const auto cones = PNSurface(cone_envelope(a, half, b, half)).faces(Lines::kEven);
  REQUIRE(offset.size() == cones.size());
  for (std::size_t i = 0; i < offset.size(); ++i) {
    REQUIRE(offset[i].poles.size() == cones[i].poles.size());
    for (std::size_t j = 0; j < offset[i].poles.size(); ++j) {
      for (std::size_t c = 0; c < 3; ++c) {
        CHECK(offset[i].poles[j][c] == Approx(cones[i].poles[j][c]).margin(kRounding));
      }
    }
  }
}

TEST_CASE("Exchanging the curves turns the normal round", "[ruled_surface]") {
  const Curve a = Curve::bezier({{0, 0, 0}, {1, 0, 0}}), b = Curve::bezier({{0, 1, 0}, {1, 1, 1}});
  for (const auto& [x, n] : samples(PNSurface(ruled_surface(b, a)), 1)) {
    CHECK(x[2] == Approx(x[0] * x[1]).margin(kRounding));
    CHECK(n[2] < 0);
  }
}

TEST_CASE("The second curve may have another domain and other knots", "[ruled_surface]") {
  const BSplineData<3> first{
      2, {0, 1, 3}, {3, 1, 3}, {{0, 0, 0}, {1, 0, 0}, {3, 1, 0}, {4, 0, 0}}, {}};
  BSplineData<3> second = first;
  second.knots = {5, 11, 20};  // breaks at 0, 6/5, 3 of the first
  for (Point& p : second.poles) p = {p[0], p[1] + 3, 1 + p[0]};
  const EnvelopeChain chain = ruled_surface(Curve::bspline(first), Curve::bspline(second));
  REQUIRE(chain.links.size() == 3);
  CHECK(chain.links[0].end == 1);
  CHECK(chain.links[1].end == Approx(1.2));
  CHECK(chain.links[2].end == 3);
  CHECK(PNSurface(chain).certificate(Lines::kEven).deviation < 1e-12);
}

TEST_CASE("Closed curves close", "[ruled_surface]") {
  const EnvelopeChain chain = ruled_surface(circle(2, 0, -2), circle(2, 1, 2));
  CHECK(chain.closed);
  CHECK(chain.links.size() == 4);
  for (const ChainLink& link : chain.links) CHECK(link.joint_before != Joint::kNone);
}

TEST_CASE("Torsal rulings inside a span cut it between them", "[ruled_surface]") {
  // On the x-axis with rulings (., 12, z), z = 9 t - 24 t^2 + 16 t^3: z' = 3 (4 t - 1)(4 t - 3).
  const Curve first = Curve::bezier({{0, 0, 0}, {15, 0, 0}}),
              second = Curve::bezier({{0, 12, 0}, {6, 12, 3}, {10, 12, -2}, {15, 12, 1}});
  const EnvelopeChain chain = ruled_surface(first, second);
  REQUIRE(chain.links.size() == 2);
  CHECK(chain.links[0].end > 0.25);
  CHECK(chain.links[0].end < 0.75);
  const PNSurface surface(chain);
  CHECK(surface.certificate(Lines::kEven).trim_deviation < 1e-9);
}

TEST_CASE("One a little beyond a free end shares no span with one inside", "[ruled_surface]") {
  // z = 64 t^3 - 45 t^2 - 3 t: z' = 3 (2 t - 1) (32 t + 1).
  const EnvelopeChain chain =
      ruled_surface(Curve::bezier({{0, 0, 0}, {15, 0, 0}}),
                    Curve::bezier({{0, 12, 0}, {6, 12, -1}, {10, 12, -17}, {15, 12, 16}}));
  CHECK(torsal_counts(chain).size() == 2);
  for (const std::size_t count : torsal_counts(chain)) CHECK(count <= 1);
  CHECK(PNSurface(chain).certificate(Lines::kEven).deviation < 1e-12);
}

TEST_CASE("Lines run on across a torsal ruling at a joint", "[ruled_surface]") {
  // A funnel: the tangents of both rims are parallel where the quarters of the circles meet.
  const EnvelopeChain chain = ruled_surface(circle(2, 0, 0), circle(1.5, 0, 2, -1));
  REQUIRE(chain.closed);
  CHECK(torsal_counts(chain) == Counts{1, 1, 1, 1});
  const PNSurface surface(chain);
  CHECK(surface.certificate(Lines::kEven).deviation < 1e-12);
  CHECK(surface.certificate(Lines::kEven).trim_deviation < 1e-9);
  const auto& faces = surface.offset(0.25).faces(Lines::kEven);
  for (std::size_t i = 0; i < faces.size(); ++i) {
    const BSplineSurface &face = faces[i], &next = faces[(i + 1) % faces.size()];
    const std::size_t columns = face.v_count(), last = face.poles.size() - columns;
    for (std::size_t j = 0; j < columns; ++j) CHECK(face.poles[last + j] == next.poles[j]);
  }
}

TEST_CASE("A torsal ruling in a span of high degree gets a short one", "[ruled_surface]") {
  // Quintics need degree 21, 25 with a torsal ruling: none is left for lines that turn.
  const EnvelopeChain chain = ruled_surface(
      Curve::bezier({{0, 0, 0}, {3, 0, 0}, {6, 0, 0}, {9, 0, 0}, {12, 0, 0}, {15, 1, 0}}),
      Curve::bezier({{0, 9, 2}, {3, 9, 1}, {6, 9, 0}, {9, 9, 0}, {12, 9, 1}, {15, 9, 3}}));
  CHECK(torsal_counts(chain) == Counts{0, 1, 0});
  CHECK(chain.links[1].end - chain.links[1].begin < 0.01);
  CHECK(PNSurface(chain).certificate(Lines::kEven).deviation < 1e-12);
}

TEST_CASE("Pinch points on the rulings are refused", "[ruled_surface]") {
  // Rulings (., 12, t^2 - t) are torsal at 1/2; the second curve runs with the first, stands still
  // in their common plane, or runs against it there.
  const auto ending = [](double from, double to) {
    return refusal(Curve::bezier({{0, 0, 0}, {15, 0, 0}}),
                   Curve::bezier({{from, 12, 0}, {(from + to) / 2, 12, -0.5}, {to, 12, 0}}));
  };
  CHECK_FALSE(ending(0, 15));
  CHECK_FALSE(ending(7, 7.125));
  CHECK(ending(7, 7) == ErrorCode::kPinched);
  CHECK(ending(7.125, 7) == ErrorCode::kPinched);
  CHECK(ending(15, 0) == ErrorCode::kPinched);
  // At an end the second curve begins along the ruling.
  CHECK(refusal(Curve::bezier({{0, 0, 0}, {15, 0, 0}}),
                Curve::bezier({{0, 6, 0}, {0, 9, 0}, {15, 9, 5}})) == ErrorCode::kPinched);
}

TEST_CASE("Planes are exact", "[ruled_surface]") {
  const PNSurface plane(ruled_surface(Curve::bezier({{0, 0, 2}, {1, 2, 2}, {3, 0, 2}}),
                                      Curve::bezier({{0, 5, 2}, {1, 6, 2}, {4, 5, 2}})));
  for (const auto& [x, n] : samples(plane.offset(0.75), 1)) {
    CHECK(x[2] == Approx(2.75).epsilon(kRounding));
    CHECK(n[2] == Approx(1).epsilon(kRounding));
  }
  for (const BSplineSurface& face : plane.faces(Lines::kEven)) CHECK(face.trims.empty());
}

TEST_CASE("A cylinder and a cone of revolution are exact strips", "[ruled_surface]") {
  const PNSurface cylinder(ruled_surface(circle(2, 0, 0), circle(2, 0, 3))),
      cone(ruled_surface(circle(2, 0, 0), circle(1, 0, 1)));
  for (const auto& [x, n] : samples(cylinder.offset(0.5), 4)) {
    CHECK(std::hypot(x[0], x[1]) == Approx(2.5).epsilon(kRounding));
    CHECK(std::abs(n[2]) < kRounding);
  }
  for (const auto& [x, n] : samples(cone.offset(0.5), 4)) {
    // The plane n.x = sqrt(2) + d of the cone r = 2 - z.
    CHECK((std::hypot(x[0], x[1]) + x[2]) / std::sqrt(2.0) ==
          Approx(std::sqrt(2.0) + 0.5).epsilon(kRounding));
    CHECK(n[2] == Approx(std::sqrt(0.5)).epsilon(kRounding));
  }
}

TEST_CASE("Other developable surfaces are refused", "[ruled_surface]") {
  const Curve cubic = Curve::bezier(kCubic);
  const auto developable = ErrorCode::kDevelopable;
  CHECK(refusal(cubic, mapped(kCubic, [](const Point& p) {
                  return Point{p[0] + 1, p[1], p[2] + 5};
                })) == developable);  // cylinder
  CHECK(refusal(cubic, mapped(kCubic, [](const Point& p) {
                  return Point{2 * p[0] + 1, 2 * p[1], 2 * p[2] + 5};
                })) == developable);  // cone
  // c and c + c', its degree raised: the tangent surface of a cubic.
  std::vector<Point> tangent = kCubic;
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t c = 0; c < 3; ++c) {
      const auto step = [&](std::size_t j) { return kCubic[j + 1][c] - kCubic[j][c]; };
      if (i > 0) tangent[i][c] += static_cast<double>(i) * step(i - 1);
      if (i < 3) tangent[i][c] += static_cast<double>(3 - i) * step(i);
    }
  }
  CHECK(refusal(cubic, Curve::bezier(tangent)) == developable);
}

TEST_CASE("Curves that are one, that meet, or that stand still are refused", "[ruled_surface]") {
  const Curve cubic = Curve::bezier(kCubic);
  CHECK(refusal(cubic, cubic) == ErrorCode::kIdenticalCurves);
  // The same curve over another domain is the same curve.
  CHECK(refusal(Curve::bspline({1, {0, 1}, {2, 2}, {{0, 0, 0}, {1, 0, 0}}, {}}),
                Curve::bspline({1, {3, 7}, {2, 2}, {{0, 0, 0}, {1, 0, 0}}, {}})) ==
        ErrorCode::kIdenticalCurves);
  const auto meeting = [](double from, double to) {
    return refusal(Curve::bezier({{0, 0, 0}, {2, 0, 0}}),
                   Curve::bezier({{0, from, 0}, {2, to, 0}}));
  };
  CHECK(meeting(0, 1) == ErrorCode::kCurvesMeet);
  CHECK(meeting(1, 0) == ErrorCode::kCurvesMeet);
  CHECK(meeting(-1, 1) == ErrorCode::kCurvesMeet);
  const Curve point = Curve::bezier({{1, 1, 1}, {1, 1, 1}});
  CHECK(refusal(cubic, point) == ErrorCode::kZeroLength);
  CHECK(refusal(point, cubic) == ErrorCode::kZeroLength);
}

TEST_CASE("Corners and jumps of speed are refused", "[ruled_surface]") {
  const auto bent = [](const Point& middle, const Point& end) {
    return Curve::bspline({1, {0, 1, 2}, {2, 1, 2}, {{0, 0, 0}, middle, end}, {}});
  };
  const Curve other = Curve::bezier({{0, 4, 0}, {2, 5, 3}});
  CHECK(refusal(bent({1, 0, 0}, {2, 1, 0}), other) == ErrorCode::kCornerTooSharp);
  CHECK(refusal(bent({1, 0, 0}, {3, 0, 0}), other) == ErrorCode::kCornerTooSharp);
}

TEST_CASE("Spheres without a common cone are refused", "[ruled_surface]") {
  const Curve first = Curve::bezier({{0, 0, 0}, {6, 0, 1}}),
              second = Curve::bezier({{0, 4, 0}, {6, 4, 3}});
  const auto with = [&](double a, double b) {
    return code_of([&] {
      cone_envelope(first, Law::bezier({a, a, 1}), second, Law::bezier({b, b, 1}));
    });
  };
  CHECK_FALSE(with(1, 0.5));
  CHECK(with(6, 1) == ErrorCode::kRadiusTooSteep);
  CHECK(with(5, 1) == ErrorCode::kRadiusTooSteep);  // they touch from within
  // The spheres along one side grow faster than they move: no point of it lies on the envelope.
  CHECK(code_of([&] {
          cone_envelope(first, Law::bezier({1, 9}), second, Law::bezier({1, 9}));
        }) == ErrorCode::kRadiusTooSteep);
}
