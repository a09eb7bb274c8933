// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/bezier/self_intersection.hpp"

#include <Eigen/Dense>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <memory>
#include <mutex>
#include <numeric>

#include "pn/algebra/parallel.hpp"
#include "pn/algebra/tensor_bernstein.hpp"
#include "pn/bezier/normal_patch.hpp"
#include "pn/bezier/trim_region.hpp"

namespace pn {
namespace {

using Box = Eigen::AlignedBox3d;
using Eigen::Matrix;
using Eigen::Matrix3Xd;
using Eigen::RowVectorXd;
using Eigen::Vector3d;
using Eigen::Vector4d;

/// Points as near as this part of the largest coordinate are one: a hundred times what rounding
/// leaves of a point, and far less than what could be built.
constexpr double kSamePlace = 1e-12;
/// Newton's method is begun on pieces whose normals turn by so little, where it seldom fails,
constexpr double kGentle = 0.3;
/// takes a step or two more than to double the digits from one to sixteen,
constexpr int kMostSteps = 8;
/// and may leave them by half their sides, so that crossings on their edges are found.
constexpr double kMargin = 0.5;
/// Normals that turn by so much [rad] are as good a reason to halve a piece as all of its length.
/// Twice kLeastFold would not do: neighbours that turn by it would not be told from sheets that
/// cross, however short they are.
constexpr double kLargeTurn = 1.0 / 3;
/// Pairs of pieces of two knot rectangles; only sheets that touch along a curve need as many.
constexpr int kMostPairs = 50000;
/// Pairs of knot rectangles that are looked at together: enough for any number of threads.
constexpr std::size_t kPairsAtOnce = 4096;
/// A surface with so many pairs that cross does so all over: a pipe as wide as its spine is long.
/// The others, which may be millions, are not looked at then.
constexpr std::size_t kEnough = 256;
/// A parameter on the side of a face differs from it by rounding, in knot spans.
constexpr double kAtSide = 1e-9;
/// Where the parts beside a corner are bent, they overlap a little farther than straight ones.
constexpr double kCornerMargin = 1.125;

std::size_t index_of(Variable variable) { return variable == Variable::kU ? 0 : 1; }

/// What the pieces of one face have in common. Their places count knot spans, so that halves are
/// exact and neighbouring faces agree.
struct Face {
  std::size_t index;
  const BSplineSurface* surface;
  TrimRegion region;
  std::array<double, 2> spans;                   ///< their number in u and v
  std::array<bool, 2> closed;                    ///< its first and last line in u or v are one
  std::array<std::array<bool, 2>, 2> collapsed;  ///< its first and last line in u or v are points

  const std::vector<double>& knots(Variable variable) const {
    return variable == Variable::kU ? surface->u_knots : surface->v_knots;
  }
  double parameter(Variable variable, double place) const {
    const std::vector<double>& knots = this->knots(variable);
    const auto last = static_cast<double>(knots.size()) - 2;
    const auto span = static_cast<std::size_t>(std::clamp(std::floor(place), 0.0, last));
    return knots[span] + (place - static_cast<double>(span)) * (knots[span + 1] - knots[span]);
  }
  Rectangle parameters(const Rectangle& place) const {
    const auto corner = [&](const std::array<double, 2>& at) -> std::array<double, 2> {
      return {parameter(Variable::kU, at[0]), parameter(Variable::kV, at[1])};
    };
    return {corner(place.low), corner(place.high)};
  }
};

/// The poles of the first or last line of a face.
std::vector<std::array<double, 3>> side(const BSplineSurface& surface, Variable across, bool last) {
  const std::size_t rows = surface.u_count(), columns = surface.v_count();
  std::vector<std::array<double, 3>> poles;
  if (across == Variable::kU) {
    const std::size_t row = last ? rows - 1 : 0;
    for (std::size_t j = 0; j < columns; ++j) poles.push_back(surface.poles[row * columns + j]);
  } else {
    const std::size_t column = last ? columns - 1 : 0;
    for (std::size_t i = 0; i < rows; ++i) poles.push_back(surface.poles[i * columns + column]);
  }
  return poles;
}

bool is_point(const std::vector<std::array<double, 3>>& poles, double same_place) {
  const auto is_there = [&](const std::array<double, 3>& p) {
    const auto& q = poles.front();
    return std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]) <= same_place;
  };
  return std::all_of(poles.begin(), poles.end(), is_there);
}

Face face_of(const SectionFace& face, std::size_t index, double same_place) {
  const BSplineSurface& s = *face.surface;
  Face result{index, &s, TrimRegion(s.trims), {}, {}, {}};
  for (const Variable variable : {Variable::kU, Variable::kV}) {
    const std::size_t i = index_of(variable);
    const auto first = side(s, variable, false), last = side(s, variable, true);
    result.spans[i] = static_cast<double>(result.knots(variable).size() - 1);
    result.closed[i] = first == last;
    result.collapsed[i] = {is_point(first, same_place), is_point(last, same_place)};
  }
  return result;
}

/// How two faces are glued: the second follows the first across u or v, and the other way round.
struct Gluing {
  std::array<bool, 2> follows, precedes;
};

Gluing gluing(const Face& a, const Face& b) {
  Gluing result = {};
  for (const Variable across : {Variable::kU, Variable::kV}) {
    const Variable along = across == Variable::kU ? Variable::kV : Variable::kU;
    if (a.knots(along) != b.knots(along)) continue;
    const auto is_glued = [&](const Face& before, const Face& after) {
      return side(*before.surface, across, true) == side(*after.surface, across, false);
    };
    result.follows[index_of(across)] = is_glued(a, b);
    result.precedes[index_of(across)] = is_glued(b, a);
  }
  return result;
}

/// A piece of a face, halved on demand.
class Piece {
 public:
  Piece(const Face& face, const NormalPatch& root, NormalPatch patch, const Rectangle& place,
        TrimRegion::Part part)
      : face_(&face), root_(&root), patch_(std::move(patch)), place_(place), part_(part) {
    // A piece that is whole has whole halves, and one that is outside is not halved.
    if (part == TrimRegion::Part::kSome) part_ = face.region.part_of(face.parameters(place));
    box_ = Box(poles().rowwise().minCoeff(), poles().rowwise().maxCoeff());
    normals_ = patch_.normal_cone();
    for (const Variable variable : {Variable::kU, Variable::kV}) {
      const std::size_t i = index_of(variable);
      tangents_[i] = patch_.tangent_cone(variable);
      length_[i] = patch_.length(variable);
    }
  }

  const Face& face() const { return *face_; }
  const NormalPatch& root() const { return *root_; }
  const Rectangle& place() const { return place_; }
  const Matrix3Xd& poles() const { return patch_.poles(); }
  const Box& box() const { return box_; }
  double size() const { return box_.diagonal().norm(); }
  double width() const { return std::min(length_[0], length_[1]); }
  bool is_outside() const { return part_ == TrimRegion::Part::kNone; }
  bool is_gentle() const { return normals_ && normals_->half_angle < kGentle; }
  const std::optional<DirectionCone>& normals() const { return normals_; }
  const std::optional<DirectionCone>& tangents(Variable variable) const {
    return tangents_[index_of(variable)];
  }

  /// Thread-safe: pairs of pieces share their halves.
  const std::array<Piece, 2>& halves() const {
    std::call_once(divided_, [&] {
      const Variable variable = halving_variable();
      std::array<NormalPatch, 2> patches = patch_.halved(variable);
      const std::array<Rectangle, 2> places = place_.halved(variable);
      halves_ = std::unique_ptr<std::array<Piece, 2>>(
          new std::array<Piece, 2>{Piece(*face_, *root_, std::move(patches[0]), places[0], part_),
                                   Piece(*face_, *root_, std::move(patches[1]), places[1], part_)});
    });
    return *halves_;
  }

 private:
  /// The one along which it is longer, compared with its size, and its normals turn more.
  Variable halving_variable() const {
    const double size = std::max(length_[0], length_[1]);
    const auto extent = [&](Variable variable) {
      return length_[index_of(variable)] / size + patch_.turn(variable) / kLargeTurn;
    };
    return extent(Variable::kU) >= extent(Variable::kV) ? Variable::kU : Variable::kV;
  }

  const Face* face_;
  const NormalPatch* root_;
  NormalPatch patch_;
  Rectangle place_;
  TrimRegion::Part part_;
  Box box_;
  std::optional<DirectionCone> normals_;
  std::array<std::optional<DirectionCone>, 2> tangents_;
  std::array<double, 2> length_;
  mutable std::once_flag divided_;
  mutable std::unique_ptr<std::array<Piece, 2>> halves_;
};

bool is_separated_along(const Vector3d& direction, const Piece& a, const Piece& b) {
  const RowVectorXd at_a = direction.transpose() * a.poles(),
                    at_b = direction.transpose() * b.poles();
  return at_a.maxCoeff() < at_b.minCoeff() || at_b.maxCoeff() < at_a.minCoeff();
}

/// The convex hulls are disjoint, seen from directions that belong to the pieces.
bool is_separated(const Piece& a, const Piece& b) {
  if (is_separated_along(b.box().center() - a.box().center(), a, b)) return true;
  for (const Piece* piece : {&a, &b}) {
    const auto& normals = piece->normals();
    if (normals && is_separated_along(normals->axis, a, b)) return true;
    for (const Variable variable : {Variable::kU, Variable::kV}) {
      const auto& tangents = piece->tangents(variable);
      if (tangents && is_separated_along(tangents->axis, a, b)) return true;
    }
  }
  return false;
}

/// The point to which the side of its face shrinks that a piece touches.
std::optional<Vector3d> pole_of(const Piece& piece) {
  const Face& face = piece.face();
  for (const Variable across : {Variable::kU, Variable::kV}) {
    const std::size_t i = index_of(across);
    for (const bool last : {false, true}) {
      const bool touches =
          last ? piece.place().high[i] == face.spans[i] : piece.place().low[i] == 0;
      if (!touches || !face.collapsed[i][last ? 1 : 0]) continue;
      return Vector3d(side(*face.surface, across, last).front().data());
    }
  }
  return std::nullopt;
}

/// The pole that both touch, where all lines meet that lead to it.
std::optional<Vector3d> common_pole(const Piece& a, const Piece& b, double same_place) {
  const auto p = pole_of(a), q = pole_of(b);
  if (!p || !q || (*p - *q).norm() > same_place) return std::nullopt;
  return p;
}

/// Two pieces have a common pole and no other common point: a plane through it is between them.
bool is_separated_at(const Vector3d& pole, const Piece& a, const Piece& b, double same_place) {
  const Vector3d direction =
      (b.box().center() - pole).normalized() - (a.box().center() - pole).normalized();
  const auto is_ahead = [&](const Piece& piece, double sign) {
    for (const auto& p : piece.poles().colwise()) {
      if ((p - pole).norm() > same_place && !(sign * direction.dot(p - pole) > 0)) return false;
    }
    return true;
  };
  return is_ahead(a, -1) && is_ahead(b, 1);
}

/// They share a point of the glued parameter plane.
bool do_touch(const Piece& a, const Piece& b, const Gluing& gluing) {
  const bool same_face = &a.face() == &b.face();
  std::array<bool, 2> overlap, meet;
  for (std::size_t i = 0; i < 2; ++i) {
    const double a_end = a.face().spans[i], b_end = b.face().spans[i];
    const bool b_follows = a.place().high[i] == a_end && b.place().low[i] == 0;
    const bool b_precedes = b.place().high[i] == b_end && a.place().low[i] == 0;
    const bool is_closed = a.face().closed[i] && b.face().closed[i];
    overlap[i] = (a.place().low[i] <= b.place().high[i] && b.place().low[i] <= a.place().high[i]) ||
                 (is_closed && (b_follows || b_precedes));
    meet[i] = (gluing.follows[i] && b_follows) || (gluing.precedes[i] && b_precedes);
  }
  if (same_face) return overlap[0] && overlap[1];
  return (meet[0] && overlap[1]) || (overlap[0] && meet[1]);
}

/// The surface is injective on the union of two pieces that touch.
bool is_injective(const Piece& a, const Piece& b) {
  const auto &au = a.tangents(Variable::kU), &av = a.tangents(Variable::kV),
             &bu = b.tangents(Variable::kU), &bv = b.tangents(Variable::kV);
  return au && av && bu && bv && are_independent(joined(*au, *bu), joined(*av, *bv));
}

/// No point of one and point of the other have tangent planes that cross.
bool are_nearly_parallel(const Piece& a, const Piece& b) {
  if (!a.normals() || !b.normals()) return false;
  const DirectionCone &n = *a.normals(), &k = *b.normals();
  const double angle = angle_between(n.axis, k.axis), spread = n.half_angle + k.half_angle;
  return angle + spread < kLeastFold || M_PI - angle + spread < kLeastCrossing;
}

bool do_cross(const Vector3d& n, const Vector3d& k) {
  return angle_between(n, k) >= kLeastFold && angle_between(n, -k) >= kLeastCrossing;
}

/// The ball around a corner of the spine that holds the overlap on its inner side.
struct CornerBall {
  std::size_t zone;
  Vector3d centre;
  double radius;
};

/// The unit vector along the axis of the circle of normals on the first or last line of a zone.
Vector3d circle_axis(const BSplineSurface& normal, bool last) {
  const auto normals = side(normal, Variable::kU, last);
  const auto at = [&](std::size_t i) -> Vector3d { return Vector3d(normals[i].data()); };
  return (at(1) - at(0)).cross(at(2) - at(0)).normalized();
}

CornerBall corner_ball(const SectionFace& zone, std::size_t index) {
  // x = m + rho n with the same weights, so the poles lie likewise.
  const auto &poles = zone.surface->poles, &normals = zone.normal->poles;
  const std::size_t other = zone.surface->v_count() / 2;
  const Vector3d x(poles[0].data()), y(poles[other].data()), n(normals[0].data()),
      k(normals[other].data());
  const double rho = (x - y).dot(n - k) / (n - k).squaredNorm();
  const double cosine =
      circle_axis(*zone.normal, false).dot(circle_axis(*zone.normal, true));  // of the turn
  return {index, x - rho * n, kCornerMargin * std::abs(rho) / std::sqrt((1 + cosine) / 2)};
}

/// A section prepared for the search.
struct Section {
  double size, same_place;
  std::vector<Face> faces;
  std::vector<NormalPatch> patches;
  std::vector<std::unique_ptr<Piece>> pieces;
  std::vector<CornerBall> corners;

  /// Both faces are the zone or beside it, and the point is where they overlap.
  bool is_at_corner(const Vector3d& point, std::size_t a, std::size_t b) const {
    return std::any_of(corners.begin(), corners.end(), [&](const CornerBall& ball) {
      const auto is_beside = [&](std::size_t face) {
        const std::size_t distance = (face + faces.size() - ball.zone) % faces.size();
        return distance <= 1 || distance + 1 == faces.size();
      };
      return is_beside(a) && is_beside(b) && (point - ball.centre).norm() <= ball.radius;
    });
  }
};

/// A point of two pieces.
struct Meeting {
  SelfIntersection crossing;
  bool is_at_corner;
};

/// Newton's method for x(p) = y(q), three equations with four unknowns: of least change.
class MeetingSearch {
 public:
  MeetingSearch(const Section& section, const Piece& a, const Piece& b)
      : section_(section), pieces_{&a, &b} {
    for (std::size_t i = 0; i < 4; ++i) {
      const Rectangle& place = pieces_[i / 2]->place();
      length_(static_cast<Eigen::Index>(i)) = place.high[i % 2] - place.low[i % 2];
      at_(static_cast<Eigen::Index>(i)) = (place.high[i % 2] + place.low[i % 2]) / 2;
    }
  }

  std::optional<Meeting> found() {
    const Vector4d start = at_;
    for (int step = 0; step < kMostSteps; ++step) {
      const std::array<SurfaceJet, 2> jets = {jet(0), jet(1)};
      const Vector3d gap = jets[0].point - jets[1].point;
      Matrix<double, 3, 4> slopes;
      slopes << jets[0].u, jets[0].v, -jets[1].u, -jets[1].v;
      if (gap.norm() <= section_.same_place) return meeting(jets, slopes);
      slopes = slopes * length_.asDiagonal();
      at_ -= length_.cwiseProduct(slopes.completeOrthogonalDecomposition().solve(gap));
      const auto moved = ((at_ - start).array() / length_.array()).abs();
      if (!(moved.maxCoeff() <= 0.5 + kMargin)) return std::nullopt;
    }
    return std::nullopt;
  }

 private:
  double place(std::size_t which, std::size_t variable) const {
    return at_(static_cast<Eigen::Index>(2 * which + variable));
  }
  /// The corner of the knot rectangle of a piece.
  double origin(std::size_t which, std::size_t variable) const {
    return std::floor(pieces_[which]->place().low[variable]);
  }
  SurfaceJet jet(std::size_t which) const {
    return pieces_[which]->root().at(place(which, 0) - origin(which, 0),
                                     place(which, 1) - origin(which, 1));
  }

  std::optional<Meeting> meeting(const std::array<SurfaceJet, 2>& jets,
                                 const Matrix<double, 3, 4>& slopes) const {
    if (!do_cross(jets[0].normal, jets[1].normal)) return std::nullopt;
    const double angle = unoriented_angle(jets[0].normal, jets[1].normal);
    if (!is_inside(0) || !is_inside(1)) return std::nullopt;
    if (is_on_collapsed_side(0) && is_on_collapsed_side(1)) return std::nullopt;
    // Where both circles shrink to the point of a spine nothing crosses: all is along one line.
    const Eigen::JacobiSVD<Matrix<double, 3, 4>> values(slopes);
    if (values.singularValues()(1) < kResolution * section_.size) return std::nullopt;
    const Vector3d x = (jets[0].point + jets[1].point) / 2;
    const std::array<FacePoint, 2> places = {face_point(0), face_point(1)};
    return Meeting{{{x.x(), x.y(), x.z()}, places, angle},
                   section_.is_at_corner(x, places[0].face, places[1].face)};
  }

  FacePoint face_point(std::size_t which) const {
    const Face& face = pieces_[which]->face();
    return {face.index, face.parameter(Variable::kU, place(which, 0)),
            face.parameter(Variable::kV, place(which, 1))};
  }
  /// In the knot rectangle and in the trims.
  bool is_inside(std::size_t which) const {
    for (std::size_t i = 0; i < 2; ++i) {
      const double local = place(which, i) - origin(which, i);
      if (local < 0 || local > 1) return false;
    }
    const FacePoint point = face_point(which);
    return pieces_[which]->face().region.contains({point.u, point.v});
  }
  bool is_on_collapsed_side(std::size_t which) const {
    const Face& face = pieces_[which]->face();
    for (std::size_t i = 0; i < 2; ++i) {
      if (face.collapsed[i][0] && place(which, i) < kAtSide) return true;
      if (face.collapsed[i][1] && place(which, i) > face.spans[i] - kAtSide) return true;
    }
    return false;
  }

  const Section& section_;
  std::array<const Piece*, 2> pieces_;
  Vector4d at_, length_;
};

using Crossing = std::optional<SelfIntersection>;

/// The one at the wider angle; the first of two at the same.
Crossing wider(const Crossing& a, const Crossing& b) {
  if (!a || !b) return a ? a : b;
  return b->angle > a->angle ? b : a;
}

/// The crossings of the pieces of two knot rectangles.
class PairSearch {
 public:
  explicit PairSearch(const Section& section) : section_(section) {}

  void search(const Piece& a) {
    if (a.is_outside() || is_too_narrow(a) || is_injective(a, a) || are_nearly_parallel(a, a)) {
      return;
    }
    if (++pairs_ > kMostPairs) return;
    const auto& [first, second] = a.halves();
    search(first);
    search(second);
    search(first, second, {});
  }

  void search(const Piece& a, const Piece& b, const Gluing& gluing) {
    if (a.is_outside() || b.is_outside() || !a.box().intersects(b.box())) return;
    if (are_nearly_parallel(a, b)) return;
    if (do_touch(a, b, gluing)) {
      if (is_injective(a, b)) return;
    } else if (const auto pole = common_pole(a, b, section_.same_place)) {
      if (is_separated_at(*pole, a, b, section_.same_place)) return;
    } else if (is_separated(a, b)) {
      return;
    } else if (a.is_gentle() && b.is_gentle()) {
      if (const auto meeting = MeetingSearch(section_, a, b).found()) {
        if (!meeting->is_at_corner) widest_ = wider(widest_, meeting->crossing);
        return;
      }
    }
    if (is_too_narrow(a) || is_too_narrow(b) || ++pairs_ > kMostPairs) return;
    if (a.size() >= b.size()) {
      for (const Piece& half : a.halves()) search(half, b, gluing);
    } else {
      for (const Piece& half : b.halves()) search(a, half, gluing);
    }
  }

  const Crossing& widest() const { return widest_; }

 private:
  bool is_too_narrow(const Piece& piece) const {
    return piece.width() < kResolution * section_.size;
  }

  const Section& section_;
  Crossing widest_;
  int pairs_ = 0;
};

Section prepared(const std::vector<SectionFace>& faces) {
  Section section{};
  Box box;
  double largest = 0;
  for (const SectionFace& face : faces) {
    for (const auto& pole : face.surface->poles) {
      const Vector3d p(pole.data());
      box.extend(p);
      largest = std::max(largest, p.lpNorm<Eigen::Infinity>());
    }
  }
  section.size = box.diagonal().norm();
  section.same_place = kSamePlace * largest;
  std::vector<std::size_t> first_patch = {0};
  std::vector<std::vector<NormalPatch>> patches(faces.size());
  for_each_index(faces.size(), [&](std::size_t i) {
    const auto& [surface, normal, stands_still] = faces[i];
    patches[i] = normal ? normal_patches(*surface, *normal) : normal_patches(*surface);
  });
  for (std::size_t i = 0; i < faces.size(); ++i) {
    section.faces.push_back(face_of(faces[i], i, section.same_place));
    if (faces[i].stands_still) section.corners.push_back(corner_ball(faces[i], i));
    for (NormalPatch& patch : patches[i]) section.patches.push_back(std::move(patch));
    first_patch.push_back(section.patches.size());
  }
  section.pieces.resize(section.patches.size());
  for_each_index(faces.size(), [&](std::size_t i) {
    const auto columns = static_cast<std::size_t>(section.faces[i].spans[1]);
    for (std::size_t k = first_patch[i]; k < first_patch[i + 1]; ++k) {
      const auto u = static_cast<double>((k - first_patch[i]) / columns),
                 v = static_cast<double>((k - first_patch[i]) % columns);
      const NormalPatch& patch = section.patches[k];
      section.pieces[k] =
          std::make_unique<Piece>(section.faces[i], patch, patch, Rectangle{{u, v}, {u + 1, v + 1}},
                                  TrimRegion::Part::kSome);
    }
  });
  return section;
}

using Pieces = std::vector<std::unique_ptr<Piece>>;
using Pair = std::array<std::size_t, 2>;

/// The pairs of pieces whose boxes overlap, each with itself too, by a sweep along the longest side
/// of the whole.
class Sweep {
 public:
  explicit Sweep(const Pieces& pieces) : pieces_(pieces), order_(pieces.size()) {
    Box whole;
    for (const auto& piece : pieces) whole.extend(piece->box());
    whole.sizes().maxCoeff(&along_);
    std::iota(order_.begin(), order_.end(), std::size_t{0});
    std::stable_sort(order_.begin(), order_.end(), [&](std::size_t a, std::size_t b) {
      return pieces[a]->box().min()(along_) < pieces[b]->box().min()(along_);
    });
  }

  /// The next pairs, kPairsAtOnce and some more; none at the end.
  std::vector<Pair> next() {
    std::vector<Pair> pairs;
    for (; first_ < order_.size() && pairs.size() < kPairsAtOnce; ++first_) {
      const std::vector<Pair> found = pairs_of_first();
      pairs.insert(pairs.end(), found.begin(), found.end());
    }
    return pairs;
  }

 private:
  std::vector<Pair> pairs_of_first() const {
    const std::size_t first = order_[first_];
    const Box& box = pieces_[first]->box();
    std::vector<Pair> pairs = {{first, first}};
    for (std::size_t j = first_ + 1; j < order_.size(); ++j) {
      const std::size_t other = order_[j];
      if (pieces_[other]->box().min()(along_) > box.max()(along_)) break;
      if (!box.intersects(pieces_[other]->box())) continue;
      pairs.push_back({std::min(first, other), std::max(first, other)});
    }
    return pairs;
  }

  const Pieces& pieces_;
  Eigen::Index along_ = 0;
  std::vector<std::size_t> order_;
  std::size_t first_ = 0;
};

Crossing widest_of(const Section& section, const Pair& pair) {
  const Piece &a = *section.pieces[pair[0]], &b = *section.pieces[pair[1]];
  PairSearch search(section);
  if (&a == &b) {
    search.search(a);
  } else {
    const bool same_face = &a.face() == &b.face();
    search.search(a, b, same_face ? Gluing{} : gluing(a.face(), b.face()));
  }
  return search.widest();
}

}  // namespace

std::optional<SelfIntersection> self_intersection(const std::vector<SectionFace>& faces) {
  const Section section = prepared(faces);
  Sweep sweep(section.pieces);
  Crossing widest;
  std::size_t found = 0;
  for (auto pairs = sweep.next(); !pairs.empty() && found < kEnough; pairs = sweep.next()) {
    std::vector<Crossing> crossings(pairs.size());
    for_each_index(pairs.size(),
                   [&](std::size_t i) { crossings[i] = widest_of(section, pairs[i]); });
    widest = std::accumulate(crossings.begin(), crossings.end(), widest, wider);
    found += static_cast<std::size_t>(std::count_if(
        crossings.begin(), crossings.end(), [](const Crossing& c) { return c.has_value(); }));
  }
  return widest;
}

}  // namespace pn
