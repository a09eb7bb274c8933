// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/minkowski/net_type.hpp"

#include <stdexcept>
#include <utility>

#include "pn/algebra/rational_matrix.hpp"

namespace pn {

namespace {

using Complex = LineCoordinates<Rational>;

std::size_t rank(const std::vector<Complex>& complexes) {
  RationalMatrix rows;
  for (const Complex& c : complexes) rows.emplace_back(c.begin(), c.end());
  return row_echelon_form(rows).size();
}

Complex sum(Complex a, const Complex& b) {
  for (std::size_t i = 0; i < a.size(); ++i) a[i] += b[i];
  return a;
}

/// The same pencil with [b, b] != 0, when it has such a complex.
LineNet with_regular_second_complex(const LineNet& net) {
  if (!klein(net.b, net.b).is_zero()) return net;
  if (!klein(net.a, net.a).is_zero()) return {net.b, net.a};
  return {net.a, sum(net.a, net.b)};
}

/// Of O at the two roots of K.
struct AxisValues {
  Rational sum, product;
};

/// K(a + k b) = 0 and O(a + k b) = alpha + beta k modulo K.
AxisValues axis_values(const LineNet& net) {
  const auto& [a, b] = net;
  const Rational kb = klein(b, b), two(2L);
  const Rational root_sum = -two * klein(a, b) / kb, root_product = klein(a, a) / kb;
  const Rational alpha = omega(a, a) - omega(b, b) * root_product;
  const Rational beta = two * omega(a, b) + omega(b, b) * root_sum;
  return {two * alpha + beta * root_sum,
          alpha * alpha + alpha * beta * root_sum + beta * beta * root_product};
}

AxisPosition position(const Rational& omega_square) {
  switch (causal_type(omega_square)) {
    case CausalType::kSpaceLike:
      return AxisPosition::kPassant;
    case CausalType::kLightLike:
      return AxisPosition::kTangent;
    default:
      return AxisPosition::kSecant;
  }
}

NetType hyperbolic_type(const LineNet& net) {
  const AxisValues o = axis_values(net);
  if (o.product.sign() < 0) {
    const bool polar_axes = rank({net.a, net.b, polar(net.a), polar(net.b)}) == 2;
    return {NetKind::kHyperbolic, {AxisPosition::kSecant, AxisPosition::kPassant}, polar_axes};
  }
  // One value is zero, or both have the sign of their sum.
  const AxisPosition first = position(o.sum);
  return {NetKind::kHyperbolic, {first, o.product.is_zero() ? AxisPosition::kTangent : first}};
}

NetType elliptic_type(const LineNet& net) {
  const AxisPosition axis =
      axis_values(net).product.is_zero() ? AxisPosition::kTangent : AxisPosition::kSecant;
  return {NetKind::kElliptic, {axis, axis}};
}

NetType parabolic_type(const LineNet& net) {
  const auto& [a, b] = net;
  const Rational root = -klein(a, b) / klein(b, b);
  Complex axis = a;
  for (std::size_t i = 0; i < axis.size(); ++i) axis[i] += root * b[i];
  const AxisPosition axis_position = position(omega(axis, axis));
  const bool tangent_pencil = axis_position == AxisPosition::kTangent && omega(axis, b).is_zero();
  return {NetKind::kParabolic, {axis_position}, false, tangent_pencil};
}

char letter(AxisPosition position) {
  switch (position) {
    case AxisPosition::kPassant:
      return 'P';
    case AxisPosition::kSecant:
      return 'S';
    default:
      return 'T';
  }
}

std::string name(NetKind kind) {
  switch (kind) {
    case NetKind::kHyperbolic:
      return "hyperbolic";
    case NetKind::kElliptic:
      return "elliptic";
    case NetKind::kParabolic:
      return "parabolic";
    default:
      return "singular";
  }
}

}  // namespace

NetType net_type(const LineNet& net) {
  if (rank({net.a, net.b}) < 2) throw std::domain_error("The complexes of a net are independent.");
  const LineNet pencil = with_regular_second_complex(net);
  if (klein(pencil.b, pencil.b).is_zero()) return {NetKind::kSingular, {}};
  const Rational ab = klein(pencil.a, pencil.b);
  const int discriminant = (ab * ab - klein(pencil.a, pencil.a) * klein(pencil.b, pencil.b)).sign();
  if (discriminant > 0) return hyperbolic_type(pencil);
  return discriminant < 0 ? elliptic_type(pencil) : parabolic_type(pencil);
}

std::string name(const NetType& type) {
  std::string result = name(type.kind);
  for (std::size_t i = 0; i < type.axes.size(); ++i) {
    result += i == 0 ? ' ' : '/';
    result += letter(type.axes[i]);
  }
  if (type.polar_axes) result += " polar";
  if (type.kind == NetKind::kParabolic && type.axes.front() == AxisPosition::kTangent)
    result += type.tangent_pencil ? " a" : " b";
  return result;
}

}  // namespace pn
