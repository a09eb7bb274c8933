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
#include "pn/conics/rational_conic_family.hpp"
#include "pn/geometry_error.hpp"
#include "pn/isotropic/envelope.hpp"

namespace pn {
namespace {

using Polynomial = RationalPolynomial;

/// Weights that vary by more on a patch are avoided where smaller patches help.
constexpr double kEvenWeights = 0.02;
constexpr int kMostArcs = 16, kMostSpans = 16;
/// Faces are not halved below this part of the interval.
constexpr double kLeastLength = 1.0 / 128;

/// Rows x, y, z, weight and columns u0^2, u0 u1, u1^2, of one degree in s.
template <class T>
using ConicPoints = std::array<Vector3<Form<T>>, 4>;

/// Where the patches of a face end: equal spans of an interval of s, and u = p_0, p_1, ..., p_arcs
/// = -p_0.
struct Division {
  double begin, length;
  int spans;
  std::vector<std::array<double, 2>> u;
  std::size_t arcs() const { return u.size() - 1; }
};

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
  // Products of short doubles are exact at any precision, their sum is not.
  const T p0(p[0]), p1(p[1]), q0(q[0]), q1(q[1]), half(0.5);
  Form<T> sum = form[0] * (p0 * q0);
  sum += form[1] * (p0 * q1 * half);
  sum += form[1] * (p1 * q0 * half);
  sum += form[2] * (p1 * q1);
  return sum;
}

/// The control column number k around: p_0 p_0, p_0 p_1, p_1 p_1, p_1 p_2, ...
template <class T>
Form<T> control_column(const Vector3<Form<T>>& form, const Division& division, std::size_t k) {
  return polar(form, division.u[k / 2], division.u[(k + 1) / 2]);
}

template <class T>
std::vector<T> bernstein_on_span(const Form<T>& form, const Division& division, int span) {
  const double length = division.length / division.spans;
  const double begin = division.begin + span * length;
  return to_bernstein(form.on_interval(T(begin), T(length)).coefficients());
}

/// The least weight in parts of the largest; not positive if some weight is not.
double weight_ratio(const Vector3<Form<double>>& weight, const Division& division) {
  double least = HUGE_VAL, largest = 0;
  for (std::size_t k = 0; k <= 2 * division.arcs(); ++k) {
    const Form<double> column = control_column(weight, division, k);
    for (int span = 0; span < division.spans; ++span) {
      for (const double w : bernstein_on_span(column, division, span)) {
        least = std::min(least, w);
        largest = std::max(largest, w);
      }
    }
  }
  return least / largest;
}

/// The weight w0 u0^2 + w1 u0 u1 + w2 u1^2 of determinant 1 along an interval, on the average.
Eigen::Matrix2d mean_weight(const Vector3<Form<double>>& weight, double begin, double length) {
  constexpr int kSamples = 16;
  Eigen::Matrix2d sum = Eigen::Matrix2d::Zero();
  for (int i = 0; i <= kSamples; ++i) {
    const double s = begin + length * i / kSamples;
    const double half = weight[1](s) / 2;
    Eigen::Matrix2d here;
    here << weight[0](s), half, half, weight[2](s);
    const double det = here.determinant();
    if (det > 0) sum += here / std::sqrt(det);
  }
  return sum;
}

/// Places u that divide the ellipse of this weight evenly.
std::optional<std::vector<std::array<double, 2>>> even_places(const Eigen::Matrix2d& weight,
                                                              int arcs) {
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

/// The fewest patches with even weights, if there are any.
std::optional<Division> even_division(const Vector3<Form<double>>& weight, double begin,
                                      double length) {
  const Eigen::Matrix2d mean = mean_weight(weight, begin, length);
  for (int patches = 4; patches <= kMostArcs * kMostSpans; patches *= 2) {
    for (int arcs = 4; arcs <= std::min(kMostArcs, patches); arcs *= 2) {
      if (patches / arcs > kMostSpans) continue;
      auto places = even_places(mean, arcs);
      if (!places) return std::nullopt;
      Division division{begin, length, patches / arcs, std::move(*places)};
      if (weight_ratio(weight, division) > kEvenWeights) return division;
    }
  }
  return std::nullopt;
}

/// Appends the faces of an interval, which is halved where no even lines fit all of it.
void append_divisions(std::vector<Division>& divisions, const Vector3<Form<double>>& weight,
                      double begin, double length) {
  if (std::optional<Division> division = even_division(weight, begin, length)) {
    divisions.push_back(std::move(*division));
    return;
  }
  if (length < kLeastLength) {
    throw GeometryError(
        ErrorCode::kWeightsNotPositive,
        "No patches with positive weights were found: an ellipse becomes too thin.");
  }
  const double half = length / 2;
  append_divisions(divisions, weight, begin, half);
  append_divisions(divisions, weight, begin + half, half);
}

BSplineSurface frame_of(int degree, const Division& division) {
  BSplineSurface frame;
  frame.u_degree = degree;
  frame.v_degree = 2;
  for (int i = 0; i <= division.spans; ++i) {
    frame.u_knots.push_back(division.begin + division.length * i / division.spans);
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
        bernstein[c] = bernstein_on_span(control_column(x[c], division, k), division, span);
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
  std::vector<Division> divisions;
  append_divisions(divisions, midpoints(at_sufficient_precision(points))[3], 0, 1);
  const std::vector<RoundedFace> rounded = at_sufficient_precision([&](long precision) {
    const ConicPoints<RealBall> x = points(precision);
    std::vector<FaceNet> faces;
    for (const Division& division : divisions) {
      faces.push_back(face_net(x, division));
      if (has_bad_weight(faces.back())) throw Undecided("the sign of a weight");
    }
    return SectionNet(std::move(faces), precision).section(0);
  });
  for (const RoundedFace& face : rounded) {
    faces_.push_back(face.surface);
    deviation_ = std::max(deviation_, face.deviation);
  }
}

}  // namespace pn
