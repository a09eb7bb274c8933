// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/minkowski/laguerre_map.hpp"

#include <stdexcept>

namespace pn {

namespace {

using Vector = LaguerreMap::Vector;
using Matrix = LaguerreMap::Matrix;

Vector unit_vector(std::size_t i) {
  Vector e;
  e[i] = Rational(1L);
  return e;
}

Vector column(const Matrix& m, std::size_t j) { return {m[0][j], m[1][j], m[2][j], m[3][j]}; }

/// The matrix of x -> map(x), a linear map.
template <class Map>
Matrix matrix_of(const Map& map) {
  Matrix m;
  for (std::size_t j = 0; j < 4; ++j) {
    const Vector image = map(unit_vector(j));
    for (std::size_t i = 0; i < 4; ++i) m[i][j] = image[i];
  }
  return m;
}

/// k with <L x, L y> = k <x, y>.
Rational square_factor(const Matrix& linear) {
  const Rational k = minkowski(column(linear, 0), column(linear, 0));
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = 0; j <= i; ++j) {
      if (minkowski(column(linear, i), column(linear, j)) !=
          k * minkowski(unit_vector(i), unit_vector(j)))
        throw std::domain_error("The matrix is no similarity of Minkowski space.");
    }
  }
  if (k.is_zero()) throw std::domain_error("The map is singular.");
  return k;
}

}  // namespace

LaguerreMap::LaguerreMap(const Matrix& linear, const Vector& translation)
    : linear_(linear), translation_(translation), square_factor_(pn::square_factor(linear)) {}

LaguerreMap LaguerreMap::identity() { return translation({}); }

LaguerreMap LaguerreMap::translation(const Vector& t) {
  return {matrix_of([](const Vector& x) { return x; }), t};
}

LaguerreMap LaguerreMap::dilation(const Rational& factor) {
  return {matrix_of([&](const Vector& x) { return translated({}, factor, x); }), {}};
}

LaguerreMap LaguerreMap::reflection(const Vector& a) {
  const Rational scale = Rational(-2L) / minkowski(a, a);
  return {matrix_of([&](const Vector& x) { return translated(x, scale * minkowski(a, x), a); }),
          {}};
}

Vector LaguerreMap::direction(const Vector& w) const {
  Vector image;
  for (std::size_t j = 0; j < 4; ++j) image = translated(image, w[j], column(linear_, j));
  return image;
}

Vector LaguerreMap::operator()(const Vector& x) const {
  return translated(translation_, Rational(1L), direction(x));
}

OrientedPlane<Rational> LaguerreMap::operator()(const OrientedPlane<Rational>& plane) const {
  const Vector w = direction(plane.w);
  return {w, square_factor_ * plane.c + minkowski(w, translation_)};
}

LaguerreMap LaguerreMap::inverse() const {
  // <L e, y> = k <e, L^-1 y>
  const Matrix back = matrix_of([this](const Vector& y) {
    Vector x;
    for (std::size_t i = 0; i < 4; ++i) {
      const Vector e = unit_vector(i);
      x[i] = minkowski(direction(e), y) * minkowski(e, e) / square_factor_;
    }
    return x;
  });
  const LaguerreMap linear(back, {});
  return {back, translated({}, Rational(-1L), linear.direction(translation_))};
}

LaguerreMap operator*(const LaguerreMap& a, const LaguerreMap& b) {
  return {matrix_of([&](const Vector& x) { return a.direction(b.direction(x)); }),
          a(b.translation_)};
}

}  // namespace pn
