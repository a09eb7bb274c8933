// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/bezier/conic_surface.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <optional>
#include <string>

#include "pn/algebra/bernstein.hpp"
#include "pn/algebra/precision.hpp"
#include "pn/bezier/line_factor.hpp"
#include "pn/bezier/section_net.hpp"
#include "pn/conics/interval_substitution.hpp"
#include "pn/geometry_error.hpp"
#include "pn/isotropic/envelope.hpp"

namespace pn {
namespace {

using Polynomial = RationalPolynomial;

/// Weights that vary by more on a patch are avoided where smaller patches help.
constexpr double kEvenWeights = 0.02;
constexpr int kMostArcs = 32, kMostSpans = 64;

/// Rows x, y, z, weight and columns u0^2, u0 u1, u1^2, of one degree in s.
template <class T>
using ConicPoints = std::array<Vector3<Form<T>>, 4>;

/// Where the patches end: equal spans of s, and u = p_0, p_1, ..., p_arcs = -p_0.
struct Division {
  int spans;
  std::vector<std::array<double, 2>> u;
  std::size_t arcs() const { return u.size() - 1; }
};

Vector3<int> column_degrees(const MovingConic& conic) {
  Vector3<int> degree{};
  for (std::size_t j = 0; j < 3; ++j) {
    for (const auto& row : conic.frame) degree[j] = std::max(degree[j], row[j].degree());
  }
  return degree;
}

/// w^T adj(C) w of the line at infinity.
Polynomial ellipticity(const MovingConic& conic) {
  const Matrix3<Polynomial> minors = adjugate(conic.conic);
  const Vector3<Polynomial>& w = conic.frame[3];
  Polynomial sum;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) sum += w[i] * minors[i][j] * w[j];
  }
  return sum;
}

void check_ellipses(const MovingConic& conic) {
  const Polynomial sign = ellipticity(conic);
  if (is_positive_on_unit_interval(sign)) return;
  const bool at_start = sign(Rational(0)).sign() <= 0;
  const double t = at_start ? 0 : roots_in_unit_interval(sign).front().value.midpoint();
  char text[32];
  std::snprintf(text, sizeof text, "%.6g", t);
  throw GeometryError(
      ErrorCode::kRegionUnbounded,
      std::string("The conic at t = ") + text +
          " is no ellipse: it has points at infinity. Only surfaces of ellipses are "
          "made.");
}

Form<RealBall> ball_form(const Polynomial& p, int degree, long precision) {
  std::vector<RealBall> balls;
  for (const Rational& c : coefficients(p, degree)) balls.emplace_back(c, precision);
  return Form<RealBall>(std::move(balls));
}

Form<double> midpoints(const Form<RealBall>& form) { return midpoint(form); }

ConicPoints<double> midpoints(const ConicPoints<RealBall>& x) {
  ConicPoints<double> result;
  for (std::size_t c = 0; c < 4; ++c) {
    for (std::size_t k = 0; k < 3; ++k) result[c][k] = midpoints(x[c][k]);
  }
  return result;
}

/// The polar form in u at two places.
template <class T>
Form<T> polar(const Vector3<Form<T>>& form, const std::array<double, 2>& p,
              const std::array<double, 2>& q) {
  const T p0(p[0]), p1(p[1]), q0(q[0]), q1(q[1]);
  Form<T> sum = form[0] * (p0 * q0);
  sum += form[1] * ((p0 * q1 + p1 * q0) * T(0.5));
  sum += form[2] * (p1 * q1);
  return sum;
}

/// The control column number k around: p_0 p_0, p_0 p_1, p_1 p_1, p_1 p_2, ...
template <class T>
Form<T> control_column(const Vector3<Form<T>>& form, const Division& division, std::size_t k) {
  return polar(form, division.u[k / 2], division.u[(k + 1) / 2]);
}

template <class T>
std::vector<T> bernstein_on_span(const Form<T>& form, int span, int spans) {
  const double length = 1.0 / spans;
  return to_bernstein(form.on_interval(T(span * length), T(length)).coefficients());
}

/// The least weight in parts of the largest; not positive if some weight is not.
double weight_ratio(const Vector3<Form<double>>& weight, const Division& division) {
  double least = HUGE_VAL, largest = 0;
  for (std::size_t k = 0; k <= 2 * division.arcs(); ++k) {
    const Form<double> column = control_column(weight, division, k);
    for (int span = 0; span < division.spans; ++span) {
      for (const double w : bernstein_on_span(column, span, division.spans)) {
        least = std::min(least, w);
        largest = std::max(largest, w);
      }
    }
  }
  return least / largest;
}

/// Places u that divide the ellipse evenly for its weight w0 u0^2 + w1 u0 u1 + w2 u1^2.
std::optional<std::vector<std::array<double, 2>>> even_places(double w0, double w1, double w2,
                                                              int arcs) {
  Eigen::Matrix2d weight;
  weight << w0, w1 / 2, w1 / 2, w2;
  const Eigen::LLT<Eigen::Matrix2d> cholesky(weight);
  if (cholesky.info() != Eigen::Success) return std::nullopt;
  std::vector<std::array<double, 2>> places;
  for (int k = 0; k < arcs; ++k) {
    const double angle = k * M_PI / arcs;
    const Eigen::Vector2d u =
        cholesky.matrixU().solve(Eigen::Vector2d(std::cos(angle), std::sin(angle)));
    places.push_back({lines::short_double(u[0]), lines::short_double(u[1])});
  }
  places.push_back({-places[0][0], -places[0][1]});
  return places;
}

/// The fewest patches with even weights, else with positive ones.
Division division_of(const Vector3<Form<double>>& weight) {
  const auto at_middle = [&](std::size_t k) { return weight[k](0.5); };
  std::optional<Division> positive;
  for (int patches = 4; patches <= kMostArcs * kMostSpans; patches *= 2) {
    for (int arcs = 4; arcs <= std::min(kMostArcs, patches); arcs *= 2) {
      if (patches / arcs > kMostSpans) continue;
      auto places = even_places(at_middle(0), at_middle(1), at_middle(2), arcs);
      if (!places) continue;
      Division division{patches / arcs, std::move(*places)};
      const double ratio = weight_ratio(weight, division);
      if (ratio > kEvenWeights) return division;
      if (ratio > 0 && !positive) positive = std::move(division);
    }
  }
  if (positive) return *positive;
  throw GeometryError(
      ErrorCode::kWeightsNotPositive,
      "No patches with positive weights were found: the ellipses become too thin or "
      "turn too far. Divide the interval.");
}

BSplineSurface frame_of(int degree, const Division& division) {
  BSplineSurface frame;
  frame.u_degree = degree;
  frame.v_degree = 2;
  for (int i = 0; i <= division.spans; ++i) {
    frame.u_knots.push_back(static_cast<double>(i) / division.spans);
    frame.u_multiplicities.push_back(i == 0 || i == division.spans ? degree + 1 : degree);
  }
  const auto arcs = static_cast<int>(division.arcs());
  for (int i = 0; i <= arcs; ++i) {
    frame.v_knots.push_back(static_cast<double>(i) / arcs);
    frame.v_multiplicities.push_back(i == 0 || i == arcs ? 3 : 2);
  }
  return frame;
}

FaceNet face_net(const ConicPoints<RealBall>& x, const Division& division) {
  const int degree = x[3][0].degree();
  const std::size_t columns = 2 * division.arcs() + 1;
  const std::size_t rows = static_cast<std::size_t>(degree * division.spans) + 1;
  FaceNet face;
  face.frame = frame_of(degree, division);
  face.stands_still = false;
  face.poles.resize(rows * columns);
  for (std::size_t k = 0; k < columns; ++k) {
    for (int span = 0; span < division.spans; ++span) {
      std::array<std::vector<RealBall>, 4> bernstein;
      for (std::size_t c = 0; c < 4; ++c) {
        bernstein[c] = bernstein_on_span(control_column(x[c], division, k), span, division.spans);
      }
      for (std::size_t i = 0; i < bernstein[3].size(); ++i) {
        NetPole& pole = face.poles[(static_cast<std::size_t>(span * degree) + i) * columns + k];
        pole.weight = bernstein[3][i];
        for (std::size_t c = 0; c < 3; ++c) pole.point[c] = bernstein[c][i] / pole.weight;
      }
    }
  }
  return face;
}

/// The weights of an ellipse have one sign.
ConicPoints<RealBall> with_positive_weight(ConicPoints<RealBall> x) {
  if (x[3][0](RealBall(0.5)).midpoint() > 0) return x;
  for (auto& row : x) {
    for (auto& form : row) form = form * RealBall(-1);
  }
  return x;
}

/// The points of a family over s on frames over s.
class PointsOfSurface {
 public:
  explicit PointsOfSurface(const MovingConic& conic) : PointsOfSurface(conic, family_of(conic)) {}

  int degree() const { return conics_.degree(); }

  ConicPoints<RealBall> operator()(long precision) const {
    const QuadraticPoints y = conics_.points(precision);
    ConicPoints<RealBall> x;
    for (std::size_t c = 0; c < 4; ++c) {
      for (std::size_t i = 0; i < 3; ++i) {
        const Form<RealBall> b = ball_form(frame_[c][i], degree_[i], precision);
        for (std::size_t k = 0; k < 3; ++k) x[c][k] += b * y.coordinate[i][k];
      }
    }
    return with_positive_weight(std::move(x));
  }

 private:
  static ConicFamily family_of(const MovingConic& conic) {
    return conic_family(conic.conic, column_degrees(conic));
  }
  PointsOfSurface(const MovingConic& conic, const ConicFamily& family)
      : PointsOfSurface(conic, family, interval_substitution(family, Rational(0), Rational(1))) {}
  PointsOfSurface(const MovingConic& conic, const ConicFamily& family,
                  const IntervalSubstitution& substitution)
      : conics_(substituted(family, substitution)) {
    for (std::size_t j = 0; j < 3; ++j) {
      degree_[j] = family.degree[j] * substitution.degree;
      for (std::size_t c = 0; c < 4; ++c) {
        frame_[c][j] = substitution(conic.frame[c][j], family.degree[j]);
      }
    }
  }

  RationalConicFamily conics_;
  Vector3<int> degree_{};
  std::array<Vector3<Polynomial>, 4> frame_;
};

}  // namespace

ConicSurface::ConicSurface(const MovingConic& conic) {
  const PointsOfSurface points(conic);
  check_ellipses(conic);
  degree_ = {points.degree(), 2};
  if (degree_[0] > kLargestDegree) {
    throw GeometryError(
        ErrorCode::kDegreeTooHigh,
        "The surface has degree " + std::to_string(degree_[0]) + " along t; 25 is the most.");
  }
  const auto division = at_sufficient_precision(
      [&](long precision) { return division_of(midpoints(points(precision))[3]); });
  RoundedFace rounded = at_sufficient_precision([&](long precision) {
    FaceNet face = face_net(points(precision), division);
    if (has_bad_weight(face)) {
      throw GeometryError(ErrorCode::kWeightsNotPositive,
                          "A weight of the surface is not positive.");
    }
    return SectionNet({std::move(face)}, precision).section(0).front();
  });
  face_ = std::move(rounded.surface);
  deviation_ = rounded.deviation;
}

}  // namespace pn
