// SPDX-License-Identifier: LGPL-2.1-or-later
// Sections: the surfaces of Gamma at all distances, for the kinds of f that carry w.
//
// Every section is x_d = (point + d direction) / weight, and its normal direction / weight.
//
// CURVE of spheres f = (centre, -radius) / denominator. x_d = centre + (radius + d) n.
//
// RULINGS f = a + v g with a = (point, -radius) / denominator and g = (axis, -level), orthogonal to
// w: <w, f_t> = 0 determines v = -<w, a'> / <w, g'>. With N = (w1, w2, w3), q = denominator,
//
//     P = q^2 <w, a'> = N.(point' q - point q') + w4 (radius' q - radius q'),
//     Q = <w, g'> = N.axis' + w4 level',
//
//     x_d = (w4 (q Q point - P axis) + (q Q radius - P level + d q^2 Q) N) / (q^2 Q w4).
//
// Both wronskians lose their leading coefficient, and Gamma is as high at infinity as it is
// elsewhere only where the lines are, so the degree is lower than that of the terms: `degree` plus
// twice that of w, which whoever makes the family knows (along_rulings.hpp). At a real root of D
// the isotropic g is proportional to w for every u, so numerator and denominator vanish there: the
// root is divided out as often as it was taken in the factorization.
//
// QUADRIC with the support function S / w4, S a linear combination of w over a common denominator:
// the point of contact of the plane N.x = S with the dual quadric of matrix K is K (N, S), and
// x_d = contact + d n. (M. Peternell, dissertation TU Wien 1997, 4.5 and 4.7.)
//
// DEVELOPABLE strip between two directrices: w depends on t only and comes along,
// x_d = (1 - v) c0 + v c1 + d normal / length.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "pn/algebra/ball.hpp"
#include "pn/isotropic/form_in_u.hpp"

namespace pn {

/// w(t, u): components w1, w2, w3, w4, quadratic in u.
template <class T>
using IsotropicVector = std::array<FormInU<T>, 4>;

/// Homogeneous in u: x_d = (point + d direction) / weight.
template <class T>
struct HomogeneousSections {
  std::array<FormInU<T>, 3> point;
  std::array<FormInU<T>, 3> direction;
  FormInU<T> weight;
};

/// A curve of spheres; all forms in the local parameter on [0, 1], of one formal degree.
template <class T>
struct SphereCurveForms {
  std::array<Form<T>, 3> centre;
  Form<T> radius;
  Form<T> denominator;
};

/// A family of lines in R^{3,1}; slopes are by the designer's parameter.
template <class T>
struct RulingForms {
  std::array<Form<T>, 3> point;
  Form<T> radius, denominator;
  std::array<Form<T>, 3> axis;
  Form<T> level;
  std::array<Form<T>, 3> point_wronskian;  ///< point' denominator - point denominator'
  Form<T> radius_wronskian;
  std::array<Form<T>, 3> axis_slope;
  Form<T> level_slope;
  std::array<SphereCurveForms<T>, 2> directrices;  ///< that bound the wanted part of each ruling
  Form<T> scale;  ///< a factor of all sections, which lets them continue those of neighbours
  std::vector<T> torsal_roots;  ///< where w is the same for all u and orthogonal to a' and g'
  int degree;  ///< of every section, without its two factors w and before division by the roots
  std::vector<T> common_roots;  ///< each as often as it divides the sections
  int common_at_infinity;
};

/// A quadric by its planes of contact.
template <class T>
struct QuadricForms {
  std::array<Form<T>, 4> support;  ///< support . w = S denominator times the linear factors of
  std::vector<T> common_roots;     ///< these roots
  Form<T> denominator;
  std::array<std::array<T, 4>, 4> dual;  ///< K: (N, S) to the homogeneous point of contact
};

/// A developable strip, linear in u = (1 - v : v).
template <class T>
struct DevelopableForms {
  std::array<SphereCurveForms<T>, 2> directrices;
  std::array<Form<T>, 3> normal;  ///< of the same formal degree as length
  Form<T> length;                 ///< that of the normal
};

template <class T>
HomogeneousSections<T> sections(const SphereCurveForms<T>& curve, const IsotropicVector<T>& w) {
  HomogeneousSections<T> result;
  result.weight = curve.denominator * w[3];
  for (std::size_t i = 0; i < 3; ++i) {
    result.point[i] = curve.centre[i] * w[3] + curve.radius * w[i];
    result.direction[i] = curve.denominator * w[i];
  }
  return result;
}

/// The sum of products of the components of a covector and of w.
template <class T>
FormInU<T> contracted(const std::array<Form<T>, 3>& spatial, const Form<T>& last,
                      const IsotropicVector<T>& w) {
  FormInU<T> sum;
  for (std::size_t j = 0; j < w[3].coefficient.size(); ++j) {
    Form<T> c = last * w[3].coefficient[j];
    for (std::size_t i = 0; i < 3; ++i) c.add_product(spatial[i], w[i].coefficient[j]);
    sum.coefficient.push_back(std::move(c));
  }
  return sum;
}

/// Without the leading coefficients beyond this degree, which are known to vanish.
template <class T>
FormInU<T> truncated(FormInU<T> form, int degree) {
  for (Form<T>& c : form.coefficient) {
    std::vector<T> kept = c.coefficients();
    kept.resize(static_cast<std::size_t>(degree) + 1);
    c = Form<T>(std::move(kept));
  }
  return form;
}

inline bool is_beyond_unit_circle(double x) { return x > 1 || x < -1; }
inline bool is_beyond_unit_circle(const RealBall& x) { return is_beyond_unit_circle(x.midpoint()); }

/// Divided by the linear factors of roots that it is known to have.
template <class T>
FormInU<T> divided_by_roots(FormInU<T> form, const std::vector<T>& roots) {
  for (const T& root : roots) {
    for (Form<T>& c : form.coefficient) c = divided_by_root(c, root, is_beyond_unit_circle(root));
  }
  return form;
}

/// A component of the sections without what all of them have in common.
template <class T>
FormInU<T> reduced(const RulingForms<T>& f, const FormInU<T>& component,
                   const IsotropicVector<T>& w) {
  const int degree = f.degree + 2 * w[3].coefficient[0].degree() - f.common_at_infinity;
  return f.scale * divided_by_roots(divided_by_roots(truncated(component, degree), f.common_roots),
                                    f.torsal_roots);
}

/// The weight of the sections alone.
template <class T>
FormInU<T> section_weight(const RulingForms<T>& f, const IsotropicVector<T>& w) {
  const FormInU<T> q = contracted(f.axis_slope, f.level_slope, w);
  return reduced(f, f.denominator * (f.denominator * q * w[3]), w);
}

template <class T>
HomogeneousSections<T> sections(const RulingForms<T>& f, const IsotropicVector<T>& w) {
  const FormInU<T> p = contracted(f.point_wronskian, f.radius_wronskian, w);
  const FormInU<T> q = contracted(f.axis_slope, f.level_slope, w);
  const FormInU<T> weight = f.denominator * q, along = f.radius * weight - f.level * p;
  const FormInU<T> weight_w4 = weight * w[3], p_w4 = p * w[3];
  HomogeneousSections<T> result;
  result.weight = reduced(f, f.denominator * weight_w4, w);
  for (std::size_t i = 0; i < 3; ++i) {
    result.point[i] = reduced(f, f.point[i] * weight_w4 - f.axis[i] * p_w4 + along * w[i], w);
    result.direction[i] = reduced(f, f.denominator * (weight * w[i]), w);
  }
  return result;
}

template <class T>
HomogeneousSections<T> sections(const QuadricForms<T>& f, const IsotropicVector<T>& w) {
  const FormInU<T> support = divided_by_roots(
      contracted({f.support[0], f.support[1], f.support[2]}, f.support[3], w), f.common_roots);
  std::array<FormInU<T>, 4> contact;
  for (std::size_t i = 0; i < 4; ++i) {
    contact[i] = Form<T>::constant(f.dual[i][3]) * support;
    for (std::size_t j = 0; j < 3; ++j) {
      contact[i] = contact[i] + f.denominator * (Form<T>::constant(f.dual[i][j]) * w[j]);
    }
  }
  HomogeneousSections<T> result;
  result.weight = contact[3] * w[3];
  for (std::size_t i = 0; i < 3; ++i) {
    result.point[i] = contact[i] * w[3];
    result.direction[i] = contact[3] * w[i];
  }
  return result;
}

template <class T>
HomogeneousSections<T> sections(const DevelopableForms<T>& f, const IsotropicVector<T>&) {
  HomogeneousSections<T> result;
  for (const SphereCurveForms<T>& c : f.directrices) {
    result.weight.coefficient.push_back(c.denominator * f.length);
    for (std::size_t i = 0; i < 3; ++i) {
      result.point[i].coefficient.push_back(c.centre[i] * f.length);
      result.direction[i].coefficient.push_back(c.denominator * f.normal[i]);
    }
  }
  return result;
}

}  // namespace pn
