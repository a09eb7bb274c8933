// SPDX-License-Identifier: LGPL-2.1-or-later
// Every skin of a random translational family is exact, and its faces cover its rectangle.
#include <catch2/catch.hpp>
#include <cmath>
#include <iostream>
#include <map>

#include "error_code.hpp"
#include "pn/bezier/translational_skin.hpp"
#include "pn/bezier/trim_region.hpp"
#include "pn/isotropic/separated_sheets.hpp"
#include "random_translational_families.hpp"
#include "surface_concept.hpp"

namespace pn::test {
namespace {

/// Edges may lie beside the true boundary by this part of the plate's size.
constexpr double kEdge = 1e-11;
/// Parameters (u, v) of a point are known to within this.
constexpr double kParameters = 1e-8;

using Balls = std::array<RealBall, 4>;

RealBall product(const Balls& x, const Balls& y) {
  return x[0] * y[0] + x[1] * y[1] + x[2] * y[2] - x[3] * y[3];
}

/// A span in balls, by its definition.
struct SpanInBalls {
  Balls second, first, start;

  SpanInBalls(const SphereParabola& c, long bits) {
    for (std::size_t i = 0; i < 4; ++i) {
      second[i] = RealBall(c.second[i], bits);
      first[i] = RealBall(c.first[i], bits);
      start[i] = RealBall(c.start[i], bits);
    }
  }

  Balls at(const RealBall& t) const {
    Balls result;
    for (std::size_t i = 0; i < 4; ++i) {
      result[i] = (second[i] * t / RealBall(2L) + first[i]) * t + start[i];
    }
    return result;
  }
  Balls slope(const RealBall& t) const {
    Balls result;
    for (std::size_t i = 0; i < 4; ++i) result[i] = second[i] * t + first[i];
    return result;
  }
  bool is_line() const {
    return std::all_of(second.begin(), second.end(), [](const RealBall& x) { return x.is_zero(); });
  }
  /// <w, slope> = 0, linear in t; of a parabola.
  RealBall contact(const Balls& w) const { return -product(w, first) / product(w, second); }
  /// t of a point x + mu w, where w is orthogonal to the line.
  RealBall along_line(const Balls& x) const {
    Balls from;
    for (std::size_t i = 0; i < 4; ++i) from[i] = x[i] - start[i];
    return product(first, from) / product(first, first);
  }
};

class TranslationConcept {
 public:
  TranslationConcept(const RandomTranslation& translation, Sheet sheet, std::uint64_t seed)
      : spline_(translation.spheres().spline),
        sheet_(sheet),
        skin_(
            std::make_shared<const TranslationalSkin>(spline_, sheet, std::vector<std::string>{})),
        surface_(skin_),
        random_(seed),
        size_(3 * translation.side()) {}

  std::size_t check() {
    const PNSurface section = surface_.offset(size_ * uniform(-0.01, 0.02));
    const auto faces = section.faces(Lines::kEven);
    const Certificate certificate = section.certificate(Lines::kEven);
    REQUIRE(faces.size() == skin_->patches().size());
    CHECK(certificate.trim_deviation <= kEdge * size_);
    CHECK(certificate.bidegree[0] <= 10);
    CHECK(certificate.bidegree[1] <= 10);
    double area = 0;
    for (std::size_t i = 0; i < faces.size(); ++i) {
      check_plain_data(faces[i]);
      REQUIRE(faces[i].trims.size() == 1);
      REQUIRE(faces[i].trims[0].size() == 4);
      check_closed(faces[i].trims[0]);
      const auto x = skin_->patches()[i].sections(certificate.precision_bits);
      find_pair(faces[i], x, static_cast<double>(i), section, certificate);
      area += check_edges(faces[i], x, section, certificate);
      check_inside(faces[i], x, static_cast<double>(i), section, certificate);
    }
    // The faces cover each pair of spans once.
    const auto pairs = static_cast<double>(spline_.c.spans.size() * spline_.d.spans.size());
    CHECK(std::abs(area - pairs) < 1e-6 * pairs);
    return faces.size();
  }

 private:
  double uniform(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random_);
  }

  struct Enclosed {
    std::array<RealBall, 3> point, normal;  ///< of the section, and n
  };

  static Enclosed enclosed(const SurfaceSections<RealBall>& x, double p, double q, double distance,
                           long bits) {
    const auto ball = [&](double a) { return RealBall(a).at_precision(bits); };
    const auto value = [&](const TensorPolynomial<RealBall>& f) { return f.at(ball(p), ball(q)); };
    const RealBall weight = value(x.weight);
    Enclosed result;
    for (std::size_t c = 0; c < 3; ++c) {
      result.normal[c] = value(x.direction[c]) / weight;
      result.point[c] = value(x.point[c]) / weight + ball(distance) * result.normal[c];
    }
    return result;
  }

  /// (u, v) of a point on the pair of spans: from its normal, along lines from where it is.
  std::array<RealBall, 2> contact(const TranslationalFamily& family, const Enclosed& e,
                                  double distance, long bits) const {
    const SpanInBalls c(family.c, bits), d(family.d, bits);
    const Balls w = {e.normal[0], e.normal[1], e.normal[2], RealBall(1)};
    Balls f = {e.point[0], e.point[1], e.point[2], RealBall(distance).at_precision(bits)};
    const auto without = [](Balls x, const Balls& y) {
      for (std::size_t i = 0; i < 4; ++i) x[i] -= y[i];
      return x;
    };
    if (c.is_line()) {
      const RealBall v = d.contact(w);
      return {c.along_line(without(f, d.at(v))), v};
    }
    const RealBall u = c.contact(w);
    return {u, d.is_line() ? d.along_line(without(f, c.at(u))) : d.contact(w)};
  }

  /// The pair of spans to which a face belongs: by a point inside.
  void find_pair(const BSplineSurface& face, const SurfaceSections<RealBall>& x, double first,
                 const PNSurface& section, const Certificate& certificate) {
    const auto [p, q] = point_inside(face, first);
    const Enclosed e = enclosed(x, p - first, q, section.distance(), certificate.precision_bits);
    for (const SphereParabola& c : spline_.c.spans) {
      for (const SphereParabola& d : spline_.d.spans) {
        const auto [u, v] = contact({c, d}, e, section.distance(), certificate.precision_bits);
        const Eigen::Vector4d f =
            FamilyInDoubles(quadratic_family({c, d})).at(u.midpoint(), v.midpoint());
        const Eigen::Vector3d from(e.point[0].midpoint() - f(0), e.point[1].midpoint() - f(1),
                                   e.point[2].midpoint() - f(2));
        const bool is_on_sphere =
            std::abs(from.norm() - std::abs(section.distance() - f(3))) < 1e-9 * size_;
        if (!is_on_sphere || !is_inside(u.midpoint()) || !is_inside(v.midpoint())) continue;
        pair_ = {c, d};
        return;
      }
    }
    FAIL("a face over no pair of spans");
  }

  static bool is_inside(double t) { return -kParameters < t && t < 1 + kParameters; }

  std::array<double, 2> point_inside(const BSplineSurface& face, double first) {
    const TrimRegion region(face.trims);
    for (int tries = 0; tries < 10000; ++tries) {
      const double p = first + uniform(0, 1), q = uniform(0, 1);
      if (region.contains({p, q})) return {p, q};
    }
    FAIL("a face without an inside");
    return {};
  }

  /// The patch's point, held against the definition of the envelope.
  std::array<double, 2> checked_place(const Enclosed& e, double distance, long bits) {
    RealBall length;
    for (const RealBall& n : e.normal) length += n * n;
    CHECK(encloses_zero(length - RealBall(1), kNarrow));
    const auto [u, v] = contact(pair_, e, distance, bits);
    const SpanInBalls c(pair_.c, bits), d(pair_.d, bits);
    const Balls at_c = c.at(u), at_d = d.at(v), by_u = c.slope(u), by_v = d.slope(v);
    const RealBall rho = RealBall(distance).at_precision(bits) - at_c[3] - at_d[3];
    RealBall square, along_u = -(rho * by_u[3]), along_v = -(rho * by_v[3]);
    for (std::size_t i = 0; i < 3; ++i) {
      const RealBall from = e.point[i] - at_c[i] - at_d[i];
      square += from * from;
      along_u += from * by_u[i];
      along_v += from * by_v[i];
    }
    const double scale = kNarrow * size_ * size_;
    CHECK(encloses_zero(square - rho * rho, scale));
    CHECK(encloses_zero(along_u, scale));
    CHECK(encloses_zero(along_v, scale));
    return {u.midpoint(), v.midpoint()};
  }

  /// The edges run along lines u = const and v = const; the area inside in (u, v).
  double check_edges(const BSplineSurface& face, const SurfaceSections<RealBall>& x,
                     const PNSurface& section, const Certificate& certificate) {
    const double first = face.u_knots.front();
    std::vector<std::array<double, 2>> polygon;
    for (const ParameterCurve& curve : face.trims[0]) {
      const auto uv_at = [&](double at) {
        const auto [p, q] = evaluate(curve, at);
        CHECK((p > first - 1e-12 && p < first + 1 + 1e-12 && q > -1e-12 && q < 1 + 1e-12));
        return checked_place(
            enclosed(x, p - first, q, section.distance(), certificate.precision_bits),
            section.distance(), certificate.precision_bits);
      };
      const auto start = uv_at(0), end = uv_at(1);
      const std::size_t constant =
          std::abs(end[0] - start[0]) < std::abs(end[1] - start[1]) ? 0 : 1;
      CHECK(std::abs(end[constant] - start[constant]) < kParameters);
      for (const double at : {0.3, 0.6}) {
        const auto uv = uv_at(at);
        CHECK(std::abs(uv[constant] - start[constant]) < kParameters);
        // In the designer's parameter, so that neighbours share it.
        const std::size_t other = 1 - constant;
        CHECK(std::abs(uv[other] - (start[other] + at * (end[other] - start[other]))) <
              kParameters);
      }
      polygon.push_back(start);
    }
    double area = 0;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const auto &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
      area += (a[0] * b[1] - a[1] * b[0]) / 2;
    }
    return sheet_ == Sheet::kOuter ? area : -area;
  }

  /// Points of the face: on the envelope, over its pair of spans, exported within the deviation.
  void check_inside(const BSplineSurface& face, const SurfaceSections<RealBall>& x, double first,
                    const PNSurface& section, const Certificate& certificate) {
    for (int i = 0; i < 2; ++i) {
      const auto [p, q] = point_inside(face, first);
      const Enclosed truth =
          enclosed(x, p - first, q, section.distance(), certificate.precision_bits);
      const auto [u, v] = checked_place(truth, section.distance(), certificate.precision_bits);
      CHECK((is_inside(u) && is_inside(v)));
      check_exported_point(face, {p, q}, truth.point, certificate);
      CHECK(certificate.deviation < 1e-11 * (size_ + extent(face)));
      check_along(truth.normal, FamilyInDoubles(quadratic_family(pair_)).normal(sheet_, u, v));
    }
  }

  TranslationalSpline spline_;
  Sheet sheet_;
  std::shared_ptr<const TranslationalSkin> skin_;
  PNSurface surface_;
  std::mt19937_64 random_;
  double size_;
  TranslationalFamily pair_;
};

void check_random(std::uint64_t count, int most_spans) {
  const auto seed = static_cast<std::uint64_t>(number_from_environment("PN_TEST_SEED", 1));
  std::map<std::string, std::uint64_t> refused;
  std::uint64_t faces = 0, pairs = 0, separated = 0;
  for (std::uint64_t i = 0; i < count; ++i) {
    const RandomTranslation translation(seed + i, most_spans);
    INFO("RandomTranslation(" << seed + i << ", " << most_spans << "):\n" << text(translation));
    const auto code = code_of([&] {
      const TranslationalSpline spline = translation.spheres().spline;
      for (const Sheet sheet : {Sheet::kOuter, Sheet::kInner}) {
        // Separated sheets, most of them planes, have tests of their own.
        if (rational_normal(quadratic_family(spline.family(0, 0)), sheet)) {
          ++separated;
          continue;
        }
        faces += TranslationConcept(translation, sheet, seed + i).check();
        pairs += spline.c.spans.size() * spline.d.spans.size();
      }
    });
    if (code) ++refused[to_string(*code)];
  }
  std::cout << "PN_TEST_SEED=" << seed << ", " << count << " random translations: " << pairs
            << " pairs of spans, " << faces << " faces, " << separated << " separated sheets\n";
  for (const auto& [code, times] : refused) {
    std::cout << "  refused with " << code << ": " << times << "\n";
  }
  CHECK(refused["weights_not_positive"] == 0);
  CHECK(20 * refused["radius_too_steep"] <= count);
  CHECK(faces <= 2 * pairs);
}

TEST_CASE("Every skin of two parabolas of spheres is exact and covers its rectangle", "[concept]") {
  check_random(static_cast<std::uint64_t>(150 * number_from_environment("PN_TEST_SCALE", 1)), 1);
}

TEST_CASE("Every skin of two splines of spheres is exact and covers its rectangle", "[concept]") {
  check_random(static_cast<std::uint64_t>(25 * number_from_environment("PN_TEST_SCALE", 1)), 4);
}

}  // namespace
}  // namespace pn::test
