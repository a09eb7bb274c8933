// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/occt/step.hpp"

#include <IFSelect_WorkSession.hxx>
#include <Interface_FloatWriter.hxx>
#include <Interface_Static.hxx>
#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <STEPCAFControl_Controller.hxx>
#include <STEPCAFControl_Writer.hxx>
#include <STEPControl_Reader.hxx>
#include <StepData_Protocol.hxx>
#include <StepData_StepModel.hxx>
#include <StepData_StepWriter.hxx>
#include <TDataStd_Name.hxx>
#include <TDocStd_Document.hxx>
#include <XCAFDoc_DocumentTool.hxx>
#include <XCAFDoc_ShapeTool.hxx>
#include <XSControl_WorkSession.hxx>
#include <cerrno>
#include <fstream>
#include <system_error>

#include "pn/occt/occt_error.hpp"

namespace pn {
namespace {

// One of OpenCASCADE's settings, which belong to the whole process, for the life of this object.
class ScopedSetting {
 public:
  ScopedSetting(std::string name, const std::string& value)
      : name_(std::move(name)), previous_(Interface_Static::CVal(name_.c_str())) {
    if (!Interface_Static::SetCVal(name_.c_str(), value.c_str())) {
      throw OcctError("OpenCASCADE has no setting " + name_ + " = " + value + ".");
    }
  }
  ~ScopedSetting() { Interface_Static::SetCVal(name_.c_str(), previous_.c_str()); }
  ScopedSetting(const ScopedSetting&) = delete;
  ScopedSetting& operator=(const ScopedSetting&) = delete;

 private:
  std::string name_;
  std::string previous_;
};

// Keeps OpenCASCADE from printing its statistics, for the life of this object.
class ScopedSilence {
 public:
  ScopedSilence() : printers_(Message::DefaultMessenger()->Printers()) {
    Message::DefaultMessenger()->ChangePrinters().Clear();
  }
  ~ScopedSilence() { Message::DefaultMessenger()->ChangePrinters() = printers_; }
  ScopedSilence(const ScopedSilence&) = delete;
  ScopedSilence& operator=(const ScopedSilence&) = delete;

 private:
  Message_SequenceOfPrinters printers_;
};

// The application protocol in OpenCASCADE's own words.
std::string protocol_name(StepSchema schema) {
  switch (schema) {
    case StepSchema::kAp203:
      return "AP203";
    case StepSchema::kAp214:
      return "AP214IS";
    case StepSchema::kAp242:
      return "AP242DIS";
  }
  throw std::invalid_argument("There is no such STEP schema.");
}

Handle(TDocStd_Document) document(const std::vector<NamedShape>& shapes) {
  Handle(TDocStd_Document) document = new TDocStd_Document("BinXCAF");
  XCAFDoc_DocumentTool::SetLengthUnit(document, 1, UnitsMethods_LengthUnit_Millimeter);
  const auto tool = XCAFDoc_DocumentTool::ShapeTool(document->Main());
  for (const NamedShape& named : shapes) {
    const TDF_Label label = tool->AddShape(named.shape, /*makeAssembly=*/false);
    const TCollection_ExtendedString name(named.name.c_str(), /*isMultiByte=*/true);
    TDataStd_Name::Set(label, name);
  }
  return document;
}

[[noreturn]] void throw_file_error(const std::string& what, const std::filesystem::path& path) {
  throw std::filesystem::filesystem_error(what, path,
                                          std::error_code(errno, std::generic_category()));
}

// Prints the model with 17 significant digits; the decimal point that Part 21 demands is what %E
// gives and %G does not.
void print(STEPControl_Writer& writer, const std::filesystem::path& path) {
  StepData_StepWriter printer(writer.Model());
  printer.FloatWriter().SetFormat("%.16E", true);
  printer.SendModel(Handle(StepData_Protocol)::DownCast(writer.WS()->Protocol()));
  std::ofstream file(path, std::ios::binary);
  if (!file) throw_file_error("The STEP file cannot be created", path);
  printer.Print(file);
  file.close();
  if (!file) throw_file_error("The STEP file cannot be written", path);
}

void write_model(const std::filesystem::path& path, const std::vector<NamedShape>& shapes,
                 const StepOptions& options) {
  const ScopedSilence silence;
  STEPCAFControl_Controller::Init();  // Before it OpenCASCADE has none of these settings.
  const ScopedSetting schema("write.step.schema", protocol_name(options.schema));
  const ScopedSetting p_curves("write.surfacecurve.mode", options.p_curves ? "On" : "Off");
  const ScopedSetting unit("write.step.unit", "MM");
  STEPCAFControl_Writer writer;
  writer.SetNameMode(true);
  if (!writer.Transfer(document(shapes), STEPControl_AsIs)) {
    throw OcctError("OpenCASCADE could not translate the shapes to STEP.");
  }
  print(writer.ChangeWriter(), path);
}

}  // namespace

void write_step(const std::filesystem::path& path, const std::vector<NamedShape>& shapes,
                const StepOptions& options) {
  std::filesystem::path partial = path;
  partial += ".partial";
  try {
    with_occt_errors([&] { write_model(partial, shapes, options); });
    std::filesystem::rename(partial, path);
  } catch (...) {
    std::error_code none_written;
    std::filesystem::remove(partial, none_written);
    throw;
  }
}

std::vector<TopoDS_Shape> read_step(const std::filesystem::path& path) {
  if (!std::ifstream(path)) throw_file_error("The STEP file cannot be opened", path);
  return with_occt_errors([&] {
    const ScopedSilence silence;
    STEPCAFControl_Controller::Init();
    const ScopedSetting unit("xstep.cascade.unit", "MM");
    STEPControl_Reader reader;
    if (reader.ReadFile(path.c_str()) != IFSelect_RetDone || reader.TransferRoots() == 0) {
      throw OcctError("No shape can be read from the STEP file " + path.string() + ".");
    }
    std::vector<TopoDS_Shape> shapes;
    for (int i = 1; i <= reader.NbShapes(); ++i) shapes.push_back(reader.Shape(i));
    return shapes;
  });
}

}  // namespace pn
