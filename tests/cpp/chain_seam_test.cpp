// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/bezier/chain_seam.hpp"

#include <catch2/catch.hpp>
#include <vector>

#include "pn/isotropic/seam.hpp"
#include "pn/shapes/canal_surface.hpp"

namespace {

std::vector<pn::IsotropicHypersurface<double>> estimates(const pn::EnvelopeChain& chain) {
  std::vector<pn::IsotropicHypersurface<double>> links;
  for (const pn::ChainLink& link : chain.links) {
    links.push_back(pn::midpoint(link.envelope.enclosure(128)));
  }
  return links;
}

/// A closed cubic C2 spine that winds in space: the uniform periodic B-spline, span by span.
pn::EnvelopeChain closed_chain() {
  const std::vector<std::array<double, 3>> ring = {{10, 0, 0},  {6, 8, 4},   {-4, 9, -3},
                                                   {-10, 1, 2}, {-5, -9, 0}, {5, -8, -4}};
  std::vector<pn::Curve> spans;
  const std::size_t n = ring.size();
  for (std::size_t i = 0; i < n; ++i) {
    std::array<std::array<double, 3>, 4> bezier;
    for (std::size_t c = 0; c < 3; ++c) {
      const double a = ring[i][c], b = ring[(i + 1) % n][c], d = ring[(i + 2) % n][c],
                   e = ring[(i + 3) % n][c];
      // Scaled by 6, so that the mean values stay exact.
      bezier[0][c] = a + 4 * b + d;
      bezier[1][c] = 4 * b + 2 * d;
      bezier[2][c] = 2 * b + 4 * d;
      bezier[3][c] = b + 4 * d + e;
    }
    spans.push_back(pn::Curve::bezier({bezier.begin(), bezier.end()}));
  }
  return pn::canal_surface(pn::Curve::chain(spans), pn::Law::constant(2));
}

}  // namespace

TEST_CASE("The even factor gives constant weight and the circle's seam") {
  const pn::EnvelopeChain chain = pn::canal_surface(
      pn::Curve::bezier({{0, 0, 0}, {10, 0, 0}, {10, 10, 5}, {20, 10, 15}}), pn::Law::constant(1));
  const auto links = estimates(chain);
  const pn::ChainSeam seam(chain, links);
  for (const double t : {0.0, 0.3, 0.77, 1.0}) {
    const Eigen::Matrix2cd a = pn::value_at(links[0].spinor, t) * seam.at(0, t);
    CHECK(((a.adjoint() * a).real() - Eigen::Matrix2d::Identity()).norm() < 1e-12);
  }
}

TEST_CASE("The derivative is that of the factor") {
  const pn::EnvelopeChain chain = closed_chain();
  const pn::ChainSeam seam(chain, estimates(chain));
  constexpr double kStep = 1e-5;
  for (const double t : {0.2, 0.5, 0.8}) {
    const Eigen::Matrix2d slope = (seam.at(1, t + kStep) - seam.at(1, t - kStep)) / (2 * kStep);
    CHECK((seam.derivative(1, t) - slope).norm() < 1e-2 * (1 + slope.norm()));
  }
}

TEST_CASE("Around a closed chain the seam comes back") {
  const pn::EnvelopeChain chain = closed_chain();
  REQUIRE(chain.closed);
  const auto links = estimates(chain);
  const pn::ChainSeam seam(chain, links);
  const auto seam_normal = [&](std::size_t link, double t) {
    const Eigen::Vector2cd a = (pn::value_at(links[link].spinor, t) * seam.at(link, t)).col(0);
    const std::complex<double> planar = 2.0 * std::conj(a(0)) * a(1);
    return Eigen::Vector3d(planar.real(), planar.imag(), std::norm(a(0)) - std::norm(a(1)));
  };
  for (std::size_t i = 0; i < links.size(); ++i) {
    const std::size_t next = (i + 1) % links.size();
    CHECK((seam_normal(i, 1) - seam_normal(next, 0)).norm() < 1e-9);
  }
}
