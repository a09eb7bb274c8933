// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/bezier/parameter_curve.hpp"

#include <Eigen/Dense>
#include <Eigen/Sparse>
#include <algorithm>
#include <cmath>
#include <limits>

#include "pn/bezier/evaluation.hpp"
#include "pn/geometry_error.hpp"

namespace pn {
namespace {

using Point = std::array<double, 2>;

constexpr int kDegree = 5;
constexpr std::size_t kFirstSpans = 4;
/// Up to so many halvings of the first spans they may be too long to show the order of the error.
constexpr double kShortSpan = 1.0 / 1024;
/// Shorter ones are halved while this halves the error at least, which rounding in doubles ends;
/// for a path that doubles cannot follow at all, they end here.
constexpr double kLeastSpan = 1.0 / 16384;
constexpr double kLeastGain = 2;

ParameterCurve frame(const std::vector<double>& knots) {
  ParameterCurve curve;
  curve.degree = kDegree;
  curve.knots = knots;
  curve.multiplicities.assign(knots.size(), 1);
  curve.multiplicities.front() = curve.multiplicities.back() = kDegree + 1;
  return curve;
}

/// The means of kDegree consecutive knots.
std::vector<double> greville_abscissae(const ParameterCurve& curve) {
  std::vector<double> flat, abscissae;
  for (std::size_t i = 0; i < curve.knots.size(); ++i) {
    flat.insert(flat.end(), static_cast<std::size_t>(curve.multiplicities[i]), curve.knots[i]);
  }
  for (std::size_t i = 1; i + kDegree < flat.size(); ++i) {
    double sum = 0;
    for (std::size_t j = i; j < i + kDegree; ++j) sum += flat[j];
    abscissae.push_back(sum / kDegree);
  }
  return abscissae;
}

ParameterCurve interpolated(const ParameterPath& path, const std::vector<double>& knots) {
  ParameterCurve curve = frame(knots);
  const std::vector<double> abscissae = greville_abscissae(curve);
  const auto count = static_cast<Eigen::Index>(abscissae.size());
  std::vector<Eigen::Triplet<double>> entries;
  Eigen::MatrixXd values(count, 2);
  for (Eigen::Index i = 0; i < count; ++i) {
    const double at = abscissae[static_cast<std::size_t>(i)];
    const ActiveBasis basis = active_basis(kDegree, curve.knots, curve.multiplicities, at);
    for (std::size_t j = 0; j < basis.values.size(); ++j) {
      entries.emplace_back(i, static_cast<Eigen::Index>(basis.first + j), basis.values[j]);
    }
    const Point point = path(at);
    values.row(i) << point[0], point[1];
  }
  Eigen::SparseMatrix<double> collocation(count, count);
  collocation.setFromTriplets(entries.begin(), entries.end());
  const Eigen::SparseLU<Eigen::SparseMatrix<double>> solver(collocation);
  if (!values.allFinite() || solver.info() != Eigen::Success) {
    throw GeometryError(ErrorCode::kRegionUnsupported,
                        "An edge of the surface could not be followed from end to end.");
  }
  const Eigen::MatrixXd poles = solver.solve(values);
  for (Eigen::Index i = 0; i < count; ++i) curve.poles.push_back({poles(i, 0), poles(i, 1)});
  curve.poles.front() = path(0);
  curve.poles.back() = path(1);
  return curve;
}

double relative_difference(double exact, double near) {
  return std::abs(exact - near) / std::max(1.0, std::abs(exact));
}

/// The largest error in a coordinate at places inside a span.
double error(const ParameterCurve& curve, const ParameterPath& path, double begin, double end) {
  double largest = 0;
  for (const double part : {0.03, 0.12, 0.25, 0.38, 0.5, 0.62, 0.75, 0.88, 0.97}) {
    const double at = begin + part * (end - begin);
    const Point exact = path(at), near = evaluate(curve, at);
    largest = std::max(
        {largest, relative_difference(exact[0], near[0]), relative_difference(exact[1], near[1])});
  }
  return largest;
}

}  // namespace

ParameterCurve interpolated(const ParameterPath& path, double tolerance) {
  std::vector<double> knots;
  for (std::size_t i = 0; i <= kFirstSpans; ++i) {
    knots.push_back(static_cast<double>(i) / kFirstSpans);
  }
  // Of every span the error before it was halved.
  std::vector<double> before(kFirstSpans, std::numeric_limits<double>::infinity());
  for (;;) {
    ParameterCurve curve = interpolated(path, knots);
    std::vector<double> finer = {0}, errors;
    for (std::size_t i = 0; i + 1 < knots.size(); ++i) {
      const double length = knots[i + 1] - knots[i];
      const double left = error(curve, path, knots[i], knots[i + 1]);
      const bool gains =
          length > kShortSpan || (length > kLeastSpan && kLeastGain * left < before[i]);
      errors.push_back(left);
      if (left > tolerance && gains) {
        errors.push_back(left);
        finer.push_back(knots[i] + length / 2);
      }
      finer.push_back(knots[i + 1]);
    }
    if (finer.size() == knots.size()) return curve;
    knots = std::move(finer);
    before = std::move(errors);
  }
}

ParameterCurve straight_line(const Point& start, const Point& end) {
  return {1, {0, 1}, {2, 2}, {start, end}};
}

Point evaluate(const ParameterCurve& curve, double parameter) {
  const ActiveBasis basis =
      active_basis(curve.degree, curve.knots, curve.multiplicities, parameter);
  Point point = {0, 0};
  for (std::size_t i = 0; i < basis.values.size(); ++i) {
    for (std::size_t c = 0; c < 2; ++c) {
      point[c] += basis.values[i] * curve.poles[basis.first + i][c];
    }
  }
  return point;
}

}  // namespace pn
