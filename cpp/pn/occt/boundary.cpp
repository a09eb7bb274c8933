// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/occt/boundary.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>
#include <stdexcept>

namespace pn {
namespace {

using ParameterPoint = std::array<double, 2>;

// Relative difference of two equal ratios of rounded numbers: half an ulp from each of the four
// numbers and from each of the two products that are compared, rounded up.
constexpr double kRatioRounding = 4 * std::numeric_limits<double>::epsilon();

bool proportional(const std::vector<double>& a, const std::vector<double>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [&](double a_i, double b_i) {
    const double product = a_i * b.front();
    return std::abs(product - b_i * a.front()) <= kRatioRounding * product;
  });
}

double length(const std::vector<double>& knots) { return knots.back() - knots.front(); }

// Where a parameter lies in the interval of the knots, from 0 to 1.
double position(double parameter, const std::vector<double>& knots) {
  return (parameter - knots.front()) / length(knots);
}

// A position can be known only this well: knots far from zero have lost digits.
double position_rounding(const std::vector<double>& knots) {
  return kRatioRounding * std::max(std::abs(knots.front()), std::abs(knots.back())) / length(knots);
}

// Compares parameters of two curves by their positions.
class SamePosition {
 public:
  SamePosition(const std::vector<double>& a_knots, const std::vector<double>& b_knots)
      : a_(a_knots),
        b_(b_knots),
        rounding_(kRatioRounding + position_rounding(a_knots) + position_rounding(b_knots)) {}

  bool operator()(double a, double b) const {
    return std::abs(position(a, a_) - position(b, b_)) <= rounding_;
  }

 private:
  const std::vector<double>& a_;
  const std::vector<double>& b_;
  double rounding_;
};

bool affinely_equal(const std::vector<double>& a, const std::vector<double>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), SamePosition(a, b));
}

BoundaryCurve row(const BSplineSurface& s, std::size_t i) {
  BoundaryCurve curve{s.v_degree, s.v_knots, s.v_multiplicities, {}, {}};
  for (std::size_t j = 0; j < s.v_count(); ++j) {
    curve.poles.push_back(s.poles[i * s.v_count() + j]);
    curve.weights.push_back(s.weights[i * s.v_count() + j]);
  }
  return curve;
}

BoundaryCurve column(const BSplineSurface& s, std::size_t j) {
  BoundaryCurve curve{s.u_degree, s.u_knots, s.u_multiplicities, {}, {}};
  for (std::size_t i = 0; i < s.u_count(); ++i) {
    curve.poles.push_back(s.poles[i * s.v_count() + j]);
    curve.weights.push_back(s.weights[i * s.v_count() + j]);
  }
  return curve;
}

// The side on which the straight line between two points of the (u, v) plane lies.
std::optional<BoundaryCurve> side_through(const BSplineSurface& s, const ParameterPoint& from,
                                          const ParameterPoint& to) {
  if (from[0] == to[0] && to[0] == s.u_knots.front()) return row(s, 0);
  if (from[0] == to[0] && to[0] == s.u_knots.back()) return row(s, s.u_count() - 1);
  if (from[1] == to[1] && to[1] == s.v_knots.front()) return column(s, 0);
  if (from[1] == to[1] && to[1] == s.v_knots.back()) return column(s, s.v_count() - 1);
  return std::nullopt;
}

BoundaryPiece straight_piece(const BSplineSurface& surface, const ParameterPoint& from,
                             const ParameterPoint& to) {
  const auto curve = side_through(surface, from, to);
  if (!curve) return ParameterCurve{1, {0, 1}, {2, 2}, {from, to}};
  const std::size_t along = from[0] == to[0] ? 1 : 0;
  if (from[along] < to[along]) return SidePiece{*curve, from[along], to[along], from, to, true};
  return SidePiece{*curve, to[along], from[along], to, from, false};
}

void require(bool condition, const char* message) {
  if (!condition) throw std::invalid_argument(message);
}

bool is_finite(const ParameterPoint& point) {
  return std::isfinite(point[0]) && std::isfinite(point[1]);
}

void validate(const ParameterCurve& curve) {
  const auto& [degree, knots, multiplicities, poles] = curve;
  require(degree >= 1 && knots.size() >= 2 && multiplicities.size() == knots.size() &&
              multiplicities.front() == degree + 1 && multiplicities.back() == degree + 1 &&
              std::all_of(multiplicities.begin() + 1, multiplicities.end() - 1,
                          [d = degree](int m) { return 1 <= m && m <= d; }),
          "The knots of a trim do not fit its degree: it is a clamped, continuous B-spline curve.");
  require(std::adjacent_find(knots.begin(), knots.end(), std::not_fn(std::less<>())) == knots.end(),
          "The knots of a trim do not rise.");
  require(poles.size() == pole_count(degree, multiplicities),
          "The number of poles of a trim does not follow from its degree and multiplicities.");
  require(std::all_of(poles.begin(), poles.end(), is_finite), "A pole of a trim is not finite.");
}

// A curve passes through a pole where a knot has the multiplicity of the degree.
std::vector<ParameterCurve> cut_at_corners(const ParameterCurve& curve) {
  std::vector<ParameterCurve> pieces;
  ParameterCurve piece{curve.degree, {curve.knots[0]}, {curve.degree + 1}, {curve.poles[0]}};
  std::size_t pole = 1;
  for (std::size_t k = 1; k < curve.knots.size(); ++k) {
    const int multiplicity = curve.multiplicities[k];
    const std::size_t last_pole = pole + curve.degree - 1;
    piece.knots.push_back(curve.knots[k]);
    if (multiplicity < curve.degree) {
      piece.multiplicities.push_back(multiplicity);
      for (int i = 0; i < multiplicity; ++i) piece.poles.push_back(curve.poles[pole++]);
      continue;
    }
    piece.multiplicities.push_back(curve.degree + 1);
    for (; pole <= last_pole; ++pole) piece.poles.push_back(curve.poles[pole]);
    pieces.push_back(piece);
    piece = {curve.degree, {curve.knots[k]}, {curve.degree + 1}, {curve.poles[last_pole]}};
  }
  return pieces;
}

BoundaryPiece boundary_piece(const BSplineSurface& surface, const ParameterCurve& smooth) {
  const auto& poles = smooth.poles;
  require(std::adjacent_find(poles.begin(), poles.end(), std::not_equal_to<>()) != poles.end(),
          "A trim is a single point.");
  if (poles.size() > 2) return smooth;
  return straight_piece(surface, poles.front(), poles.back());
}

BoundaryLoop boundary_loop(const BSplineSurface& surface, const TrimLoop& trims) {
  require(!trims.empty(), "A loop of trims is empty.");
  for (const ParameterCurve& trim : trims) validate(trim);
  const ParameterCurve* previous = &trims.back();
  BoundaryLoop loop;
  for (const ParameterCurve& trim : trims) {
    require(previous->poles.back() == trim.poles.front(),
            "A loop of trims is not closed: a curve does not begin where the one before it ends.");
    previous = &trim;
    for (const auto& smooth : cut_at_corners(trim)) loop.push_back(boundary_piece(surface, smooth));
  }
  return loop;
}

BoundaryLoop whole_boundary(const BSplineSurface& s) {
  const std::array<ParameterPoint, 4> corners = {
      ParameterPoint{s.u_knots.front(), s.v_knots.front()},
      ParameterPoint{s.u_knots.back(), s.v_knots.front()},
      ParameterPoint{s.u_knots.back(), s.v_knots.back()},
      ParameterPoint{s.u_knots.front(), s.v_knots.back()}};
  BoundaryLoop loop;
  for (std::size_t i = 0; i < 4; ++i) {
    loop.push_back(straight_piece(s, corners[i], corners[(i + 1) % 4]));
  }
  return loop;
}

}  // namespace

BoundaryCurve reversed(BoundaryCurve curve) {
  const double sum = curve.knots.front() + curve.knots.back();
  for (double& knot : curve.knots) knot = sum - knot;
  std::reverse(curve.knots.begin(), curve.knots.end());
  std::reverse(curve.multiplicities.begin(), curve.multiplicities.end());
  std::reverse(curve.poles.begin(), curve.poles.end());
  std::reverse(curve.weights.begin(), curve.weights.end());
  return curve;
}

bool is_degenerate(const BoundaryCurve& curve) {
  return std::all_of(curve.poles.begin(), curve.poles.end(),
                     [&](const auto& pole) { return pole == curve.poles.front(); });
}

bool coincide(const BoundaryCurve& a, const BoundaryCurve& b) {
  return a.degree == b.degree && a.multiplicities == b.multiplicities && a.poles == b.poles &&
         proportional(a.weights, b.weights) && affinely_equal(a.knots, b.knots);
}

SidePiece reversed(const SidePiece& piece) {
  const double sum = piece.curve.knots.front() + piece.curve.knots.back();
  return {reversed(piece.curve), sum - piece.last, sum - piece.first, piece.end,
          piece.start,           !piece.rising};
}

bool coincide(const SidePiece& a, const SidePiece& b) {
  const SamePosition same(a.curve.knots, b.curve.knots);
  return coincide(a.curve, b.curve) && same(a.first, b.first) && same(a.last, b.last);
}

std::vector<BoundaryLoop> boundary_loops(const BSplineSurface& surface) {
  if (surface.trims.empty()) return {whole_boundary(surface)};
  std::vector<BoundaryLoop> loops;
  for (const TrimLoop& trims : surface.trims) loops.push_back(boundary_loop(surface, trims));
  return loops;
}

}  // namespace pn
