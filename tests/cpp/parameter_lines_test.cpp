// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/bezier/parameter_lines.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "enclosures.hpp"
#include "pn/shapes/canal_surface.hpp"

using namespace pn;
using namespace pn::test;

namespace {

const BSplineData<3> kCubic{3,
                            {0, 1, 3, 4},
                            {4, 1, 1, 4},
                            {{0, 0, 0}, {1, 0, 0}, {2, 3, 0}, {3, 1, 2}, {4, 0, 1}, {6, 0, 1}},
                            {}};

EnvelopeChain smooth_chain() {
  return canal_surface(
      Curve::bspline(kCubic),
      Law::bspline(
          {3, {0, 1, 3, 4}, {4, 1, 1, 4}, {{0.5}, {0.5}, {0.75}, {0.5}, {0.25}, {0.25}}, {}}));
}

EnvelopeChain cornered_chain() {
  return canal_surface(
      Curve::bspline({1, {0, 1, 2}, {2, 1, 2}, {{0, 0, 0}, {3, 0, 0}, {3, 4, 1}}, {}}),
      Law::constant(0.5));
}

/// A periodic C2 cubic around a bent ring.
EnvelopeChain closed_chain() {
  BSplineData<3> data{3, {0, 1, 2, 3, 4}, {4, 3, 3, 3, 4}, {}, {}};
  const std::array<std::array<double, 3>, 4> d = {{{6, 0, 0}, {0, 6, 3}, {-6, 0, 0}, {0, -6, 3}}};
  const auto mean = [&](int a, int b, int c, int wa, int wb, int wc) {
    std::array<double, 3> p;
    for (std::size_t i = 0; i < 3; ++i)
      p[i] = (wa * d[a % 4][i] + wb * d[b % 4][i] + wc * d[c % 4][i]) / (wa + wb + wc);
    return p;
  };
  for (int i = 0; i <= 4; ++i) {
    data.poles.push_back(mean(i + 3, i, i + 1, 1, 4, 1));
    if (i == 4) break;
    data.poles.push_back(mean(i, i + 1, i, 2, 1, 0));
    data.poles.push_back(mean(i, i + 1, i, 1, 2, 0));
  }
  return canal_surface(Curve::bspline(data), Law::constant(1));
}

/// The homogeneous sections and their derivatives by the spine's parameter at an end of a segment.
struct EndForms {
  std::array<std::array<RealBall, 3>, 7> value, slope;  ///< [x y z, V1 V2 V3, w][q]
};

EndForms at_end(const LinedSegment& segment, long end) {
  const HomogeneousSections<RealBall>& forms = segment.sections;
  const RealBall t = RealBall(end).at_precision(128), length(segment.end - segment.begin);
  EndForms result;
  const auto set = [&](std::size_t i, const FormInU<RealBall>& q) {
    for (std::size_t k = 0; k < 3; ++k) {
      result.value[i][k] = q.coefficient[k](t);
      result.slope[i][k] = q.coefficient[k].derivative()(t) / length;
    }
  };
  for (std::size_t i = 0; i < 3; ++i) {
    set(i, forms.point[i]);
    set(3 + i, forms.direction[i]);
  }
  set(6, forms.weight);
  return result;
}

/// A smooth joint: every homogeneous section is C1 in the spine's parameter, as functions of u. A
/// tangent one: they agree up to a common factor.
void check_joint(const LinedSegment& left, const LinedSegment& right, Joint joint) {
  const EndForms a = at_end(left, 1), b = at_end(right, 0);
  const RealBall factor = joint == Joint::kSmooth ? RealBall(1) : b.value[6][0] / a.value[6][0];
  REQUIRE(factor.is_positive());
  for (std::size_t i = 0; i < 7; ++i) {
    for (std::size_t q = 0; q < 3; ++q) {
      CHECK(encloses_zero(a.value[i][q] * factor - b.value[i][q], 1e-9));
      if (joint == Joint::kSmooth) CHECK(encloses_zero(a.slope[i][q] - b.slope[i][q], 1e-9));
    }
  }
}

int degree_of(const LinedSegment& segment) {
  return segment.sections.weight.coefficient.front().degree();
}

void check_joints(const EnvelopeChain& chain, Lines lines) {
  const auto segments = lined_segments(chain, lines, 128);
  for (std::size_t i = 1; i < segments.size(); ++i) {
    INFO("joint before segment " << i);
    CHECK(segments[i].joint_before != Joint::kNone);
    check_joint(segments[i - 1], segments[i], segments[i].joint_before);
  }
  if (chain.closed) check_joint(segments.back(), segments.front(), segments.front().joint_before);
}

}  // namespace

TEST_CASE("Lines run on across every joint, and C1 across smooth ones", "[parameter_lines]") {
  for (const EnvelopeChain& chain : {smooth_chain(), cornered_chain(), closed_chain()}) {
    check_joints(chain, Lines::kEven);
    check_joints(chain, Lines::kLowestDegree);
  }
  const auto segments = lined_segments(smooth_chain(), Lines::kEven, 128);
  for (std::size_t i = 1; i < segments.size(); ++i)
    CHECK(segments[i].joint_before == Joint::kSmooth);
  CHECK(lined_segments(closed_chain(), Lines::kEven, 128).front().joint_before == Joint::kSmooth);
}

TEST_CASE("Segments cover the spine end to end", "[parameter_lines]") {
  const auto segments = lined_segments(smooth_chain(), Lines::kEven, 128);
  CHECK(segments.front().begin == 0);
  CHECK(segments.back().end == 4);
  for (std::size_t i = 1; i < segments.size(); ++i) CHECK(segments[i].begin == segments[i - 1].end);

  const auto cornered = lined_segments(cornered_chain(), Lines::kEven, 128);
  for (const LinedSegment& segment : cornered) {
    if (!segment.stands_still) continue;
    CHECK(segment.begin >= 0);
    CHECK(segment.end <= 1);
  }
}

TEST_CASE("Lines of lowest degree add nothing where weights allow it, else a linear factor",
          "[parameter_lines]") {
  const EnvelopeChain gentle = canal_surface(
      Curve::bezier({{0, 0, 0}, {1, 0, 0}, {2, 0.25, 0}, {3, 0.25, 0.25}}), Law::constant(0.25));
  for (const LinedSegment& segment : lined_segments(gentle, Lines::kLowestDegree, 128)) {
    CHECK(degree_of(segment) == gentle.links[0].envelope.degree());
  }
  const EnvelopeChain chain = smooth_chain();
  int largest = 0;
  for (const ChainLink& link : chain.links) largest = std::max(largest, link.envelope.degree());
  for (const LinedSegment& segment : lined_segments(chain, Lines::kLowestDegree, 128)) {
    CHECK(degree_of(segment) <= largest + 2);
  }
}

TEST_CASE(
    "Even lines have an even weight, at the right end of a free segment exactly to short doubles",
    "[parameter_lines]") {
  for (const LinedSegment& segment : lined_segments(smooth_chain(), Lines::kEven, 128)) {
    const auto w4 = isotropic_vector<double>(segment.lines)[3];
    const double q00 = w4.coefficient[0](1), q01 = w4.coefficient[1](1), q11 = w4.coefficient[2](1);
    CHECK(q00 == Approx(1).epsilon(1e-5));
    CHECK(q11 == Approx(1).epsilon(1e-5));
    CHECK(std::abs(q01) < 1e-5);
  }
}

TEST_CASE("Faces around the circle", "[parameter_lines]") {
  CHECK(circle_columns(Lines::kEven, 4, 2).size() == 1);
  CHECK(circle_columns(Lines::kEven, 4, 2)[0].degree == 4);
  CHECK(circle_columns(Lines::kLowestDegree, 8, 2).size() == 8);
  CHECK(circle_columns(Lines::kLowestDegree, 8, 2)[3].degree == 2);
}
