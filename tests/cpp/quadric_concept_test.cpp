// SPDX-License-Identifier: LGPL-2.1-or-later
// What every quadric and every region of one must satisfy, on a thousand of random ones.
//
// PN_TEST_SEED chooses the inputs, PN_TEST_SCALE multiplies their number.
#include <Eigen/Dense>
#include <catch2/catch.hpp>
#include <iostream>
#include <map>
#include <optional>

#include "error_code.hpp"
#include "pn/bezier/chain_net.hpp"
#include "pn/bezier/evaluation.hpp"
#include "pn/bezier/parameter_curve.hpp"
#include "random_quadrics.hpp"
#include "surface_concept.hpp"

namespace pn::test {
namespace {

using Eigen::Vector3d;
using Place = Eigen::Vector2d;

/// A point so far from every bound, in parts of the region's size, is told to be inside or outside
/// of polygons that follow the loops.
constexpr double kClear = 4e-3;

/// x.(S x) + 2 h z + k = 0 with diagonal S, and the side of its gradient on which the normal is.
struct Equation {
  std::array<Rational, 3> square;
  Rational half_linear, constant;
  int side;

  template <class T, class Convert>
  T value(const std::array<T, 3>& x, Convert&& number) const {
    T sum = number(half_linear) * x[2] + number(half_linear) * x[2] + number(constant);
    for (std::size_t i = 0; i < 3; ++i) sum += number(square[i]) * x[i] * x[i];
    return sum;
  }
  /// Half the gradient.
  template <class T, class Convert>
  std::array<T, 3> gradient(const std::array<T, 3>& x, Convert&& number) const {
    return {number(square[0]) * x[0], number(square[1]) * x[1],
            number(square[2]) * x[2] + number(half_linear)};
  }
};

Equation equation_of(const QuadricInput& input) {
  std::array<Rational, 3> half;
  for (std::size_t i = 0; i < 3; ++i) half[i] = Rational::exactly(input.half[i]);
  const Rational one(1), zero, below = Rational(-1) / Rational(2);
  const Rational x = one / (half[0] * half[0]), y = one / (half[1] * half[1]),
                 z = one / (half[2] * half[2]);
  switch (input.kind) {
    case QuadricKind::kEllipsoid:
      return {{x, y, z}, zero, -one, 1};
    case QuadricKind::kOneSheetHyperboloid:
      return {{x, y, -z}, zero, -one, 1};
    case QuadricKind::kTwoSheetHyperboloid:
      return {{x, y, -z}, zero, one, 1};
    case QuadricKind::kEllipticParaboloid:
      return {{half[2] * x, half[2] * y, zero}, below, zero, 1};
    case QuadricKind::kHyperbolicParaboloid:
      return {{half[2] * x, -half[2] * y, zero}, below, zero, -1};
    case QuadricKind::kEllipticCylinder:
      return {{x, y, zero}, zero, -one, 1};
    case QuadricKind::kEllipticCone:
      return {{x, y, -z}, zero, zero, 1};
    case QuadricKind::kParabolicCylinder:
      return {{half[2] * x, zero, zero}, below, zero, 1};
  }
  throw std::logic_error("a kind without an equation");
}

/// Bidegrees by the table of docs/quadrics.md.
std::array<int, 2> degree_of(const QuadricInput& input) {
  const auto [a, b, c] = input.half;
  switch (input.kind) {
    case QuadricKind::kEllipsoid:
      if (a == b && b == c) return {2, 2};
      return {8, a == b || b == c || c == a ? 2 : 4};
    case QuadricKind::kTwoSheetHyperboloid:
      return {8, a == b ? 2 : 4};
    case QuadricKind::kEllipticParaboloid:
      return {6, a == b ? 2 : 4};
    case QuadricKind::kOneSheetHyperboloid:
      return {4, 4};
    case QuadricKind::kHyperbolicParaboloid:
      return {5, 4};
    case QuadricKind::kParabolicCylinder:
      return {7, 1};
    case QuadricKind::kEllipticCylinder:
    case QuadricKind::kEllipticCone:
      return {1, 2};
  }
  return {0, 0};
}

/// How far a point is outside the bounds [mm]; negative inside.
double excess(const QuadricBounds& bounds, const Vector3d& p) {
  double result = -HUGE_VAL;
  for (std::size_t i = 0; i < 3; ++i) {
    const double x = p(static_cast<Eigen::Index>(i));
    result = std::max({result, bounds.box[i].low - x, x - bounds.box[i].high});
  }
  if (!bounds.angle) return result;
  const double width = bounds.angle->high - bounds.angle->low;
  if (width >= 2 * M_PI - 1e-8) return result;
  const auto left_of = [&](double angle) {
    return p.y() * std::cos(angle) - p.x() * std::sin(angle);
  };
  const double before = -left_of(bounds.angle->low), after = left_of(bounds.angle->high);
  return std::max(result, width < M_PI ? std::max(before, after) : std::min(before, after));
}

/// Points of the whole quadric, most of them near the region.
class PointSource {
 public:
  PointSource(const QuadricInput& input, const Equation& equation, const Vector3d& low,
              const Vector3d& high, std::mt19937_64& random)
      : input_(input), low_(low), high_(high), random_(random) {
    const auto number = [](const Rational& x) { return x.to_double(); };
    for (std::size_t i = 0; i < 3; ++i) square_[i] = number(equation.square[i]);
    half_linear_ = number(equation.half_linear);
    constant_ = number(equation.constant);
  }

  /// None where the coordinates that were chosen allow none.
  std::optional<Vector3d> point() {
    const bool is_angular = input_.bounds.angle && random_() % 2 == 0;
    return is_angular ? at_some_angle() : with_one_coordinate_solved_for();
  }

 private:
  double unit() { return std::uniform_real_distribution<double>()(random_); }
  double within(std::size_t i) {
    const auto k = static_cast<Eigen::Index>(i);
    return low_(k) + unit() * (high_(k) - low_(k));
  }
  bool is_on_the_sheet(double z) const {
    return z > 0 || (input_.kind != QuadricKind::kTwoSheetHyperboloid &&
                     input_.kind != QuadricKind::kEllipticCone);
  }

  std::optional<Vector3d> with_one_coordinate_solved_for() {
    const std::size_t axis = random_() % 3;
    Vector3d p(within(0), within(1), within(2));
    p(static_cast<Eigen::Index>(axis)) = 0;
    double rest = constant_ + 2 * half_linear_ * p.z();
    for (std::size_t i = 0; i < 3; ++i) {
      rest += square_[i] * p(static_cast<Eigen::Index>(i)) * p(static_cast<Eigen::Index>(i));
    }
    double& own = p(static_cast<Eigen::Index>(axis));
    if (square_[axis] == 0) {
      if (axis != 2) return std::nullopt;
      own = -rest / (2 * half_linear_);
    } else {
      own = std::sqrt(-rest / square_[axis]) * (random_() % 2 == 0 ? 1 : -1);
    }
    if (!p.allFinite() || !is_on_the_sheet(p.z())) return std::nullopt;
    return p;
  }

  /// (r cos, r sin, z) with s r^2 = -(z part): by z, or by r where the surface is a graph.
  std::optional<Vector3d> at_some_angle() {
    const Interval& sector = *input_.bounds.angle;
    const double angle = sector.low + unit() * (sector.high - sector.low);
    const double c = std::cos(angle), s = std::sin(angle);
    const double across = square_[0] * c * c + square_[1] * s * s;
    double r = 0, z = within(2);
    if (half_linear_ != 0) {
      r = unit() * std::hypot(high_.x() - low_.x(), high_.y() - low_.y());
      z = -across * r * r / (2 * half_linear_);
    } else {
      r = std::sqrt(-(square_[2] * z * z + constant_) / across);
    }
    if (!std::isfinite(r) || !is_on_the_sheet(z)) return std::nullopt;
    return Vector3d(r * c, r * s, z);
  }

  const QuadricInput& input_;
  Vector3d low_, high_;
  std::mt19937_64& random_;
  std::array<double, 3> square_;
  double half_linear_, constant_;
};

/// A face at distance zero with polygons that follow its loops, and a grid of points around them.
class FaceMap {
 public:
  explicit FaceMap(const BSplineSurface& face) : face_(face), evaluation_(face) {
    low_ = {face.u_knots.front(), face.v_knots.front()};
    high_ = {face.u_knots.back(), face.v_knots.back()};
    for (const TrimLoop& loop : face.trims) polygons_.push_back(polygon(loop));
    if (!polygons_.empty()) {
      std::swap(low_, high_);
      for (const Place& corner : polygons_.front()) {
        low_ = low_.cwiseMin(corner);
        high_ = high_.cwiseMax(corner);
      }
    }
    for (const double along : grid()) {
      for (int j = 0; j <= kGrid; ++j) {
        const Place place = at(along, static_cast<double>(j) / kGrid);
        nodes_.push_back({place, point(place)});
      }
    }
  }

  Vector3d point(const Place& place) const { return vector(evaluation_(place.x(), place.y())); }
  /// The place at these parts of the rectangle around the loops.
  Place at(double along, double across) const {
    return low_ + Place(along, across).cwiseProduct(high_ - low_);
  }
  /// Within the knots but for rounding.
  bool holds(const Place& place) const { return (place - clamped(place)).norm() < 1e-12; }
  /// Inside the loops.
  bool contains(const Place& place) const {
    if (polygons_.empty()) return true;
    bool inside = false;
    for (const std::vector<Place>& loop : polygons_) {
      for (std::size_t i = 0; i < loop.size(); ++i) {
        const Place &a = loop[i], &b = loop[(i + 1) % loop.size()];
        if ((a.y() > place.y()) == (b.y() > place.y())) continue;
        const double x = a.x() + (place.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x());
        if (place.x() < x) inside = !inside;
      }
    }
    return inside;
  }
  /// Twice the areas inside the loops, positive counterclockwise.
  std::vector<double> areas() const {
    std::vector<double> areas;
    for (const std::vector<Place>& loop : polygons_) {
      areas.push_back(0);
      for (std::size_t i = 0; i < loop.size(); ++i) {
        const Place &a = loop[i], &b = loop[(i + 1) % loop.size()];
        areas.back() += a.x() * b.y() - a.y() * b.x();
      }
    }
    return areas;
  }
  /// Where a point lies on the whole face, by the Gauss-Newton method from the nearest nodes; what
  /// is near is measured in parts of a box, since regions may be slender.
  std::optional<Place> place_of(const Vector3d& target, const Vector3d& box,
                                double tolerance) const {
    std::vector<Node> nearest = nodes_;
    const auto distance = [&](const Node& node) {
      return (node.point - target).cwiseQuotient(box).squaredNorm();
    };
    const auto is_nearer = [&](const Node& a, const Node& b) { return distance(a) < distance(b); };
    constexpr std::ptrdiff_t kStarts = 40;
    std::partial_sort(nearest.begin(), nearest.begin() + kStarts, nearest.end(), is_nearer);
    for (std::ptrdiff_t i = 0; i < kStarts; ++i) {
      const Place place = approached(nearest[static_cast<std::size_t>(i)].place, target, box);
      if ((point(place) - target).norm() <= tolerance) return place;
    }
    return std::nullopt;
  }

 private:
  static constexpr int kGrid = 48;
  /// Parts along, denser at both ends, where lines may be far from even.
  static std::vector<double> grid() {
    std::vector<double> parts;
    for (int i = 0; i <= kGrid; ++i) parts.push_back(static_cast<double>(i) / kGrid);
    for (int k = 5; k <= 12; ++k) {
      parts.push_back(std::ldexp(1, -k));
      parts.push_back(1 - std::ldexp(1, -k));
    }
    return parts;
  }
  struct Node {
    Place place;
    Vector3d point;
  };

  static std::vector<Place> polygon(const TrimLoop& loop) {
    constexpr int kPerSpan = 4;
    std::vector<Place> corners;
    for (const ParameterCurve& curve : loop) {
      for (std::size_t i = 0; i + 1 < curve.knots.size(); ++i) {
        const double from = curve.knots[i], to = curve.knots[i + 1];
        for (int k = 0; k < kPerSpan; ++k) {
          const auto [u, v] = evaluate(curve, from + (to - from) * k / kPerSpan);
          corners.emplace_back(u, v);
        }
      }
    }
    return corners;
  }

  Place clamped(const Place& p) const {
    return {std::clamp(p.x(), face_.u_knots.front(), face_.u_knots.back()),
            std::clamp(p.y(), face_.v_knots.front(), face_.v_knots.back())};
  }
  Place approached(Place place, const Vector3d& target, const Vector3d& box) const {
    constexpr int kSteps = 60;
    constexpr double kDifference = 1e-6;
    const auto gap = [&](const Place& p) -> Vector3d {
      return (point(p) - target).cwiseQuotient(box);
    };
    // Steps a million times shorter than Newton's come no closer any more.
    constexpr double kMostDamping = 1e6;
    double damping = 1e-3, error = gap(place).norm();
    for (int step = 0; step < kSteps && error > 0 && damping < kMostDamping; ++step) {
      Eigen::Matrix<double, 3, 2> slopes;
      for (int c = 0; c < 2; ++c) {
        const Place aside = kDifference * Place::Unit(c);
        const Place low = clamped(place - aside), high = clamped(place + aside);
        slopes.col(c) = (gap(high) - gap(low)) / (high(c) - low(c));
      }
      Eigen::Matrix2d normal = slopes.transpose() * slopes;
      normal.diagonal() *= 1 + damping;
      const Place next = clamped(place - normal.ldlt().solve(slopes.transpose() * gap(place)));
      const bool is_closer = gap(next).norm() < error;
      if (is_closer) place = next;
      error = gap(place).norm();
      damping *= is_closer ? 0.1 : 10;
    }
    return place;
  }

  const BSplineSurface& face_;
  SurfaceEvaluation evaluation_;
  std::vector<std::vector<Place>> polygons_;  ///< along the loops, the outer one first
  Place low_, high_;                          ///< the rectangle around them
  std::vector<Node> nodes_;
};

class QuadricConcept {
 public:
  QuadricConcept(const QuadricInput& input, std::uint64_t seed)
      : input_(input),
        equation_(equation_of(input)),
        chain_(quadric(input.kind, input.half, input.bounds)),
        surface_(PNSurface(chain_)),
        random_(seed) {}

  void check() {
    CHECK(surface_.degree() == degree_of(input_));
    const std::vector<BSplineSurface> faces = surface_.faces(Lines::kEven);
    const Certificate certificate = surface_.certificate(Lines::kEven);
    CHECK(certificate.exact);
    const ChainNet net(chain_, Lines::kEven, certificate.precision_bits);
    for (const BSplineSurface& face : faces) {
      check_plain_data(face);
    }
    measure(faces);
    check_neighbours(net);
    check_inner_sides(faces);
    check_edges(faces, certificate.trim_deviation);
    check_coverage(faces);
    for (const PNSurface& surface : {surface_, surface_.offset(input_.distance)}) {
      check_points(surface, net);
    }
  }

 private:
  double unit() { return static_cast<double>(random_() % 1025) / 1024; }
  double uniform() { return std::uniform_real_distribution<double>()(random_); }

  /// Faces that meet share a row or a column of control points, bit for bit.
  static void check_neighbours(const ChainNet& net) {
    const std::vector<RoundedFace> faces = net.section(0);
    for (std::size_t i = 0; i < faces.size(); ++i) {
      for (std::size_t j = 0; j < faces.size(); ++j) {
        const BSplineSurface &a = faces[i].surface, &b = faces[j].surface;
        const bool is_around = net.places()[i].arcs > 0;
        if (is_around && a.u_knots == b.u_knots &&
            std::fmod(a.v_knots.back(), 4) == b.v_knots.front()) {
          CHECK((column(a, a.v_count() - 1) == column(b, 0)));
        }
        if (a.v_knots == b.v_knots && a.u_knots.back() == b.u_knots.front()) {
          CHECK((row(a, a.u_count() - 1) == row(b, 0)));
        }
      }
    }
  }

  /// Every stretch of a side between two faces bounds both, in opposite directions.
  void check_inner_sides(const std::vector<BSplineSurface>& faces) const {
    using Stretch = std::array<std::array<double, 2>, 2>;
    std::map<Stretch, int> balance;
    const auto is_trimmed = [](const BSplineSurface& face) { return !face.trims.empty(); };
    if (!std::all_of(faces.begin(), faces.end(), is_trimmed)) return;
    for (const BSplineSurface& face : faces) {
      for (const TrimLoop& loop : face.trims) {
        for (const ParameterCurve& curve : loop) {
          Stretch side = {curve.poles.front(), curve.poles.back()};
          if (curve.degree > 1) continue;
          const bool is_pole = side[0][0] == side[1][0] && (side[0][0] == 0 || side[0][0] == 1);
          if (is_pole && !chain_.closed) continue;
          for (auto& end : side) {
            end[1] = std::fmod(end[1], 4);
            if (chain_.closed) end[0] = std::fmod(end[0], chain_.links.back().end);
          }
          const bool ascends = side[0] < side[1];
          if (!ascends) std::swap(side[0], side[1]);
          balance[side] += ascends ? 1 : -1;
        }
      }
    }
    for (const auto& [side, sum] : balance) {
      CAPTURE(side[0][0], side[0][1], side[1][0], side[1][1]);
      CHECK(sum == 0);
    }
  }

  /// The box around the region.
  void measure(const std::vector<BSplineSurface>& faces) {
    constexpr int kPoints = 9;
    const auto add = [&](const BSplineSurface& face, double u, double v) {
      const Vector3d p = vector(evaluate(face, u, v));
      low_ = low_.cwiseMin(p);
      high_ = high_.cwiseMax(p);
    };
    for (const BSplineSurface& face : faces) {
      for (const TrimLoop& loop : face.trims) {
        for (const ParameterCurve& curve : loop) {
          for (int k = 0; k < kPoints; ++k) {
            const auto [u, v] = evaluate(curve, static_cast<double>(k) / kPoints);
            add(face, u, v);
          }
        }
      }
      if (!face.trims.empty()) continue;
      const FaceMap map(face);
      for (int i = 0; i < kPoints; ++i) {
        for (int j = 0; j < kPoints; ++j) {
          const Place place = map.at(i / (kPoints - 1.0), j / (kPoints - 1.0));
          add(face, place.x(), place.y());
        }
      }
    }
    size_ = std::max(low_.cwiseAbs().maxCoeff(), high_.cwiseAbs().maxCoeff());
  }

  /// The loops are closed, the outer one runs counterclockwise around all others, and their curves
  /// lie on the bounds.
  void check_edges(const std::vector<BSplineSurface>& faces, double trim_deviation) const {
    for (const BSplineSurface& face : faces) {
      const FaceMap map(face);
      const std::vector<double> areas = map.areas();
      for (std::size_t i = 0; i < areas.size(); ++i) CHECK((areas[i] > 0) == (i == 0));
      for (const TrimLoop& loop : face.trims) {
        check_closed(loop);
        for (const ParameterCurve& curve : loop) {
          for (const double part : {0.0, 0.1, 0.3, 0.5, 0.6, 0.8, 0.9, 1.0}) {
            const auto [u, v] = evaluate(curve, part);
            const Vector3d p = map.point({u, v});
            CAPTURE(u, v, p.transpose());
            CHECK(map.holds({u, v}));
            if (curve.degree == 1) continue;
            CHECK(std::abs(excess(input_.bounds, p)) <= trim_deviation + kRounding * size_);
          }
        }
      }
    }
    // For bodies of some millimetres, and in proportion for others.
    CHECK(trim_deviation <= 1e-9 * size_ / 4);
  }

  /// Places are inside the loops just when their points are inside the bounds, and every point of
  /// the quadric inside the bounds lies on one face.
  void check_coverage(const std::vector<BSplineSurface>& faces) {
    const double clear = kClear * (high_ - low_).norm();
    std::vector<FaceMap> maps;
    for (const BSplineSurface& face : faces) maps.emplace_back(face);
    for (const FaceMap& map : maps) {
      for (int i = 0; i < 12; ++i) {
        const Place place = map.at(uniform(), uniform());
        const Vector3d p = map.point(place);
        const double beyond = excess(input_.bounds, p);
        CAPTURE(place.transpose(), p.transpose(), beyond);
        if (maps.size() == 1 && std::abs(beyond) > clear) {
          CHECK(map.contains(place) == (beyond < 0));
        }
        if (beyond > clear) CHECK_FALSE(map.contains(place));
      }
    }
    const Vector3d margin = 0.05 * (high_ - low_) + Vector3d::Constant(clear);
    PointSource source(input_, equation_, low_ - margin, high_ + margin, random_);
    for (int i = 0; i < 24; ++i) {
      const std::optional<Vector3d> p = source.point();
      if (!p) continue;
      const double beyond = excess(input_.bounds, *p);
      if (std::abs(beyond) <= clear) continue;
      int times = 0;
      for (const FaceMap& map : maps) {
        const std::optional<Place> place = map.place_of(*p, margin, 1e-9 * size_);
        if (place && map.contains(*place)) ++times;
      }
      CAPTURE(p->transpose(), beyond);
      CHECK(times == (beyond < 0 ? 1 : 0));
    }
  }

  /// Identities, equation and certificate at random points.
  void check_points(const PNSurface& surface, const ChainNet& net) {
    const Certificate certificate = surface.certificate(Lines::kEven);
    const std::vector<BSplineSurface> faces = surface.faces(Lines::kEven);
    const std::vector<LinedSegment>& segments = net.segments();
    const std::size_t index = random_() % faces.size();
    const BSplineSurface& face = faces[index];
    const auto segment = std::find_if(segments.begin(), segments.end(), [&](const auto& s) {
      return s.begin == face.u_knots.front();
    });
    REQUIRE(segment != segments.end());
    const double first = face.v_knots.front(), last = face.v_knots.back();
    const double v = first + unit() * (last - first);
    const int arcs = net.places().front().arcs;
    const Place u = arcs == 0 ? Place(1 - v, v) : Place(circle_point(v, arcs));
    check_equation(*segment, unit(), u.x(), u.y(), net.precision());
    const double at = segment->begin + unit() * (segment->end - segment->begin);
    check_certificate(face, *segment, columns_of(face, net), at, v, surface.distance(),
                      certificate);
  }

  /// The columns of a face, over its own knots across or fewer.
  CircleColumns columns_of(const BSplineSurface& face, const ChainNet& net) const {
    const int arcs = net.places().front().arcs;
    if (arcs == 0) return straight_band(1, face.v_degree);
    return circle_part(static_cast<int>(face.v_knots.front()),
                       static_cast<int>(face.v_knots.back()), arcs, face.v_degree / 2);
  }

  /// The point is on the quadric, the normal along its gradient and on the right side.
  void check_equation(const LinedSegment& segment, double at, double c, double s, long precision) {
    const RealBall t = RealBall(at).at_precision(precision), u0(c), u1(s);
    CAPTURE(at, c, s);
    const bool is_pole = jet(segment.sections.weight, t, u0, u1).value.contains_zero();
    if (is_pole) return;
    check_identities(segment.sections, t, u0, u1);
    const EnclosedContact here = contact(segment.sections, t, u0, u1);
    const auto number = [&](const Rational& x) { return RealBall(x, precision); };
    const auto gradient = equation_.gradient(here.point, number);
    double size = 0, slope = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      size += std::abs((gradient[i] * here.point[i]).magnitude_upper());
      slope = std::max(slope, gradient[i].magnitude_upper());
    }
    CHECK(encloses_zero(equation_.value(here.point, number), kNarrow * (1 + size)));
    RealBall along;
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t j = (i + 1) % 3;
      CHECK(encloses_zero(here.normal[i] * gradient[j] - here.normal[j] * gradient[i],
                          kNarrow * slope));
      along += here.normal[i] * gradient[i];
    }
    CHECK((equation_.side > 0 ? along.is_positive() : along.is_negative()));
  }

  QuadricInput input_;
  Equation equation_;
  EnvelopeChain chain_;
  PNSurface surface_;
  std::mt19937_64 random_;
  Vector3d low_ = Vector3d::Constant(HUGE_VAL), high_ = -low_;  ///< the box around the region
  double size_ = 0;                                             ///< its largest coordinate
};

/// The code with which an input was refused; nothing when it passed every check.
std::optional<ErrorCode> check_quadric(const QuadricInput& input, std::uint64_t seed) {
  return code_of([&] { QuadricConcept(input, seed).check(); });
}

/// No point that is found on the quadric is well inside the bounds.
bool is_empty(const QuadricInput& input, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  const auto& [x, y, z] = input.extent;
  const Vector3d low(x.low, y.low, z.low), high(x.high, y.high, z.high);
  PointSource source(input, equation_of(input), low, high, random);
  for (int i = 0; i < 400; ++i) {
    const std::optional<Vector3d> p = source.point();
    if (p && excess(input.bounds, *p) < -1e-6 * (high - low).norm()) return false;
  }
  return true;
}

/// Whether what the input asks for is one of the things that docs/quadrics.md says are refused.
bool is_refused_by_rule(const QuadricInput& input, ErrorCode code, std::uint64_t seed) {
  const Interval& z = input.bounds.box[2];
  switch (code) {
    case ErrorCode::kRegionEmpty:
      return is_empty(input, seed);
    case ErrorCode::kNotRational:
      return input.half[0] != input.half[1];
    case ErrorCode::kRegionUnsupported:
      if (input.kind == QuadricKind::kParabolicCylinder) return input.bounds.angle || z.low > 0;
      return input.kind == QuadricKind::kEllipticCone && z.low <= 0 && z.high >= 0;
    default:
      return false;
  }
}

/// Whether it is what a region may turn out to be: too thin, touching itself, or with rulings or
/// circles that go too far for few faces.
bool is_refused_by_chance(ErrorCode code) {
  return code == ErrorCode::kRegionUnsupported || code == ErrorCode::kWeightsNotPositive;
}

TEST_CASE("Every quadric is exact and covers its region, no more", "[concept]") {
  const auto seed = static_cast<std::uint64_t>(number_from_environment("PN_TEST_SEED", 40240));
  const auto count = static_cast<std::uint64_t>(1000 * number_from_environment("PN_TEST_SCALE", 1));
  std::cout << "PN_TEST_SEED=" << seed << ", " << count << " random quadrics\n";
  std::map<std::pair<std::string, ErrorCode>, std::uint64_t> refused;
  std::uint64_t refusals = 0, by_chance = 0, one_sheet = 0;
  for (std::uint64_t i = 0; i < count; ++i) {
    const QuadricInput input = RandomQuadric(seed + i).input();
    INFO("RandomQuadric(" << seed + i << "): " << input);
    const std::optional<ErrorCode> code = check_quadric(input, seed + i);
    if (!code) continue;
    CAPTURE(to_string(*code));
    ++refused[{name_of(input.kind), *code}];
    ++refusals;
    if (is_refused_by_rule(input, *code, seed + i)) continue;
    CHECK(is_refused_by_chance(*code));
    ++(input.kind == QuadricKind::kOneSheetHyperboloid ? one_sheet : by_chance);
  }
  for (const auto& [reason, times] : refused) {
    std::cout << "  " << reason.first << " refused with " << to_string(reason.second) << ": "
              << times << "\n";
  }
  std::cout << "  accepted: " << count - refusals << "\n";
  CHECK(4 * refusals < count + 4);
  CHECK(25 * by_chance <= count + 25);
  // Boxes leave most of the circumference, for which there is no link of rulings.
  CHECK(20 * one_sheet <= count + 20);
}

}  // namespace
}  // namespace pn::test
