// SPDX-License-Identifier: LGPL-2.1-or-later
// Stereographic projection of normals, turned by a spinor of short numbers.
//
// The spinors a = x + z y with x = (a0, a1), y = (-conj a1, conj a0) give all unit vectors but one:
// those of the sphere turned so that z = 0 is the normal of x, projected from its antipode. The
// normal of a spinor is (2 Re(conj(a0) a1), 2 Im(conj(a0) a1), |a0|^2 - |a1|^2) / |a|^2. With x of
// a few bits the rotation is exact up to a factor, and polynomials in z stay small.
#pragma once

#include <Eigen/Dense>
#include <array>
#include <complex>
#include <optional>
#include <vector>

#include "pn/isotropic/along_surface.hpp"

namespace pn {

struct Spinor {
  std::complex<double> a0, a1;
};

/// A spinor of this unit normal.
Spinor spinor_of(const Eigen::Vector3d& n);

class Stereographic {
 public:
  /// With this unit normal near z = 0.
  explicit Stereographic(const Eigen::Vector3d& n);

  /// The spinors of z = 0 and z = infinity.
  Spinor north() const { return north_; }
  Spinor south() const { return {-std::conj(north_.a1), std::conj(north_.a0)}; }

  std::complex<double> projected(const Eigen::Vector3d& n) const;

 private:
  Spinor north_;
};

/// A parallelogram in the plane of z: z = origin + p across[0] + q across[1], p and q in [0, 1].
struct PlaneFrame {
  std::complex<double> origin;
  std::array<std::complex<double>, 2> across;

  /// (p, q) of z.
  std::array<double, 2> parameters(const std::complex<double>& z) const;
};

/// The parallelogram around some points and a margin, with the directions of another, of short
/// numbers; nothing when they lie on a line.
std::optional<PlaneFrame> frame_around(const std::vector<std::complex<double>>& points,
                                       const PlaneFrame& directions);

/// The isotropic vectors of the normals in a parallelogram, times a number that makes their
/// coefficients integers.
IsotropicPolynomials<Rational> isotropic_polynomials(const Stereographic& chart,
                                                     const PlaneFrame& frame);

/// The multiple of a power of two that has about so many bits, as many as a number of this size.
double shortened(double x, double size, int bits);
std::complex<double> shortened(const std::complex<double>& z, double size, int bits);

}  // namespace pn
