// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/bezier/polar_chart.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <memory>
#include <optional>

#include "pn/algebra/precision.hpp"
#include "pn/bezier/contact_solver.hpp"
#include "pn/bezier/stereographic.hpp"
#include "pn/isotropic/base_points.hpp"

namespace pn {
namespace {

using Complex = std::complex<double>;
using Eigen::Vector2d;
using Eigen::Vector3d;
using Eigen::Vector4d;
using Parameters = std::array<double, 2>;

constexpr int kFrameBits = 24;
/// So near to the base point, in parts of the image, tau is no quotient of z any more.
constexpr double kNear = 1.0 / 64;
/// There it is read off the images of two points so far to the sides of the line, in (u, v).
constexpr double kAside = 1.0 / 256;

/// The free choices of a chart: z = p0 + sigma (1 + i tau) direction, sigma and tau on intervals.
struct Frame {
  Stereographic rotation;
  std::size_t base_point;  ///< which of the family
  Complex direction;
  std::array<double, 2> origin = {0, 0},
                        length = {1, 1};  ///< (sigma, tau) = origin + length (p, q)
};

/// w and the contact of a family in a chart.
struct ChartPolynomials {
  IsotropicPolynomials<RealBall> w;
  Contact<RealBall> contact;
};

PowerForm<RealBall> in_balls(const PowerForm<Rational>& f, long bits) {
  PowerForm<RealBall> result;
  for (std::size_t i = 0; i < f.size(); ++i) {
    for (std::size_t c = 0; c < 4; ++c) result[i][c] = RealBall(f[i][c], bits);
  }
  return result;
}

ComplexBall ball(const Complex& z, long bits) {
  return {RealBall(z.real()).at_precision(bits), RealBall(z.imag()).at_precision(bits)};
}

/// The coordinate z of an isotropic vector, enclosed.
ComplexBall projected(const Stereographic& rotation, const MinkowskiVector<RealBall>& w,
                      long bits) {
  const bool is_northern = w[2].midpoint() >= 0;
  const ComplexBall x0 = is_northern ? ComplexBall(w[3] + w[2]) : ComplexBall(w[0], -w[1]);
  const ComplexBall x1 = is_northern ? ComplexBall(w[0], w[1]) : ComplexBall(w[3] - w[2]);
  const auto product = [&](const Spinor& s) {
    return ball(std::conj(s.a0), bits) * x0 + ball(std::conj(s.a1), bits) * x1;
  };
  return product(rotation.south()) / product(rotation.north());
}

/// north + (p0 + sigma (1 + i tau) direction) south in (sigma, tau).
IsotropicPolynomials<RealBall> isotropic_polynomials(const Frame& frame, const ComplexBall& p0,
                                                     long bits) {
  const Spinor north = frame.rotation.north(), south = frame.rotation.south();
  SpinorPolynomials<RealBall> spinor;
  const auto set = [&](std::size_t i, const Complex& n, const Complex& s) {
    const ComplexBall at_base = ball(n, bits) + p0 * ball(s, bits),
                      along = ball(frame.direction, bits) * ball(s, bits),
                      across = ball(Complex(0, 1), bits) * along;
    spinor.re[i] = spinor.im[i] = TensorPolynomial<RealBall>(1, 1);
    const auto put = [&](int j, int k, const ComplexBall& c) {
      spinor.re[i](j, k) = c.real();
      spinor.im[i](j, k) = c.imag();
    };
    put(0, 0, at_base);
    put(1, 0, along);
    put(1, 1, across);
  };
  set(0, north.a0, south.a0);
  set(1, north.a1, south.a1);
  return pn::isotropic_polynomials(spinor);
}

/// The polynomials in (p, q).
ChartPolynomials chart_polynomials(const QuadraticFamily& family, const Frame& frame, long bits) {
  const auto point = base_points(family, bits)[frame.base_point];
  ChartPolynomials chart;
  chart.w = isotropic_polynomials(frame, projected(frame.rotation, point, bits), bits);
  const Contact<RealBall> all = contact_of(in_balls(family.power(), bits), chart.w);
  chart.contact = {all.a.divided_by_u(), all.b.divided_by_u(), all.e.divided_by_u()};
  const auto substitute = [&](TensorPolynomial<RealBall>& p) {
    const auto number = [bits](double x) { return RealBall(x).at_precision(bits); };
    p = p.substituted(Variable::kU, number(frame.origin[0]), number(frame.length[0]))
            .substituted(Variable::kV, number(frame.origin[1]), number(frame.length[1]));
  };
  for (auto& p : chart.w) substitute(p);
  for (auto* p : {&chart.contact.a, &chart.contact.b, &chart.contact.e}) substitute(*p);
  return chart;
}

/// The line of (u, v) that has the normal of a base point: normal.(u, v) + level = 0.
struct ParabolicLine {
  Vector2d normal;
  double level;

  ParabolicLine(const QuadraticFamily& family, const Vector4d& w) {
    const auto a = family.power();
    const auto q = [&](std::size_t i) {
      const auto x = [&](std::size_t c) { return a[i][c].to_double(); };
      return w(0) * x(0) + w(1) * x(1) + w(2) * x(2) - w(3) * x(3);
    };
    const Vector2d first(q(0), q(1)), second(q(1), q(2));
    const bool is_first = first.norm() > second.norm();
    const double length = std::max(first.norm(), second.norm());
    normal = (is_first ? first : second) / length;
    level = (is_first ? q(3) : q(4)) / length;
  }

  Vector2d foot(const Vector2d& uv) const { return uv - (normal.dot(uv) + level) * normal; }
};

/// Finds the parameters (p, q) of points of the triangle.
class PolarLocator {
 public:
  PolarLocator(const QuadraticFamily& family, Sheet sheet, const Frame& frame,
               const ParabolicLine& line, const Complex& p0)
      : doubles_(family),
        sheet_(sheet),
        frame_(frame),
        line_(line),
        p0_(p0),
        solver_(chart_polynomials(family, frame, kLeastPrecision).contact) {}

  Parameters operator()(const Parameters& uv) const {
    const Parameters at = start(uv);
    return solver_.solution(uv, {(at[0] - frame_.origin[0]) / frame_.length[0],
                                 (at[1] - frame_.origin[1]) / frame_.length[1]});
  }

 private:
  /// (z - p0) / direction
  Complex image(const Vector2d& uv) const {
    return (frame_.rotation.projected(doubles_.normal(sheet_, uv(0), uv(1))) - p0_) /
           frame_.direction;
  }

  /// (sigma, tau), nearly.
  Parameters start(const Parameters& uv) const {
    const Vector2d at(uv[0], uv[1]);
    const Complex here = image(at);
    if (std::abs(here.real()) > kNear) return {here.real(), here.imag() / here.real()};
    const Vector2d aside = kAside * line_.normal;
    const Complex across = image(at + aside) - image(at - aside);
    return {here.real(), across.imag() / across.real()};
  }

  FamilyInDoubles doubles_;
  Sheet sheet_;
  Frame frame_;
  ParabolicLine line_;
  Complex p0_;
  ContactSolver solver_;
};

/// The longest direction of points around 0, as long as they are far.
Complex principal_direction(const std::vector<Complex>& points) {
  Complex squares = 0;  // the angle of this sum is twice that of the axis
  double farthest = 0;
  for (const Complex& z : points) {
    squares += z * z;
    farthest = std::max(farthest, std::abs(z));
  }
  return std::polar(farthest, std::arg(squares) / 2);
}

double signed_area(const std::vector<Parameters>& polygon) {
  double area = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const auto &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    area += (a[0] * b[1] - a[1] * b[0]) / 2;
  }
  return area;
}

/// The intervals around the image of the triangle in the (sigma, tau)-plane, oriented so that S_p x
/// S_q points along the normal, which is against m_u x m_v on the inner sheet; nothing where it
/// could not be followed.
std::optional<Frame> around(Frame frame, const PolarLocator& locate, Sheet sheet) {
  std::vector<Parameters> images;
  for (const Parameters& uv : edge_points()) {
    images.push_back(locate(uv));
    if (!std::isfinite(images.back()[0]) || !std::isfinite(images.back()[1])) return std::nullopt;
  }
  const ImageBox box = box_around(images);
  for (std::size_t c = 0; c < 2; ++c) {
    const double length = box.high[c] - box.low[c];
    if (!(length > 0)) return std::nullopt;
    frame.origin[c] = shortened(box.low[c], length, kFrameBits);
    frame.length[c] = shortened(length, length, kFrameBits);
  }
  const bool is_upright = signed_area(images) > 0;
  if (is_upright != (sheet == Sheet::kOuter)) {
    frame.origin[1] += frame.length[1];
    frame.length[1] = -frame.length[1];
  }
  return frame;
}

Vector4d midpoint(const MinkowskiVector<RealBall>& w) {
  return {w[0].midpoint(), w[1].midpoint(), w[2].midpoint(), w[3].midpoint()};
}

std::optional<SkinPatch> polar_patch(const QuadraticFamily& family, Sheet sheet,
                                     std::size_t base_point, const Vector4d& w) {
  const FamilyInDoubles doubles(family);
  const Vector3d n = w.head<3>() / w(3);
  const ParabolicLine line(family, w);
  const Vector2d middle(1.0 / 3, 1.0 / 3), foot = line.foot(middle);
  const Vector3d across =
      doubles.by_u(foot(0), foot(1)).head<3>().cross(doubles.by_v(foot(0), foot(1)).head<3>());
  if ((n.dot(across) > 0) != (sheet == Sheet::kOuter)) return std::nullopt;
  Frame frame{Stereographic(doubles.normal(sheet, middle(0), middle(1))), base_point, {}};
  const Complex p0 = frame.rotation.projected(n);
  std::vector<Complex> images;
  for (const Parameters& uv : edge_points()) {
    images.push_back(frame.rotation.projected(doubles.normal(sheet, uv[0], uv[1])) - p0);
  }
  const Complex direction = principal_direction(images);
  frame.direction = shortened(direction, std::abs(direction), kFrameBits);
  const std::optional<Frame> found =
      around(frame, PolarLocator(family, sheet, frame, line, p0), sheet);
  if (!found) return std::nullopt;
  const auto sections_at = [family, chosen = *found](long bits) {
    const ChartPolynomials chart = chart_polynomials(family, chosen, bits);
    return sections(in_balls(family.power(), bits), chart.w, chart.contact);
  };
  const auto place_of = [locate =
                             std::make_shared<const PolarLocator>(family, sheet, *found, line, p0)](
                            const Parameters& uv) { return (*locate)(uv); };
  const TensorPolynomial<RealBall> weight = sections_at(kLeastPrecision).weight;
  return SkinPatch{{weight.degree(Variable::kU), weight.degree(Variable::kV)},
                   sections_at,
                   place_of,
                   sheet,
                   least_ratio(weight)};
}

}  // namespace

std::vector<SkinPatch> polar_patches(const QuadraticFamily& family, Sheet sheet) {
  const auto points = at_sufficient_precision([&](long bits) { return base_points(family, bits); });
  std::vector<SkinPatch> patches;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (auto patch = polar_patch(family, sheet, i, midpoint(points[i]))) {
      patches.push_back(std::move(*patch));
    }
  }
  return patches;
}

}  // namespace pn
