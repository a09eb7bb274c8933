// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/occt/mass.hpp"

#include <BRepBndLib.hxx>
#include <BRepGProp.hxx>
#include <BRep_Tool.hxx>
#include <Bnd_Box.hxx>
#include <GProp_GProps.hxx>
#include <Geom2dAdaptor_Curve.hxx>
#include <GeomAdaptor_Surface.hxx>
#include <Precision.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <algorithm>
#include <cmath>
#include <limits>
#include <math.hxx>
#include <math_Vector.hxx>
#include <stdexcept>
#include <vector>

#include "pn/algebra/parallel.hpp"
#include "pn/occt/curve_on_surface.hpp"
#include "pn/occt/occt_error.hpp"

namespace pn {
namespace {

// Gauss-Kronrod rules of 10 and 21 points on stretches where the integrand is analytic. Where they
// agree this well, relative to the sizes added up, the error of the better one is about the power
// 3/2 of that: rounding.
constexpr int kGaussPoints = 10;
constexpr int kKronrodPoints = 21;
constexpr double kAgreement = 1e-10;

// The part of the whole way below which a stretch is not halved any more. Only where a normal
// vanishes inside a face does it come near that; what such a stretch adds is too little to matter.
constexpr double kShortest = 1e-6;

// No stretch is halved.
constexpr double kWhole = 1;

// The part of a whole integral that a stretch may be off: where normals vanish, rounding is all
// that is left of the integrand, which never settles by itself.
constexpr double kNegligible = 1e-12;

// A p-curve is searched for crossings of the knot lines of its surface in this many steps between
// its own knots. Two crossings inside one step would cost accuracy, not correctness.
constexpr int kCrossingSteps = 32;

// Points and derivatives of a rational surface are right to some units in the last place of the
// sizes that are added up; sums over many points are better, not worse.
constexpr double kRounding = 8 * std::numeric_limits<double>::epsilon();

// A value, the size of the terms that it is the sum of, to which its rounding is relative, and an
// estimate of the error of the quadrature.
struct Sum {
  double value = 0;
  double size = 0;
  double error = 0;

  Sum& operator+=(const Sum& other) {
    value += other.value;
    size += other.size;
    error += other.error;
    return *this;
  }
};

Sum operator*(double factor, const Sum& sum) {
  return {factor * sum.value, std::abs(factor) * sum.size, std::abs(factor) * sum.error};
}

struct GaussKronrodRule {
  GaussKronrodRule()
      : points(1, kKronrodPoints), weights(1, kKronrodPoints), gauss_weights(1, kGaussPoints) {
    math_Vector gauss_points(1, kGaussPoints);
    math::KronrodPointsAndWeights(kKronrodPoints, points, weights);
    math::OrderedGaussPointsAndWeights(kGaussPoints, gauss_points, gauss_weights);
  }
  math_Vector points;  // Every second one is a point of the Gauss rule.
  math_Vector weights;
  math_Vector gauss_weights;
};

// When a stretch is halved no more: it is this short, or its error is this small.
struct Limits {
  double shortest;
  double negligible;
};

// Integral of f, which gives Sums, from a to b, also where a > b. Stretches are halved down to the
// limits, and never beyond neighbouring doubles.
template <class Function>
Sum integral(const Function& f, double a, double b, const Limits& limits) {
  if (a == b) return {};
  static const GaussKronrodRule rule;
  const double middle = (a + b) / 2;
  const double half = (b - a) / 2;
  Sum gauss, kronrod;
  for (int i = 1; i <= kKronrodPoints; ++i) {
    const Sum term = f(middle + half * rule.points(i));
    kronrod += rule.weights(i) * term;
    if (i % 2 == 0) gauss += rule.gauss_weights(i / 2) * term;
  }
  const double difference = std::abs(kronrod.value - gauss.value);
  const bool has_settled = difference <= kAgreement * kronrod.size;
  const bool is_negligible = std::abs(half) * difference <= limits.negligible;
  const bool is_short = std::abs(half) < limits.shortest || middle == a || middle == b;
  if (is_short || is_negligible || has_settled) {
    if (difference > 0) {
      kronrod.error += has_settled ? difference * std::sqrt(difference / kronrod.size) : difference;
    }
    return half * kronrod;
  }
  Sum sum = integral(f, a, middle, limits);
  return sum += integral(f, middle, b, limits);
}

// The same, split at `cuts` between a and b, in this order, the shortest stretch being a part of
// the whole way.
template <class Function>
Sum integral(const Function& f, double a, const std::vector<double>& cuts, double b,
             const Limits& parts) {
  const Limits limits{parts.shortest * std::abs(b - a), parts.negligible};
  Sum sum;
  for (const double cut : cuts) {
    sum += integral(f, a, cut, limits);
    a = cut;
  }
  return sum += integral(f, a, b, limits);
}

std::vector<double> u_breaks(const GeomAdaptor_Surface& surface) {
  TColStd_Array1OfReal breaks(1, surface.NbUIntervals(GeomAbs_CN) + 1);
  surface.UIntervals(breaks, GeomAbs_CN);
  return {breaks.begin(), breaks.end()};
}

std::vector<double> v_breaks(const GeomAdaptor_Surface& surface) {
  TColStd_Array1OfReal breaks(1, surface.NbVIntervals(GeomAbs_CN) + 1);
  surface.VIntervals(breaks, GeomAbs_CN);
  return {breaks.begin(), breaks.end()};
}

// The knots of one parameter of a surface, on both sides of its period if it has one.
class Knots {
 public:
  Knots(std::vector<double> knots, bool is_periodic)
      : knots_(std::move(knots)), period_(is_periodic ? knots_.back() - knots_.front() : 0) {}

  // From the first to the last one.
  double length() const { return knots_.back() - knots_.front(); }

  // Those passed on the way from a, which does not count, to b, which does.
  std::vector<double> passed(double a, double b) const {
    const auto [low, high] = std::minmax(a, b);
    std::vector<double> result;
    for (const double knot : knots_) {
      for (double k = first_from(low, knot); k <= high; k += period_) {
        if (k >= low && k != a) result.push_back(k);
        if (period_ == 0) break;
      }
    }
    std::sort(result.begin(), result.end());
    result.erase(std::unique(result.begin(), result.end()), result.end());
    if (a > b) std::reverse(result.begin(), result.end());
    return result;
  }

 private:
  double first_from(double low, double knot) const {
    return period_ == 0 ? knot : knot + period_ * std::ceil((low - knot) / period_);
  }

  std::vector<double> knots_;
  double period_;
};

// The parameter between a and b at which `coordinate` takes the value, to the last place.
template <class Coordinate>
double crossing(const Coordinate& coordinate, double value, double a, double b) {
  const bool starts_below = coordinate(a) < value;
  for (double middle = (a + b) / 2; middle != a && middle != b; middle = (a + b) / 2) {
    ((coordinate(middle) < value) == starts_below ? a : b) = middle;
  }
  return b;
}

// A face as the domain of integrals.
//
// By Green's theorem the integral of g over the region to the left of the boundary curves
// (u(t), v(t)) is the sum of the integrals of G(u, v) v' dt, G being the integral of g over the
// first parameter from any fixed u0 to u. Both are split where surface or p-curve are not analytic.
class Domain {
 public:
  explicit Domain(const TopoDS_Face& face)
      : surface_(BRep_Tool::Surface(face)),
        u_knots_(u_breaks(surface_), surface_.IsUPeriodic()),
        v_knots_(v_breaks(surface_), surface_.IsVPeriodic()),
        sign_(face.Orientation() == TopAbs_REVERSED ? -1 : 1) {
    const TopoDS_Shape forward = face.Oriented(TopAbs_FORWARD);
    for (TopExp_Explorer edge(forward, TopAbs_EDGE); edge.More(); edge.Next()) {
      add(TopoDS::Edge(edge.Current()), TopoDS::Face(forward));
    }
    if (boundary_.empty()) throw std::invalid_argument("A face has no boundary.");
  }

  // Integral of density(S, S_u x S_v), which gives Sums, over u and v: as exact as doubles allow.
  template <class Density>
  Sum integral_of(const Density& density) const {
    const Sum rough = integral_by_one_rule(density);
    return integral_of(density, {kShortest, kNegligible * rough.size});
  }

  // The same with no stretch halved.
  template <class Density>
  Sum integral_by_one_rule(const Density& density) const {
    return integral_of(density, {kWhole, 0});
  }

  // 1 where the face points along S_u x S_v, -1 where against it.
  double sign() const { return sign_; }

 private:
  template <class Density>
  Sum integral_of(const Density& density, const Limits& parts) const {
    const double u0 = boundary_.front().curve.Value(boundary_.front().cuts.front()).X();
    // What a strip may be off counts for every v.
    const Limits across{parts.shortest, parts.negligible / v_knots_.length()};
    const auto strip = [&](double u, double v) {
      const auto at = [&](double s) {
        gp_Pnt point;
        gp_Vec s_u, s_v;
        surface_.D1(s, v, point, s_u, s_v);
        return density(point, s_u.Crossed(s_v));
      };
      return integral(at, u0, u_knots_.passed(u0, u), u, across);
    };
    Sum sum;
    for (const BoundaryCurve& piece : boundary_) {
      const auto at = [&](double t) {
        gp_Pnt2d uv;
        gp_Vec2d step;
        piece.curve.D1(t, uv, step);
        // The sides along u add nothing and need no integral.
        return step.Y() == 0 ? Sum{} : step.Y() * strip(uv.X(), uv.Y());
      };
      const std::vector<double> inner(piece.cuts.begin() + 1, piece.cuts.end() - 1);
      sum += piece.sign * integral(at, piece.cuts.front(), inner, piece.cuts.back(), parts);
    }
    return sum;
  }

  // A p-curve, the parameters between which it is analytic on the surface, and whether the region
  // lies to its left (1) or right (-1).
  struct BoundaryCurve {
    Geom2dAdaptor_Curve curve;
    std::vector<double> cuts;
    double sign;
  };

  void add(const TopoDS_Edge& edge, const TopoDS_Face& face) {
    const TopAbs_Orientation orientation = edge.Orientation();
    if (orientation != TopAbs_FORWARD && orientation != TopAbs_REVERSED) return;
    double first, last;
    const auto p_curve = BRep_Tool::CurveOnSurface(edge, face, first, last);
    if (p_curve.IsNull()) throw std::invalid_argument("An edge has no curve on its face.");
    const Geom2dAdaptor_Curve curve(p_curve, first, last);
    boundary_.push_back({curve, cuts(curve), orientation == TopAbs_FORWARD ? 1. : -1.});
  }

  std::vector<double> cuts(const Geom2dAdaptor_Curve& curve) const {
    TColStd_Array1OfReal spans(1, curve.NbIntervals(GeomAbs_CN) + 1);
    curve.Intervals(spans, GeomAbs_CN);
    const auto u = [&](double t) { return curve.Value(t).X(); };
    const auto v = [&](double t) { return curve.Value(t).Y(); };
    std::vector<double> result(spans.begin(), spans.end());
    for (int span = 1; span < spans.Length(); ++span) {
      const double step = (spans(span + 1) - spans(span)) / kCrossingSteps;
      for (int i = 0; i < kCrossingSteps; ++i) {
        const double a = spans(span) + i * step;
        const double b = std::min(a + step, spans(span + 1));
        for (const double knot : u_knots_.passed(u(a), u(b))) {
          result.push_back(crossing(u, knot, a, b));
        }
        for (const double knot : v_knots_.passed(v(a), v(b))) {
          result.push_back(crossing(v, knot, a, b));
        }
      }
    }
    std::sort(result.begin(), result.end());
    result.erase(std::unique(result.begin(), result.end()), result.end());
    return result;
  }

  GeomAdaptor_Surface surface_;
  Knots u_knots_;
  Knots v_knots_;
  double sign_;
  std::vector<BoundaryCurve> boundary_;
};

// The density of the area.
Sum area_element(const gp_Pnt&, const gp_Vec& normal) {
  return {normal.Magnitude(), normal.Magnitude()};
}

// Volume of the cone from `apex` over a face, negative where the face points towards it.
Sum volume_below(const TopoDS_Face& face, const gp_Pnt& apex) {
  const Domain domain(face);
  const auto cone = [&](const gp_Pnt& point, const gp_Vec& normal) {
    const gp_Vec ray(apex, point);
    return Sum{ray.Dot(normal), ray.Magnitude() * normal.Magnitude()};
  };
  return domain.sign() / 3 * domain.integral_of(cone);
}

// The sum over all faces of a shape of what integral_over(face) gives.
template <class Integral>
Sum over_faces(const TopoDS_Shape& shape, const Integral& integral_over) {
  std::vector<TopoDS_Face> faces;
  for (TopExp_Explorer face(shape, TopAbs_FACE); face.More(); face.Next()) {
    faces.push_back(TopoDS::Face(face.Current()));
  }
  std::vector<Sum> terms(faces.size());
  for_each_index(faces.size(), [&](std::size_t i) { terms[i] = integral_over(faces[i]); });
  Sum sum;
  for (const Sum& term : terms) sum += term;
  return sum;
}

// Volume inside a closed shell. An apex on the shell keeps the cones small.
Sum volume_inside(const TopoDS_Shape& shell) {
  const TopExp_Explorer vertex(shell, TopAbs_VERTEX);
  const gp_Pnt apex = BRep_Tool::Pnt(TopoDS::Vertex(vertex.Current()));
  return over_faces(shell, [&](const TopoDS_Face& face) { return volume_below(face, apex); });
}

Sum volume_of_closed_shells(const TopoDS_Shape& shape) {
  bool is_open = true;
  Sum sum;
  for (TopExp_Explorer shell(shape, TopAbs_SHELL); shell.More(); shell.Next()) {
    if (!BRep_Tool::IsClosed(shell.Current())) continue;
    is_open = false;
    sum += volume_inside(shell.Current());
  }
  if (is_open) throw std::invalid_argument("An open shape has no volume.");
  return sum;
}

Sum area_of_faces(const TopoDS_Shape& shape) {
  return over_faces(shape,
                    [](const TopoDS_Face& face) { return Domain(face).integral_of(area_element); });
}

// The area that lies between the edges of the faces and their curves on them, at most and about.
double open_area(const TopoDS_Shape& shape) {
  GProp_GProps edges;
  BRepGProp::LinearProperties(shape, edges);
  return trim_deviation(shape) * edges.Mass();
}

double size_of(const TopoDS_Shape& shape) {
  Bnd_Box box;
  BRepBndLib::Add(shape, box);
  return std::sqrt(box.SquareExtent());
}

Measure measure(const Sum& sum, double open) {
  return {sum.value, sum.error + kRounding * sum.size + open};
}

}  // namespace

double volume(const TopoDS_Shape& shape) {
  return with_occt_errors([&] { return volume_of_closed_shells(shape).value; });
}

double area(const TopoDS_Shape& shape) {
  return with_occt_errors([&] { return area_of_faces(shape).value; });
}

double area_by_one_rule(const TopoDS_Shape& shape) {
  return with_occt_errors([&] {
    const auto area_of = [](const TopoDS_Face& face) {
      return Domain(face).integral_by_one_rule(area_element);
    };
    return over_faces(shape, area_of).value;
  });
}

Measure measured_volume(const TopoDS_Shape& shape) {
  return with_occt_errors([&] {
    // A cone over the open area is no higher than the shape.
    return measure(volume_of_closed_shells(shape), open_area(shape) * size_of(shape) / 3);
  });
}

Measure measured_area(const TopoDS_Shape& shape) {
  return with_occt_errors([&] { return measure(area_of_faces(shape), open_area(shape)); });
}

}  // namespace pn
