// SPDX-License-Identifier: LGPL-2.1-or-later
// STEP files that keep every double.
#pragma once

#include <TopoDS_Shape.hxx>
#include <filesystem>
#include <string>
#include <vector>

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

/// Writes the shapes, in millimetres, each as one product, every real with 17 significant digits.
///
/// The file appears under its name only when it is complete. Throws
/// std::filesystem::filesystem_error when it cannot be written, OcctError when OpenCASCADE cannot
/// translate a shape.
void write_step(const std::filesystem::path& path, const std::vector<NamedShape>& shapes,
                const StepOptions& options = {});

/// The shapes of a STEP file, one for each root product, in millimetres. OpenCASCADE makes closed
/// surfaces periodic; `from_geometry` undoes this.
///
/// Throws std::filesystem::filesystem_error when the file cannot be opened, OcctError when it is no
/// STEP file or nothing in it can be translated.
std::vector<TopoDS_Shape> read_step(const std::filesystem::path& path);

}  // namespace pn
