// SPDX-License-Identifier: LGPL-2.1-or-later
// A second route to what the kernel exports: splines by de Boor's algorithm and sections of Gamma
// at points, over Q or in balls.
#pragma once

#include <algorithm>
#include <array>
#include <vector>

#include "pn/bezier/bspline_surface.hpp"
#include "pn/bezier/circle_parameter.hpp"
#include "pn/isotropic/isotropic_hypersurface.hpp"

namespace pn::test {

/// A zero that an enclosure proves: it contains zero and is narrower than `scale` allows.
inline bool encloses_zero(const RealBall& x, double scale) {
  return x.contains_zero() && x.magnitude_upper() <= scale;
}

/// Every knot as often as its multiplicity says, as numbers of type T.
template <class T, class Convert>
std::vector<T> flat_knots(const std::vector<double>& knots, const std::vector<int>& multiplicities,
                          Convert&& convert) {
  std::vector<T> flat;
  for (std::size_t i = 0; i < knots.size(); ++i) {
    flat.insert(flat.end(), static_cast<std::size_t>(multiplicities[i]), convert(knots[i]));
  }
  return flat;
}

/// The index of the last knot of the span that holds x; the last span is closed.
inline std::size_t span_at(const std::vector<double>& knots, const std::vector<int>& multiplicities,
                           double x) {
  std::size_t last = static_cast<std::size_t>(multiplicities[0]) - 1;
  for (std::size_t i = 1; i + 1 < knots.size() && knots[i] <= x; ++i) {
    last += static_cast<std::size_t>(multiplicities[i]);
  }
  return last;
}

/// de Boor's algorithm for coefficients that add and can be multiplied by T: coefficients[i] is the
/// one of index last - degree + i.
template <class T, class Coefficient>
Coefficient de_boor(int degree, const std::vector<T>& flat, std::size_t last,
                    std::vector<Coefficient> coefficients, const T& x) {
  const auto n = static_cast<std::size_t>(degree);
  for (std::size_t round = 1; round <= n; ++round) {
    for (std::size_t j = n; j >= round; --j) {
      const T& low = flat[last - n + j];
      const T& high = flat[last + j + 1 - round];
      const T ratio = (x - low) / (high - low);
      coefficients[j] = coefficients[j - 1] * (T(1L) - ratio) + coefficients[j] * ratio;
    }
  }
  return coefficients[n];
}

/// x, y, z and weight.
struct Homogeneous {
  std::array<RealBall, 4> coordinate;
  friend Homogeneous operator*(Homogeneous a, const RealBall& factor) {
    for (RealBall& x : a.coordinate) x *= factor;
    return a;
  }
  friend Homogeneous operator+(Homogeneous a, const Homogeneous& b) {
    for (std::size_t i = 0; i < 4; ++i) a.coordinate[i] += b.coordinate[i];
    return a;
  }
  std::array<RealBall, 3> point() const {
    return {coordinate[0] / coordinate[3], coordinate[1] / coordinate[3],
            coordinate[2] / coordinate[3]};
  }
};

/// The enclosed point of the surface with these weighted control points over the knots of the
/// frame.
inline std::array<RealBall, 3> enclosed_point(const BSplineSurface& frame,
                                              const std::vector<Homogeneous>& controls, double u,
                                              double v, long precision) {
  const auto ball = [&](double x) { return RealBall(x).at_precision(precision); };
  const auto u_flat = flat_knots<RealBall>(frame.u_knots, frame.u_multiplicities, ball);
  const auto v_flat = flat_knots<RealBall>(frame.v_knots, frame.v_multiplicities, ball);
  const std::size_t u_last = span_at(frame.u_knots, frame.u_multiplicities, u);
  const std::size_t v_last = span_at(frame.v_knots, frame.v_multiplicities, v);
  const auto v_degree = static_cast<std::size_t>(frame.v_degree);
  std::vector<Homogeneous> rows;
  for (std::size_t i = u_last - static_cast<std::size_t>(frame.u_degree); i <= u_last; ++i) {
    const auto first =
        controls.begin() + static_cast<std::ptrdiff_t>(i * frame.v_count() + v_last - v_degree);
    const std::vector<Homogeneous> row(first, first + static_cast<std::ptrdiff_t>(v_degree) + 1);
    rows.push_back(de_boor(frame.v_degree, v_flat, v_last, row, ball(v)));
  }
  return de_boor(frame.u_degree, u_flat, u_last, std::move(rows), ball(u)).point();
}

/// The enclosed point of the surface that the doubles describe exactly.
inline std::array<RealBall, 3> enclosed_point(const BSplineSurface& surface, double u, double v,
                                              long precision) {
  const auto ball = [&](double x) { return RealBall(x).at_precision(precision); };
  std::vector<Homogeneous> controls;
  controls.reserve(surface.poles.size());
  for (std::size_t i = 0; i < surface.poles.size(); ++i) {
    const auto& pole = surface.poles[i];
    controls.push_back(Homogeneous{{ball(pole[0]), ball(pole[1]), ball(pole[2]), ball(1)}} *
                       ball(surface.weights[i]));
  }
  return enclosed_point(surface, controls, u, v, precision);
}

/// The factors of the coefficients of a form in u at parameter v of the columns, exactly.
inline std::vector<Rational> circle_coefficients(const CircleColumns& columns, double v) {
  const auto flat = flat_knots<Rational>(columns.knots, columns.multiplicities, Rational::exactly);
  const std::size_t last = span_at(columns.knots, columns.multiplicities, v);
  std::vector<Rational> result;
  for (std::size_t q = 0; q < columns.coefficients.front().size(); ++q) {
    std::vector<Rational> active;
    for (std::size_t j = last - static_cast<std::size_t>(columns.degree); j <= last; ++j) {
      active.push_back(columns.coefficients[j][q]);
    }
    result.push_back(de_boor(columns.degree, flat, last, std::move(active), Rational::exactly(v)));
  }
  return result;
}

/// The sum of the form's coefficients at t times these factors.
inline RealBall value(const FormInU<RealBall>& form, const RealBall& t,
                      const std::vector<RealBall>& factors) {
  RealBall sum;
  for (std::size_t j = 0; j < factors.size(); ++j) sum += form.coefficient[j](t) * factors[j];
  return sum;
}

inline RealBall power(const RealBall& x, int exponent) {
  RealBall result(1);
  for (int i = 0; i < exponent; ++i) result *= x;
  return result;
}

/// The form in t that is left at u = (u0 : u1).
inline Form<RealBall> at_u(const FormInU<RealBall>& form, const RealBall& u0, const RealBall& u1) {
  const int n = form.degree();
  Form<RealBall> sum;
  for (int j = 0; j <= n; ++j) {
    sum += form.coefficient[static_cast<std::size_t>(j)] *
           (RealBall(small_binomial(n, j)) * power(u0, n - j) * power(u1, j));
  }
  return sum;
}

/// The derivatives by u0 and u1, divided by the degree: F = u0 F_0 + u1 F_1.
inline std::array<FormInU<RealBall>, 2> polars(const FormInU<RealBall>& form) {
  std::array<FormInU<RealBall>, 2> result;
  const auto n = static_cast<std::size_t>(form.degree());
  for (std::size_t j = 0; j < n; ++j) {
    result[0].coefficient.push_back(form.coefficient[j]);
    result[1].coefficient.push_back(form.coefficient[j + 1]);
  }
  return result;
}

/// Value of a form with its derivatives by t and along the circle, at u = (u0 : u1).
struct Jet {
  RealBall value, along, around;
};

inline Jet jet(const FormInU<RealBall>& form, const RealBall& t, const RealBall& u0,
               const RealBall& u1) {
  const Form<RealBall> here = at_u(form, u0, u1);
  const auto [by_u0, by_u1] = polars(form);
  const RealBall around = at_u(by_u1, u0, u1)(t) * u0 - at_u(by_u0, u0, u1)(t) * u1;
  return {here(t), here.derivative()(t), around * RealBall(form.degree())};
}

}  // namespace pn::test
