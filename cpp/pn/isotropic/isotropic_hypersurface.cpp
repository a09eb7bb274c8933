// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/isotropic/isotropic_hypersurface.hpp"

namespace pn {
namespace {

template <std::size_t Size, class Map>
auto each(const std::array<Form<RealBall>, Size>& forms, const Map& map) {
  std::array<decltype(map(forms[0])), Size> result;
  for (std::size_t i = 0; i < Size; ++i) result[i] = map(forms[i]);
  return result;
}

template <class Map>
auto each(const std::vector<RealBall>& numbers, const Map& map) {
  std::vector<decltype(map(numbers[0]))> result;
  for (const RealBall& x : numbers) result.push_back(map(x));
  return result;
}

/// What becomes of the forms, of the places of roots and of the constants of a carrier.
template <class FormOf, class RootOf, class NumberOf>
struct CarrierMap {
  FormOf form;
  RootOf root;
  NumberOf number;

  using Number = decltype(std::declval<NumberOf>()(std::declval<RealBall>()));

  SphereCurveForms<Number> curve(const SphereCurveForms<RealBall>& f) const {
    return {each(f.centre, form), form(f.radius), form(f.denominator)};
  }
  Carrier<Number> operator()(const SphereCurveForms<RealBall>& f) const { return curve(f); }
  Carrier<Number> operator()(const RulingForms<RealBall>& f) const {
    return RulingForms<Number>{each(f.point, form),
                               form(f.radius),
                               form(f.denominator),
                               each(f.axis, form),
                               form(f.level),
                               each(f.point_wronskian, form),
                               form(f.radius_wronskian),
                               each(f.axis_slope, form),
                               form(f.level_slope),
                               {curve(f.directrices[0]), curve(f.directrices[1])},
                               form(f.scale),
                               each(f.torsal_roots, root),
                               f.degree,
                               each(f.common_roots, root),
                               f.common_at_infinity};
  }
  Carrier<Number> operator()(const QuadricForms<RealBall>& f) const {
    QuadricForms<Number> result{
        each(f.support, form), each(f.common_roots, root), form(f.denominator), {}};
    for (std::size_t i = 0; i < 4; ++i) {
      for (std::size_t j = 0; j < 4; ++j) result.dual[i][j] = number(f.dual[i][j]);
    }
    return result;
  }
  Carrier<Number> operator()(const DevelopableForms<RealBall>& f) const {
    return DevelopableForms<Number>{
        {curve(f.directrices[0]), curve(f.directrices[1])}, each(f.normal, form), form(f.length)};
  }
};

template <class FormOf, class RootOf, class NumberOf>
CarrierMap(FormOf, RootOf, NumberOf) -> CarrierMap<FormOf, RootOf, NumberOf>;

const auto midpoint_of_form = [](const Form<RealBall>& form) { return midpoint(form); };
const auto midpoint_of_number = [](const RealBall& x) { return x.midpoint(); };

struct SectionDegree {
  int spinor_degree;

  int operator()(const SphereCurveForms<RealBall>& f) const {
    return f.denominator.degree() + 2 * spinor_degree;
  }
  int operator()(const RulingForms<RealBall>& f) const {
    return f.degree + 4 * spinor_degree + f.scale.degree() - f.common_at_infinity -
           static_cast<int>(f.common_roots.size() + f.torsal_roots.size());
  }
  int operator()(const QuadricForms<RealBall>& f) const {
    return f.denominator.degree() + 4 * spinor_degree;
  }
  int operator()(const DevelopableForms<RealBall>& f) const {
    return f.directrices[0].denominator.degree() + f.length.degree();
  }
};

struct SectionDegreeAround {
  int operator()(const SphereCurveForms<RealBall>&) const { return 2; }
  int operator()(const RulingForms<RealBall>&) const { return 4; }
  int operator()(const QuadricForms<RealBall>&) const { return 4; }
  int operator()(const DevelopableForms<RealBall>&) const { return 1; }
};

}  // namespace

int section_degree(const Carrier<RealBall>& carrier, int spinor_degree) {
  return std::visit(SectionDegree{spinor_degree}, carrier);
}

int section_degree_around(const Carrier<RealBall>& carrier) {
  return std::visit(SectionDegreeAround{}, carrier);
}

CircleForms<RealBall> on_interval(const CircleForms<RealBall>& circles, const RealBall& origin,
                                  const RealBall& length) {
  const auto form = [&](const Form<RealBall>& f) { return f.on_interval(origin, length); };
  return {each(circles.axis, form), form(circles.level)};
}

namespace {

/// On an interval t - root is `length` times as large as parameter - root there: what is divided by
/// so many roots keeps its scale by this factor.
struct KeepScale {
  const RealBall& length;

  RealBall factor(std::size_t roots) const {
    RealBall result(1);
    for (std::size_t i = 0; i < roots; ++i) result /= length;
    return result;
  }
  void operator()(SphereCurveForms<RealBall>&) const {}
  void operator()(DevelopableForms<RealBall>&) const {}
  void operator()(RulingForms<RealBall>& f) const {
    f.scale = f.scale * factor(f.common_roots.size() + f.torsal_roots.size());
  }
  void operator()(QuadricForms<RealBall>& f) const {
    for (Form<RealBall>& form : f.support) form = form * factor(f.common_roots.size());
  }
};

}  // namespace

Carrier<RealBall> on_interval(const Carrier<RealBall>& carrier, const RealBall& origin,
                              const RealBall& length) {
  Carrier<RealBall> result =
      std::visit(CarrierMap{[&](const Form<RealBall>& f) { return f.on_interval(origin, length); },
                            [&](const RealBall& root) { return (root - origin) / length; },
                            [](const RealBall& x) { return x; }},
                 carrier);
  std::visit(KeepScale{length}, result);
  return result;
}

Carrier<double> midpoint(const Carrier<RealBall>& carrier) {
  return std::visit(CarrierMap{midpoint_of_form, midpoint_of_number, midpoint_of_number}, carrier);
}

CircleForms<double> midpoint(const CircleForms<RealBall>& circles) {
  return {each(circles.axis, midpoint_of_form), midpoint_of_form(circles.level)};
}

SpinorMatrix<std::complex<double>> midpoint(const SpinorMatrix<ComplexBall>& spinor) {
  SpinorMatrix<std::complex<double>> result;
  for (int i = 0; i < 2; ++i) {
    for (int j = 0; j < 2; ++j) result.entry[i][j] = midpoint(spinor.entry[i][j]);
  }
  result.degree = spinor.degree;
  return result;
}

IsotropicHypersurface<double> midpoint(const IsotropicHypersurface<RealBall>& gamma) {
  return {midpoint(gamma.carrier), midpoint(gamma.circles), midpoint(gamma.spinor)};
}

}  // namespace pn
