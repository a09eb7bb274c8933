// SPDX-License-Identifier: LGPL-2.1-or-later
// STEP files that keep every double.
#pragma once

#include <TopoDS_Shape.hxx>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

#include "pn/algebra/cancellation.hpp"
#include "pn/occt/round_trip.hpp"

namespace pn {

/// Application protocol of a STEP file.
enum class StepSchema { kAp203, kAp214, kAp242 };

struct StepOptions {
  StepSchema schema = StepSchema::kAp214;
  /// Writes the p-curves of the edges; a reader that misses them projects the edges anew.
  bool p_curves = true;
};

/// A shape and the name, in UTF-8, of its product.
struct NamedShape {
  TopoDS_Shape shape;
  std::string name;
};

/// What is called now and then with the part of the work that is done, from 0 to 1, and answers
/// whether to go on.
using Progress = std::function<bool(double)>;

/// What was written does not come back from the file: a sentence on each difference.
class RoundTripError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// What a complete file holds, as it was read back from it.
struct StepReport {
  RoundTrip round_trip;
  std::uintmax_t bytes = 0;
};

/// Writes the shapes, in millimetres, each as one product, every real with 17 significant digits.
///
/// The file appears under its name only when it is complete; until then, and after any failure, a
/// file of that name stays as it is. Throws std::filesystem::filesystem_error when it cannot be
/// written, OcctError when OpenCASCADE cannot translate a shape.
void write_step(const std::filesystem::path& path, const std::vector<NamedShape>& shapes,
                const StepOptions& options = {});

/// The same, but the file is read back first, and appears only when it holds just what was written.
///
/// Throws also RoundTripError, and Cancelled (cancellation.hpp) when `progress` says no.
StepReport write_verified_step(const std::filesystem::path& path,
                               const std::vector<NamedShape>& shapes,
                               const StepOptions& options = {}, const Progress& progress = {});

/// The shapes of a STEP file, one for each root product, in millimetres. OpenCASCADE makes closed
/// surfaces periodic; `from_geometry` undoes this.
///
/// Throws std::filesystem::filesystem_error when the file cannot be opened, OcctError when it is no
/// STEP file or nothing in it can be translated.
std::vector<TopoDS_Shape> read_step(const std::filesystem::path& path);

}  // namespace pn
