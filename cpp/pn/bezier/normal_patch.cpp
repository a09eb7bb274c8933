// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/bezier/normal_patch.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace pn {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::RowVectorXd;
using Eigen::Vector3d;
using Net = NormalPatch::Net;

constexpr Index kComponents = NormalPatch::kComponents;

/// The basis functions at t and their derivatives.
struct BernsteinBasis {
  RowVectorXd value, slope;
};

BernsteinBasis bernstein_basis(Index degree, double t) {
  RowVectorXd lower = RowVectorXd::Zero(degree + 1), slope = RowVectorXd::Zero(degree + 1);
  lower(0) = 1;
  const auto raise = [&](Index to) {
    for (Index i = to; i > 0; --i) lower(i) = (1 - t) * lower(i) + t * lower(i - 1);
    lower(0) *= 1 - t;
  };
  for (Index k = 1; k < degree; ++k) raise(k);
  for (Index i = 0; i <= degree && degree > 0; ++i) {
    const double before = i > 0 ? lower(i - 1) : 0, here = i < degree ? lower(i) : 0;
    slope(i) = static_cast<double>(degree) * (before - here);
  }
  if (degree > 0) raise(degree);
  return {std::move(lower), std::move(slope)};
}

/// The Bezier points of each span from the poles that are active on it: the blossom at the ends of
/// the span (L. Ramshaw, Blossoms are polar forms, CAGD 6, 1989).
struct SpanPoints {
  Index first_pole;
  MatrixXd from_poles;
};

std::vector<SpanPoints> span_points(int degree, const std::vector<double>& knots,
                                    const std::vector<int>& multiplicities) {
  std::vector<double> flat;
  for (std::size_t i = 0; i < knots.size(); ++i) {
    flat.insert(flat.end(), static_cast<std::size_t>(multiplicities[i]), knots[i]);
  }
  const auto p = static_cast<std::size_t>(degree);
  std::vector<SpanPoints> spans;
  for (std::size_t k = p; k + 1 + p < flat.size(); ++k) {
    if (flat[k] == flat[k + 1]) continue;
    MatrixXd points(degree + 1, degree + 1);
    for (std::size_t right = 0; right <= p; ++right) {
      MatrixXd blossom = MatrixXd::Identity(degree + 1, degree + 1);
      for (std::size_t r = 1; r <= p; ++r) {
        const double at = r <= right ? flat[k + 1] : flat[k];
        for (std::size_t j = p; j >= r; --j) {
          const double low = flat[k - p + j], high = flat[k + 1 + j - r];
          const double share = (at - low) / (high - low);
          const auto row = static_cast<Index>(j);
          blossom.row(row) = (1 - share) * blossom.row(row - 1) + share * blossom.row(row);
        }
      }
      points.row(static_cast<Index>(right)) = blossom.row(degree);
    }
    spans.push_back({static_cast<Index>(k - p), std::move(points)});
  }
  return spans;
}

Net homogeneous(const BSplineSurface& surface, const BSplineSurface& normal) {
  const std::size_t rows = surface.u_count(), columns = surface.v_count();
  Net net(static_cast<Index>(rows), kComponents * static_cast<Index>(columns));
  for (std::size_t i = 0; i < rows; ++i) {
    for (std::size_t j = 0; j < columns; ++j) {
      const std::size_t index = i * columns + j;
      const auto row = static_cast<Index>(i), column = kComponents * static_cast<Index>(j);
      const double weight = surface.weights[index];
      net.block<1, 3>(row, column) =
          weight * Eigen::Map<const Eigen::RowVector3d>(surface.poles[index].data());
      net.block<1, 3>(row, column + 3) =
          weight * Eigen::Map<const Eigen::RowVector3d>(normal.poles[index].data());
      net(row, column + 6) = weight;
    }
  }
  return net;
}

/// Along the columns of a net, or along its rows: the halves by de Casteljau's algorithm.
template <class Line>
std::array<Net, 2> halved(const Net& net, Index count, const Line& line) {
  std::array<Net, 2> halves = {net, net};
  auto& [left, right] = halves;
  for (Index round = 1; round < count; ++round) {
    for (Index i = 0; i + round < count; ++i) {
      line(right, i) = (0.5 * (line(right, i) + line(right, i + 1))).eval();
    }
    line(left, round) = line(right, 0);
  }
  return halves;
}

}  // namespace

NormalPatch::NormalPatch(Net net, Normals normals)
    : net_(std::move(net)),
      normals_are_(normals),
      poles_(3, rows() * columns()),
      normals_(3, rows() * columns()) {
  for (Index i = 0; i < rows(); ++i) {
    for (Index j = 0; j < columns(); ++j) {
      const auto point = net_.block<1, kComponents>(i, kComponents * j);
      poles_.col(place(i, j)) = point.head<3>().transpose() / weight(i, j);
      normals_.col(place(i, j)) = point.segment<3>(3).transpose() / weight(i, j);
    }
  }
}

int NormalPatch::degree(Variable variable) const { return static_cast<int>(count(variable)) - 1; }

SurfaceJet NormalPatch::at(double u, double v) const {
  const BernsteinBasis along = bernstein_basis(rows() - 1, u),
                       across = bernstein_basis(columns() - 1, v);
  const RowVectorXd line = along.value * net_, slope = along.slope * net_;
  using Component = Eigen::Matrix<double, kComponents, 1>;
  Component value = Component::Zero(), by_u = value, by_v = value;
  for (Index j = 0; j < columns(); ++j) {
    const auto point = line.segment<kComponents>(kComponents * j).transpose();
    value += across.value(j) * point;
    by_v += across.slope(j) * point;
    by_u += across.value(j) * slope.segment<kComponents>(kComponents * j).transpose();
  }
  const double weight = value(6);
  const Vector3d point = value.head<3>() / weight;
  const Vector3d x_u = (by_u.head<3>() - by_u(6) * point) / weight,
                 x_v = (by_v.head<3>() - by_v(6) * point) / weight;
  const Vector3d normal =
      normals_are_ == Normals::kRational ? Vector3d(value.segment<3>(3)) : x_u.cross(x_v);
  return {point, x_u, x_v, normal.normalized()};
}

std::array<NormalPatch, 2> NormalPatch::halved(Variable variable) const {
  const auto row = [](Net& net, Index i) { return net.row(i); };
  const auto column = [](Net& net, Index j) {
    return net.middleCols<kComponents>(kComponents * j);
  };
  std::array<Net, 2> halves = variable == Variable::kU ? pn::halved(net_, rows(), row)
                                                       : pn::halved(net_, columns(), column);
  return {NormalPatch(std::move(halves[0]), normals_are_),
          NormalPatch(std::move(halves[1]), normals_are_)};
}

std::optional<DirectionCone> NormalPatch::normal_cone() const {
  if (normals_are_ == Normals::kOfDerivatives) {
    const auto along = tangent_cone(Variable::kU), across = tangent_cone(Variable::kV);
    return along && across ? cross_cone(*along, *across) : std::nullopt;
  }
  const Vector3d sum = normals_.rowwise().sum();
  const double length = sum.norm();
  if (!(length > 0)) return std::nullopt;
  const Vector3d axis = sum / length;
  const double least = (axis.transpose() * normals_).minCoeff();
  return DirectionCone{axis, std::acos(std::clamp(least, -1.0, 1.0))};
}

std::optional<DirectionCone> NormalPatch::tangent_cone(Variable variable) const {
  const Index di = variable == Variable::kU ? 1 : 0, dj = 1 - di;
  const Vector3d centre = poles_.col(place(rows() / 2, columns() / 2));
  const auto moved = [&](Index i, Index j) -> Vector3d {
    return weight(i, j) * (poles_.col(place(i, j)) - centre);
  };
  Eigen::Matrix3Xd steps(3, (rows() - di) * (columns() - dj));
  double weight_step = 0;
  Index next = 0;
  for (Index i = 0; i + di < rows(); ++i) {
    for (Index j = 0; j + dj < columns(); ++j) {
      steps.col(next++) = moved(i + di, j + dj) - moved(i, j);
      weight_step = std::max(weight_step, std::abs(weight(i + di, j + dj) - weight(i, j)));
    }
  }
  const Vector3d sum = steps.rowwise().sum();
  const double length = sum.norm();
  if (!(length > 0)) return std::nullopt;
  const Vector3d axis = sum / length;
  const auto along = (axis.transpose() * steps).eval();
  const double shortest = along.minCoeff();
  const double radius = std::sqrt((poles_.colwise() - centre).colwise().squaredNorm().maxCoeff());
  const double aside = weight_step * radius;
  if (!(aside < shortest)) return std::nullopt;
  double widest = 0;  // the squared tangent of the angle of a step
  for (Index i = 0; i < next; ++i) {
    widest =
        std::max(widest, (steps.col(i) - along(i) * axis).squaredNorm() / (along(i) * along(i)));
  }
  return DirectionCone{axis, std::atan(std::sqrt(widest)) + std::asin(aside / shortest)};
}

double NormalPatch::longest_line(const Eigen::Matrix3Xd& points, Variable variable) const {
  const Variable other = variable == Variable::kU ? Variable::kV : Variable::kU;
  double longest = 0;
  for (Index line = 0; line < count(other); ++line) {
    double length = 0;
    for (Index k = 1; k < count(variable); ++k) {
      const Index at = line * stride(other) + k * stride(variable);
      length += (points.col(at) - points.col(at - stride(variable))).norm();
    }
    longest = std::max(longest, length);
  }
  return longest;
}

namespace {

std::vector<NormalPatch> patches_of(const BSplineSurface& surface, const Net& net,
                                    Normals normals) {
  const auto along = span_points(surface.u_degree, surface.u_knots, surface.u_multiplicities);
  const auto across = span_points(surface.v_degree, surface.v_knots, surface.v_multiplicities);
  std::vector<NormalPatch> patches;
  for (const SpanPoints& u : along) {
    const Net rows = u.from_poles * net.middleRows(u.first_pole, u.from_poles.cols());
    for (const SpanPoints& v : across) {
      Net patch = Net::Zero(rows.rows(), kComponents * v.from_poles.rows());
      for (Index j = 0; j < v.from_poles.rows(); ++j) {
        for (Index k = 0; k < v.from_poles.cols(); ++k) {
          patch.middleCols<kComponents>(kComponents * j) +=
              v.from_poles(j, k) * rows.middleCols<kComponents>(kComponents * (v.first_pole + k));
        }
      }
      patches.emplace_back(std::move(patch), normals);
    }
  }
  return patches;
}

}  // namespace

std::vector<NormalPatch> normal_patches(const BSplineSurface& surface,
                                        const BSplineSurface& normal) {
  return patches_of(surface, homogeneous(surface, normal), Normals::kRational);
}

std::vector<NormalPatch> normal_patches(const BSplineSurface& surface) {
  BSplineSurface none = surface;
  none.poles.assign(surface.poles.size(), {0, 0, 0});
  return patches_of(surface, homogeneous(surface, none), Normals::kOfDerivatives);
}

}  // namespace pn
