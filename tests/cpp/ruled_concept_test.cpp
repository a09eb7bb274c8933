// SPDX-License-Identifier: LGPL-2.1-or-later
// What every ruled surface and every envelope of cones must satisfy, on thousands of random ones.
//
// PN_TEST_SEED chooses the inputs, PN_TEST_SCALE multiplies their number.
#include <Eigen/Dense>
#include <catch2/catch.hpp>
#include <iostream>
#include <map>
#include <optional>
#include <set>

#include "pn/bezier/chain_net.hpp"
#include "pn/bezier/evaluation.hpp"
#include "pn/bezier/parameter_curve.hpp"
#include "pn/isotropic/along_rulings.hpp"
#include "pn/shapes/ruled_surface.hpp"
#include "pn/shapes/sphere_spans.hpp"
#include "random_ruled_surfaces.hpp"
#include "surface_concept.hpp"

namespace pn::test {
namespace {

using Eigen::Vector3d;

/// The cosine of 120 degrees: fewer surfaces are refused for their weights where normals turn by
/// less along every ruling.
constexpr double kSteepTurn = -0.5;
/// Beside a pinch point normals turn by a right angle at least: its cosine, as samples see it.
constexpr double kPinchedTurn = 0.1;

/// A sphere with its rates by the parameter.
struct MovingSphere {
  Vector3d centre, motion;
  double radius, growth;
};

/// The sphere at v between two: c = (1 - v) c0 + v c1.
MovingSphere between(const MovingSphere& a, const MovingSphere& b, double v) {
  return {(1 - v) * a.centre + v * b.centre, (1 - v) * a.motion + v * b.motion,
          (1 - v) * a.radius + v * b.radius, (1 - v) * a.growth + v * b.growth};
}

/// The value of a function and its derivative, computed over Q.
template <std::size_t Dimension>
std::array<std::array<double, Dimension>, 2> jet_of(const PiecewiseRational<Dimension>& function,
                                                    const Rational& t) {
  std::size_t i = 0;
  while (i + 2 < function.breaks.size() && !(t < function.breaks[i + 1])) ++i;
  const Rational length = function.breaks[i + 1] - function.breaks[i];
  const Rational local = (t - function.breaks[i]) / length;
  const auto& [numerator, denominator] = function.spans[i];
  const Rational q = denominator(local), rate = denominator.derivative()(local) / q;
  std::array<std::array<double, Dimension>, 2> result;
  for (std::size_t c = 0; c < Dimension; ++c) {
    const Rational value = numerator[c](local) / q;
    result[0][c] = value.to_double();
    result[1][c] = ((numerator[c].derivative()(local) / q - value * rate) / length).to_double();
  }
  return result;
}

/// One side of the surface: the curve of centres with its radii.
struct Side {
  Curve curve;
  Law law;

  const Rational& begin() const { return curve.function().breaks.front(); }
  const Rational& end() const { return curve.function().breaks.back(); }

  /// The sphere at this part of the domain, its rates by a parameter over [0, 1].
  MovingSphere at(const Rational& part) const {
    const Rational length = end() - begin(), t = begin() + part * length;
    const double scale = length.to_double();
    const auto m = jet_of(curve.function(), t);
    const auto r = jet_of(law.over(begin(), end()), t);
    return {vector(m[0]), scale * vector(m[1]), r[0][0], scale * r[1][0]};
  }
  /// The spheres over a part of the domain, unless it is not one of them over which the curve is
  /// rational.
  std::optional<SphereCurve> over(const Rational& from, const Rational& to) const {
    const Rational low = begin() + from * (end() - begin()),
                   high = begin() + to * (end() - begin());
    std::vector<Rational> more;
    for (const Rational& x : {low, high}) {
      if (begin() < x && x < end()) more.push_back(x);
    }
    for (const SphereSpan& span : sphere_spans(curve, law, more)) {
      if (span.begin == low && span.end == high) return span.spheres;
    }
    return std::nullopt;
  }
};

/// Degrees of the lines of a family in Pluecker coordinates, without common divisors.
struct LineDegrees {
  int denominator, direction, line;
};

LineDegrees line_degrees(const Rulings& rulings) {
  const auto& [a, g] = rulings;
  const std::array<RationalPolynomial, 4> point = {a.centre[0], a.centre[1], a.centre[2],
                                                   -a.radius},
                                          axis = {g.axis[0], g.axis[1], g.axis[2], -g.level};
  RationalPolynomial common = a.denominator;
  int degree = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = i + 1; j < 4; ++j) {
      const RationalPolynomial b = point[i] * axis[j] - point[j] * axis[i];
      common = gcd(common, b);
      degree = std::max(degree, b.degree());
    }
  }
  const int m = a.denominator.degree() - common.degree(), h = g.degree();
  return {m, h, std::max(m + h, degree - common.degree())};
}

/// Torsal rulings count up to this part beyond a free end, too.
Rational beyond_free_end() { return Rational(1L) / Rational(16L); }

/// The torsal rulings of lines on a span, with those a little beyond its free ends.
int torsal_count(const Rulings& rulings, const SpanPlace& place) {
  const Rational low = place.meets_before ? Rational(0L) : -beyond_free_end(),
                 high = place.meets_after ? Rational(1L) : Rational(1L) + beyond_free_end();
  return static_cast<int>(
      roots_in_unit_interval(ruling_normal(rulings).torsion.on_interval(low, high - low)).size());
}

/// The degree of the theorem for lines in space: R = 0.
int degree_of_lines(const Rulings& rulings, const SpanPlace& place) {
  const auto [m, h, line] = line_degrees(rulings);
  const int excess = line == m + h ? 2 * m + h - 2 : m + line - 1;
  const int torsal = torsal_count(rulings, place);
  // A torsal ruling costs 3, and a linear factor lets its neighbours continue it.
  const bool has_neighbours = place.meets_before || place.meets_after;
  return excess + 4 * ((h + 1) / 2) + 3 * torsal + (torsal > 0 && has_neighbours ? 1 : 0);
}

/// The places where the loops of a face cross a line u = const, and whether they ascend in u there.
struct Crossing {
  double v;
  bool ascends;
};

std::vector<Crossing> crossings(const BSplineSurface& face, double u) {
  std::vector<Crossing> result;
  for (const TrimLoop& loop : face.trims) {
    for (const ParameterCurve& curve : loop) {
      double low = 0, high = 1;
      const double from = curve.poles.front()[0], to = curve.poles.back()[0];
      if (!((from < u && u < to) || (to < u && u < from))) continue;
      for (int i = 0; i < 60; ++i) {
        const double middle = (low + high) / 2;
        ((evaluate(curve, middle)[0] < u) == (from < to) ? low : high) = middle;
      }
      result.push_back({evaluate(curve, (low + high) / 2)[1], from < to});
    }
  }
  return result;
}

void check_loops(const BSplineSurface& face) {
  REQUIRE(face.trims.size() == 1);
  const TrimLoop& loop = face.trims.front();
  check_closed(loop);
  for (const ParameterCurve& curve : loop) {
    for (const auto& [u, v] : curve.poles) {
      CHECK(u >= face.u_knots.front());
      CHECK(u <= face.u_knots.back());
      CHECK(std::isfinite(v));
    }
  }
}

/// Both corners of the side of a face at this end of its first parameter.
std::array<std::array<double, 2>, 2> corners(const BSplineSurface& face, double u) {
  std::vector<std::array<double, 2>> found;
  for (const ParameterCurve& curve : face.trims.front()) {
    for (const auto& end : {curve.poles.front(), curve.poles.back()}) {
      if (end[0] == u && std::find(found.begin(), found.end(), end) == found.end()) {
        found.push_back(end);
      }
    }
  }
  REQUIRE(found.size() == 2);
  std::sort(found.begin(), found.end());
  return {found[0], found[1]};
}

void check_shared_corners(const std::vector<BSplineSurface>& faces, bool closed) {
  for (std::size_t i = 0; i < faces.size(); ++i) {
    if (i + 1 == faces.size() && !closed) continue;
    const BSplineSurface &left = faces[i], &right = faces[(i + 1) % faces.size()];
    const auto a = corners(left, left.u_knots.back()), b = corners(right, right.u_knots.front());
    CHECK(a[0][1] == b[0][1]);
    CHECK(a[1][1] == b[1][1]);
  }
}

EnvelopeChain chain_of(const std::array<Side, 2>& sides, bool cones) {
  return cones ? cone_envelope(sides[0].curve, sides[0].law, sides[1].curve, sides[1].law)
               : ruled_surface(sides[0].curve, sides[1].curve);
}

Side side_of(const RuledInput& input, std::size_t which) {
  return {Curve::bspline(input.curves[which]),
          input.radii ? Law::bspline((*input.radii)[which]) : Law::constant(0)};
}

class RuledConcept {
 public:
  RuledConcept(const RuledInput& input, std::uint64_t seed)
      : sides_{side_of(input, 0), side_of(input, 1)},
        cones_(input.radii.has_value()),
        chain_(chain_of(sides_, cones_)),
        surface_(PNSurface(chain_)),
        random_(seed) {}

  void check() {
    REQUIRE((is_strip() || std::holds_alternative<RulingBand>(chain_.extent)));
    CHECK(chain_.links.front().begin == sides_[0].begin().to_double());
    CHECK(chain_.links.back().end == sides_[0].end().to_double());
    if (!is_strip()) {
      for (const ChainLink& link : chain_.links) check_degree(link);
    }
    const double distance = std::ldexp(unit(), -2) * extent(surface_.faces(Lines::kEven).front());
    check_lines(Lines::kEven, surface_);
    check_lines(random_() % 4 == 0 ? Lines::kLowestDegree : Lines::kEven,
                surface_.offset(random_() % 2 == 0 ? distance : -distance));
  }

 private:
  /// Developable, in whole faces.
  bool is_strip() const { return std::holds_alternative<Strip>(chain_.extent); }

  double unit() { return static_cast<double>(random_() % 1025) / 1024; }
  /// Not at an end.
  double inside() { return static_cast<double>(1 + random_() % 1023) / 1024; }

  Rational part_of(double t) const {
    const Rational &begin = sides_[0].begin(), &end = sides_[0].end();
    return (Rational::exactly(t) - begin) / (end - begin);
  }

  void check_degree(const ChainLink& link) {
    CHECK(link.envelope.degree() <= kLargestDegree);
    CHECK(link.envelope.degree_around() == 4);
    if (cones_) return;
    CHECK_FALSE(link.envelope.is_substituted());
    const auto a = sides_[0].over(part_of(link.begin), part_of(link.end));
    const auto b = sides_[1].over(part_of(link.begin), part_of(link.end));
    if (!a || !b) return;  // breaks of the second curve that are no doubles on the first
    const SpanPlace place{1L, chain_.closed || &link != &chain_.links.front(),
                          chain_.closed || &link != &chain_.links.back()};
    // The factor for neighbours is constant where it is the same at both ends.
    const int most = degree_of_lines(joined(*a, *b).rulings, place);
    CHECK(link.envelope.degree() <= most);
    CHECK(link.envelope.degree() >= most - 1);
  }

  void check_lines(Lines lines, const PNSurface& surface) {
    const std::vector<BSplineSurface> faces = surface.faces(lines);
    const Certificate certificate = surface.certificate(lines);
    CHECK(certificate.exact);
    const ChainNet& net = net_of(lines, certificate.precision_bits);
    const std::vector<LinedSegment>& segments = net.segments();
    const auto of_face = strips(segments);
    REQUIRE(faces.size() == of_face.size());
    double size = 0;
    for (const BSplineSurface& face : faces) {
      check_plain_data(face);
      if (is_strip()) {
        CHECK(face.trims.empty());
      } else {
        check_loops(face);
      }
      size = std::max(size, extent(face));
    }
    check_shared_rows(faces, 1, chain_.closed);
    if (!is_strip()) check_shared_corners(faces, chain_.closed);
    CHECK(certificate.trim_deviation <= 1e-9 * std::max(1.0, size / 1e3));

    const auto links = links_of(chain_, segments);
    for (int sample = 0; sample < 2; ++sample) {
      const std::size_t index = random_() % faces.size();
      const auto [first, last] = of_face[index];
      const std::size_t at = first + random_() % (last - first);
      const LinedSegment& segment = segments[at];
      const RealBall t = RealBall(unit()).at_precision(net.precision()), s(unit());
      CHECK(jet(segment.sections.weight, t, RealBall(1) - s, s).value.is_positive());
      check_identities(segment.sections, t, RealBall(1) - s, s);
      const CircleColumns columns =
          straight_band(static_cast<int>(faces[index].v_knots.size()) - 1, faces[index].v_degree);
      const double u = segment.begin + unit() * (segment.end - segment.begin);
      check_certificate(faces[index], segment, columns, u, unit(), surface.distance(), certificate);
      if (is_strip() && links[at]->envelope.is_substituted()) continue;
      check_coverage(faces[index], net.normals()[index], segment, *links[at], surface.distance(),
                     size, certificate.trim_deviation);
    }
  }

  /// The net behind the faces, made once for all distances.
  const ChainNet& net_of(Lines lines, long precision) {
    std::optional<ChainNet>& net = nets_[lines];
    if (!net || net->precision() != precision) net.emplace(chain_, lines, precision);
    return *net;
  }

  /// The spheres of both sides at a parameter of a segment.
  std::array<MovingSphere, 2> spheres_at(const ChainLink& link, const LinedSegment& segment,
                                         double u) const {
    if (!link.envelope.is_substituted())
      return {sides_[0].at(part_of(u)), sides_[1].at(part_of(u))};
    const auto& rulings = std::get<RulingForms<double>>(segment.carrier);
    const double local = (u - segment.begin) / (segment.end - segment.begin);
    const auto sphere = [&](const SphereCurveForms<double>& f) {
      const double q = f.denominator(local), rate = f.denominator.derivative()(local) / q;
      MovingSphere result;
      for (Eigen::Index i = 0; i < 3; ++i) {
        const Form<double>& c = f.centre[static_cast<std::size_t>(i)];
        result.centre[i] = c(local) / q;
        result.motion[i] = c.derivative()(local) / q - rate * result.centre[i];
      }
      result.radius = f.radius(local) / q;
      result.growth = f.radius.derivative()(local) / q - rate * result.radius;
      return result;
    };
    return {sphere(rulings.directrices[0]), sphere(rulings.directrices[1])};
  }

  /// On the line u = const of the face: it crosses the loop where v is 0 and where it is 1, in
  /// between v grows, and every point is that of the sphere at v moved along its normal. So the
  /// face is the part 0 <= v <= 1, nothing less and nothing else.
  void check_coverage(const BSplineSurface& face, const BSplineSurface& normals,
                      const LinedSegment& segment, const ChainLink& link, double distance,
                      double size, double trim_deviation) {
    const double u = segment.begin + inside() * (segment.end - segment.begin);
    CAPTURE(u, distance, segment.begin, segment.end);
    const auto [low, high] = spheres_at(link, segment, u);
    std::vector<Crossing> edges = crossings(face, u);
    if (is_strip()) edges = {{0, true}, {1, false}};
    REQUIRE(edges.size() == 2);
    std::sort(edges.begin(), edges.end(),
              [](const Crossing& a, const Crossing& b) { return a.v < b.v; });
    // The region lies to the left of its loop.
    CHECK(edges[0].ascends);
    CHECK_FALSE(edges[1].ascends);
    CHECK(edges[0].v >= 0);
    CHECK(edges[1].v <= 1);
    const Vector3d ruling = high.centre - low.centre;
    double before = -INFINITY;
    constexpr int kSteps = 6;
    for (int i = 0; i <= kSteps; ++i) {
      const double s = edges[0].v + (edges[1].v - edges[0].v) * i / kSteps;
      const Vector3d x = vector(evaluate(face, u, s)), n = vector(evaluate(normals, u, s));
      const auto at = [&](double v) -> Vector3d {
        const MovingSphere sphere = between(low, high, v);
        return sphere.centre + (sphere.radius + distance) * n;
      };
      const Vector3d direction = at(1) - at(0);
      const double v = (x - at(0)).dot(direction) / direction.squaredNorm();
      CHECK((x - at(v)).norm() <= kRounding * size);
      const MovingSphere sphere = between(low, high, v);
      const double speed = std::max(low.motion.norm(), high.motion.norm());
      CHECK(std::abs(n.norm() - 1) <= kRounding);
      CHECK(std::abs(n.dot(ruling) + high.radius - low.radius) <= kRounding * size);
      CHECK(std::abs(n.dot(sphere.motion) + sphere.growth) <= 1e-9 * (speed + size));
      CHECK(n.dot(sphere.motion.cross(ruling)) >= -1e-9 * speed * size);
      const double allowed = 2 * trim_deviation + kRounding * size;
      if (i == 0) CHECK(std::abs(v) * direction.norm() <= allowed);
      if (i == kSteps) CHECK(std::abs(v - 1) * direction.norm() <= allowed);
      CHECK(v > before);
      before = v;
    }
  }

  std::array<Side, 2> sides_;
  bool cones_;
  EnvelopeChain chain_;
  PNSurface surface_;
  std::map<Lines, std::optional<ChainNet>> nets_;
  std::mt19937_64 random_;
};

/// The normal of the band at v, on the side of c_t x c_v; nothing where the spheres have none.
std::optional<Vector3d> normal_at(const MovingSphere& low, const MovingSphere& high, double v) {
  const MovingSphere sphere = between(low, high, v);
  const Vector3d ruling = high.centre - low.centre;
  Eigen::Matrix<double, 2, 3> planes;
  planes << sphere.motion.transpose(), ruling.transpose();
  const Eigen::Vector2d levels(-sphere.growth, low.radius - high.radius);
  const Vector3d nearest = planes.completeOrthogonalDecomposition().solve(levels);
  const double square = 1 - nearest.squaredNorm();
  if (!(square > 0) || sphere.motion.cross(ruling).isZero()) return std::nullopt;
  return nearest + std::sqrt(square) * sphere.motion.cross(ruling).normalized();
}

/// The least cosine of the angle between the normals at both ends of a ruling: -1 where some point
/// of it has none.
double least_cosine(const std::array<Side, 2>& sides) {
  constexpr long kSteps = 64;
  double least = 1;
  for (long i = 0; i <= kSteps; ++i) {
    const Rational part = Rational(i) / Rational(kSteps);
    const MovingSphere low = sides[0].at(part), high = sides[1].at(part);
    for (const double v : {0.0, 0.25, 0.5, 0.75}) {
      const auto a = normal_at(low, high, v), b = normal_at(low, high, 1);
      if (!a || !b) return -1;
      least = std::min(least, a->dot(*b));
    }
  }
  return least;
}

/// The code with which an input was refused; nothing when it passed every check.
std::optional<ErrorCode> check_ruled(const RuledInput& input, std::uint64_t seed) {
  try {
    RuledConcept(input, seed).check();
    return std::nullopt;
  } catch (const GeometryError& error) {
    return error.code();
  }
}

TEST_CASE("Every ruled surface is exact and covers its rulings, no more", "[concept]") {
  const auto seed = static_cast<std::uint64_t>(number_from_environment("PN_TEST_SEED", 30240));
  const auto count = static_cast<std::uint64_t>(2000 * number_from_environment("PN_TEST_SCALE", 1));
  std::cout << "PN_TEST_SEED=" << seed << ", " << count << " random ruled surfaces\n";
  // What a random pair of curves may honestly be refused for.
  const std::set<ErrorCode> allowed = {ErrorCode::kDegreeTooHigh, ErrorCode::kDevelopable,
                                       ErrorCode::kRadiusTooSteep, ErrorCode::kCurvesMeet,
                                       ErrorCode::kPinched};
  std::map<std::pair<std::string, ErrorCode>, std::uint64_t> refused;
  std::uint64_t refusals = 0, for_weights = 0, gentle = 0;
  for (std::uint64_t i = 0; i < count; ++i) {
    const RuledInput input = RandomRuledSurface(seed + i).input();
    INFO("RandomRuledSurface(" << seed + i << "): " << input);
    const std::optional<ErrorCode> code = check_ruled(input, seed + i);
    if (!code) continue;
    CAPTURE(to_string(*code));
    // A band that turns by nearly two right angles is no arc with positive weights.
    if (*code == ErrorCode::kWeightsNotPositive) {
      ++for_weights;
      if (least_cosine({side_of(input, 0), side_of(input, 1)}) >= kSteepTurn) ++gentle;
    } else {
      CHECK(allowed.count(*code) == 1);
    }
    if (*code == ErrorCode::kPinched) {
      CHECK(least_cosine({side_of(input, 0), side_of(input, 1)}) < kPinchedTurn);
    }
    ++refused[{input.kind.substr(0, input.kind.find(',')), *code}];
    ++refusals;
  }
  for (const auto& [reason, times] : refused) {
    std::cout << "  " << reason.first << " refused with " << to_string(reason.second) << ": "
              << times << "\n";
  }
  std::cout << "  accepted: " << count - refusals << "\n";
  CHECK(4 * refusals < count);
  CHECK(200 * for_weights <= count);
  CHECK(1000 * gentle <= count);
}

}  // namespace
}  // namespace pn::test
