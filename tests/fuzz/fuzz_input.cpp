// SPDX-License-Identifier: LGPL-2.1-or-later
#include "fuzz_input.hpp"

#include <cstring>
#include <limits>

#include "pn/algebra/bernstein.hpp"
#include "pn/bezier/bspline_surface.hpp"
#include "pn/geometry_error.hpp"
#include "pn/input_numbers.hpp"

namespace pn::fuzz {
namespace {

using Limits = std::numeric_limits<double>;

constexpr std::array<double, 16> kSpecial = {-0.0,
                                             Limits::denorm_min(),
                                             -Limits::min(),
                                             Limits::epsilon(),
                                             1 + Limits::epsilon(),
                                             1 - Limits::epsilon() / 2,
                                             1e-150,
                                             1e-9,
                                             0.1,
                                             1e9,
                                             -1e9,
                                             1e150,
                                             Limits::max(),
                                             -Limits::max(),
                                             Limits::infinity(),
                                             Limits::quiet_NaN()};

}  // namespace

double FuzzInput::number() {
  const int b = byte();
  if (b < 112) return b / 4.0;
  if (b < 224) return (111 - b) / 4.0;
  if (b < 240) return (b - 232) + byte() / 256.0;
  if (b < 248) return kSpecial[byte() % kSpecial.size()];
  return bits();
}

double FuzzInput::bits() {
  std::array<std::uint8_t, sizeof(double)> bytes;
  for (std::uint8_t& b : bytes) b = byte();
  double result;
  std::memcpy(&result, bytes.data(), sizeof(result));
  return result;
}

std::vector<double> FuzzInput::numbers(std::size_t count) {
  std::vector<double> result(count);
  for (double& x : result) x = number();
  return result;
}

template <std::size_t Dimension>
BSplineData<Dimension> FuzzInput::bspline(const SplineSize& size) {
  BSplineData<Dimension> data;
  data.degree = 1 + choice(size.degree);
  data.knots = {flag() ? number() : 0.0};
  data.multiplicities = {data.degree + 1};
  for (int spans = 1 + choice(size.spans); spans > 0; --spans) {
    data.knots.push_back(data.knots.back() + (seldom() ? number() : (1 + choice(8)) / 4.0));
    data.multiplicities.push_back(spans > 1 ? 1 + choice(data.degree) : data.degree + 1);
  }
  if (seldom()) data.multiplicities[byte() % data.multiplicities.size()] = choice(size.degree);
  const std::size_t count = seldom() ? byte() % 8 : pole_count(data.degree, data.multiplicities);
  const bool is_rational = choice(4) == 3, is_closed = choice(4) == 3;
  for (std::size_t i = 0; i < count; ++i) data.poles.push_back(point<Dimension>());
  if (is_closed && count > 0) data.poles.back() = data.poles.front();
  if (!is_rational) return data;
  for (std::size_t i = 0; i < count; ++i) {
    data.weights.push_back(seldom() ? number() : (1 + choice(16)) / 4.0);
  }
  return data;
}

template BSplineData<1> FuzzInput::bspline(const SplineSize&);
template BSplineData<2> FuzzInput::bspline(const SplineSize&);
template BSplineData<3> FuzzInput::bspline(const SplineSize&);
template BSplineData<4> FuzzInput::bspline(const SplineSize&);

SplineSurfaceData FuzzInput::spline_surface(const SplineSize& size) {
  const auto along = bspline<1>(size), across = bspline<1>(size);
  SplineSurfaceData data{{along.degree, across.degree},
                         {along.knots, across.knots},
                         {along.multiplicities, across.multiplicities},
                         {},
                         {}};
  const bool is_rational = !along.weights.empty();
  for (std::size_t i = along.poles.size() * across.poles.size(); i > 0; --i) {
    data.poles.push_back(point<3>());
    if (is_rational) data.weights.push_back(seldom() ? number() : (1 + choice(16)) / 4.0);
  }
  return data;
}

SphereSpline FuzzInput::sphere_spline(const SplineSize& size) {
  return SphereSpline::bspline(bspline<4>(size));
}

Law FuzzInput::law(const SplineSize& size) {
  switch (choice(3)) {
    case 0:
      return Law::constant(number());
    case 1:
      return Law::bezier(numbers(static_cast<std::size_t>(1 + choice(size.degree + 1))));
    default:
      return Law::bspline(bspline<1>(size));
  }
}

RationalPolynomial FuzzInput::polynomial(int degree) {
  std::vector<Rational> bernstein;
  for (int k = 0; k <= degree; ++k) {
    const double x = number();
    require_input_number(x, "A coefficient");
    bernstein.push_back(Rational::exactly(x));
  }
  return RationalPolynomial(from_bernstein(std::move(bernstein)));
}

}  // namespace pn::fuzz
