// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/occt/brep.hpp"

#include <BRepTools.hxx>
#include <BRepTools_ShapeSet.hxx>
#include <BRep_Builder.hxx>
#include <limits>
#include <locale>
#include <sstream>
#include <stdexcept>

#include "pn/occt/occt_error.hpp"

namespace pn {
namespace {

// OpenCASCADE writes vertices with 15 digits, everything else with all 17.
class ExactShapeSet : public BRepTools_ShapeSet {
 public:
  ExactShapeSet() : BRepTools_ShapeSet(/*theWithTriangles=*/true) {}

  using BRepTools_ShapeSet::WriteGeometry;
  void WriteGeometry(const TopoDS_Shape& shape, Standard_OStream& stream) const override {
    const auto precision = stream.precision(std::numeric_limits<double>::max_digits10);
    BRepTools_ShapeSet::WriteGeometry(shape, stream);
    stream.precision(precision);
  }
};

}  // namespace

std::string to_brep(const TopoDS_Shape& shape) {
  return with_occt_errors([&] {
    std::ostringstream stream;
    stream.imbue(std::locale::classic());
    ExactShapeSet shapes;
    shapes.Add(shape);
    stream << "DBRep_DrawableShape\n";
    shapes.Write(stream);
    shapes.Write(shape, stream);
    return stream.str();
  });
}

TopoDS_Shape from_brep(const std::string& text) {
  return with_occt_errors([&] {
    std::istringstream stream(text);
    stream.imbue(std::locale::classic());
    TopoDS_Shape shape;
    BRepTools::Read(shape, stream, BRep_Builder());
    if (shape.IsNull()) throw std::invalid_argument("The text is no shape in the BREP format.");
    return shape;
  });
}

}  // namespace pn
