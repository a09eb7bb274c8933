// SPDX-License-Identifier: LGPL-2.1-or-later
// Every skin of a random family of spheres is exact, and its faces are those of its triangle.
#include <catch2/catch.hpp>
#include <cmath>
#include <iostream>
#include <map>

#include "error_code.hpp"
#include "pn/bezier/evaluation.hpp"
#include "pn/bezier/skin.hpp"
#include "pn/bezier/trim_region.hpp"
#include "pn/shapes/sphere_family.hpp"
#include "random_sphere_families.hpp"
#include "surface_concept.hpp"

namespace pn::test {
namespace {

/// Edges may lie beside the true boundary by this part of the plate's size.
constexpr double kEdge = 1e-11;

using Balls = std::array<RealBall, 4>;

/// A family in balls.
struct FamilyInBalls {
  std::array<Balls, 6> control;

  FamilyInBalls(const QuadraticFamily& family, long bits) {
    for (std::size_t i = 0; i < 6; ++i) {
      for (std::size_t c = 0; c < 4; ++c) control[i][c] = RealBall(family.control()[i][c], bits);
    }
  }

  /// (m, -r) and its derivatives by de Casteljau's algorithm.
  std::array<Balls, 3> jet(const RealBall& u, const RealBall& v) const {
    const RealBall w = RealBall(1L) - u - v, two(2L);
    std::array<Balls, 3> result;
    for (std::size_t c = 0; c < 4; ++c) {
      const RealBall at_u = u * control[0][c] + v * control[1][c] + w * control[3][c],
                     at_v = u * control[1][c] + v * control[2][c] + w * control[4][c],
                     at_w = u * control[3][c] + v * control[4][c] + w * control[5][c];
      result[0][c] = u * at_u + v * at_v + w * at_w;
      result[1][c] = two * (at_u - at_w);
      result[2][c] = two * (at_v - at_w);
    }
    return result;
  }

  /// Where the sphere touches in direction n: <(n, 1), f_u> = <(n, 1), f_v> = 0, linear in (u, v).
  std::array<RealBall, 2> contact(const std::array<RealBall, 3>& n) const {
    const auto product = [&](const Balls& x) {
      return n[0] * x[0] + n[1] * x[1] + n[2] * x[2] - x[3];
    };
    const auto slopes = [&](double u, double v) {
      const auto at = jet(RealBall(u), RealBall(v));
      return std::array{product(at[1]), product(at[2])};
    };
    const auto origin = slopes(0, 0), along_u = slopes(1, 0), along_v = slopes(0, 1);
    const RealBall a = along_u[0] - origin[0], b = along_v[0] - origin[0],
                   c = along_u[1] - origin[1], d = along_v[1] - origin[1];
    const RealBall determinant = a * d - b * c;
    return {(b * origin[1] - d * origin[0]) / determinant,
            (c * origin[0] - a * origin[1]) / determinant};
  }
};

class SkinConcept {
 public:
  SkinConcept(const ControlSpheres& spheres, Sheet sheet, std::uint64_t seed)
      : family_(sphere_family(spheres).family),
        sheet_(sheet),
        skin_(std::make_shared<const Skin>(family_, sheet, std::vector<std::string>{})),
        surface_(skin_),
        random_(seed) {
    for (const auto& sphere : spheres) {
      for (const double x : sphere) size_ = std::max(size_, std::abs(x));
    }
  }

  void check() {
    const PNSurface section = surface_.offset(size_ * uniform(-0.01, 0.02));
    const auto faces = section.faces(Lines::kEven);
    const Certificate certificate = section.certificate(Lines::kEven);
    REQUIRE(faces.size() == skin_->patches().size());
    CHECK(certificate.trim_deviation <= kEdge * size_);
    double area = 0;
    for (std::size_t i = 0; i < faces.size(); ++i) {
      check_plain_data(faces[i]);
      REQUIRE(faces[i].trims.size() == 1);
      check_closed(faces[i].trims[0]);
      const auto x = skin_->patches()[i].sections(certificate.precision_bits);
      area += check_edges(faces[i], x, section, certificate);
      check_inside(faces[i], x, static_cast<double>(i), section, certificate);
    }
    // The images of the loops in the triangle of (u, v) cover it once.
    CHECK(std::abs(area - 0.5) < 1e-6);
  }

 private:
  double uniform(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random_);
  }

  struct Enclosed {
    std::array<RealBall, 3> point, normal;  ///< of the section, and n
    std::array<RealBall, 2> uv;
  };

  /// The patch's point, held against the definition of the envelope at the contact of its normal.
  Enclosed checked_point(const SurfaceSections<RealBall>& x, double p, double q, double distance,
                         long bits) {
    const auto ball = [&](double a) { return RealBall(a).at_precision(bits); };
    const auto value = [&](const TensorPolynomial<RealBall>& f) { return f.at(ball(p), ball(q)); };
    const RealBall weight = value(x.weight);
    REQUIRE(weight.is_positive());
    Enclosed result;
    RealBall length;
    for (std::size_t c = 0; c < 3; ++c) {
      result.normal[c] = value(x.direction[c]) / weight;
      result.point[c] = value(x.point[c]) / weight + ball(distance) * result.normal[c];
      length += result.normal[c] * result.normal[c];
    }
    CHECK(encloses_zero(length - RealBall(1), kNarrow));
    const FamilyInBalls family(family_, bits);
    result.uv = family.contact(result.normal);
    const auto [sphere, by_u, by_v] = family.jet(result.uv[0], result.uv[1]);
    const RealBall r = -sphere[3], rho = r + ball(distance);
    RealBall square, along_u = -(rho * by_u[3]), along_v = -(rho * by_v[3]);
    for (std::size_t c = 0; c < 3; ++c) {
      const RealBall from = result.point[c] - sphere[c];
      square += from * from;
      along_u += from * by_u[c];
      along_v += from * by_v[c];
    }
    const double scale = kNarrow * size_ * size_;
    CHECK(encloses_zero(square - rho * rho, scale));
    CHECK(encloses_zero(along_u, scale));
    CHECK(encloses_zero(along_v, scale));
    return result;
  }

  /// The edges run along those of the triangle or of its parts; the area inside in (u, v).
  double check_edges(const BSplineSurface& face, const SurfaceSections<RealBall>& x,
                     const PNSurface& section, const Certificate& certificate) {
    std::vector<std::array<double, 2>> polygon;
    const double first = face.u_knots.front();
    for (const ParameterCurve& curve : face.trims[0]) {
      const auto uv_at = [&](double at) {
        const auto [p, q] = evaluate(curve, at);
        CHECK((p > first && p < first + 1 && q > 0 && q < 1));
        const Enclosed e =
            checked_point(x, p - first, q, section.distance(), certificate.precision_bits);
        return std::array{e.uv[0].midpoint(), e.uv[1].midpoint()};
      };
      const auto start = uv_at(0), end = uv_at(1);
      polygon.push_back(start);
      for (const double at : {0.25, 0.6}) {
        // On the straight line between its ends.
        const auto uv = uv_at(at);
        const double du = end[0] - start[0], dv = end[1] - start[1];
        const double across = (uv[0] - start[0]) * dv - (uv[1] - start[1]) * du;
        CHECK(std::abs(across) < 1e-9 * std::hypot(du, dv));
      }
    }
    double area = 0;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const auto &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
      area += (a[0] * b[1] - a[1] * b[0]) / 2;
    }
    return sheet_ == Sheet::kOuter ? area : -area;
  }

  /// Points of the face: on the envelope, over the triangle, exported within the deviation.
  void check_inside(const BSplineSurface& face, const SurfaceSections<RealBall>& x, double first,
                    const PNSurface& section, const Certificate& certificate) {
    const TrimRegion region(face.trims);
    for (int found = 0, tries = 0; found < 2 && tries < 1000; ++tries) {
      const double p = uniform(0, 1), q = uniform(0, 1);
      if (!region.contains({first + p, q})) continue;
      ++found;
      const Enclosed truth =
          checked_point(x, (first + p) - first, q, section.distance(), certificate.precision_bits);
      const double u = truth.uv[0].midpoint(), v = truth.uv[1].midpoint();
      CHECK((u > -1e-9 && v > -1e-9 && u + v < 1 + 1e-9));
      check_exported_point(face, {first + p, q}, truth.point, certificate);
      CHECK(certificate.deviation < 1e-11 * (size_ + extent(face)));
      check_along(truth.normal, FamilyInDoubles(family_).normal(sheet_, u, v));
    }
  }

  QuadraticFamily family_;
  Sheet sheet_;
  std::shared_ptr<const Skin> skin_;
  PNSurface surface_;
  std::mt19937_64 random_;
  double size_ = 0;
};

TEST_CASE("Every skin is exact and covers its triangle", "[concept]") {
  const auto seed = static_cast<std::uint64_t>(number_from_environment("PN_TEST_SEED", 1));
  const auto count = static_cast<std::uint64_t>(200 * number_from_environment("PN_TEST_SCALE", 1));
  std::cout << "PN_TEST_SEED=" << seed << ", " << count << " random families of spheres\n";
  std::map<ErrorCode, std::uint64_t> refused;
  for (std::uint64_t i = 0; i < count; ++i) {
    const ControlSpheres spheres = RandomSphereFamily(seed + i).spheres();
    INFO("RandomSphereFamily(" << seed + i << "): " << text(spheres));
    for (const Sheet sheet : {Sheet::kOuter, Sheet::kInner}) {
      const auto code = code_of([&] { SkinConcept(spheres, sheet, seed + i).check(); });
      if (!code) continue;
      CAPTURE(to_string(*code));
      const bool is_unreal = unreal_place(family_of(spheres)).has_value();
      CHECK((*code == ErrorCode::kRadiusTooSteep) == is_unreal);
      ++refused[*code];
    }
  }
  for (const auto& [code, times] : refused) {
    std::cout << "  refused with " << to_string(code) << ": " << times << "\n";
  }
  CHECK(100 * refused[ErrorCode::kWeightsNotPositive] <= 2 * count);
}

}  // namespace
}  // namespace pn::test
