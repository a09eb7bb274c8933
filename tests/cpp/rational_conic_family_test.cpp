// SPDX-License-Identifier: LGPL-2.1-or-later
// PN_TEST_SCALE multiplies the number of random families.
#include "pn/conics/rational_conic_family.hpp"

#include <algorithm>
#include <catch2/catch.hpp>

#include "conic_families.hpp"
#include "enclosures.hpp"
#include "error_code.hpp"
#include "pn/algebra/precision.hpp"
#include "pn/geometry_error.hpp"
#include "surface_concept.hpp"

using namespace pn;
using namespace pn::test;

namespace {

template <class T>
Form<T> form_over(const RationalPolynomial& p, int degree);
template <>
Form<Rational> form_over(const RationalPolynomial& p, int degree) {
  return Form<Rational>(coefficients(p, degree));
}
template <>
Form<RealBall> form_over(const RationalPolynomial& p, int degree) {
  std::vector<RealBall> balls;
  for (const Rational& c : coefficients(p, degree)) balls.emplace_back(c, 1024);
  return Form<RealBall>(std::move(balls));
}

/// The five coefficients in u of x^T C x; x has degree n - f.
template <class T>
std::vector<Form<T>> identity(const ConicFamily& family, const Matrix3<Form<T>>& points) {
  std::vector<Form<T>> sum(5);
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      const int degree = family.degree[i] + family.degree[j] + family.twist;
      if (family.matrix[i][j].is_zero()) continue;
      const auto c = form_over<T>(family.matrix[i][j], degree);
      for (std::size_t p = 0; p < 3; ++p) {
        for (std::size_t q = 0; q < 3; ++q) sum[p + q] += points[i][p] * c * points[j][q];
      }
    }
  }
  return sum;
}

double largest_coefficient(const Matrix3<Form<RealBall>>& points) {
  double largest = 0;
  for (const auto& row : points) {
    for (const auto& entry : row) {
      for (const RealBall& c : entry.coefficients()) {
        if (!c.is_finite()) throw Undecided("a coefficient");
        largest = std::max(largest, c.magnitude_upper());
      }
    }
  }
  return largest;
}

/// The points at a precision that encloses them and the identity narrowly.
QuadraticPoints narrow_points(const ConicFamily& family, const RationalConicFamily& conics) {
  return at_sufficient_precision([&](long bits) {
    const QuadraticPoints points = conics.points(bits);
    const double size = largest_coefficient(points.coordinate);
    for (const auto& form : identity(family, points.coordinate)) {
      for (const RealBall& c : form.coefficients()) {
        if (c.magnitude_upper() > kNarrow * size * size) throw Undecided("the identity");
      }
    }
    return points;
  });
}

void check_identity(const ConicFamily& family, const RationalConicFamily& conics) {
  const QuadraticPoints points = narrow_points(family, conics);
  CHECK(points.degree == conics.degree());
  const double size = largest_coefficient(points.coordinate);
  REQUIRE(size > 0);
  for (const auto& form : identity(family, points.coordinate)) {
    for (const RealBall& c : form.coefficients()) {
      CHECK(encloses_zero(c, kNarrow * size * size));
    }
  }
  // The three columns are independent where the conic is regular, so u runs through all of it.
  const auto value = [&](std::size_t i, std::size_t k) {
    return points.coordinate[i][k](RealBall(17));
  };
  RealBall det;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t a = (i + 1) % 3, b = (i + 2) % 3;
    det += value(i, 0) * (value(a, 1) * value(b, 2) - value(b, 1) * value(a, 2));
  }
  if (!determinant(family.matrix)(Rational(17)).is_zero()) CHECK_FALSE(det.contains_zero());
  if (conics.rational_points()) {
    for (const auto& form : identity(family, *conics.rational_points())) {
      for (const Rational& c : form.coefficients()) CHECK(c.is_zero());
    }
  }
}

RationalConicFamily checked(const Conic& matrix) {
  const ConicFamily family = conic_family(matrix);
  RationalConicFamily conics(family);
  CHECK(conics.degree() >= conics.least_degree());
  check_identity(family, conics);
  return conics;
}

/// a = 0 for one of the choices at all single zeros, each tried; nothing where they are many.
std::optional<bool> some_choice_is_balanced(const ConicFamily& family) {
  constexpr int kMostChoices = 64;
  constexpr long kBits = 512;
  const auto first = [](const RationalLattice&, const RationalLattice&) { return 0; };
  const RationalSteps steps =
      rational_steps(family, singular_conics(family), first, Leave::kEveryChoice);
  const LineConditions conditions(steps, line_pairs(steps, kBits), kBits);
  int count = 1;
  for (const LinePair& pair : conditions.pairs()) count *= pair.multiplicity + 1;
  if (conditions.pairs().empty() || count > kMostChoices) return std::nullopt;
  for (int number = 0; number < count; ++number) {
    LineChoice choice;
    int rest = number;
    for (const LinePair& pair : conditions.pairs()) {
      choice.push_back(rest % (pair.multiplicity + 1));
      rest /= pair.multiplicity + 1;
    }
    if (conditions.balanced_points(choice)) return true;
  }
  return false;
}

RationalPolynomial poly(const std::vector<long>& c) { return conic_polynomial(c); }

/// Of Y^2 + k c^2 W^2 - 2 f W P, checked; all types are (0, 2), and P is a point, so m = h and a =
/// h before any choice, with h the degree of f and c.
RationalConicFamily checked_with_double_zeros(long k, const RationalPolynomial& f,
                                              const RationalPolynomial& c) {
  const RationalPolynomial zero, factor(k);
  const ConicFamily family = conic_family(
      {{{1L, zero, zero}, {zero, factor * c * c, -f}, {zero, -f, zero}}}, {0, f.degree(), 0});
  RationalConicFamily conics(family);
  check_identity(family, conics);
  CHECK(conics.least_degree() == f.degree());
  return conics;
}

/// f = (t - 1) ... (t - h), c = 7 (t + 1)^h.
RationalConicFamily checked_with_double_zeros(long k, int h) {
  RationalPolynomial f(1L), c(7L);
  for (int i = 1; i <= h; ++i) {
    f *= poly({-i, 1});
    c *= poly({1, 1});
  }
  return checked_with_double_zeros(k, f, c);
}

}  // namespace

TEST_CASE("The families of the paper have the degree of the theorem", "[rational_conic_family]") {
  const auto degree = [](const Conic& c) { return checked(c).degree(); };
  CHECK(degree(diagonal(poly({1, 0, 1}), poly({1}), poly({-1, 0, -2}))) == 2);
  CHECK(degree(diagonal(poly({1, 0, 1}), poly({4, 0, 1}), poly({0, 0, -5, 0, -2}))) == 3);
  CHECK(degree(diagonal(poly({1, 0, 1}), poly({4, 0, 1}), poly({-5, 0, -2}))) == 2);
  CHECK(degree(diagonal(poly({1}), poly({-1, 0, -1}), poly({-1, 0, -2, 0, -5}))) == 4);
  CHECK(degree(diagonal(poly({1, 0, 3, 0, 3, 0, 1}), poly({4, 0, 5, 0, 1}), poly({-5, 0, -2}))) ==
        6);
}

TEST_CASE("Y^2 + c^2 W^2 - 2 f W P with real zeros of f has degree 2 h and is rational",
          "[rational_conic_family]") {
  for (int h = 1; h <= 5; ++h) {
    const RationalConicFamily conics = checked_with_double_zeros(1, h);
    CHECK(conics.degree() == 2 * h);
    CHECK(conics.rational_points().has_value());
  }
}

TEST_CASE("Y^2 - 2 c^2 W^2 - 2 f W P has degree h by one irrational line at each double zero of f",
          "[rational_conic_family]") {
  for (int h = 1; h <= 5; ++h) {
    const RationalConicFamily conics = checked_with_double_zeros(-2, h);
    CHECK(conics.degree() == h);
    CHECK_FALSE(conics.rational_points().has_value());
  }
}

TEST_CASE(
    "Y^2 - c^2 W^2 - 2 f W P has degree h over Q by one rational line at each double zero of f",
    "[rational_conic_family]") {
  for (int h = 1; h <= 5; ++h) {
    const RationalConicFamily conics = checked_with_double_zeros(-1, h);
    CHECK(conics.degree() == h);
    CHECK(conics.rational_points().has_value());
  }
}

TEST_CASE("Two lines less q times a square: least degree over Q where q has rational zeros",
          "[rational_conic_family]") {
  // The intersection of l1 and l3 is a rational point, and q has two real places with real lines.
  RandomConics random(7);
  for (int repeat = 0; repeat < 12; ++repeat) {
    Vector3<RationalPolynomial> l1, l2, l3;
    for (std::size_t i = 0; i < 3; ++i) {
      l1[i] = random.any(1), l2[i] = random.any(1), l3[i] = random.any(1);
    }
    const RationalPolynomial q = poly({-1 - repeat, 1}) * poly({2, 3});
    Conic c;
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < 3; ++j) {
        c[i][j] = l1[i] * l2[j] + l1[j] * l2[i] - q * l3[i] * l3[j];
      }
    }
    INFO("family " << repeat);
    const RationalConicFamily conics = checked(c);
    CHECK(conics.degree() == conics.least_degree());
    CHECK(conics.rational_points().has_value());
  }
}

TEST_CASE("Lines at only some of the conjugate zeros give the least degree",
          "[rational_conic_family]") {
  const auto splitting = [](const RationalPolynomial& f, const RationalPolynomial& c) {
    const RationalConicFamily conics = checked_with_double_zeros(-2, f, c);
    return conics.degree() - conics.least_degree();
  };
  CHECK(splitting(poly({-2, 0, 1}), poly({1, 1, 3})) == 0);
  CHECK(splitting(poly({2, 0, 1}), poly({1, 1, 3})) == 0);
  CHECK(splitting(poly({-2, 0, 0, 1}), poly({1, 1, 3, 5})) == 0);
  CHECK(splitting(poly({2, -4, 0, 0, 1}), poly({1, 1, 3, 5, 2})) == 0);
}

TEST_CASE("Squarefree diagonal families: degree of the ansatz, or one more with odd parity",
          "[rational_conic_family]") {
  RandomConics random(1);
  for (int l = 0; l <= 3; ++l) {
    for (int m = 0; m <= 3; ++m) {
      for (int n = 0; n <= 3; ++n) {
        INFO("degrees " << 2 * l << ", " << 2 * m << ", " << 2 * n);
        const auto conics =
            checked(diagonal(random.positive(l), random.positive(m), -random.positive(n)));
        CHECK(conics.least_degree() == std::max({l + m, m + n, n + l}));
        // Infinity has real lines, and the parity is free, if one degree is below both others,
        // which differ in sign.
        const bool is_free = (l < m && l < n) || (m < l && m < n);
        CHECK(conics.degree() - conics.least_degree() == (is_free ? 0 : (l + m) % 2));
      }
    }
  }
}

TEST_CASE("No choice of lines gives a lower degree", "[rational_conic_family]") {
  int irrational = 0, rational = 0, odd = 0;
  for (int seed = 0; seed < 150; ++seed) {
    const NamedConic conic = RandomConics(static_cast<std::uint64_t>(seed)).next();
    INFO(conic.kind << ", seed " << seed);
    std::optional<RationalConicFamily> conics;
    try {
      conics.emplace(conic_family(conic.matrix));
    } catch (const GeometryError&) {
      continue;
    }
    const ConicFamily family = conic_family(conic.matrix);
    const std::optional<bool> balanced = some_choice_is_balanced(family);
    if (!balanced) continue;
    CHECK((conics->degree() == conics->least_degree()) == *balanced);
    odd += *balanced ? 0 : 1;
    (conics->rational_points() ? rational : irrational) += 1;
  }
  CHECK(irrational > 20);
  CHECK(rational > 5);
  CHECK(odd > 0);
}

TEST_CASE("Random families with planted zeros: points on the conics, of least degree",
          "[rational_conic_family]") {
  int solved = 0, rational = 0, odd = 0;
  const int count = static_cast<int>(200 * number_from_environment("PN_TEST_SCALE", 1));
  for (int seed = 0; seed < count; ++seed) {
    const NamedConic conic = RandomConics(static_cast<std::uint64_t>(seed)).next();
    INFO(conic.kind << ", seed " << seed);
    try {
      const RationalConicFamily conics = checked(conic.matrix);
      ++solved;
      if (conics.rational_points()) {
        ++rational;
      } else {
        CHECK(conics.degree() <= conics.least_degree() + 1);
        odd += conics.degree() - conics.least_degree();
      }
    } catch (const GeometryError& error) {
      CHECK(
          (error.code() == ErrorCode::kNoRealPoints || error.code() == ErrorCode::kSingularConics));
    }
  }
  INFO(solved << " solved, " << rational << " over Q, " << odd << " of odd parity");
  CHECK(solved > count / 3);
  CHECK(rational > 0);
  CHECK(odd > 0);
}

TEST_CASE("Conics without real points are found exactly and the interval is named",
          "[rational_conic_family]") {
  const auto code = [](const Conic& c) {
    return code_of([&] { RationalConicFamily(conic_family(c)); });
  };
  CHECK(code(diagonal(1L, poly({0, 1}), 1L)) == ErrorCode::kNoRealPoints);
  CHECK(code(diagonal(1L, 1L, poly({1, 0, 1}))) == ErrorCode::kNoRealPoints);
  CHECK(code(diagonal(1L, 1L, poly({0, -1}))) == ErrorCode::kNoRealPoints);
  CHECK_THROWS_WITH(RationalConicFamily(conic_family(diagonal(1L, 1L, poly({-2, 0, 1})))),
                    Catch::Contains("for t < -1.41421"));
}
