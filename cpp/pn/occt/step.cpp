// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/occt/step.hpp"

#include <IFSelect_WorkSession.hxx>
#include <Interface_FloatWriter.hxx>
#include <Interface_Static.hxx>
#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <Message_ProgressIndicator.hxx>
#include <Message_ProgressScope.hxx>
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

// What the steps of an export take of its time, roughly.
constexpr double kTransferShare = 1;
constexpr double kPrintShare = 1;
constexpr double kReadShare = 5;
constexpr double kCompareShare = 5;
constexpr double kAllShares = kTransferShare + kPrintShare + kReadShare + kCompareShare;

// OpenCASCADE's progress as a function that may ask to break off.
class ProgressIndicator : public Message_ProgressIndicator {
 public:
  explicit ProgressIndicator(const Progress& progress) : progress_(progress) {}
  Standard_Boolean UserBreak() override { return is_cancelled_; }

 protected:
  void Show(const Message_ProgressScope&, const Standard_Boolean) override {
    if (progress_ && !is_cancelled_) is_cancelled_ = !progress_(GetPosition());
  }

 private:
  const Progress& progress_;
  bool is_cancelled_ = false;
};

void require_more(const Message_ProgressScope& scope) {
  if (!scope.More()) throw Cancelled();
}

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
                 const StepOptions& options, Message_ProgressScope& scope) {
  const ScopedSilence silence;
  STEPCAFControl_Controller::Init();  // Before it OpenCASCADE has none of these settings.
  const ScopedSetting schema("write.step.schema", protocol_name(options.schema));
  const ScopedSetting p_curves("write.surfacecurve.mode", options.p_curves ? "On" : "Off");
  const ScopedSetting unit("write.step.unit", "MM");
  STEPCAFControl_Writer writer;
  writer.SetNameMode(true);
  const bool is_done =
      writer.Transfer(document(shapes), STEPControl_AsIs, nullptr, scope.Next(kTransferShare));
  require_more(scope);
  if (!is_done) throw OcctError("OpenCASCADE could not translate the shapes to STEP.");
  print(writer.ChangeWriter(), path);
  scope.Next(kPrintShare);
  require_more(scope);
}

std::vector<TopoDS_Shape> read_model(const std::filesystem::path& path,
                                     Message_ProgressScope& scope) {
  if (!std::ifstream(path)) throw_file_error("The STEP file cannot be opened", path);
  const ScopedSilence silence;
  STEPCAFControl_Controller::Init();
  const ScopedSetting unit("xstep.cascade.unit", "MM");
  STEPControl_Reader reader;
  const bool is_read = reader.ReadFile(path.c_str()) == IFSelect_RetDone;
  const bool has_roots = is_read && reader.TransferRoots(scope.Next(kReadShare)) > 0;
  require_more(scope);
  if (!has_roots) {
    throw OcctError("No shape can be read from the STEP file " + path.string() + ".");
  }
  std::vector<TopoDS_Shape> shapes;
  for (int i = 1; i <= reader.NbShapes(); ++i) shapes.push_back(reader.Shape(i));
  return shapes;
}

RoundTrip read_back(const std::filesystem::path& path, const std::vector<NamedShape>& shapes,
                    Message_ProgressScope& scope) {
  std::vector<TopoDS_Shape> written;
  for (const NamedShape& named : shapes) written.push_back(named.shape);
  const auto read = read_model(path, scope);
  RoundTrip result = compare_round_trip(written, read, scope.Next(kCompareShare));
  require_more(scope);
  if (!result.differences.empty()) {
    std::string text = "The STEP file was not kept, since it does not hold what was written.";
    for (const std::string& difference : result.differences) text += " " + difference;
    throw RoundTripError(text);
  }
  return result;
}

// Does the work on a file aside, which gets its name when all is well, and gives its result.
template <class Work>
auto with_file_aside(const std::filesystem::path& path, const Work& work) {
  std::filesystem::path partial = path;
  partial += ".partial";
  try {
    auto result = with_occt_errors([&] { return work(partial); });
    std::filesystem::rename(partial, path);
    return result;
  } catch (...) {
    std::error_code none_written;
    std::filesystem::remove(partial, none_written);
    throw;
  }
}

}  // namespace

void write_step(const std::filesystem::path& path, const std::vector<NamedShape>& shapes,
                const StepOptions& options) {
  with_file_aside(path, [&](const std::filesystem::path& file) {
    Message_ProgressScope unwatched(Message_ProgressRange(), "STEP export", kAllShares);
    write_model(file, shapes, options, unwatched);
    return std::filesystem::file_size(file);
  });
}

StepReport write_verified_step(const std::filesystem::path& path,
                               const std::vector<NamedShape>& shapes, const StepOptions& options,
                               const Progress& progress) {
  return with_file_aside(path, [&](const std::filesystem::path& file) {
    const Handle(ProgressIndicator) indicator = new ProgressIndicator(progress);
    Message_ProgressScope scope(indicator->Start(), "STEP export", kAllShares);
    write_model(file, shapes, options, scope);
    return StepReport{read_back(file, shapes, scope), std::filesystem::file_size(file)};
  });
}

std::vector<TopoDS_Shape> read_step(const std::filesystem::path& path) {
  return with_occt_errors([&] {
    Message_ProgressScope unwatched(Message_ProgressRange(), "STEP import", kReadShare);
    return read_model(path, unwatched);
  });
}

}  // namespace pn
