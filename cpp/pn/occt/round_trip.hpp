// SPDX-License-Identifier: LGPL-2.1-or-later
// Round trip: whether shapes come back from a file as they were written.
//
// A B-spline surface has come back when its degrees, knots, multiplicities, poles and weights are
// the same bit for bit. Readers make closed surfaces periodic, and a placed shape may come back as
// an instance with a placement: neither changes a number of the surface in its own coordinates.
// Edges may be projected anew. They then lie within the confusion of OpenCASCADE, 1e-7 mm, of where
// they were, which bounds what areas and volumes may differ by.
#pragma once

#include <Message_ProgressRange.hxx>
#include <TopoDS_Shape.hxx>
#include <cstddef>
#include <string>
#include <vector>

namespace pn {

/// What was found to be the same.
struct RoundTrip {
  std::size_t faces = 0;
  std::size_t bspline_faces = 0;  ///< of these, those that were compared bit for bit
  std::size_t poles = 0;          ///< of the B-spline faces
  double volume = 0;              ///< [mm^3] inside closed shells
  /// What differs, a sentence each; none when the shapes have come back.
  std::vector<std::string> differences;
};

/// Compares the faces of `read` with those of `written`, in their order: surfaces, areas, validity,
/// closed shells and their volume.
///
/// Offset surfaces count as a difference even if they come back, since other programs lose them.
/// When `progress` is broken off, what has not been looked at is left out.
RoundTrip compare_round_trip(const std::vector<TopoDS_Shape>& written,
                             const std::vector<TopoDS_Shape>& read,
                             const Message_ProgressRange& progress = {});

}  // namespace pn
