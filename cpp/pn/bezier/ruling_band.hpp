// SPDX-License-Identifier: LGPL-2.1-or-later
// Ruling band: the lines of a ruled surface that run along its two directrices.
//
// On the ruling from c0(t) to c1(t) the normal at v is orthogonal to g and to (1 - v) c0' + v c1'.
// The target makes the normals of both directrices, and a margin of the arc between them beyond,
// the lines u = (1 : 0) and u = (0 : 1), with weight 1 on both: the band is the arc u = (1 - s :
// s), s in [0, 1], and its weights are positive, the middle one being the cosine of half the angle
// between the normals. The directrices themselves are no lines u = const, their normals being
// irrational; the margin leaves them inside.
#pragma once

#include "pn/bezier/target_lines.hpp"
#include "pn/isotropic/along_rulings.hpp"

namespace pn {

/// <w, c'> for the two directrices c, freed of torsal roots: its zero in u is where the directrix
/// crosses.
using DirectrixForms = std::array<FormInU<double>, 2>;

DirectrixForms directrix_forms(const RulingForms<double>& rulings,
                               const IsotropicVector<double>& w);

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
