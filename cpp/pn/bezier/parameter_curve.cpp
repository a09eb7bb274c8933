// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/bezier/parameter_curve.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <numeric>

#include "pn/bezier/evaluation.hpp"
#include "pn/geometry_error.hpp"

namespace pn {
namespace {

using Point = std::array<double, 2>;
/// Points, one a row.
using Points = Eigen::Matrix<double, Eigen::Dynamic, 2>;

constexpr int kDegree = 9;
/// Below this part of the path the tenth power gains nothing more in doubles.
constexpr double kLeastSpan = 1.0 / 4096;

ParameterCurve frame(const std::vector<double>& knots) {
  ParameterCurve curve;
  curve.degree = kDegree;
  curve.knots = knots;
  curve.multiplicities.assign(knots.size(), 1);
  curve.multiplicities.front() = curve.multiplicities.back() = kDegree + 1;
  return curve;
}

SplineBasis basis_of(const ParameterCurve& curve) {
  return SplineBasis(curve.degree, curve.knots, curve.multiplicities);
}

/// The means of kDegree consecutive knots, each end counted kDegree times.
std::vector<double> greville_abscissae(const std::vector<double>& knots) {
  std::vector<double> flat(kDegree, knots.front());
  flat.insert(flat.end(), knots.begin() + 1, knots.end() - 1);
  flat.insert(flat.end(), kDegree, knots.back());
  std::vector<double> abscissae;
  for (auto first = flat.begin(); first + kDegree <= flat.end(); ++first) {
    abscissae.push_back(std::accumulate(first, first + kDegree, 0.0) / kDegree);
  }
  return abscissae;
}

/// A value of a spline as a combination of its poles, by their numbers.
struct BandedRow : ActiveBasis {
  double at(std::size_t column) const { return values[static_cast<Eigen::Index>(column - first)]; }
  double& at(std::size_t column) { return values[static_cast<Eigen::Index>(column - first)]; }
  std::size_t end() const { return first + static_cast<std::size_t>(values.size()); }
};

/// The poles of the spline with these points. Gauss's elimination needs no exchange of rows, as the
/// matrix is totally positive. (C. de Boor, A. Pinkus, Backward error analysis for totally positive
/// linear systems, Numer. Math. 27, 1977.)
Points solved(std::vector<BandedRow> rows, Points points) {
  const auto point = [&](std::size_t i) { return points.row(static_cast<Eigen::Index>(i)); };
  for (std::size_t i = 0; i < rows.size(); ++i) {
    for (std::size_t k = i + 1; k < rows.size() && rows[k].first <= i; ++k) {
      const double factor = rows[k].at(i) / rows[i].at(i);
      for (std::size_t j = i; j < rows[i].end(); ++j) rows[k].at(j) -= factor * rows[i].at(j);
      point(k) -= factor * point(i);
    }
  }
  for (std::size_t i = rows.size(); i-- > 0;) {
    for (std::size_t j = i + 1; j < rows[i].end(); ++j) point(i) -= rows[i].at(j) * point(j);
    point(i) /= rows[i].at(i);
  }
  return points;
}

ParameterCurve interpolated(const ParameterPath& path, const std::vector<double>& knots) {
  ParameterCurve curve = frame(knots);
  const SplineBasis basis = basis_of(curve);
  const std::vector<double> abscissae = greville_abscissae(knots);
  std::vector<BandedRow> rows;
  Points points(static_cast<Eigen::Index>(abscissae.size()), 2);
  for (std::size_t i = 0; i < abscissae.size(); ++i) {
    rows.push_back({basis.at(abscissae[i])});
    const Point point = path(abscissae[i]);
    points.row(static_cast<Eigen::Index>(i)) << point[0], point[1];
  }
  if (!points.allFinite()) {
    throw GeometryError(ErrorCode::kRegionUnsupported,
                        "An edge of the surface could not be followed from end to end.");
  }
  const Points poles = solved(std::move(rows), std::move(points));
  for (const auto& pole : poles.rowwise()) curve.poles.push_back({pole(0), pole(1)});
  curve.poles.front() = path(0);
  curve.poles.back() = path(1);
  return curve;
}

Point point_of(const ParameterCurve& curve, const ActiveBasis& basis) {
  Point point = {0, 0};
  for (Eigen::Index i = 0; i < basis.values.size(); ++i) {
    const Point& pole = curve.poles[basis.first + static_cast<std::size_t>(i)];
    for (std::size_t c = 0; c < 2; ++c) point[c] += basis.values[i] * pole[c];
  }
  return point;
}

double relative_difference(double exact, double near) {
  return std::abs(exact - near) / std::max(1.0, std::abs(exact));
}

/// The largest error in a coordinate at places inside a span, between the abscissae.
double error(const ParameterCurve& curve, const SplineBasis& basis, const ParameterPath& path,
             double begin, double end) {
  double largest = 0;
  for (const double part : {0.03, 0.12, 0.25, 0.38, 0.5, 0.62, 0.75, 0.88, 0.97}) {
    const double at = begin + part * (end - begin);
    const Point exact = path(at), near = point_of(curve, basis.at(at));
    largest = std::max(
        {largest, relative_difference(exact[0], near[0]), relative_difference(exact[1], near[1])});
  }
  return largest;
}

/// While some span is far off, those much nearer to the path are so because of it.
constexpr double kFarOff = 1e-3;

/// The knots of a curve, and the middles of the spans where it does not follow the path.
std::vector<double> refined_knots(const ParameterCurve& curve, const ParameterPath& path,
                                  double tolerance) {
  const SplineBasis basis = basis_of(curve);
  const std::vector<double>& knots = curve.knots;
  std::vector<double> errors;
  for (std::size_t i = 1; i < knots.size(); ++i) {
    const bool is_shortest = knots[i] - knots[i - 1] <= kLeastSpan;
    errors.push_back(is_shortest ? 0 : error(curve, basis, path, knots[i - 1], knots[i]));
  }
  const double largest = *std::max_element(errors.begin(), errors.end());
  const double tolerated = std::max(tolerance, kFarOff * largest);
  std::vector<double> refined = {knots.front()};
  for (std::size_t i = 1; i < knots.size(); ++i) {
    if (errors[i - 1] > tolerated) refined.push_back((knots[i - 1] + knots[i]) / 2);
    refined.push_back(knots[i]);
  }
  return refined;
}

}  // namespace

ParameterCurve interpolated(const ParameterPath& path, double tolerance) {
  std::vector<double> knots = {0, 0.5, 1};
  for (;;) {
    ParameterCurve curve = interpolated(path, knots);
    std::vector<double> finer = refined_knots(curve, path, tolerance);
    if (finer.size() == knots.size()) return curve;
    knots = std::move(finer);
  }
}

ParameterCurve straight_line(const Point& start, const Point& end) {
  return {1, {0, 1}, {2, 2}, {start, end}};
}

Point evaluate(const ParameterCurve& curve, double parameter) {
  return point_of(curve, basis_of(curve).at(parameter));
}

}  // namespace pn
