// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/bezier/stereographic.hpp"

#include <cmath>

namespace pn {
namespace {

using Complex = std::complex<double>;

/// The rotation may be this short: it only has to bring the normals near z = 0.
constexpr int kBits = 12;

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

}  // namespace pn
