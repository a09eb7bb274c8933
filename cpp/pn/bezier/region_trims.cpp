// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/bezier/region_trims.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>

#include "pn/bezier/region_lines.hpp"
#include "pn/geometry_error.hpp"
#include "pn/isotropic/seam.hpp"

namespace pn {
namespace {

using Eigen::Matrix2cd;
using Eigen::Vector2d;
using Eigen::Vector3d;
using Point = std::array<double, 2>;

/// The circle parameter of a whole circle runs over [0, 4].
constexpr double kAround = 4;
/// Places on an arc at which it is looked at for where it crosses a line between halves.
constexpr int kSamples = 128;
constexpr int kBisections = 60;
/// So near to a pole, in the link's parameter, a point counts as the pole.
constexpr double kAtPole = 1e-9;
/// The direction in which an arc leaves a pole is extrapolated from steps of this size along it.
constexpr double kLeavingStep = 1e-4;
/// A point inside the region is looked for so far to the side of an edge, and of a pole.
constexpr double kAside = 1e-5;
/// A corner so near to a line between faces lies on it: what rounding leaves of one that does.
constexpr double kOnLine = 1e-10;
/// Paths of regions run near poles, where doubles resolve less than elsewhere.
constexpr double kParameterTolerance = 1e-12;

/// The parameters (t, v) of the points of a region, common to all its faces.
class RegionParameters {
 public:
  RegionParameters(const BoundedRegion& region, const ChainNet& net)
      : region_(region), segments_(net.segments()), arcs_(net.places().front().arcs) {}

  bool is_closed() const { return arcs_ > 0; }
  /// Between the arcs around; beyond one, paths are only once differentiable.
  double knot_distance() const { return kAround / arcs_; }
  /// Where one segment ends and the next begins.
  std::vector<double> joints() const {
    std::vector<double> joints;
    for (std::size_t i = 1; i < segments_.size(); ++i) joints.push_back(segments_[i].begin);
    return joints;
  }

  /// v of a normal on the circle of t; around the circle up to multiples of 4.
  double across(const ContactPoint& at) const {
    const Vector2d u = parameter_of(matrix(at.t), at.normal);
    if (!is_closed()) return u(1) / (u(0) + u(1));
    return circle_parameter(u(0), u(1), arcs_) * kAround / arcs_;
  }

  /// Whether the surface point with these parameters is in the region.
  bool contains(const Point& at) const {
    const Eigen::Vector2cd a = matrix(at[0]) * direction(at[1]);
    const double size = a.squaredNorm();
    const std::complex<double> mixed = std::conj(a(0)) * a(1);
    const Vector3d normal(2 * mixed.real() / size, 2 * mixed.imag() / size,
                          (std::norm(a(0)) - std::norm(a(1))) / size);
    return region_.contains({at[0], normal});
  }

 private:
  Matrix2cd matrix(double t) const {
    std::size_t i = 0;
    while (i + 1 < segments_.size() && segments_[i + 1].begin <= t) ++i;
    const LinedSegment& segment = segments_[i];
    return value_at(segment.lines, (t - segment.begin) / (segment.end - segment.begin));
  }
  Vector2d direction(double v) const {
    if (!is_closed()) return {1 - v, v};
    return circle_point(v * arcs_ / kAround, arcs_);
  }

  const BoundedRegion& region_;
  std::vector<LinedSegment> segments_;
  int arcs_;
};

/// An arc of the boundary in parameters, with v near a given value.
class ArcPath {
 public:
  ArcPath(std::shared_ptr<const RegionParameters> parameters, BoundaryArc arc)
      : parameters_(std::move(parameters)), arc_(std::move(arc)) {}

  /// The point at s with v in the interval of this centre, for a closed region.
  Point at(double s, double centre) const {
    const ContactPoint contact = arc_(s);
    if (contact.t < kAtPole) return {0, leaving(s, centre)};
    if (contact.t > 1 - kAtPole) return {1, leaving(s, centre)};
    return {contact.t, near(parameters_->across(contact), centre)};
  }
  bool is_at_pole(double s) const {
    const double t = arc_(s).t;
    return t < kAtPole || t > 1 - kAtPole;
  }

 private:
  double near(double v, double centre) const {
    if (!parameters_->is_closed()) return v;
    return v - kAround * std::round((v - centre) / kAround);
  }
  /// v at an end of the arc that is a pole: the limit along the arc.
  double leaving(double s, double centre) const {
    const double step = s < 0.5 ? kLeavingStep : -kLeavingStep;
    const auto v = [&](int steps) {
      return near(parameters_->across(arc_(s + steps * step)), centre);
    };
    return 3 * v(1) - 3 * v(2) + v(3);
  }

  std::shared_ptr<const RegionParameters> parameters_;
  BoundaryArc arc_;
};

/// A part of an arc over [begin, end] of its parameter, with fixed corners.
struct Stretch {
  ArcPath path;
  double begin, end;
  Point start, finish;  ///< v in [0, 4) for a closed region
};

/// A directed edge of a face.
struct FaceEdge {
  TrimEdge edge;
  Point start, finish;
};

/// The parameter rectangle of a face.
struct Rectangle {
  std::array<double, 2> low, high;

  double centre() const { return (low[1] + high[1]) / 2; }
  bool holds(const Point& p) const {
    return p[0] > low[0] && p[0] < high[0] && p[1] > low[1] && p[1] < high[1];
  }
};

Rectangle rectangle_of(const FaceNet& face) {
  return {{face.frame.u_knots.front(), face.frame.v_knots.front()},
          {face.frame.u_knots.back(), face.frame.v_knots.back()}};
}

/// A point on a side of a rectangle, moved off a pole, where all v are one point.
Point beside_pole(Point p) {
  p[0] = std::clamp(p[0], kAside, 1 - kAside);
  return p;
}

/// The corners of the control polygons of a loop, which follow it closely enough to tell inside
/// from outside of other loops.
std::vector<Point> polygon(const TrimEdgeLoop& loop) {
  std::vector<Point> corners;
  for (const TrimEdge& edge : loop) {
    corners.insert(corners.end(), edge.curve.poles.begin(), edge.curve.poles.end() - 1);
  }
  return corners;
}

/// Twice the area inside, positive for a loop that runs counterclockwise.
double signed_area(const std::vector<Point>& polygon) {
  double area = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    area += a[0] * b[1] - a[1] * b[0];
  }
  return area;
}

bool is_inside(const Point& p, const std::vector<Point>& polygon) {
  bool inside = false;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    const bool crosses = (a[1] > p[1]) != (b[1] > p[1]);
    if (crosses && p[0] < a[0] + (p[1] - a[1]) / (b[1] - a[1]) * (b[0] - a[0])) inside = !inside;
  }
  return inside;
}

/// Loops by faces: every outer one with the holes inside it.
std::vector<std::vector<TrimEdgeLoop>> grouped(std::vector<TrimEdgeLoop> loops) {
  std::vector<std::vector<TrimEdgeLoop>> faces;
  std::vector<std::vector<Point>> outer;
  std::vector<TrimEdgeLoop> holes;
  for (TrimEdgeLoop& loop : loops) {
    std::vector<Point> corners = polygon(loop);
    if (signed_area(corners) < 0) {
      holes.push_back(std::move(loop));
      continue;
    }
    outer.push_back(std::move(corners));
    faces.push_back({std::move(loop)});
  }
  for (TrimEdgeLoop& hole : holes) {
    for (std::size_t i = 0; i < faces.size(); ++i) {
      if (!is_inside(hole.front().curve.poles.front(), outer[i])) continue;
      faces[i].push_back(std::move(hole));
      break;
    }
  }
  return faces;
}

class RegionTrimmer {
 public:
  RegionTrimmer(const EnvelopeChain& chain, const ChainNet& net)
      : region_(std::get<BoundedRegion>(chain.extent)),
        net_(net),
        parameters_(std::make_shared<RegionParameters>(region_, net)) {
    if (is_bounded_by_parallels(region_)) return;
    for (const auto& loop : region_.loops) add_loop(loop);
  }

  std::vector<TrimmedFace> faces() const {
    std::vector<TrimmedFace> result;
    for (std::size_t i = 0; i < net_.faces().size(); ++i) {
      if (is_bounded_by_parallels(region_)) {
        result.push_back({i, {}});
        continue;
      }
      for (auto& loops : grouped(joined(edges_of(rectangle_of(net_.faces()[i]))))) {
        result.push_back({i, std::move(loops)});
      }
    }
    return result;
  }

 private:
  /// Cuts the arcs of a loop at the knots around, with corners shared by neighbours.
  void add_loop(const std::vector<BoundaryArc>& loop) {
    std::vector<Stretch> stretches;
    for (const BoundaryArc& arc : loop) {
      const ArcPath path(parameters_, arc);
      const std::vector<double> places = samples(path);
      std::vector<double> cuts = {0};
      if (parameters_->is_closed()) {
        const auto at_knots = crossings(places, [&](double s) {
          const double v = path.at(s, kAround / 2)[1];
          return v - nearest_knot(v);
        });
        cuts.insert(cuts.end(), at_knots.begin(), at_knots.end());
      }
      for (const double joint : parameters_->joints()) {
        const auto at_joint =
            crossings(places, [&](double s) { return path.at(s, kAround / 2)[0] - joint; });
        cuts.insert(cuts.end(), at_joint.begin(), at_joint.end());
      }
      cuts.push_back(1);
      std::sort(cuts.begin(), cuts.end());
      for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
        stretches.push_back({path, cuts[i], cuts[i + 1], {}, {}});
      }
    }
    fix_corners(stretches);
    stretches_.insert(stretches_.end(), stretches.begin(), stretches.end());
  }

  double nearest_knot(double v) const {
    const double distance = parameters_->knot_distance();
    return distance * std::round(v / distance);
  }

  /// Places on an arc between which v changes little; near a pole it changes fast.
  static std::vector<double> samples(const ArcPath& path) {
    constexpr double kEnd = 1e-6;  // where an arc begins or ends on a line, it does not cross it
    std::vector<double> places = {kEnd};
    for (int i = 1; i <= kSamples; ++i) {
      add_samples(path, places, kEnd + (1 - 2 * kEnd) * i / kSamples);
    }
    return places;
  }
  static void add_samples(const ArcPath& path, std::vector<double>& places, double to) {
    constexpr double kSmallStep = 0.1, kShortest = 1e-10;
    const double from = places.back();
    const double change = path.at(to, kAround / 2)[1] - path.at(from, kAround / 2)[1];
    const bool is_small = std::abs(std::remainder(change, kAround)) <= kSmallStep;
    if (is_small || to - from <= kShortest) return places.push_back(to);
    add_samples(path, places, (from + to) / 2);
    add_samples(path, places, to);
  }

  /// The zeros of a function of s that are no jumps.
  template <class Function>
  static std::vector<double> crossings(const std::vector<double>& places, const Function& f) {
    std::vector<double> result;
    for (std::size_t i = 0; i + 1 < places.size(); ++i) {
      double low = places[i], high = places[i + 1];
      const double at_low = f(low), at_high = f(high);
      if ((at_low < 0) == (at_high < 0)) continue;
      for (int k = 0; k < kBisections; ++k) {
        const double middle = (low + high) / 2;
        ((f(middle) < 0) == (at_low < 0) ? low : high) = middle;
      }
      const double here = std::abs(f((low + high) / 2));
      if (here < std::min(std::abs(at_low), std::abs(at_high))) result.push_back((low + high) / 2);
    }
    return result;
  }

  /// At a pole both neighbours keep their own v; elsewhere the corner is that of the later one.
  void fix_corners(std::vector<Stretch>& stretches) const {
    for (std::size_t i = 0; i < stretches.size(); ++i) {
      Stretch& before = stretches[(i + stretches.size() - 1) % stretches.size()];
      Stretch& own = stretches[i];
      own.start = corner(own, own.begin);
      before.finish = own.path.is_at_pole(own.begin) ? corner(before, before.end) : own.start;
    }
  }

  Point corner(const Stretch& stretch, double s) const {
    Point p = stretch.path.at(s, kAround / 2);
    const Point q = on_line(p);
    const bool is_cut = s > 0 && s < 1;
    if (is_cut || std::hypot(p[0] - q[0], p[1] - q[1]) < kOnLine) p = q;
    if (parameters_->is_closed() && p[1] >= kAround) p[1] -= kAround;
    return p;
  }

  /// A point moved onto the nearest line between faces or at a knot.
  Point on_line(Point p) const {
    double nearest = HUGE_VAL;
    Point result = p;
    if (parameters_->is_closed()) {
      result[1] = nearest_knot(p[1]);
      nearest = std::abs(result[1] - p[1]);
    }
    for (const double joint : parameters_->joints()) {
      if (std::abs(p[0] - joint) >= nearest) continue;
      nearest = std::abs(p[0] - joint);
      result = {joint, p[1]};
    }
    return result;
  }

  Point moved(Point p, double centre) const {
    if (parameters_->is_closed()) p[1] -= kAround * std::round((p[1] - centre) / kAround);
    return p;
  }

  /// The stretch as an edge, run so that the region is on its left.
  FaceEdge edge_of(const Stretch& stretch, double centre) const {
    const Point start = moved(stretch.start, centre), finish = moved(stretch.finish, centre);
    const ParameterPath path = [=](double s) -> Point {
      if (s == 0) return start;
      if (s == 1) return finish;
      return stretch.path.at(stretch.begin + s * (stretch.end - stretch.begin), centre);
    };
    const Point a = path(0.5 - kAside), b = path(0.5 + kAside), middle = path(0.5);
    const Point aside = {middle[0] - (b[1] - a[1]) / 2, middle[1] + (b[0] - a[0]) / 2};
    if (parameters_->contains(aside)) {
      return {{interpolated(path, kParameterTolerance), path}, start, finish};
    }
    const ParameterPath back = [path](double s) { return path(1 - s); };
    return {{interpolated(back, kParameterTolerance), back}, finish, start};
  }

  std::vector<FaceEdge> edges_of(const Rectangle& face) const {
    std::vector<FaceEdge> edges;
    std::vector<Point> corners;
    for (const Stretch& stretch : stretches_) {
      corners.push_back(moved(stretch.start, face.centre()));
      corners.push_back(moved(stretch.finish, face.centre()));
      const double middle = (stretch.begin + stretch.end) / 2;
      if (face.holds(stretch.path.at(middle, face.centre()))) {
        edges.push_back(edge_of(stretch, face.centre()));
      }
    }
    // The sides counterclockwise: along t at low v, along v at high t, and back.
    const Point a = face.low, b = {face.high[0], face.low[1]}, c = face.high,
                d = {face.low[0], face.high[1]};
    for (const auto& [from, to] : {std::pair{a, b}, {b, c}, {c, d}, {d, a}}) {
      const std::vector<FaceEdge> stretches = edges_on_side(from, to, corners);
      edges.insert(edges.end(), stretches.begin(), stretches.end());
    }
    return edges;
  }

  /// The stretches of a side inside the region, between the corners that lie on it.
  std::vector<FaceEdge> edges_on_side(const Point& from, const Point& to,
                                      const std::vector<Point>& corners) const {
    const std::size_t along = from[0] == to[0] ? 1 : 0, across = 1 - along;
    const auto is_inside = [&](double x) { return (x - from[along]) * (x - to[along]) < 0; };
    std::vector<double> stops = {from[along], to[along]};
    for (const Point& corner : corners) {
      if (corner[across] == from[across] && is_inside(corner[along]))
        stops.push_back(corner[along]);
    }
    std::sort(stops.begin(), stops.end());
    if (from[along] > to[along]) std::reverse(stops.begin(), stops.end());
    std::vector<FaceEdge> edges;
    for (std::size_t i = 0; i + 1 < stops.size(); ++i) {
      if (stops[i] == stops[i + 1]) continue;
      Point start = from, finish = from, middle = from;
      start[along] = stops[i];
      finish[along] = stops[i + 1];
      middle[along] = (stops[i] + stops[i + 1]) / 2;
      if (parameters_->contains(beside_pole(middle))) edges.push_back(straight(start, finish));
    }
    return edges;
  }

  static FaceEdge straight(const Point& start, const Point& finish) {
    return {{straight_line(start, finish), {}}, start, finish};
  }

  /// The edges end to end.
  static std::vector<TrimEdgeLoop> joined(std::vector<FaceEdge> edges) {
    std::vector<TrimEdgeLoop> loops;
    while (!edges.empty()) {
      TrimEdgeLoop loop = {edges.back().edge};
      const Point start = edges.back().start;
      Point end = edges.back().finish;
      edges.pop_back();
      while (end != start) {
        const auto next = std::find_if(edges.begin(), edges.end(),
                                       [&](const FaceEdge& e) { return e.start == end; });
        if (next == edges.end()) {
          throw GeometryError(ErrorCode::kRegionUnsupported,
                              "The bounds touch a line between two faces; move one of them a "
                              "little.");
        }
        loop.push_back(next->edge);
        end = next->finish;
        edges.erase(next);
      }
      loops.push_back(std::move(loop));
    }
    return loops;
  }

  const BoundedRegion& region_;
  const ChainNet& net_;
  std::shared_ptr<const RegionParameters> parameters_;
  std::vector<Stretch> stretches_;
};

}  // namespace

std::vector<TrimmedFace> region_faces(const EnvelopeChain& chain, const ChainNet& net) {
  return RegionTrimmer(chain, net).faces();
}

}  // namespace pn
