// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/conics/rational_lattice.hpp"

#include <algorithm>
#include <limits>
#include <vector>

#include "pn/algebra/power_of_two.hpp"

namespace pn {
namespace {

using Polynomial = RationalPolynomial;

/// Values at infinity are rational numbers: the field of any linear polynomial serves.
ResidueField field_of(const Place& place) { return ResidueField(place ? *place : power_of_t(1)); }

/// The line of a conic of rank 1: a row that is not zero.
Vector3<Polynomial> double_line(const Matrix3<Polynomial>& conic) {
  return *std::find_if(conic.begin(), conic.end(), [&](const Vector3<Polynomial>& row) {
    return std::any_of(row.begin(), row.end(), [](const Polynomial& p) { return !p.is_zero(); });
  });
}

Matrix3<Polynomial> reduced(Matrix3<Polynomial> m, const ResidueField& field) {
  for (auto& row : m) {
    for (Polynomial& entry : row) entry = field.reduced(entry);
  }
  return m;
}

/// What makes of polynomials some whose coefficients have no common factor but a power of two, and
/// are at most about 1: doubles look for lines later on, and long integers are too large for them.
Polynomial to_short_numbers(const std::vector<Polynomial>& polynomials) {
  Rational common;
  for (const Polynomial& p : polynomials) common = gcd(common, content(p));
  return Polynomial(power_of_two_near(common) / (common * power_of_two_near(polynomials)));
}

}  // namespace

RationalLattice::RationalLattice(const ConicFamily& family)
    : row_degree_(family.degree),
      conic_(family.matrix),
      degree_(family.degree),
      twist_(family.twist) {
  for (std::size_t i = 0; i < 3; ++i) basis_[i][i] = Polynomial(1L);
}

Matrix3<Polynomial> RationalLattice::at(const Place& place) const {
  if (place) return reduced(conic_, ResidueField(*place));
  Matrix3<Polynomial> top;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      const int degree = degree_[i] + degree_[j] + twist_;
      if (degree >= 0) top[i][j] = Polynomial(conic_[i][j].coefficient(degree));
    }
  }
  return top;
}

/// w_i <- w_i - (l_i / l_j) w_j for the lowest w_j off the line, and w_j <- L w_j.
void RationalLattice::step_onto_line(const Place& place, const Vector3<Polynomial>& line,
                                     int divisions) {
  const ResidueField field = field_of(place);
  std::size_t pivot = 3;
  for (std::size_t j = 0; j < 3; ++j) {
    if (line[j].is_zero()) continue;
    if (pivot == 3 || degree_[j] < degree_[pivot]) pivot = j;
  }
  const Polynomial inverse = field.inverse(line[pivot]);
  for (std::size_t i = 0; i < 3; ++i) {
    if (i == pivot || line[i].is_zero()) continue;
    const Polynomial ratio = field.product(line[i], inverse);
    const Polynomial lift = place ? ratio : ratio * power_of_t(degree_[i] - degree_[pivot]);
    add_multiple(i, -lift, pivot);
  }
  if (place) {
    multiply(pivot, *place);
    divide(*place, divisions);
    reduce();
  } else {
    ++degree_[pivot];
    twist_ -= divisions;
  }
}

/// w_j <- sum of (n_i / n_j) w_i for the double point n and the highest w_j of it, the others
/// w_i <- L w_i.
void RationalLattice::step_onto_double_point(const Place& place) {
  const ResidueField field = field_of(place);
  const Vector3<Polynomial> point = double_line(reduced(adjugate(at(place)), field));
  std::size_t pivot = 3;
  for (std::size_t j = 0; j < 3; ++j) {
    if (point[j].is_zero()) continue;
    if (pivot == 3 || degree_[j] > degree_[pivot]) pivot = j;
  }
  const Polynomial inverse = field.inverse(point[pivot]);
  for (std::size_t i = 0; i < 3; ++i) {
    if (i == pivot) continue;
    if (!point[i].is_zero()) {
      const Polynomial ratio = field.product(point[i], inverse);
      add_multiple(pivot, place ? ratio : ratio * power_of_t(degree_[pivot] - degree_[i]), i);
    }
    if (place) {
      multiply(i, *place);
    } else {
      ++degree_[i];
    }
  }
  if (place) {
    divide(*place, 2);
    reduce();
  } else {
    twist_ -= 2;
  }
}

void RationalLattice::add_multiple(std::size_t column, const Polynomial& factor, std::size_t of) {
  for (auto& row : basis_) row[column] += factor * row[of];
  for (std::size_t k = 0; k < 3; ++k) conic_[column][k] += factor * conic_[of][k];
  for (std::size_t k = 0; k < 3; ++k) conic_[k][column] += factor * conic_[k][of];
}

void RationalLattice::multiply(std::size_t column, const Polynomial& factor) {
  for (auto& row : basis_) row[column] *= factor;
  for (std::size_t k = 0; k < 3; ++k) conic_[column][k] *= factor;
  for (std::size_t k = 0; k < 3; ++k) conic_[k][column] *= factor;
}

void RationalLattice::divide(const Polynomial& factor, int times) {
  for (auto& row : conic_) {
    for (Polynomial& entry : row) {
      for (int i = 0; i < times; ++i) entry = exact_quotient(entry, factor);
    }
  }
  twist_ -= times * factor.degree();
}

LeadingTerm RationalLattice::leading_term(std::size_t column) const {
  // Rows may have negative degrees, so no degree tells a zero apart.
  const auto height = [&](std::size_t i) {
    return basis_[i][column].is_zero() ? std::numeric_limits<int>::min()
                                       : basis_[i][column].degree() + row_degree_[i];
  };
  std::size_t row = 0;
  for (std::size_t i = 1; i < 3; ++i) {
    if (height(i) >= height(row)) row = i;
  }
  const Polynomial& entry = basis_[row][column];
  return {row, height(row), entry.coefficient(entry.degree())};
}

void RationalLattice::reduce() {
  reduce_columns(
      3, [&](std::size_t j) { return leading_term(j); },
      [&](std::size_t i, const Polynomial& factor, std::size_t j) { add_multiple(i, factor, j); });
  for (std::size_t j = 0; j < 3; ++j) degree_[j] = leading_term(j).degree;
  make_primitive();
}

void RationalLattice::make_primitive() {
  for (std::size_t j = 0; j < 3; ++j) {
    multiply(j, to_short_numbers({basis_[0][j], basis_[1][j], basis_[2][j]}));
  }
  std::vector<Polynomial> entries;
  for (const auto& row : conic_) entries.insert(entries.end(), row.begin(), row.end());
  const Polynomial factor = to_short_numbers(entries);
  for (auto& row : conic_) {
    for (Polynomial& entry : row) entry *= factor;
  }
}

/// By Cramer's rule, up to a factor.
LatticePoint in_lattice(const RationalLattice& lattice, const Vector3<Polynomial>& point) {
  const Matrix3<Polynomial> inverse = adjugate(lattice.basis());
  LatticePoint result{{}, 0};
  Polynomial common;
  for (std::size_t j = 0; j < 3; ++j) {
    Polynomial& y = result.coordinate[j];
    for (std::size_t i = 0; i < 3; ++i) y += inverse[j][i] * point[i];
    common = gcd(common, y);
  }
  std::optional<int> degree;
  for (std::size_t j = 0; j < 3; ++j) {
    Polynomial& y = result.coordinate[j];
    if (y.is_zero()) continue;
    y = exact_quotient(y, common);
    const int needed = y.degree() + lattice.degree()[j];
    degree = std::max(degree.value_or(needed), needed);
  }
  result.degree = *degree;
  return result;
}

/// With v v^T = -adj M, both M + [v]_x and M - [v]_x have rank 1, and their rows are the lines.
std::optional<std::array<Vector3<Polynomial>, 2>> rational_lines(const Matrix3<Polynomial>& conic,
                                                                 const ResidueField& field) {
  const Matrix3<Polynomial> minors = reduced(adjugate(conic), field);
  std::size_t k = 0;
  while (minors[k][k].is_zero()) ++k;
  const std::optional<Polynomial> root = field.square_root(-minors[k][k]);
  if (!root) return std::nullopt;
  const Polynomial inverse = field.inverse(*root);
  Vector3<Polynomial> v;
  for (std::size_t i = 0; i < 3; ++i) v[i] = field.product(-minors[i][k], inverse);
  const auto line = [&](const Vector3<Polynomial>& w) {
    return double_line({{{conic[0][0], conic[0][1] - w[2], conic[0][2] + w[1]},
                         {conic[1][0] + w[2], conic[1][1], conic[1][2] - w[0]},
                         {conic[2][0] - w[1], conic[2][1] + w[0], conic[2][2]}}});
  };
  return std::array<Vector3<Polynomial>, 2>{line(v), line({-v[0], -v[1], -v[2]})};
}

namespace {

/// The steps at one place.
void step_down(RationalSteps& steps, const Place& place, SmithType type,
               const ChooseLattice& choose, Leave leave) {
  RationalLattice& lattice = steps.lattice;
  for (; type.a >= 2; type.a -= 2, type.b -= 2) {
    lattice.step_onto_line(place, double_line(lattice.at(place)), 2);
  }
  int p = type.b;
  if (type.a == 1) {
    for (int i = 0; i < type.b; ++i) {
      lattice.step_onto_line(place, double_line(lattice.at(place)), 1);
    }
    p = 1;
  }
  if (p == 0) return;
  if (leave == Leave::kEveryChoice) {
    steps.left.push_back({place, p});
    return;
  }
  const ResidueField field = field_of(place);
  while (p > 0) {
    if (const auto lines = rational_lines(lattice.at(place), field)) {
      std::array<RationalLattice, 2> next = {lattice, lattice};
      for (std::size_t i = 0; i < 2; ++i) next[i].step_onto_line(place, (*lines)[i], 1);
      lattice = std::move(next[choose(next[0], next[1]) == 0 ? 0 : 1]);
      ++steps.choices;
      p -= 1;
    } else if (p >= 2) {
      lattice.step_onto_double_point(place);
      ++steps.double_points;
      p -= 2;
    } else {
      steps.left.push_back({place, p});
      return;
    }
  }
}

}  // namespace

RationalSteps rational_steps(const ConicFamily& family, const SingularConics& singular,
                             const ChooseLattice& choose, Leave leave) {
  RationalSteps steps{RationalLattice(family), {}, 0, 0};
  for (const SingularFactor& part : singular.finite) {
    for (const Polynomial& factor : irreducible_factors(part.factor)) {
      step_down(steps, factor, part.type, choose, leave);
    }
  }
  step_down(steps, std::nullopt, singular.at_infinity, choose, leave);
  return steps;
}

}  // namespace pn
