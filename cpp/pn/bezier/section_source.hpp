// SPDX-License-Identifier: LGPL-2.1-or-later
// Section sources: what a PN surface is a section of, whatever gives the control points.
//
// A chain of envelopes is one (chain_source.hpp), a skin of a two-parameter family of spheres is
// another (skin.hpp). Below it there is one way for all: rounding, certificate, trims, evaluation.
#pragma once

#include <array>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "pn/bezier/offset_limits.hpp"
#include "pn/bezier/parameter_lines.hpp"
#include "pn/bezier/section_net.hpp"
#include "pn/bezier/trim_edge.hpp"

namespace pn {

/// The control points of all sections, and a way to find the edges of their faces.
struct TrimmableNet {
  std::shared_ptr<const SectionNet> net;
  std::function<std::vector<TrimmedFace>()> trimmed_faces;
};

/// A value that does not change. Its members may be called from several threads.
class SectionSource {
 public:
  virtual ~SectionSource() = default;

  /// Degree along and around of what the algebra delivers.
  virtual std::array<int, 2> degree() const = 0;
  /// Throws Undecided when the precision does not suffice, GeometryError when there is no net with
  /// positive weights.
  virtual TrimmableNet net(Lines lines, long precision) const = 0;
  /// Sections at distances other than zero are rational.
  virtual bool has_offsets() const { return true; }
  /// The certified range of distances without a singular point.
  virtual OffsetRange regular_range() const = 0;
  /// Nothing in the input was fitted or closed up.
  virtual bool is_exact() const = 0;
  /// Sentences for the user.
  virtual std::vector<std::string> notes() const = 0;
};

}  // namespace pn
