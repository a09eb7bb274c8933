// SPDX-License-Identifier: LGPL-2.1-or-later
// What every canal surface must satisfy, on thousands of random ones.
//
// PN_TEST_SEED chooses the inputs, PN_TEST_SCALE multiplies their number.
#include <catch2/catch.hpp>
#include <cstdlib>
#include <iostream>
#include <map>
#include <optional>
#include <set>

#include "enclosures.hpp"
#include "pn/bezier/pn_surface.hpp"
#include "pn/geometry_error.hpp"
#include "pn/shapes/canal_surface.hpp"
#include "random_canals.hpp"

namespace pn::test {
namespace {

/// Identities are enclosed to this relative width: far below what a wrong formula leaves, far above
/// what 128 bits leave.
constexpr double kNarrow = 1e-9;

double number_from_environment(const char* name, double otherwise) {
  const char* text = std::getenv(name);
  return text ? std::atof(text) : otherwise;
}

/// Odd, even and nonreal roots of D, with infinity among the real ones.
struct RootKinds {
  bool any_real = false, odd_real = false;
  int pair_savings = 0;  ///< sum of ceil(p / 2)
};

RootKinds root_kinds(const CircleFamily& circles) {
  const RationalPolynomial d = circles.discriminant();
  RootKinds kinds;
  const int at_infinity = 2 * circles.degree() - d.degree();
  kinds.any_real = at_infinity > 0;
  kinds.odd_real = at_infinity % 2 != 0;
  for (const RealRoot& root : isolate_roots(d, 256).real) {
    kinds.any_real = true;
    kinds.odd_real = kinds.odd_real || root.multiplicity % 2 != 0;
  }
  for (const ConjugatePair& pair : isolate_roots(d, 256).pairs) {
    kinds.pair_savings += (pair.multiplicity + 1) / 2;
  }
  return kinds;
}

void check_degree(const AlongCurve& envelope) {
  const int k = envelope.curve().degree(), h = envelope.circles().degree();
  const RootKinds kinds = root_kinds(envelope.circles());
  CHECK(envelope.is_substituted() == kinds.odd_real);
  if (kinds.odd_real) {
    CHECK(envelope.degree() == 2 * k + 2 * h);
    return;
  }
  const int least = (h + 1) / 2, most = std::max(least, h - kinds.pair_savings);
  CHECK(envelope.degree() >= k + 2 * least);
  CHECK(envelope.degree() <= k + 2 * (kinds.any_real ? most : least));
}

/// The sphere of the spine at parameter t, by its own span: centre and radius.
std::array<Rational, 4> sphere_at(const Curve& spine, const Law& law, const Rational& t) {
  const auto value = [&](const auto& function, std::size_t component) {
    std::size_t i = 0;
    while (i + 2 < function.breaks.size() && !(t < function.breaks[i + 1])) ++i;
    const Rational local = (t - function.breaks[i]) / (function.breaks[i + 1] - function.breaks[i]);
    return function.spans[i].numerator[component](local) / function.spans[i].denominator(local);
  };
  const auto& curve = spine.function();
  const auto radius = law.over(curve.breaks.front(), curve.breaks.back());
  return {value(curve, 0), value(curve, 1), value(curve, 2), value(radius, 0)};
}

/// |n| = 1, n.x_t = n.x_u = 0 and x_d - x = d n at a point of a segment, as enclosures of zero.
void check_identities(const LinedSegment& segment, double at, double angle, long precision) {
  const RealBall t = RealBall(at).at_precision(precision);
  const RealBall u0(std::cos(angle)), u1(std::sin(angle));
  const IsotropicVector<RealBall> vector = isotropic_vector<RealBall>(segment.spinor);
  const HomogeneousSections<RealBall> forms = sections(segment.curve, vector);
  std::array<Jet, 4> w;
  for (std::size_t i = 0; i < 4; ++i) w[i] = jet(vector[i], t, u0, u1);
  const RealBall w4 = w[3].value;
  REQUIRE(w4.is_positive());
  const std::array<RealBall, 3> n = {w[0].value / w4, w[1].value / w4, w[2].value / w4};
  CHECK(encloses_zero(n[0] * n[0] + n[1] * n[1] + n[2] * n[2] - RealBall(1), kNarrow));

  const Jet weight = jet(forms.weight, t, u0, u1);
  REQUIRE(weight.value.is_positive());
  RealBall along, around;
  double speed_along = 0, speed_around = 0, size = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const Jet p = jet(forms.point[i], t, u0, u1);
    const RealBall square = weight.value * weight.value;
    const RealBall x_t = (p.along * weight.value - p.value * weight.along) / square;
    const RealBall x_u = (p.around * weight.value - p.value * weight.around) / square;
    along += n[i] * x_t;
    around += n[i] * x_u;
    size = std::max(size, (p.value / weight.value).magnitude_upper());
    speed_along = std::max(speed_along, x_t.magnitude_upper());
    speed_around = std::max(speed_around, x_u.magnitude_upper());

    // x_d for d = 1 against x + n, each by its own forms.
    const RealBall moved = (p.value + jet(forms.direction[i], t, u0, u1).value) / weight.value -
                           p.value / weight.value;
    CHECK(encloses_zero(moved - n[i], kNarrow));
  }
  CHECK(encloses_zero(along, kNarrow * (size + speed_along)));
  CHECK(encloses_zero(around, kNarrow * (size + speed_around)));

  // The circle on which the sphere touches: n.axis + level = 0.
  RealBall circle = segment.curve.level(t);
  double axis = circle.magnitude_upper();
  for (std::size_t i = 0; i < 3; ++i) {
    circle += n[i] * segment.curve.axis[i](t);
    axis = std::max(axis, segment.curve.axis[i](t).magnitude_upper());
  }
  CHECK(encloses_zero(circle, kNarrow * axis));
}

/// The centre and the radius of a segment are those of the spine at its parameter.
void check_sphere(const LinedSegment& segment, const Curve& spine, const Law& law,
                  const Rational& local) {
  const Rational begin = Rational::exactly(segment.begin), end = Rational::exactly(segment.end);
  const auto sphere = sphere_at(spine, law, begin + local * (end - begin));
  const RealBall t(local, segment.curve.denominator[0].precision());
  const RealBall denominator = segment.curve.denominator(t);
  for (std::size_t i = 0; i < 3; ++i) {
    CHECK((segment.curve.centre[i](t) / denominator).contains(sphere[i]));
  }
  CHECK((segment.curve.radius(t) / denominator).contains(sphere[3]));
}

void check_plain_data(const BSplineSurface& face) {
  const auto check_direction = [](int degree, const std::vector<double>& knots,
                                  const std::vector<int>& multiplicities) {
    REQUIRE(knots.size() == multiplicities.size());
    CHECK(multiplicities.front() == degree + 1);
    CHECK(multiplicities.back() == degree + 1);
    for (std::size_t i = 1; i < knots.size(); ++i) CHECK(knots[i - 1] < knots[i]);
    for (std::size_t i = 1; i + 1 < knots.size(); ++i) CHECK(multiplicities[i] <= degree - 1);
  };
  check_direction(face.u_degree, face.u_knots, face.u_multiplicities);
  check_direction(face.v_degree, face.v_knots, face.v_multiplicities);
  CHECK(face.u_degree <= 25);
  REQUIRE(face.poles.size() == face.u_count() * face.v_count());
  REQUIRE(face.weights.size() == face.poles.size());
  for (const double weight : face.weights) CHECK(weight > 0);
}

struct ControlPoint {
  std::array<double, 3> pole;
  double weight;
  bool operator==(const ControlPoint& other) const {
    return pole == other.pole && weight == other.weight;
  }
};

std::vector<ControlPoint> row(const BSplineSurface& face, std::size_t i) {
  std::vector<ControlPoint> result;
  for (std::size_t j = 0; j < face.v_count(); ++j) {
    result.push_back({face.poles[i * face.v_count() + j], face.weights[i * face.v_count() + j]});
  }
  return result;
}

std::vector<ControlPoint> column(const BSplineSurface& face, std::size_t j) {
  std::vector<ControlPoint> result;
  for (std::size_t i = 0; i < face.u_count(); ++i) {
    result.push_back({face.poles[i * face.v_count() + j], face.weights[i * face.v_count() + j]});
  }
  return result;
}

/// The faces come strip by strip along the spine, `around` of them around each strip.
void check_shared_boundaries(const std::vector<BSplineSurface>& faces, std::size_t around,
                             bool closed) {
  for (std::size_t i = 0; i < faces.size(); ++i) {
    const std::size_t strip = i / around * around;
    const BSplineSurface& beside = faces[strip + (i + 1 - strip) % around];
    CHECK((column(faces[i], faces[i].v_count() - 1) == column(beside, 0)));
    const bool last = i + around >= faces.size();
    if (last && !closed) continue;
    CHECK((row(faces[i], faces[i].u_count() - 1) == row(faces[(i + around) % faces.size()], 0)));
  }
}

double ratio_of(const Form<RealBall>& form) {
  const auto bernstein = to_bernstein(form.coefficients());
  double least = INFINITY, largest = 0;
  for (const RealBall& b : bernstein) {
    least = std::min(least, b.lower());
    largest = std::max(largest, b.upper());
  }
  return least / largest;
}

/// What the weights of the spine leave of the ratio of the surface's weights.
void check_weight_ratio(const std::vector<BSplineSurface>& faces,
                        const std::vector<LinedSegment>& segments) {
  double least = INFINITY, largest = 0, of_spine = 1;
  for (const BSplineSurface& face : faces) {
    for (const double weight : face.weights) {
      least = std::min(least, weight);
      largest = std::max(largest, weight);
    }
  }
  for (const LinedSegment& segment : segments) {
    of_spine = std::min(of_spine, ratio_of(segment.curve.denominator));
  }
  CHECK(least / largest > 0.01 * of_spine);
}

class CanalConcept {
 public:
  CanalConcept(const CanalInput& input, std::uint64_t seed)
      : spine_(Curve::bspline(input.spine)),
        law_(Law::bspline(input.radius)),
        chain_(canal_surface(spine_, law_)),
        surface_(PNSurface(chain_)),
        random_(seed) {}

  void check() {
    int degree = 0;
    for (const ChainLink& link : chain_.links) {
      check_degree(link.envelope);
      degree = std::max(degree, link.envelope.degree());
    }
    CHECK(surface_.degree() == std::array<int, 2>{degree, 2});
    const double distance = std::ldexp(unit(), -2) * radius_scale();
    check_lines(Lines::kEven, surface_);
    check_lines(Lines::kEven, surface_.offset(distance));
    if (random_() % 4 == 0) check_lines(Lines::kLowestDegree, surface_.offset(distance));
  }

 private:
  double unit() { return static_cast<double>(random_() % 1025) / 1024; }

  double radius_scale() const {
    const SphereCurve& curve = chain_.links.front().envelope.curve();
    return (curve.radius(Rational()) / curve.denominator(Rational())).to_double();
  }

  void check_lines(Lines lines, const PNSurface& surface) {
    std::vector<BSplineSurface> faces;
    try {
      faces = surface.faces(lines);
    } catch (const GeometryError&) {
      if (lines == Lines::kEven) throw;
      return;  // separate faces with positive weights need not exist
    }
    const Certificate certificate = surface.certificate(lines);
    const std::vector<LinedSegment> segments =
        lined_segments(chain_, lines, certificate.precision_bits);
    for (const BSplineSurface& face : faces) check_plain_data(face);

    std::vector<std::size_t> first_segments;
    for (std::size_t i = 0; i < segments.size(); ++i) {
      if (i == 0 || segments[i].joint_before != Joint::kSmooth) first_segments.push_back(i);
    }
    REQUIRE(faces.size() % first_segments.size() == 0);
    const std::size_t around = faces.size() / first_segments.size();
    check_shared_boundaries(faces, around, chain_.closed);
    if (lines == Lines::kEven) {
      CHECK(around == 1);
      if (has_room_for_lines()) check_weight_ratio(faces, segments);
    }

    check_segment(segments[random_() % segments.size()], certificate.precision_bits);
    const std::size_t index = random_() % faces.size();
    const std::size_t strip = index / around;
    const std::size_t end =
        strip + 1 < first_segments.size() ? first_segments[strip + 1] : segments.size();
    const std::vector<LinedSegment> of_face(
        segments.begin() + static_cast<std::ptrdiff_t>(first_segments[strip]),
        segments.begin() + static_cast<std::ptrdiff_t>(end));
    const int arcs = lines == Lines::kEven ? static_cast<int>(faces[index].v_knots.size()) - 1
                                           : static_cast<int>(around);
    const CircleColumns columns = circle_columns(lines, arcs)[index % around];
    for (int sample = 0; sample < 3; ++sample) {
      check_certificate(faces[index], of_face, columns, surface.distance(), certificate);
    }
  }

  bool has_room_for_lines() const {
    return std::all_of(chain_.links.begin(), chain_.links.end(),
                       [](const ChainLink& link) { return link.envelope.degree() <= 25 - 6; });
  }

  void check_segment(const LinedSegment& segment, long precision) {
    check_identities(segment, unit(), 2 * M_PI * unit(), precision);
    const ChainLink* link = nullptr;
    for (const ChainLink& candidate : chain_.links) {
      if (candidate.begin <= segment.begin && segment.end <= candidate.end) link = &candidate;
    }
    if (segment.stands_still || !link || link->envelope.is_substituted()) return;
    check_sphere(segment, spine_, law_, Rational::exactly(unit()));
  }

  /// A point of the surface of doubles lies within the deviation of the true point.
  void check_certificate(const BSplineSurface& face, const std::vector<LinedSegment>& segments,
                         const CircleColumns& columns, double distance,
                         const Certificate& certificate) {
    const long precision = certificate.precision_bits;
    const LinedSegment& segment = segments[random_() % segments.size()];
    const double u = segment.begin + unit() * (segment.end - segment.begin);
    const double v =
        columns.knots.front() + unit() * (columns.knots.back() - columns.knots.front());
    const auto ball = [&](double x) { return RealBall(x).at_precision(precision); };
    const RealBall s = (ball(u) - ball(segment.begin)) / (ball(segment.end) - ball(segment.begin));
    std::array<RealBall, 3> c;
    const auto exact = circle_coefficients(columns, v);
    for (std::size_t q = 0; q < 3; ++q) c[q] = RealBall(exact[q], precision);
    const HomogeneousSections<RealBall> forms =
        sections(segment.curve, isotropic_vector<RealBall>(segment.spinor));
    const auto exported = enclosed_point(face, u, v, precision);
    const RealBall weight = value(forms.weight, s, c);
    RealBall squares;
    double size = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const RealBall truth =
          (value(forms.point[i], s, c) + ball(distance) * value(forms.direction[i], s, c)) / weight;
      const RealBall difference = exported[i] - truth;
      squares += difference * difference;
      size = std::max(size, truth.magnitude_upper());
    }
    CAPTURE(u, v, distance);
    CHECK(sqrt(abs(squares)).upper() <= certificate.deviation);
    // A certificate that says nothing would always hold.
    if (certificate.exact) CHECK(certificate.deviation < 1e-11 * (size + extent(face)));
  }

  static double extent(const BSplineSurface& face) {
    double largest = 0;
    for (const auto& pole : face.poles) {
      for (const double x : pole) largest = std::max(largest, std::abs(x));
    }
    return largest;
  }

  Curve spine_;
  Law law_;
  EnvelopeChain chain_;
  PNSurface surface_;
  std::mt19937_64 random_;
};

/// The code with which an input was refused; nothing when it passed every check.
std::optional<ErrorCode> check_canal(const CanalInput& input, std::uint64_t seed) {
  try {
    CanalConcept(input, seed).check();
    return std::nullopt;
  } catch (const GeometryError& error) {
    return error.code();
  }
}

TEST_CASE("Every canal surface is exact, even and closed up", "[concept]") {
  const auto seed = static_cast<std::uint64_t>(number_from_environment("PN_TEST_SEED", 20240));
  const auto count = static_cast<std::uint64_t>(2000 * number_from_environment("PN_TEST_SCALE", 1));
  std::cout << "PN_TEST_SEED=" << seed << ", " << count << " random canal surfaces\n";
  // What a random spine may honestly be refused for.
  const std::set<ErrorCode> allowed = {ErrorCode::kNegativeRadius, ErrorCode::kRadiusTooSteep,
                                       ErrorCode::kCornerTooSharp, ErrorCode::kDegreeTooHigh,
                                       ErrorCode::kPinched,        ErrorCode::kZeroLength};
  std::map<ErrorCode, std::uint64_t> refused;
  std::uint64_t refusals = 0;
  for (std::uint64_t i = 0; i < count; ++i) {
    const CanalInput input = RandomCanal(seed + i).input();
    INFO("RandomCanal(" << seed + i << "): " << input);
    const std::optional<ErrorCode> code = check_canal(input, seed + i);
    if (!code) continue;
    CAPTURE(to_string(*code));
    CHECK(allowed.count(*code) == 1);
    ++refused[*code];
    ++refusals;
  }
  for (const auto& [code, times] : refused) {
    std::cout << "  refused with " << to_string(code) << ": " << times << "\n";
  }
  CHECK(4 * refusals < count);
}

}  // namespace
}  // namespace pn::test
