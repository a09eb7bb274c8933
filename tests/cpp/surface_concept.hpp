// SPDX-License-Identifier: LGPL-2.1-or-later
// What every surface must satisfy, whatever its shape: the common part of the concept tests.
#pragma once

#include <Eigen/Dense>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdlib>
#include <set>
#include <utility>
#include <vector>

#include "enclosures.hpp"
#include "pn/bezier/pn_surface.hpp"
#include "pn/geometry_error.hpp"

namespace pn::test {

/// Identities are enclosed to this relative width: far below what a wrong formula leaves, far above
/// what 128 bits leave.
constexpr double kNarrow = 1e-9;

/// What evaluation in doubles leaves of an identity, in parts of the surface's size.
constexpr double kRounding = 1e-11;

inline double number_from_environment(const char* name, double otherwise) {
  const char* text = std::getenv(name);
  return text ? std::atof(text) : otherwise;
}

inline Eigen::Vector3d vector(const std::array<double, 3>& p) { return {p[0], p[1], p[2]}; }

/// x of the section at distance zero and n, at a point of a segment.
struct EnclosedContact {
  std::array<RealBall, 3> point, normal;
};

inline EnclosedContact contact(const HomogeneousSections<RealBall>& forms, const RealBall& t,
                               const RealBall& u0, const RealBall& u1) {
  const RealBall weight = jet(forms.weight, t, u0, u1).value;
  EnclosedContact result;
  for (std::size_t i = 0; i < 3; ++i) {
    result.point[i] = jet(forms.point[i], t, u0, u1).value / weight;
    result.normal[i] = jet(forms.direction[i], t, u0, u1).value / weight;
  }
  return result;
}

/// |n| = 1 and n.x_t = n.x_u = 0, for x of the sections at distances zero and one, as enclosures of
/// zero, where the weight does not vanish.
inline void check_identities(const HomogeneousSections<RealBall>& forms, const RealBall& t,
                             const RealBall& u0, const RealBall& u1) {
  const std::array<RealBall, 3> n = contact(forms, t, u0, u1).normal;
  CHECK(encloses_zero(n[0] * n[0] + n[1] * n[1] + n[2] * n[2] - RealBall(1), kNarrow));
  const Jet weight = jet(forms.weight, t, u0, u1);
  REQUIRE_FALSE(weight.value.contains_zero());
  const RealBall square = weight.value * weight.value;
  for (const double distance : {0.0, 1.0}) {
    RealBall along, around;
    double size = 0, speed_along = 0, speed_around = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const Jet p = jet(forms.point[i], t, u0, u1), v = jet(forms.direction[i], t, u0, u1);
      const auto section = [&](const RealBall& a, const RealBall& b) {
        return a + RealBall(distance) * b;
      };
      const RealBall x = section(p.value, v.value);
      const RealBall x_t = (section(p.along, v.along) * weight.value - x * weight.along) / square;
      const RealBall x_u =
          (section(p.around, v.around) * weight.value - x * weight.around) / square;
      along += n[i] * x_t;
      around += n[i] * x_u;
      size = std::max(size, (x / weight.value).magnitude_upper());
      speed_along = std::max(speed_along, x_t.magnitude_upper());
      speed_around = std::max(speed_around, x_u.magnitude_upper());
    }
    CHECK(encloses_zero(along, kNarrow * (size + speed_along)));
    CHECK(encloses_zero(around, kNarrow * (size + speed_around)));
  }
}

inline void check_plain_data(const BSplineSurface& face) {
  const auto check_direction = [](int degree, const std::vector<double>& knots,
                                  const std::vector<int>& multiplicities) {
    REQUIRE(knots.size() == multiplicities.size());
    CHECK(multiplicities.front() == degree + 1);
    CHECK(multiplicities.back() == degree + 1);
    for (std::size_t i = 1; i < knots.size(); ++i) CHECK(knots[i - 1] < knots[i]);
    for (std::size_t i = 1; i + 1 < knots.size(); ++i) CHECK(multiplicities[i] <= degree - 1);
  };
  check_direction(face.u_degree, face.u_knots, face.u_multiplicities);
  check_direction(face.v_degree, face.v_knots, face.v_multiplicities);
  CHECK(face.u_degree <= 25);
  REQUIRE(face.poles.size() == face.u_count() * face.v_count());
  REQUIRE(face.weights.size() == face.poles.size());
  for (const double weight : face.weights) CHECK(weight > 0);
}

/// Every curve ends where the next one begins, bit for bit.
inline void check_closed(const TrimLoop& loop) {
  for (std::size_t i = 0; i < loop.size(); ++i) {
    CHECK(loop[i].poles.back() == loop[(i + 1) % loop.size()].poles.front());
  }
}

struct ControlPoint {
  std::array<double, 3> pole;
  double weight;
  bool operator==(const ControlPoint& other) const {
    return pole == other.pole && weight == other.weight;
  }
};

inline std::vector<ControlPoint> row(const BSplineSurface& face, std::size_t i) {
  std::vector<ControlPoint> result;
  for (std::size_t j = 0; j < face.v_count(); ++j) {
    result.push_back({face.poles[i * face.v_count() + j], face.weights[i * face.v_count() + j]});
  }
  return result;
}

inline std::vector<ControlPoint> column(const BSplineSurface& face, std::size_t j) {
  std::vector<ControlPoint> result;
  for (std::size_t i = 0; i < face.u_count(); ++i) {
    result.push_back({face.poles[i * face.v_count() + j], face.weights[i * face.v_count() + j]});
  }
  return result;
}

/// The faces come strip by strip along the first parameter, `around` of them across each strip:
/// one shares its last row with the next strip, bit for bit.
inline void check_shared_rows(const std::vector<BSplineSurface>& faces, std::size_t around,
                              bool closed) {
  for (std::size_t i = 0; i < faces.size(); ++i) {
    const bool last = i + around >= faces.size();
    if (last && !closed) continue;
    CHECK((row(faces[i], faces[i].u_count() - 1) == row(faces[(i + around) % faces.size()], 0)));
  }
}

/// The segments of every strip: [first, last).
inline std::vector<std::pair<std::size_t, std::size_t>> strips(
    const std::vector<LinedSegment>& segments) {
  std::vector<std::pair<std::size_t, std::size_t>> result;
  for (std::size_t i = 0; i < segments.size(); ++i) {
    if (i == 0 || segments[i].joint_before != Joint::kSmooth) result.emplace_back(i, i);
    result.back().second = i + 1;
  }
  return result;
}

/// The link of every segment.
inline std::vector<const ChainLink*> links_of(const EnvelopeChain& chain,
                                              const std::vector<LinedSegment>& segments) {
  std::vector<const ChainLink*> result;
  auto link = chain.links.begin();
  for (const LinedSegment& segment : segments) {
    REQUIRE(link != chain.links.end());
    result.push_back(&*link);
    const double end = link->stands_still() ? 1 : link->end;
    if (segment.end == end) ++link;
  }
  CHECK(link == chain.links.end());
  return result;
}

/// The parameter of a link on [0, 1] at `local` on one of its segments.
inline Rational on_link(const ChainLink& link, const LinedSegment& segment, const Rational& local) {
  const double from = link.stands_still() ? 0 : link.begin, to = link.stands_still() ? 1 : link.end;
  const Rational begin = Rational::exactly(segment.begin), end = Rational::exactly(segment.end);
  const Rational at = begin + local * (end - begin);
  return (at - Rational::exactly(from)) / (Rational::exactly(to) - Rational::exactly(from));
}

/// The largest coordinate of a pole.
inline double extent(const BSplineSurface& face) {
  double largest = 0;
  for (const auto& pole : face.poles) {
    for (const double x : pole) largest = std::max(largest, std::abs(x));
  }
  return largest;
}

/// The exported point of a face lies within the deviation of the true one.
inline void check_exported_point(const BSplineSurface& face, const std::array<double, 2>& place,
                                 const std::array<RealBall, 3>& truth,
                                 const Certificate& certificate) {
  const auto exported = enclosed_point(face, place[0], place[1], certificate.precision_bits);
  RealBall squares;
  for (std::size_t c = 0; c < 3; ++c) {
    squares += (exported[c] - truth[c]) * (exported[c] - truth[c]);
  }
  CHECK(sqrt(abs(squares)).upper() <= certificate.deviation);
}

/// Two unit vectors are the same, but for rounding.
inline void check_along(const std::array<RealBall, 3>& x, const Eigen::Vector3d& y) {
  CHECK(x[0].midpoint() * y(0) + x[1].midpoint() * y(1) + x[2].midpoint() * y(2) > 1 - 1e-9);
}

/// The point of the surface of doubles at (u, v) lies within the deviation of the true point, which
/// is that of the segment, at parameter v of the columns.
inline void check_certificate(const BSplineSurface& face, const LinedSegment& segment,
                              const CircleColumns& columns, double u, double v, double distance,
                              const Certificate& certificate) {
  const long precision = certificate.precision_bits;
  const auto ball = [&](double x) { return RealBall(x).at_precision(precision); };
  const RealBall s = (ball(u) - ball(segment.begin)) / (ball(segment.end) - ball(segment.begin));
  std::vector<RealBall> factors;
  for (const Rational& x : circle_coefficients(columns, v)) factors.emplace_back(x, precision);
  const HomogeneousSections<RealBall>& forms = segment.sections;
  const RealBall weight = value(forms.weight, s, factors);
  std::array<RealBall, 3> truth;
  double size = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    truth[i] = (value(forms.point[i], s, factors) +
                ball(distance) * value(forms.direction[i], s, factors)) /
               weight;
    size = std::max(size, truth[i].magnitude_upper());
  }
  CAPTURE(u, v, distance);
  check_exported_point(face, {u, v}, truth, certificate);
  // A certificate that says nothing would always hold.
  if (certificate.exact) CHECK(certificate.deviation < 1e-11 * (size + extent(face)));
}

}  // namespace pn::test
