// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/conics/line_conditions.hpp"

#include <algorithm>
#include <cmath>

#include "pn/algebra/ball_kernel.hpp"
#include "pn/algebra/roots.hpp"
#include "pn/conics/conic_normal_form.hpp"

namespace pn {
namespace {

using Complex = std::complex<double>;

Form<RealBall> form(const RationalPolynomial& p, int degree, long precision) {
  if (degree < 0) return {};
  std::vector<RealBall> balls;
  for (const Rational& c : coefficients(p, degree)) balls.emplace_back(c, precision);
  return Form<RealBall>(std::move(balls));
}

double size(const ComplexBall& z) { return std::abs(z.midpoint()); }

Jet product(const Jet& a, const Jet& b) {
  Jet result(a.size());
  add_product(result, a, b);
  return result;
}
Jet sum(Jet a, const Jet& b) {
  for (std::size_t i = 0; i < a.size(); ++i) a[i] += b[i];
  return a;
}
Jet negative(Jet a) {
  for (ComplexBall& x : a) x = -x;
  return a;
}

/// One of the square roots; away from the cut of the principal one.
ComplexBall any_square_root(const ComplexBall& z) {
  if (z.midpoint().real() >= 0) return sqrt(z);
  return ComplexBall(RealBall(), RealBall(1)) * sqrt(-z);
}

Jet any_square_root(const Jet& a) {
  Jet root(a.size());
  root[0] = any_square_root(a[0]);
  const ComplexBall twice = root[0] + root[0];
  for (std::size_t k = 1; k < a.size(); ++k) {
    ComplexBall rest = a[k];
    for (std::size_t i = 1; i < k; ++i) rest -= root[i] * root[k - i];
    root[k] = rest / twice;
  }
  return root;
}

double length(const Vector3<Jet>& v) {
  return std::max({size(v[0][0]), size(v[1][0]), size(v[2][0])});
}

/// About 1 in its largest coordinate.
Vector3<Jet> scaled_to_unit(Vector3<Jet> v) {
  const double largest = length(v);
  if (!std::isfinite(largest) || largest == 0) throw Undecided("the lines of a singular conic");
  const ComplexBall scale(std::exp2(-std::ilogb(largest)));
  for (Jet& jet : v) {
    for (ComplexBall& x : jet) x *= scale;
  }
  return v;
}

Matrix3<Jet> adjugate(const Matrix3<Jet>& m) {
  Matrix3<Jet> minors;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t i1 = (i + 1) % 3, i2 = (i + 2) % 3;
    for (std::size_t j = 0; j < 3; ++j) {
      const std::size_t j1 = (j + 1) % 3, j2 = (j + 2) % 3;
      minors[i][j] = sum(product(m[i1][j1], m[i2][j2]), negative(product(m[i1][j2], m[i2][j1])));
    }
  }
  return minors;
}

/// As rational_lines, times the square root and from the largest entries.
LinePair pair_of(const std::optional<ComplexBall>& place, bool is_real, const Matrix3<Jet>& m) {
  const Matrix3<Jet> minors = adjugate(m);
  std::size_t k = 0;
  for (std::size_t i = 1; i < 3; ++i) {
    if (size(minors[i][i][0]) > size(minors[k][k][0])) k = i;
  }
  const ComplexBall& minor = minors[k][k][0];
  if (minor.contains_zero()) throw Undecided("the rank of a singular conic");
  const auto kind = !is_real                     ? LinePair::Kind::kComplexPlace
                    : minor.real().is_negative() ? LinePair::Kind::kRealLines
                                                 : LinePair::Kind::kConjugateLines;
  const Jet root = any_square_root(negative(minors[k][k]));
  const auto line = [&](const Jet& r) {
    Matrix3<Jet> rows;
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < 3; ++j) rows[i][j] = product(r, m[i][j]);
    }
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t i1 = (i + 1) % 3, i2 = (i + 2) % 3;
      rows[i1][i2] = sum(rows[i1][i2], minors[i][k]);
      rows[i2][i1] = sum(rows[i2][i1], negative(minors[i][k]));
    }
    return scaled_to_unit(
        *std::max_element(rows.begin(), rows.end(),
                          [](const auto& a, const auto& b) { return length(a) < length(b); }));
  };
  return {place, kind, static_cast<int>(m[0][0].size()), {line(root), line(negative(root))}};
}

/// The first coefficients in tau = t - c, or s at infinity.
Jet jet(const Form<RealBall>& form, const std::optional<ComplexBall>& place, int count) {
  Jet result(static_cast<std::size_t>(count));
  if (!place) {
    for (int k = 0; k < count && k <= form.degree(); ++k) {
      result[static_cast<std::size_t>(k)] = ComplexBall(form[form.degree() - k]);
    }
    return result;
  }
  // Horner's scheme with polynomials in tau.
  for (int i = form.degree(); i >= 0; --i) {
    for (std::size_t k = result.size(); k-- > 0;) {
      result[k] *= *place;
      if (k > 0) result[k] += result[k - 1];
    }
    result[0] += ComplexBall(form[i]);
  }
  return result;
}

Vector3<Complex> midpoint(const Vector3<Jet>& v) {
  return {v[0][0].midpoint(), v[1][0].midpoint(), v[2][0].midpoint()};
}

/// Of lines, near 0 if they are the same.
double distance(const Vector3<Complex>& a, const Vector3<Complex>& b) {
  return std::abs(a[1] * b[2] - a[2] * b[1]) + std::abs(a[2] * b[0] - a[0] * b[2]) +
         std::abs(a[0] * b[1] - a[1] * b[0]);
}

double distance(const std::optional<Complex>& a, const std::optional<Complex>& b) {
  if (!a || !b) return a || b ? HUGE_VAL : 0;
  return std::abs(*a - *b);
}

std::optional<Complex> midpoint(const std::optional<ComplexBall>& place) {
  if (!place) return std::nullopt;
  return place->midpoint();
}

/// The coefficient of tau^order in l.y, as a row for the coefficients of y, scaled so that no power
/// is large.
std::vector<ComplexBall> condition(const LinePair& pair, const Vector3<Jet>& line, int order,
                                   const Vector3<int>& degree) {
  const int highest = *std::max_element(degree.begin(), degree.end());
  const bool beyond = pair.place && size(*pair.place) > 1;
  const ComplexBall one(1.0);
  const ComplexBall base = !pair.place ? ComplexBall() : beyond ? one / *pair.place : *pair.place;
  std::vector<ComplexBall> power = {one};
  for (int i = 0; i < highest + order; ++i) power.push_back(power.back() * base);
  std::vector<ComplexBall> row;
  for (std::size_t i = 0; i < 3; ++i) {
    for (int p = 0; p <= degree[i]; ++p) {
      const int exponent = pair.place ? p : degree[i] - p;
      ComplexBall entry;
      double binomial = 1;
      for (int q = 0; q <= std::min(order, exponent); ++q) {
        const int reduced = beyond ? highest - exponent + q : exponent - q;
        entry += line[i][static_cast<std::size_t>(order - q)] * ComplexBall(binomial) *
                 power[static_cast<std::size_t>(reduced)];
        binomial = binomial * (exponent - q) / (q + 1);
      }
      row.push_back(std::move(entry));
    }
  }
  return row;
}

std::vector<RealBall> real_part(const std::vector<ComplexBall>& row) {
  std::vector<RealBall> result;
  for (const ComplexBall& z : row) result.push_back(z.real());
  return result;
}

std::vector<RealBall> imaginary_part(const std::vector<ComplexBall>& row) {
  std::vector<RealBall> result;
  for (const ComplexBall& z : row) result.push_back(z.imag());
  return result;
}

}  // namespace

std::vector<LinePair> line_pairs(const RationalSteps& steps, long precision) {
  const RationalLattice& lattice = steps.lattice;
  Matrix3<Form<RealBall>> conic;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      conic[i][j] = form(lattice.conic()[i][j],
                         lattice.degree()[i] + lattice.degree()[j] + lattice.twist(), precision);
    }
  }
  const auto pair_at = [&](const std::optional<ComplexBall>& place, bool is_real,
                           int multiplicity) {
    Matrix3<Jet> at;
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < 3; ++j) at[i][j] = jet(conic[i][j], place, multiplicity);
    }
    return pair_of(place, is_real, at);
  };
  std::vector<LinePair> pairs;
  for (const auto& [place, multiplicity] : steps.left) {
    if (!place) {
      pairs.push_back(pair_at(std::nullopt, true, multiplicity));
      continue;
    }
    const RootSet roots = isolate_roots(*place, precision);
    for (const auto& c : roots.pairs) pairs.push_back(pair_at(c.value, false, multiplicity));
    for (const auto& c : roots.real) {
      pairs.push_back(pair_at(ComplexBall(c.value), true, multiplicity));
    }
  }
  return pairs;
}

std::vector<ChosenLine> places_of(const std::vector<LinePair>& pairs, const LineChoice& choice) {
  std::vector<ChosenLine> places;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    places.push_back({midpoint(pairs[i].place), midpoint(pairs[i].line[0]), choice[i]});
  }
  return places;
}

LineChoice recognized(const std::vector<LinePair>& pairs, const std::vector<ChosenLine>& chosen) {
  LineChoice choice;
  for (const LinePair& pair : pairs) {
    const std::optional<Complex> here = midpoint(pair.place);
    const auto known = std::min_element(chosen.begin(), chosen.end(),
                                        [&](const ChosenLine& a, const ChosenLine& b) {
                                          return distance(a.place, here) < distance(b.place, here);
                                        });
    const bool same_order = distance(known->first_line, midpoint(pair.line[0])) <=
                            distance(known->first_line, midpoint(pair.line[1]));
    choice.push_back(same_order ? known->conditions : pair.multiplicity - known->conditions);
  }
  return choice;
}

LineConditions::LineConditions(const RationalSteps& steps, std::vector<LinePair> pairs,
                               long precision)
    : pairs_(std::move(pairs)), precision_(precision), column_degree_(steps.lattice.degree()) {
  const RationalLattice& lattice = steps.lattice;
  const Vector3<int>& e = column_degree_;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      basis_[i][j] = form(lattice.basis()[i][j], e[j] - lattice.row_degree()[i], precision);
      conic_[i][j] = form(lattice.conic()[i][j], e[i] + e[j] + lattice.twist(), precision);
    }
  }
  for (const LinePair& pair : pairs_) {
    rows_ += (pair.is_real() ? 1 : 2) * pair.multiplicity;
  }
  m_ = (e[0] + e[1] + e[2] + rows_) / 3;
}

bool LineConditions::has_real_lines() const {
  return std::any_of(pairs_.begin(), pairs_.end(),
                     [](const LinePair& pair) { return pair.kind == LinePair::Kind::kRealLines; });
}

/// A basis of the vectors y on the chosen lines, when they have this dimension.
std::optional<std::vector<LineConditions::Vector>> LineConditions::on_lines(
    const LineChoice& choice, int degree, std::size_t dimension) const {
  Vector3<int> d;
  std::size_t unknowns = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    d[i] = degree - column_degree_[i];
    unknowns += static_cast<std::size_t>(std::max(d[i] + 1, 0));
  }
  const auto most = static_cast<std::size_t>(rows_) + dimension;
  if (unknowns < dimension || unknowns > most) return std::nullopt;
  std::vector<std::vector<RealBall>> rows;
  const auto add_conditions = [&](const LinePair& pair, std::size_t line, int count) {
    for (int order = 0; order < count; ++order) {
      const auto row = condition(pair, pair.line[line], order, d);
      rows.push_back(real_part(row));
      if (pair.kind != LinePair::Kind::kRealLines) rows.push_back(imaginary_part(row));
    }
  };
  for (std::size_t i = 0; i < pairs_.size(); ++i) {
    const LinePair& pair = pairs_[i];
    if (pair.kind == LinePair::Kind::kConjugateLines) {
      add_conditions(pair, 0, pair.multiplicity / 2);
    } else {
      add_conditions(pair, 0, choice[i]);
      add_conditions(pair, 1, pair.multiplicity - choice[i]);
    }
  }
  const auto solutions = kernel(std::move(rows), unknowns - dimension);
  if (!solutions) return std::nullopt;
  std::vector<Vector> vectors;
  for (const std::vector<RealBall>& solution : *solutions) {
    Vector y;
    auto next = solution.begin();
    for (std::size_t i = 0; i < 3; ++i) {
      const auto end = next + std::max(d[i] + 1, 0);
      y[i] = Form<RealBall>(std::vector<RealBall>(next, end));
      next = end;
    }
    vectors.push_back(std::move(y));
  }
  return vectors;
}

/// a^T Q b / g at t, up to a factor that does not depend on a and b.
RealBall LineConditions::quotient(const Vector& a, const Vector& b, long t) const {
  const RealBall place(t);
  RealBall sum;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      sum += a[i](place) * conic_[i][j](place) * b[j](place);
    }
  }
  for (const LinePair& pair : pairs_) {
    if (!pair.place) continue;
    const RealBall x = RealBall(t) - pair.place->real(), y = pair.place->imag();
    const RealBall factor = pair.is_real() ? x : x * x + y * y;
    for (int i = 0; i < pair.multiplicity; ++i) sum /= factor;
  }
  return sum;
}

LineConditions::Vector LineConditions::point(const Vector& y) const {
  Vector result;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) result[i] += basis_[i][j] * y[j];
  }
  return result;
}

namespace {

/// Seen on the circle, the distance of a place from all others and from infinity.
double clearance(const std::vector<LinePair>& pairs, long t) {
  double least = 1 / std::hypot(1.0, t);
  for (const LinePair& pair : pairs) {
    if (!pair.place) continue;
    const Complex c = pair.place->midpoint();
    const double distance = std::abs(c - static_cast<double>(t));
    least = std::min(least, distance / (std::hypot(1.0, t) * std::hypot(1.0, std::abs(c))));
  }
  return least;
}

/// Of some integers those with the largest distances from all places.
std::vector<long> ordinary_places(const std::vector<LinePair>& pairs, int count) {
  std::vector<long> places;
  for (long t = -count - 2; t <= count + 2; ++t) places.push_back(t);
  std::sort(places.begin(), places.end(),
            [&](long a, long b) { return clearance(pairs, a) > clearance(pairs, b); });
  places.resize(static_cast<std::size_t>(count));
  return places;
}

/// The form with these values at as many integers, by Newton's divided differences.
Form<RealBall> interpolated(const std::vector<long>& places, std::vector<RealBall> values) {
  const std::size_t n = values.size();
  for (std::size_t order = 1; order < n; ++order) {
    for (std::size_t i = n; i-- > order;) {
      values[i] = (values[i] - values[i - 1]) / RealBall(places[i] - places[i - order]);
    }
  }
  auto result = Form<RealBall>::constant(values[n - 1]);
  for (std::size_t i = n - 1; i-- > 0;) {
    result = result * Form<RealBall>({RealBall(-places[i]), RealBall(1)});
    result[0] += values[i];
  }
  return result;
}

}  // namespace

std::optional<QuadraticPoints> LineConditions::balanced_points(const LineChoice& choice) const {
  const auto y = on_lines(choice, m_, 3);
  if (!y) return std::nullopt;
  const long t = ordinary_places(pairs_, 1).front();
  Matrix3<RealBall> conic;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) conic[i][j] = quotient((*y)[i], (*y)[j], t);
  }
  const std::optional<QuadraticColumns> columns = points_of_constant_conic(conic);
  if (!columns) return std::nullopt;
  QuadraticPoints result{{}, m_};
  for (std::size_t j = 0; j < 3; ++j) {
    const Vector w = point((*y)[j]);
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t k = 0; k < 3; ++k) result.coordinate[i][k] += w[i] * (*columns)[j][k];
    }
  }
  return result;
}

std::optional<QuadraticPoints> LineConditions::unbalanced_points(const LineChoice& choice,
                                                                 int splitting) const {
  const auto a = static_cast<std::size_t>(splitting);
  const auto low = on_lines(choice, m_ - splitting, 1);
  const auto middle = on_lines(choice, m_, a + 2);
  const auto high = on_lines(choice, m_ + splitting, 3 * a + 3);
  if (!low || !middle || !high) return std::nullopt;
  const std::vector<long> places = ordinary_places(pairs_, 2 * splitting + 1);
  const auto largest = [](const std::vector<Vector>& from, const auto& measure) {
    return *std::max_element(from.begin(), from.end(), [&](const Vector& x, const Vector& y) {
      return std::abs(measure(x).midpoint()) < std::abs(measure(y).midpoint());
    });
  };
  const auto with = [&](const Vector& x) {
    return [&](const Vector& y) { return quotient(x, y, places.front()); };
  };
  const Vector& w0 = low->front();
  const Vector w1 = largest(*middle, [&](const Vector& y) { return with(y)(y); });
  const Vector w2 = largest(*high, with(w0));
  UnbalancedLattice<RealBall> lattice;
  lattice.alpha = with(w0)(w2);
  lattice.beta = with(w1)(w1);
  if (lattice.alpha.contains_zero() || lattice.beta.contains_zero()) return std::nullopt;
  const auto form_of = [&](const Vector& x, const Vector& y, std::size_t degree) {
    std::vector<RealBall> values;
    for (std::size_t i = 0; i <= degree; ++i) values.push_back(quotient(x, y, places[i]));
    return interpolated(places, std::move(values));
  };
  lattice.q12 = form_of(w1, w2, a);
  lattice.q22 = form_of(w2, w2, 2 * a);
  const Vector p0 = point(w0), p1 = point(w1), p2 = point(w2);
  for (std::size_t i = 0; i < 3; ++i) lattice.basis[i] = {p0[i], p1[i], p2[i]};
  return QuadraticPoints{points_of_unbalanced_lattice(lattice), m_ + splitting};
}

PointInBalls LineConditions::lowest_column(const LineChoice& choice) const {
  int degree = m_;
  while (!on_lines(choice, degree - 1, 0)) --degree;
  const auto column = on_lines(choice, degree, 1);
  if (degree == m_ || !column) throw Undecided("the lowest curve on a family of conics");
  return {column->front(), degree};
}

PointInBalls LineConditions::in_balls(const LatticePoint& point) const {
  PointInBalls result{{}, point.degree};
  for (std::size_t j = 0; j < 3; ++j) {
    result.coordinate[j] = form(point.coordinate[j], point.degree - column_degree_[j], precision_);
  }
  return result;
}

namespace {

/// l.w modulo tau^p, for both lines.
std::array<Jet, 2> values_on_lines(const LinePair& pair, const PointInBalls& w) {
  const auto p = static_cast<std::size_t>(pair.multiplicity);
  std::array<Jet, 2> values = {Jet(p), Jet(p)};
  for (std::size_t j = 0; j < 3; ++j) {
    const Jet y = jet(w.coordinate[j], pair.place, pair.multiplicity);
    for (std::size_t k = 0; k < 2; ++k) values[k] = sum(values[k], product(pair.line[k][j], y));
  }
  return values;
}

/// The first order with a coefficient certainly different from zero, at most p.
int certain_order(const Jet& values) {
  const auto nonzero = std::find_if(values.begin(), values.end(),
                                    [](const ComplexBall& x) { return !x.contains_zero(); });
  return static_cast<int>(nonzero - values.begin());
}

}  // namespace

/// The orders i and j of l1.w and l2.w have i + j >= p, and i = 0, j = 0 or i + j = p.
LineChoice LineConditions::choice_through(const PointInBalls& w) const {
  LineChoice choice;
  for (const LinePair& pair : pairs_) {
    const auto [on_first, on_second] = values_on_lines(pair, w);
    const int i = certain_order(on_first), j = certain_order(on_second), p = pair.multiplicity;
    if (i != 0 && j != 0 && i + j != p) throw Undecided("the line on which a curve meets a conic");
    choice.push_back(j == 0 ? p : i);
  }
  return choice;
}

/// Pairs first, since a single step of sigma needs a real place.
TurnedChoice LineConditions::turned_away(LineChoice choice, const PointInBalls& w) const {
  int rest = m_ - w.degree;
  const auto turn = [&](LinePair::Kind kind, int gain) {
    for (std::size_t k = 0; k < pairs_.size(); ++k) {
      if (pairs_[k].kind != kind) continue;
      // A multiple of w that vanishes to a higher order than it must is near to the other lattice.
      const auto [on_first, on_second] = values_on_lines(pairs_[k], w);
      int& i = choice[k];
      const int p = pairs_[k].multiplicity;
      const int up = certain_order(on_first) > i ? 0 : p - i;
      const int down = certain_order(on_second) > p - i ? 0 : i;
      const int steps = std::min(std::max(up, down), rest / gain);
      i += up >= down ? steps : -steps;
      rest -= gain * steps;
    }
  };
  turn(LinePair::Kind::kComplexPlace, 2);
  turn(LinePair::Kind::kRealLines, 1);
  return {std::move(choice), rest};
}

}  // namespace pn
