// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/bezier/conic_lines.hpp"

#include <catch2/catch.hpp>
#include <memory>

#include "error_code.hpp"
#include "moving_ellipses.hpp"

using namespace pn;
using namespace pn::test;

namespace {

RationalPolynomial poly(const std::vector<long>& c) { return conic_polynomial(c); }

std::shared_ptr<const ConicPoints> points(const MovingConic& conic) {
  return std::make_shared<const ConicPoints>(ConicSpan{conic, {}});
}

/// Two spans; the matrices of the second are three times as large where they meet.
ConicChain two_spans() {
  const RationalPolynomial aa = poly({6, 1}), bb = poly({4, 0, 2});
  return {{points(upright(ellipse(poly({2, 1, 3}), poly({5, -2, 1})))),
           points(upright(diagonal(-3L * aa * bb, 3L * bb, 3L * aa), 1))},
          false};
}

std::array<const FormInU<RealBall>*, 4> components(const SectionSegment& segment) {
  const auto& [point, direction, weight] = segment.sections;
  return {&point[0], &point[1], &point[2], &weight};
}

}  // namespace

TEST_CASE("Lines run on from segment to segment with the same weights", "[conic_lines]") {
  for (const Lines lines : {Lines::kEven, Lines::kLowestDegree}) {
    const auto segments = lined_segments(two_spans(), lines, 192);
    for (std::size_t i = 1; i < segments.size(); ++i) {
      CHECK(segments[i].begin == segments[i - 1].end);
      const auto left = components(segments[i - 1]), right = components(segments[i]);
      for (std::size_t c = 0; c < 4; ++c) {
        for (std::size_t k = 0; k < 3; ++k) {
          const RealBall a = left[c]->coefficient[k](RealBall(1)),
                         b = right[c]->coefficient[k](RealBall(0));
          CHECK(a.overlaps(b));
          CHECK((a - b).magnitude_upper() < 1e-40);
        }
      }
    }
    CHECK(segments.front().begin == 0);
    CHECK(segments.back().end == 2);
  }
}

TEST_CASE("Lines of lowest degree keep the degree, even ones add two", "[conic_lines]") {
  const auto conic = points(upright(ellipse(poly({2, 1, 3}), poly({5, -2, 1}))));
  const auto degree = [&](Lines lines) {
    return lined_segments({{conic}, false}, lines, 128)
        .front()
        .sections.weight.coefficient[0]
        .degree();
  };
  CHECK(degree(Lines::kLowestDegree) == conic->degree());
  CHECK(degree(Lines::kEven) == conic->degree() + 2);
}

TEST_CASE("Lines that are even already cost no degree", "[conic_lines]") {
  const auto conic = points(upright(ellipse(4L, 1L)));
  const auto segments = lined_segments({{conic}, false}, Lines::kEven, 128);
  REQUIRE(segments.size() == 1);
  CHECK(segments[0].sections.weight.coefficient[0].degree() == 1);
}

TEST_CASE("A closed surface without room for its last lines is refused", "[conic_lines]") {
  // Half-axes whose squares have a degree that leaves no room under 25.
  const RationalPolynomial high = poly({1}) + power_of_t(13) * poly({1, -1});
  const auto conic = points(upright(ellipse(high * high + poly({1}), high * high + poly({2}))));
  REQUIRE(conic->degree() > 23);
  CHECK(code_of([&] {
          lined_segments({{conic}, true}, Lines::kEven, 128);
        }) == ErrorCode::kDegreeTooHigh);
}

TEST_CASE("The band of arcs holds them", "[conic_lines]") {
  // Circles of radius 1 cut by a line that turns.
  const auto conic = std::make_shared<const ConicPoints>(ConicSpan{
      upright(diagonal(-1L, 1L, 1L)), Vector3<RationalPolynomial>{0L, poly({0, 2}), poly({1})}});
  for (const ConicSegment& segment : lined_segments({{conic}, false}, Lines::kEven, 128)) {
    CHECK(segment.around == Around::kArc);
    for (const double t : {0.0, 0.3, 0.9, 1.0}) {
      CHECK(value(segment.cut, t, 1.0, 0.0) < 0);
      CHECK(value(segment.cut, t, 0.0, 1.0) < 0);
      CHECK(value(segment.cut, t, 1.0, 1.0) > 0);
    }
  }
}
