// SPDX-License-Identifier: LGPL-2.1-or-later
// Ruling band: the lines of a ruled surface that run along its two directrices.
//
// On the ruling from c0(t) to c1(t) the normal at v is orthogonal to g and to (1 - v) c0' + v c1'.
// The target makes the normals of both directrices, and a margin of the arc between them beyond,
// the lines u = (1 : 0) and u = (0 : 1), with weight 1 on both: the band is the arc u = (1 - s :
// s), s in [0, 1], and its weights are positive, the middle one being the cosine of half the angle
// between the normals. The directrices themselves are no lines u = const, their normals being
// irrational; the margin leaves them inside.
//
// LEMMA (joints at a torsal ruling). Let A E be pinched at t* (torsal_ruling.hpp). At t* w is l^2
// times the normal of the ruling, <w, c'> freed of its torsal root is l d_c for either directrix c,
// and the weight of the sections is l^3 m, where l = (0, 1) u, d_c and m are linear in u. Let V be
// the matrix with the rows d_c0 / q0^2 and d_c1 / q1^2 (q the denominators), times the fourth root
// of the weight at V^-1 (1, -1). Two links that share the ruling have the same lines u = const and
// the same weights on it, when V+ F+ = V- F-.
//
// Proof: The line u lies on the point of the ruling that divides the directrices as d_c1 : -d_c0,
// so V+ F+ and V- F- must be proportional; then so are the zeros of l, at the one point without a
// normal, and of m, at infinity, and the weights. These are equal since they are so in the middle,
// where V F u = (1, -1). QED
#pragma once

#include "pn/bezier/line_factor.hpp"
#include "pn/bezier/target_lines.hpp"
#include "pn/isotropic/along_rulings.hpp"

namespace pn {

/// <w, c'> for the two directrices c, freed of torsal roots: its zero in u is where the directrix
/// crosses.
template <class T>
using DirectrixForms = std::array<FormInU<T>, 2>;

template <class T>
DirectrixForms<T> directrix_forms(const RulingForms<T>& rulings, const IsotropicVector<T>& w);

/// V of the lemma at an end of a link that is a torsal ruling. `pinched` is A E
/// (torsal_ruling.hpp).
template <class T>
lines::Matrix<T> torsal_frame(const RulingForms<T>& rulings,
                              const SpinorMatrix<ComplexOf<T>>& pinched, int end);

/// s of the line u = (1 - s : s) on which a directrix lies at t; of the two zeros, whose normals
/// are opposite, the one nearer to the arc [0, 1].
double band_parameter(const FormInU<double>& directrix, double t);

class BandLines : public TargetLines {
 public:
  /// `links` carry rulings; `margin` is a part of the arc of normals between the directrices.
  BandLines(std::vector<IsotropicHypersurface<double>> links, double margin);

 private:
  Eigen::Matrix2d factor(std::size_t link, double place) const override;
  double beside_torsal_rulings(std::size_t link, double t) const;

  std::vector<IsotropicHypersurface<double>> links_;
  double margin_;
};

}  // namespace pn
