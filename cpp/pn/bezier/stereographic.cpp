// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/bezier/stereographic.hpp"

#include <algorithm>
#include <cmath>

#include "pn/bezier/skin_patch.hpp"

namespace pn {
namespace {

using Complex = std::complex<double>;

/// The rotation may be this short: it only has to bring the normals near z = 0.
constexpr int kBits = 12;
/// Bits of a frame: enough for one as flat as the normals of a sheet may be.
constexpr int kFrameBits = 24;

}  // namespace

Spinor spinor_of(const Eigen::Vector3d& n) {
  if (n.z() >= 0) return {1 + n.z(), {n.x(), n.y()}};
  return {{n.x(), -n.y()}, 1 - n.z()};
}

Stereographic::Stereographic(const Eigen::Vector3d& n) {
  const Spinor spinor = spinor_of(n);
  north_ = {shortened(spinor.a0, 2, kBits), shortened(spinor.a1, 2, kBits)};
}

Complex Stereographic::projected(const Eigen::Vector3d& n) const {
  const Spinor x = spinor_of(n), s = south();
  return (std::conj(s.a0) * x.a0 + std::conj(s.a1) * x.a1) /
         (std::conj(north_.a0) * x.a0 + std::conj(north_.a1) * x.a1);
}

double shortened(double x, double size, int bits) {
  int exponent = 0;
  std::frexp(size, &exponent);
  return std::ldexp(std::round(std::ldexp(x, bits - exponent)), exponent - bits);
}

Complex shortened(const Complex& z, double size, int bits) {
  return {shortened(z.real(), size, bits), shortened(z.imag(), size, bits)};
}

std::array<double, 2> PlaneFrame::parameters(const Complex& z) const {
  const Complex from = z - origin;
  const auto cross = [](const Complex& x, const Complex& y) { return (std::conj(x) * y).imag(); };
  const double area = cross(across[0], across[1]);
  return {cross(from, across[1]) / area, cross(across[0], from) / area};
}

std::optional<PlaneFrame> frame_around(const std::vector<Complex>& points,
                                       const PlaneFrame& directions) {
  std::vector<std::array<double, 2>> images;
  for (const Complex& z : points) images.push_back(directions.parameters(z));
  const ImageBox box = box_around(images);
  PlaneFrame frame{directions.origin, {}};
  double shortest = INFINITY;
  for (std::size_t c = 0; c < 2; ++c) {
    const Complex side = directions.across[c] * (box.high[c] - box.low[c]);
    if (!(std::abs(side) > 0) || !std::isfinite(std::abs(side))) return std::nullopt;
    frame.across[c] = shortened(side, std::abs(side), kFrameBits);
    frame.origin += directions.across[c] * box.low[c];
    shortest = std::min(shortest, std::abs(side));
  }
  frame.origin = shortened(frame.origin, shortest, kFrameBits);
  return frame;
}

IsotropicPolynomials<Rational> isotropic_polynomials(const Stereographic& chart,
                                                     const PlaneFrame& frame) {
  const Spinor north = chart.north(), south = chart.south();
  const auto component = [&](const Complex& n, const Complex& s) {
    const auto part = [&](auto&& real_or_imaginary) {
      // Products of short doubles are exact in Q, not always in doubles.
      const auto product = [&](const Complex& z) {
        const auto number = [](double x) { return Rational::exactly(x); };
        return real_or_imaginary(
            number(s.real()) * number(z.real()) - number(s.imag()) * number(z.imag()),
            number(s.real()) * number(z.imag()) + number(s.imag()) * number(z.real()));
      };
      const Rational constant =
          real_or_imaginary(Rational::exactly(n.real()), Rational::exactly(n.imag()));
      return TensorPolynomial<Rational>::linear(constant + product(frame.origin),
                                                product(frame.across[0]), product(frame.across[1]));
    };
    return std::array{part([](const Rational& re, const Rational&) { return re; }),
                      part([](const Rational&, const Rational& im) { return im; })};
  };
  const auto a0 = component(north.a0, south.a0), a1 = component(north.a1, south.a1);
  const auto [re0, im0, re1, im1] = with_integers(std::array{a0[0], a0[1], a1[0], a1[1]});
  return pn::isotropic_polynomials(SpinorPolynomials<Rational>{{re0, re1}, {im0, im1}});
}

}  // namespace pn
