// SPDX-License-Identifier: LGPL-2.1-or-later
// Surfaces whose shape is known in closed form, as B-splines: what the tests build shapes from.
#pragma once

#include <array>
#include <cmath>
#include <vector>

#include "pn/bezier/bspline_surface.hpp"

namespace pn::test {

constexpr double kPi = 3.14159265358979323846;

/// A rational B-spline curve in a plane.
struct PlaneCurve {
  int degree;
  std::vector<double> knots;
  std::vector<int> multiplicities;
  std::vector<std::array<double, 2>> poles;
  std::vector<double> weights;
};

/// The straight line from a to b, over [0, 1].
inline PlaneCurve line(std::array<double, 2> a, std::array<double, 2> b) {
  return {1, {0, 1}, {2, 2}, {a, b}, {1, 1}};
}

/// The half circle x^2 + y^2 = 1, x >= 0, from (0, -1) to (0, 1), as one arc of degree 4.
inline PlaneCurve half_circle() {
  return {4, {0, 1}, {5, 5}, {{0, -1}, {1, -1}, {2, 0}, {1, 1}, {0, 1}}, {2, 1, 2. / 3, 1, 2}};
}

/// The unit circle in four quadratic arcs, only C0 as a B-spline: nine poles.
inline PlaneCurve quadratic_circle() {
  const double c = std::sqrt(0.5);
  return {2,
          {0, 1, 2, 3, 4},
          {3, 2, 2, 2, 3},
          {{1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}, {0, -1}, {1, -1}, {1, 0}},
          {1, c, 1, c, 1, c, 1, c, 1}};
}

/// The arcs `first` to `last` of the unit circle in four arcs of degree 4, C1 as a B-spline.
///
/// (p^2 - q^2, 2 p q) / (p^2 + q^2), where (p, q) runs on the quadratic B-spline with control
/// points (cos j pi / 4, sin j pi / 4). Pieces that meet do so in equal poles.
inline PlaneCurve circle_arcs(int first, int last) {
  using Point = std::array<double, 2>;
  const double c = std::sqrt(0.5);
  const std::array<Point, 8> directions = {Point{1, 0}, {c, c},   {0, 1},  {-c, c},
                                           {-1, 0},     {-c, -c}, {0, -1}, {c, -c}};
  const auto control = [&](int j) { return directions[j % 8]; };
  const auto joint = [&](int j) {
    const auto [p, q] = control(j);
    const auto [r, s] = control(j + 1);
    return Point{(p + r) / 2, (q + s) / 2};
  };
  PlaneCurve curve{4, {}, {}, {}, {}};
  // Products of two linear factors of a quartic coefficient: a and b stand for (p, q) each.
  struct Term {
    double factor;
    Point a;
    Point b;
  };
  const auto append = [&](const std::vector<Term>& coefficient) {
    double x = 0, y = 0, w = 0;
    for (const auto& [factor, a, b] : coefficient) {
      x += factor * (a[0] * b[0] - a[1] * b[1]);
      y += factor * (a[0] * b[1] + a[1] * b[0]);
      w += factor * (a[0] * b[0] + a[1] * b[1]);
    }
    curve.poles.push_back({x / w, y / w});
    curve.weights.push_back(w);
  };
  for (int arc = first; arc < last; ++arc) {
    const Point b0 = joint(arc), b1 = control(arc + 1), b2 = joint(arc + 1);
    if (arc == first) append({{1, b0, b0}});
    append({{1, b0, b1}});
    append({{1. / 3, b0, b2}, {2. / 3, b1, b1}});
    append({{1, b1, b2}});
    if (arc == last - 1) append({{1, b2, b2}});
  }
  for (int j = first; j <= last; ++j) {
    curve.knots.push_back(j);
    curve.multiplicities.push_back(j == first || j == last ? 5 : 3);
  }
  return curve;
}

inline PlaneCurve circle() { return circle_arcs(0, 4); }

/// `curve` scaled by `factor`, then moved by `shift` along x.
inline PlaneCurve scaled(PlaneCurve curve, double factor, double shift) {
  for (auto& [x, y] : curve.poles) {
    x = shift + factor * x;
    y = factor * y;
  }
  return curve;
}

/// The profile, its x the distance from the z-axis and its y the height, turned about the z-axis
/// along `circle`. A profile that rises outside gives normals S_u x S_v away from the axis.
inline BSplineSurface revolve(const PlaneCurve& profile, const PlaneCurve& circle) {
  BSplineSurface surface;
  surface.u_degree = profile.degree;
  surface.u_knots = profile.knots;
  surface.u_multiplicities = profile.multiplicities;
  surface.v_degree = circle.degree;
  surface.v_knots = circle.knots;
  surface.v_multiplicities = circle.multiplicities;
  for (std::size_t i = 0; i < profile.poles.size(); ++i) {
    const auto [radius, height] = profile.poles[i];
    for (std::size_t j = 0; j < circle.poles.size(); ++j) {
      const auto [x, y] = circle.poles[j];
      surface.poles.push_back({radius * x, -radius * y, height});
      surface.weights.push_back(profile.weights[i] * circle.weights[j]);
    }
  }
  return surface;
}

/// A tube about the z-axis: its radius is r0 at the height z0 and r1 at z1.
inline BSplineSurface tube(double r0, double z0, double r1, double z1) {
  return revolve(line({r0, z0}, {r1, z1}), circle());
}

inline BSplineSurface torus(double major_radius, double minor_radius) {
  return revolve(scaled(circle(), minor_radius, major_radius), circle());
}

/// The unit sphere, cut along two meridians.
inline std::vector<BSplineSurface> sphere_halves() {
  return {revolve(half_circle(), circle_arcs(0, 2)), revolve(half_circle(), circle_arcs(2, 4))};
}

/// Three tubes in a row: radius 2, then widening to 3, then narrowing to 1.
inline std::vector<BSplineSurface> three_tubes() {
  return {tube(2, 0, 2, 5), tube(2, 5, 3, 7), tube(3, 7, 1, 8)};
}

/// Volume inside the three tubes.
inline double three_tubes_volume() {
  const auto frustum = [](double r0, double r1, double height) {
    return kPi * height * (r0 * r0 + r0 * r1 + r1 * r1) / 3;
  };
  return frustum(2, 2, 5) + frustum(2, 3, 2) + frustum(3, 1, 1);
}

/// The same points with the second parameter, and so the normal, turned round.
inline BSplineSurface turned_round(const BSplineSurface& surface) {
  BSplineSurface result = surface;
  const std::size_t columns = surface.v_count();
  for (std::size_t k = 0; k < surface.poles.size(); ++k) {
    const std::size_t mirrored = k - k % columns + (columns - 1 - k % columns);
    result.poles[k] = surface.poles[mirrored];
    result.weights[k] = surface.weights[mirrored];
  }
  const double sum = surface.v_knots.front() + surface.v_knots.back();
  for (std::size_t k = 0; k < surface.v_knots.size(); ++k) {
    const std::size_t mirrored = surface.v_knots.size() - 1 - k;
    result.v_knots[k] = sum - surface.v_knots[mirrored];
    result.v_multiplicities[k] = surface.v_multiplicities[mirrored];
  }
  return result;
}

/// True when all numbers of two surfaces are equal.
inline bool same_surface(const BSplineSurface& a, const BSplineSurface& b) {
  return a.u_degree == b.u_degree && a.v_degree == b.v_degree && a.u_knots == b.u_knots &&
         a.v_knots == b.v_knots && a.u_multiplicities == b.u_multiplicities &&
         a.v_multiplicities == b.v_multiplicities && a.poles == b.poles && a.weights == b.weights;
}

}  // namespace pn::test
