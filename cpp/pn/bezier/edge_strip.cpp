// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/bezier/edge_strip.hpp"

#include <algorithm>
#include <cmath>
#include <memory>

#include "pn/algebra/precision.hpp"
#include "pn/bezier/line_factor.hpp"
#include "pn/bezier/ruling_band.hpp"
#include "pn/bezier/skin_patch.hpp"
#include "pn/geometry_error.hpp"
#include "pn/isotropic/contact_circles.hpp"
#include "pn/isotropic/seam.hpp"

namespace pn {
namespace {

using Eigen::Matrix2d;
using Eigen::Vector2d;
using Eigen::Vector3d;
using Eigen::Vector4d;
using Parameters = std::array<double, 2>;

/// Places along an edge at which the width of its strip is looked at.
constexpr int kSamples = 32;
/// The patch is wider than what was seen of the strip by this part.
constexpr double kMargin = 1.0 / 50;
/// Half the angle of spinors that one quadratic arc with positive weights may have: normals turn by
/// four times as much.
constexpr double kMostHalfAngle = 1.3;

/// The spheres along an edge.
SphereCurve edge_curve(const QuadraticFamily& family, std::size_t edge) {
  constexpr std::array<std::array<std::size_t, 3>, 3> kControl = {
      {{5, 3, 0}, {0, 1, 2}, {2, 4, 5}}};
  const auto component = [&](std::size_t c, long sign) {
    const auto& b = family.control();
    const auto [first, middle, last] = kControl[edge];
    const Rational two(2L), s(sign), &p = b[first][c], &q = b[middle][c], &r = b[last][c];
    return RationalPolynomial({s * p, s * two * (q - p), s * (p - two * q + r)});
  };
  return {{component(0, 1), component(1, 1), component(2, 1)},
          component(3, -1),
          RationalPolynomial(std::vector<Rational>{Rational(1L)})};
}

/// Derivatives of (m, -r) along an edge and from it into the triangle.
struct EdgeDerivatives {
  Vector4d along, inwards;

  EdgeDerivatives(const FamilyInDoubles& family, std::size_t edge, double at) {
    const Parameters uv = on_edge(edge, at), start = on_edge(edge, 0), end = on_edge(edge, 1),
                     opposite = on_edge((edge + 2) % 3, 0);
    const Vector4d by_u = family.by_u(uv[0], uv[1]), by_v = family.by_v(uv[0], uv[1]);
    along = (end[0] - start[0]) * by_u + (end[1] - start[1]) * by_v;
    inwards = (opposite[0] - uv[0]) * by_u + (opposite[1] - uv[1]) * by_v;
  }

  /// <w, f_inwards> <= 0 for w = (n, 1).
  bool is_outwards(const Vector3d& n) const { return n.dot(inwards.head<3>()) <= inwards(3); }
};

/// The patch's choice of lines: u = lines p(s), p with these poles.
struct StripLines {
  Matrix2d lines;
  std::array<Vector2d, 3> poles;
};

/// The circles of an edge by its own parameter, in doubles.
class EdgeCircles {
 public:
  explicit EdgeCircles(const SphereCurve& curve)
      : circles_(curve), spinor_(midpoint(circles_.spinor())) {}

  const Envelope& envelope() const { return circles_.envelope(); }
  double parameter(double at) const { return circles_.parameter(at); }
  /// A there.
  auto spinor(double at) const { return value_at(spinor_, parameter(at)); }

 private:
  ContactCircles circles_;
  SpinorMatrix<std::complex<double>> spinor_;
};

/// Places on the patch of a strip.
class StripPlaces {
 public:
  StripPlaces(EdgeCircles circles, StripLines choice)
      : circles_(std::move(circles)), choice_(std::move(choice)) {}

  /// Of a normal on the circle at a parameter of the edge.
  Parameters operator()(double at, const Vector3d& normal) const {
    const Vector2d u = choice_.lines.inverse() * parameter_of(circles_.spinor(at), normal);
    FormInU<double> parallel;
    for (const Vector2d& p : choice_.poles) {
      parallel.coefficient.push_back(Form<double>::constant(p(0) * u(1) - p(1) * u(0)));
    }
    return {circles_.parameter(at), band_parameter(parallel, 0)};
  }

 private:
  EdgeCircles circles_;
  StripLines choice_;
};

/// The normals of an edge from the inner to the outer skin around the outside, evenly.
NormalArc outer_arc(const FamilyInDoubles& family, std::size_t edge, double at) {
  const Parameters uv = on_edge(edge, at);
  const Vector3d inner = family.normal(Sheet::kInner, uv[0], uv[1]),
                 outer = family.normal(Sheet::kOuter, uv[0], uv[1]);
  const EdgeDerivatives f(family, edge, at);
  const Vector3d axis = f.along.head<3>().normalized();
  const auto turned = [=](double angle) {
    return Vector3d(Eigen::AngleAxisd(angle, axis) * inner);
  };
  const auto around = [&](const Vector3d& n) { return Vector3d(n - n.dot(axis) * axis); };
  double angle = angle_about(axis, around(inner), around(outer));
  if (!f.is_outwards(turned(angle / 2))) angle += angle > 0 ? -2 * M_PI : 2 * M_PI;
  return [=](double part) -> Vector3d {  // with the ends of the skins, bit for bit
    if (part == 0) return inner;
    if (part == 1) return outer;
    return turned(part * angle);
  };
}

StripLines chosen_lines(const FamilyInDoubles& family, std::size_t edge,
                        const EdgeCircles& circles) {
  const Vector3d middle = outer_arc(family, edge, 0.5)(0.5);
  const Matrix2d even = even_factor(circles.spinor(0.5), middle);
  // Angles of spinors from the middle line, of both seams.
  double low = 0, high = 0;
  int side = 0;
  for (int i = 0; i <= kSamples; ++i) {
    const double at = static_cast<double>(i) / kSamples;
    const Parameters uv = on_edge(edge, at);
    for (const Sheet sheet : {Sheet::kInner, Sheet::kOuter}) {
      const Vector2d u =
          even.inverse() * parameter_of(circles.spinor(at), family.normal(sheet, uv[0], uv[1]));
      const double angle = std::atan(u(1) / u(0));
      low = std::min(low, angle);
      high = std::max(high, angle);
      if (sheet == Sheet::kOuter) side += angle > 0 ? 1 : -1;
    }
  }
  const double half = (high - low) / 2 * (1 + 2 * kMargin), centre = (low + high) / 2;
  if (!(half < kMostHalfAngle)) {
    throw GeometryError(ErrorCode::kWeightsNotPositive,
                        "The strip along an edge turns too far for one patch; divide the six "
                        "spheres into smaller families.");
  }
  StripLines choice;
  choice.lines = even * Eigen::Rotation2Dd(centre).toRotationMatrix();
  if (side < 0) choice.lines.col(1) = -choice.lines.col(1);
  choice.lines = choice.lines.unaryExpr([](double x) { return lines::short_double(x); });
  const double c = lines::short_double(std::cos(half)), s = lines::short_double(std::sin(half));
  choice.poles = {Vector2d(c, -s), Vector2d(lines::short_double(1 / c), 0), Vector2d(c, s)};
  return choice;
}

/// u(s) = lines p(s), in the second parameter.
std::array<TensorPolynomial<RealBall>, 2> circle_lines(const StripLines& choice, long bits) {
  const auto ball = [bits](double x) { return RealBall(x).at_precision(bits); };
  std::array<TensorPolynomial<RealBall>, 2> u;
  for (int i = 0; i < 2; ++i) {
    std::array<RealBall, 3> pole;
    for (std::size_t k = 0; k < 3; ++k) {
      for (int j = 0; j < 2; ++j) {
        pole[k] += ball(choice.lines(i, j)) * ball(choice.poles[k](j));
      }
    }
    TensorPolynomial<RealBall> p(0, 2);
    p(0, 0) = pole[0];
    p(0, 1) = (pole[1] - pole[0]) * RealBall(2);
    p(0, 2) = pole[0] - pole[1] * RealBall(2) + pole[2];
    u[static_cast<std::size_t>(i)] = std::move(p);
  }
  return u;
}

/// A form in u along the lines u(s).
TensorPolynomial<RealBall> along_lines(const FormInU<RealBall>& form,
                                       const std::array<TensorPolynomial<RealBall>, 2>& u) {
  TensorPolynomial<RealBall> sum;
  const int n = form.degree();
  for (int q = 0; q <= n; ++q) {
    const Form<RealBall>& c = form.coefficient[static_cast<std::size_t>(q)];
    TensorPolynomial<RealBall> term(c.degree(), 0);
    for (int i = 0; i <= c.degree(); ++i) term(i, 0) = c[i] * RealBall(small_binomial(n, q));
    for (int k = 0; k < n; ++k) term = term * u[k < n - q ? 0 : 1];
    sum += term;
  }
  return sum;
}

SurfaceSections<RealBall> strip_sections(const Envelope& envelope, const StripLines& choice,
                                         long bits) {
  const IsotropicHypersurface<RealBall> gamma = envelope.enclosure(bits);
  const auto forms = sections(gamma.carrier, isotropic_vector<RealBall>(gamma.spinor));
  const auto u = circle_lines(choice, bits);
  SurfaceSections<RealBall> result;
  for (std::size_t c = 0; c < 3; ++c) {
    result.point[c] = along_lines(forms.point[c], u);
    result.direction[c] = along_lines(forms.direction[c], u);
  }
  result.weight = along_lines(forms.weight, u);
  return result;
}

void append_pieces(std::vector<ParameterPath>& boundary, const ParameterPath& path,
                   const std::vector<double>& ends) {
  double from = 0;
  for (const double to : ends) {
    boundary.push_back(part_of(path, from, to));
    from = to;
  }
  boundary.push_back(part_of(path, from, 1));
}

}  // namespace

NormalArc end_arc(const QuadraticFamily& family, std::size_t edge, int end) {
  return outer_arc(FamilyInDoubles(family), edge, end);
}

ExactPatch edge_strip(const QuadraticFamily& family, std::size_t edge,
                      const std::vector<double>& inner_ends,
                      const std::vector<double>& outer_ends) {
  const EdgeCircles circles(edge_curve(family, edge));
  const FamilyInDoubles doubles(family);
  const StripLines choice = chosen_lines(doubles, edge, circles);
  const auto place = std::make_shared<const StripPlaces>(circles, choice);
  const auto seam = [&](Sheet sheet, bool is_forward) -> ParameterPath {
    return [=](double along) {
      const double at = is_forward ? along : 1 - along;
      const Parameters uv = on_edge(edge, at);
      return (*place)(at, doubles.normal(sheet, uv[0], uv[1]));
    };
  };
  const auto end_circle = [&](int end) -> ParameterPath {
    return [place, end, arc = outer_arc(doubles, edge, end)](double at) {
      return (*place)(end, arc(end == 1 ? at : 1 - at));
    };
  };
  ExactPatch strip{{0, 0},
                   [envelope = circles.envelope(), choice](long bits) {
                     return strip_sections(envelope, choice, bits);
                   },
                   {}};
  const TensorPolynomial<RealBall> weight = strip.sections(kLeastPrecision).weight;
  strip.degree = {weight.degree(Variable::kU), weight.degree(Variable::kV)};
  if (!(least_ratio(weight) > 0)) {
    throw GeometryError(ErrorCode::kWeightsNotPositive,
                        "No patch with positive weights was found along an edge; divide the six "
                        "spheres into smaller families.");
  }
  std::vector<double> outer_back;
  for (auto end = outer_ends.rbegin(); end != outer_ends.rend(); ++end) {
    outer_back.push_back(1 - *end);
  }
  append_pieces(strip.boundary, seam(Sheet::kInner, true), inner_ends);
  strip.boundary.push_back(end_circle(1));
  append_pieces(strip.boundary, seam(Sheet::kOuter, false), outer_back);
  strip.boundary.push_back(end_circle(0));
  return strip;
}

}  // namespace pn
