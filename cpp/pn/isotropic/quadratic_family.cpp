// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/isotropic/quadratic_family.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace pn {
namespace {

using Vector = MinkowskiVector<Rational>;
using Form = TernaryForm<Rational>;

const Rational kHalf = Rational(1L) / Rational(2L);

Vector combined(const Vector& x, const Rational& s, const Vector& y, const Rational& t) {
  Vector result;
  for (std::size_t c = 0; c < 4; ++c) result[c] = s * x[c] + t * y[c];
  return result;
}

Vector middle(const Vector& x, const Vector& y) { return combined(x, kHalf, y, kHalf); }

Vector difference(const Vector& x, const Vector& y) { return combined(x, 1L, y, -1L); }

/// Halvings of the triangle after which what is not proved counts as not true: the part is then
/// 2^-8 of it.
constexpr int kMostHalvings = 8;

std::array<double, 2> centre(const FamilyPart& part) {
  const auto& [p, q, r] = part.corners;
  return {(p[0] + q[0] + r[0]) / 3, (p[1] + q[1] + r[1]) / 3};
}

std::optional<std::array<double, 2>> unreal_place(const FamilyPart& part, int halvings) {
  const Form delta = metric(part.family).determinant;
  if (has_positive_coefficients(delta)) return std::nullopt;
  const int n = delta.degree();
  const std::array<std::array<int, 2>, 3> corners = {{{n, 0}, {0, n}, {0, 0}}};
  for (std::size_t c = 0; c < 3; ++c) {
    if (delta(corners[c][0], corners[c][1]).sign() <= 0) return part.corners[c];
  }
  if (halvings == 0) return centre(part);
  for (const FamilyPart& quarter : part.quartered()) {
    if (const auto place = unreal_place(quarter, halvings - 1)) return place;
  }
  return std::nullopt;
}

/// Both regions together.
RealRegion joined(RealRegion a, const RealRegion& b) {
  const auto append = [](std::vector<FamilyPart>& to, const std::vector<FamilyPart>& from) {
    to.insert(to.end(), from.begin(), from.end());
  };
  append(a.real, b.real);
  append(a.unreal, b.unreal);
  append(a.border, b.border);
  return a;
}

RealRegion real_region(const FamilyPart& part, int halvings) {
  const Form delta = metric(part.family).determinant;
  if (has_positive_coefficients(delta)) return {{part}, {}, {}};
  if (has_positive_coefficients(delta * Rational(-1L))) return {{}, {part}, {}};
  if (halvings == 0) return {{}, {}, {part}};
  RealRegion region;
  for (const FamilyPart& quarter : part.quartered()) {
    region = joined(std::move(region), real_region(quarter, halvings - 1));
  }
  return region;
}

/// An upper bound of |m| + |r| for a vector (m, -r).
Rational bound(const Vector& x) {
  const double m = std::hypot(x[0].to_double(), x[1].to_double(), x[2].to_double());
  return Rational::exactly((m + std::abs(x[3].to_double())) * (1 + 1e-12));
}

/// The corollary's polynomials in R, coefficient by coefficient: p0 - R p1 + R^2 p2 > 0.
struct RegularityTest {
  struct InRadius {
    Form constant, linear, square;
  };
  std::vector<InRadius> conditions;

  explicit RegularityTest(const QuadraticFamily& family) {
    const FamilyMetric g = metric(family);
    const auto a = family.power();
    const Rational h11 = bound(a[0]), h12 = bound(a[1]), h22 = bound(a[2]);
    const Form zero(2), one = [] {
      const Form sum = Form::linear(1L, 1L, 1L);
      return sum * sum;
    }();
    conditions.push_back({g.g11, one * h11, zero});
    conditions.push_back({g.g22, one * h22, zero});
    const Form square = one * one * (h11 * h22 - h12 * h12);
    const Form mixed = (g.g11 * h22 + g.g22 * h11) * one,
               cross = g.g12 * one * (Rational(2L) * h12);
    conditions.push_back({g.determinant, mixed + cross, square});
    conditions.push_back({g.determinant, mixed - cross, square});
  }

  bool holds(double radius) const {
    const Rational r = Rational::exactly(radius), square = r * r;
    return std::all_of(conditions.begin(), conditions.end(), [&](const InRadius& c) {
      for (std::size_t k = 0; k < c.constant.coefficients().size(); ++k) {
        const Rational value = c.constant.coefficients()[k] - r * c.linear.coefficients()[k] +
                               square * c.square.coefficients()[k];
        if (value.sign() <= 0) return false;
      }
      return true;
    });
  }
};

/// The largest radius that passes, within 2^-20 of it.
double largest_radius(const RegularityTest& test) {
  double low = 0, high = 1;
  while (test.holds(high)) {
    low = high;
    high *= 2;
    if (!std::isfinite(high)) return high;
  }
  while (high - low > std::ldexp(high, -20)) {
    const double mid = (low + high) / 2;
    (test.holds(mid) ? low : high) = mid;
  }
  return low;
}

double regular_radius(const QuadraticFamily& family, int halvings) {
  const RegularityTest test(family);
  if (test.holds(0)) return largest_radius(test);
  if (halvings == 0) return 0;
  double least = std::numeric_limits<double>::infinity();
  for (const QuadraticFamily& quarter : family.quartered()) {
    least = std::min(least, regular_radius(quarter, halvings - 1));
  }
  return least;
}

}  // namespace

std::array<Vector, 6> QuadraticFamily::power() const {
  const auto& [b200, b110, b020, b101, b011, b002] = control_;
  const auto doubled = [](const Vector& x, const Vector& y) {  // 2 (x - y)
    return combined(x, 2L, y, -2L);
  };
  return {doubled(difference(b200, b101), difference(b101, b002)),
          doubled(difference(b110, b101), difference(b011, b002)),
          doubled(difference(b020, b011), difference(b011, b002)),
          doubled(b101, b002),
          doubled(b011, b002),
          b002};
}

std::array<MinkowskiVector<Form>, 2> QuadraticFamily::derivatives() const {
  const auto& [b200, b110, b020, b101, b011, b002] = control_;
  const auto form = [](const Vector& u, const Vector& v, const Vector& w) {
    const auto component = [&](std::size_t c) {
      return Form::linear(u[c], v[c], w[c]) * Rational(2L);
    };
    return MinkowskiVector<Form>{component(0), component(1), component(2), component(3)};
  };
  return {form(difference(b200, b101), difference(b110, b011), difference(b101, b002)),
          form(difference(b110, b101), difference(b020, b011), difference(b011, b002))};
}

QuadraticFamily QuadraticFamily::exchanged() const {
  const auto& [b200, b110, b020, b101, b011, b002] = control_;
  return QuadraticFamily({b020, b110, b200, b011, b101, b002});
}

std::array<QuadraticFamily, 4> QuadraticFamily::quartered() const {
  const auto& [b200, b110, b020, b101, b011, b002] = control_;
  // One blossom of the middles of two edges each; the value in the middle of an edge is the middle
  // of the control points of its halves.
  const Vector u_uv = middle(b200, b110), v_uv = middle(b110, b020), u_uw = middle(b200, b101),
               w_uw = middle(b101, b002), v_vw = middle(b020, b011), w_vw = middle(b011, b002);
  const Vector uv = middle(u_uv, v_uv), uw = middle(u_uw, w_uw), vw = middle(v_vw, w_vw);
  const Vector uv_uw = middle(middle(b200, b101), middle(b110, b011)),
               uv_vw = middle(middle(b110, b020), middle(b101, b011)),
               uw_vw = middle(middle(b110, b011), middle(b101, b002));
  return {QuadraticFamily({b200, u_uv, uv, u_uw, uv_uw, uw}),
          QuadraticFamily({uv, v_uv, b020, uv_vw, v_vw, vw}),
          QuadraticFamily({uw, uw_vw, vw, w_uw, w_vw, b002}),
          QuadraticFamily({vw, uw_vw, uw, uv_vw, uv_uw, uv})};
}

std::array<FamilyPart, 4> FamilyPart::quartered() const {
  const auto& [p, q, r] = corners;
  const auto mean = [](const std::array<double, 2>& a, const std::array<double, 2>& b) {
    return std::array{(a[0] + b[0]) / 2, (a[1] + b[1]) / 2};
  };
  const auto pq = mean(p, q), pr = mean(p, r), qr = mean(q, r);
  const auto parts = family.quartered();
  return {{{parts[0], {p, pq, pr}},
           {parts[1], {pq, q, qr}},
           {parts[2], {pr, qr, r}},
           {parts[3], {qr, pr, pq}}}};
}

FamilyMetric metric(const QuadraticFamily& family) {
  const auto [fu, fv] = family.derivatives();
  const Form g11 = minkowski(fu, fu), g12 = minkowski(fu, fv), g22 = minkowski(fv, fv);
  return {g11, g12, g22, g11 * g22 - g12 * g12};
}

std::optional<std::array<double, 2>> unreal_place(const QuadraticFamily& family) {
  return unreal_place({family}, kMostHalvings);
}

RealRegion real_region(const QuadraticFamily& family, int halvings) {
  return real_region(FamilyPart{family}, halvings);
}

double regular_radius(const QuadraticFamily& family) {
  return regular_radius(family, kMostHalvings);
}

}  // namespace pn
