// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/bezier/region_trims.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>

#include "pn/bezier/ruling_band.hpp"
#include "pn/geometry_error.hpp"
#include "pn/isotropic/seam.hpp"

namespace pn {
namespace {

using Eigen::Matrix2cd;
using Eigen::Vector2d;
using Eigen::Vector3d;
using Point = std::array<double, 2>;

/// The circle parameter of a whole circle runs over [0, 4], that of a half over two of these.
constexpr double kAround = 4;
constexpr double kHalf = 2;
/// Places on an arc at which it is looked at for where it crosses a line between halves.
constexpr int kSamples = 128;
constexpr int kBisections = 60;
/// So near to a pole, in the link's parameter, a point counts as the pole.
constexpr double kAtPole = 1e-7;
/// The direction in which an arc leaves a pole is extrapolated from steps of this size along it.
constexpr double kLeavingStep = 1e-4;
/// A point inside the region is looked for so far to the side of an edge, and of a pole.
constexpr double kAside = 1e-5;
/// Paths of regions run near poles, where doubles resolve less than elsewhere.
constexpr double kParameterTolerance = 1e-12;

/// The link's parameters of the points of a region: (t, v).
class RegionParameters {
 public:
  RegionParameters(const BoundedRegion& region, const SectionNet& net)
      : region_(region), segment_(net.segments().front()), arcs_(net.faces().front().arcs) {}

  bool is_closed() const { return arcs_ > 0; }

  /// v of a normal on the circle of t, for t in the link; around the circle up to multiples of 4.
  double across(const ContactPoint& at) const {
    const Vector2d u = parameter_of(matrix(at.t), at.normal);
    if (!is_closed()) return u(1) / (u(0) + u(1));
    return circle_parameter(u(0), u(1), arcs_) * kAround / arcs_;
  }

  /// Whether the surface point with these parameters is in the region.
  bool contains(const Point& at) const {
    const Vector2d u = direction(at[1]);
    const Eigen::Vector2cd a = matrix(at[0]) * u;
    const double size = a.squaredNorm();
    const std::complex<double> mixed = std::conj(a(0)) * a(1);
    const Vector3d normal(2 * mixed.real() / size, 2 * mixed.imag() / size,
                          (std::norm(a(0)) - std::norm(a(1))) / size);
    return region_.contains(normal);
  }

 private:
  Matrix2cd matrix(double t) const {
    return value_at(segment_.lines, (t - segment_.begin) / (segment_.end - segment_.begin));
  }
  Vector2d direction(double v) const {
    if (!is_closed()) return {1 - v, v};
    return circle_point(v * arcs_ / kAround, arcs_);
  }

  const BoundedRegion& region_;
  const LinedSegment& segment_;
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

Point reversed_at(const ParameterPath& path, double s) { return path(1 - s); }

class RegionTrimmer {
 public:
  RegionTrimmer(const EnvelopeChain& chain, const SectionNet& net)
      : region_(std::get<BoundedRegion>(chain.extent)),
        net_(net),
        parameters_(std::make_shared<RegionParameters>(region_, net)) {
    for (const auto& loop : region_.loops) add_loop(loop);
  }

  std::vector<FaceTrims> trims() const {
    std::vector<FaceTrims> result;
    for (std::size_t i = 0; i < net_.faces().size(); ++i) {
      if (region_.loops.empty()) {
        result.emplace_back();
      } else {
        result.push_back(joined(parameters_->is_closed() ? edges_of_half(i) : edges_of_band()));
      }
    }
    return result;
  }

 private:
  /// Cuts the arcs of a loop at the lines between halves, with corners shared by neighbours.
  void add_loop(const std::vector<BoundaryArc>& loop) {
    std::vector<Stretch> stretches;
    for (const BoundaryArc& arc : loop) {
      const ArcPath path(parameters_, arc);
      std::vector<double> cuts = {0};
      if (parameters_->is_closed()) {
        for (const double s : line_crossings(path)) cuts.push_back(s);
      }
      cuts.push_back(1);
      for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
        stretches.push_back({path, cuts[i], cuts[i + 1], {}, {}});
      }
    }
    fix_corners(stretches);
    stretches_.insert(stretches_.end(), stretches.begin(), stretches.end());
  }

  /// Where v is a multiple of 2.
  std::vector<double> line_crossings(const ArcPath& path) const {
    const auto from_line = [&](double s) {
      const double v = path.at(s, kAround / 2)[1];
      return v - kHalf * std::round(v / kHalf);
    };
    std::vector<double> result;
    for (int i = 0; i < kSamples; ++i) {
      double low = (i + 0.001) / kSamples, high = (i + 1.001) / kSamples;
      if (i == kSamples - 1) high = 1 - 0.001 / kSamples;
      const double at_low = from_line(low), at_high = from_line(high);
      const bool jumps = std::abs(at_low - at_high) > kHalf / 2;
      if (jumps || (at_low < 0) == (at_high < 0)) continue;
      for (int k = 0; k < kBisections; ++k) {
        const double middle = (low + high) / 2;
        ((from_line(middle) < 0) == (at_low < 0) ? low : high) = middle;
      }
      result.push_back((low + high) / 2);
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
    const bool is_cut = s > 0 && s < 1;
    if (is_cut) p[1] = kHalf * std::round(p[1] / kHalf);
    if (parameters_->is_closed() && p[1] >= kAround) p[1] -= kAround;
    return p;
  }

  Point moved(Point p, double centre) const {
    if (parameters_->is_closed()) p[1] -= kAround * std::round((p[1] - centre) / kAround);
    // The line at the far end of the second half is the one at the start of the first.
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
    const ParameterPath back = [path](double s) { return reversed_at(path, s); };
    return {{interpolated(back, kParameterTolerance), back}, finish, start};
  }

  std::vector<FaceEdge> edges_of_band() const {
    std::vector<FaceEdge> edges;
    for (const Stretch& stretch : stretches_) edges.push_back(edge_of(stretch, 0));
    return edges;
  }

  std::vector<FaceEdge> edges_of_half(std::size_t half) const {
    const double low = kHalf * static_cast<double>(half), centre = low + 1, high = low + kHalf;
    std::vector<FaceEdge> edges;
    for (const Stretch& stretch : stretches_) {
      const Point middle = stretch.path.at((stretch.begin + stretch.end) / 2, centre);
      if (middle[1] > low && middle[1] < high) edges.push_back(edge_of(stretch, centre));
    }
    const BSplineSurface& frame = net_.faces()[half].frame;
    const double first = frame.u_knots.front(), last = frame.u_knots.back();
    for (const auto& [from, to] : stretches_inside(first, last, stops_on_line(low), [&](double t) {
           return Point{t, low};
         })) {
      edges.push_back(straight({from, low}, {to, low}));
    }
    for (const auto& [from, to] : stretches_inside(first, last, stops_on_line(high), [&](double t) {
           return Point{t, high};
         })) {
      edges.push_back(straight({to, high}, {from, high}));
    }
    for (const double pole : {first, last}) {
      if (pole != 0 && pole != 1) continue;
      const double aside = pole == 0 ? kAside : 1 - kAside;
      for (const auto& [from, to] :
           stretches_inside(low, high, stops_at_pole(pole, centre), [&](double v) {
             return Point{aside, v};
           })) {
        edges.push_back(pole == 0 ? straight({pole, to}, {pole, from})
                                  : straight({pole, from}, {pole, to}));
      }
    }
    return edges;
  }

  static FaceEdge straight(const Point& start, const Point& finish) {
    return {{straight_line(start, finish), {}}, start, finish};
  }

  /// t of the corners on the line at v.
  std::vector<double> stops_on_line(double v) const {
    std::vector<double> stops;
    for (const Stretch& stretch : stretches_) {
      if (stretch.start[1] == std::fmod(v, kAround)) stops.push_back(stretch.start[0]);
    }
    return stops;
  }

  /// v of the corners at a pole, in the half of this centre.
  std::vector<double> stops_at_pole(double pole, double centre) const {
    std::vector<double> stops;
    for (const Stretch& stretch : stretches_) {
      for (const Point& end : {stretch.start, stretch.finish}) {
        const double v = moved(end, centre)[1];
        if (end[0] == pole && std::abs(v - centre) < kHalf / 2) stops.push_back(v);
      }
    }
    return stops;
  }

  /// The intervals between stops whose middle is inside the region.
  template <class PointAt>
  std::vector<std::array<double, 2>> stretches_inside(double first, double last,
                                                      std::vector<double> stops,
                                                      const PointAt& point_at) const {
    stops.push_back(first);
    stops.push_back(last);
    std::sort(stops.begin(), stops.end());
    std::vector<std::array<double, 2>> inside;
    for (std::size_t i = 0; i + 1 < stops.size(); ++i) {
      if (stops[i] == stops[i + 1]) continue;
      if (parameters_->contains(point_at((stops[i] + stops[i + 1]) / 2))) {
        inside.push_back({stops[i], stops[i + 1]});
      }
    }
    return inside;
  }

  /// The edges end to end.
  static FaceTrims joined(std::vector<FaceEdge> edges) {
    FaceTrims loops;
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
  const SectionNet& net_;
  std::shared_ptr<const RegionParameters> parameters_;
  std::vector<Stretch> stretches_;
};

}  // namespace

std::vector<FaceTrims> region_trims(const EnvelopeChain& chain, const SectionNet& net) {
  return RegionTrimmer(chain, net).trims();
}

}  // namespace pn
