#include "io/formats/cad_writer.h"

#include "core/message/message.h"
#include "core/model/length_units.h"
#include "io/brep/occt_progress.h"
#include "io/document/document_of_parts.h"
#include "io/document/xcaf_document.h"
#include "io/formats/step/step_names.h"
#include "io/formats/step/step_order.h"

#include <APIHeaderSection_MakeHeader.hxx>
#include <BRepAdaptor_Surface.hxx>
#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <IGESCAFControl_Writer.hxx>
#include <IGESControl_Controller.hxx>
#include <IGESData_IGESModel.hxx>
#include <Interface_Static.hxx>
#include <STEPCAFControl_Controller.hxx>
#include <STEPCAFControl_Writer.hxx>
#include <StepData_Protocol.hxx>
#include <StepData_StepModel.hxx>
#include <StepData_StepWriter.hxx>
#include <TCollection_HAsciiString.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <XSControl_WorkSession.hxx>

#include <algorithm>
#include <sstream>
#include <utility>

namespace knead {

namespace {

bool hasCurvedFace(const TopoDS_Shape& shape)
{
    for (TopExp_Explorer faces(shape, TopAbs_FACE); faces.More(); faces.Next())
        if (BRepAdaptor_Surface(TopoDS::Face(faces.Current()), false).GetType() != GeomAbs_Plane)
            return true;
    return false;
}

/// The name that OpenCASCADE's writers have for a length unit.
const char* writerUnit(const std::string& unit)
{
    if (unit == "inch")
        return "INCH";
    if (unit == "ft")
        return "FT";
    if (unit == "m")
        return "M";
    if (unit == "cm")
        return "CM";
    if (unit == "mm" || unit.empty())
        return "MM";
    throw Problem(Message("Export", "A CAD file cannot be written in %1; choose mm, cm, m, inch or ft.").with(unit));
}

// Same parts, same bytes: when a file was written is what the file system is for.
constexpr const char* noDate = "1970-01-01T00:00:00";

std::string writeStep(const Handle(TDocStd_Document) & document, const NamedShapes& shapes,
                      const ExportOptions& options, TaskControl& control)
{
    const bool hasCurvedFaces =
        std::any_of(shapes.begin(), shapes.end(), [](const auto& named) { return hasCurvedFace(named.first); });
    STEPCAFControl_Controller::Init();
    Interface_Static::SetIVal("write.step.schema", options.useAp214 ? 4 : 5);
    Interface_Static::SetCVal("write.step.unit", writerUnit(options.unit));
    // Without curves on curved surfaces readers make their own, and tolerances grow. Planes need none.
    Interface_Static::SetIVal("write.surfacecurve.mode", hasCurvedFaces ? 1 : 0);
    Interface_Static::SetIVal("write.precision.mode", 1); // the largest tolerance, so that readers know it
    STEPCAFControl_Writer writer;
    writer.SetColorMode(true);
    writer.SetNameMode(true);
    writer.SetLayerMode(true);
    writer.SetDimTolMode(false);
    TaskPortion transferring(control, 0, 0.8);
    Handle(OcctProgress) progress = new OcctProgress(transferring, "writing faces");
    const bool done = writer.Transfer(document, STEPControl_AsIs, nullptr, progress->Start());
    control.throwIfCancelled();
    if (!done)
        throw Problem(Message("Export", "The parts could not be put into STEP."));
    nameShapes(shapes, writer.ChangeWriter());
    takePartNumbersApart(writer.ChangeWriter());
    APIHeaderSection_MakeHeader header(writer.ChangeWriter().Model());
    header.SetOriginatingSystem(new TCollection_HAsciiString("Knead"));
    header.SetPreprocessorVersion(new TCollection_HAsciiString("Knead, OpenCASCADE"));
    header.SetAuthorValue(1, new TCollection_HAsciiString(""));
    header.SetOrganizationValue(1, new TCollection_HAsciiString(""));
    header.SetName(new TCollection_HAsciiString(""));
    header.SetTimeStamp(new TCollection_HAsciiString(noDate));
    StepData_StepWriter text(writer.ChangeWriter().Model());
    text.SendModel(Handle(StepData_Protocol)::DownCast(writer.ChangeWriter().WS()->Protocol()));
    std::ostringstream bytes;
    if (!text.Print(bytes))
        throw Problem(Message("Export", "The STEP text could not be written."));
    return withStylesInOrder(std::move(bytes).str());
}

std::string writeIges(const Handle(TDocStd_Document) & document, const ExportOptions& options, TaskControl& control)
{
    IGESControl_Controller::Init();
    Interface_Static::SetCVal("write.iges.unit", writerUnit(options.unit));
    Interface_Static::SetIVal("write.iges.brep.mode", 1); // solids, not loose surfaces
    IGESCAFControl_Writer writer;
    writer.SetColorMode(true);
    writer.SetNameMode(true);
    writer.SetLayerMode(true);
    TaskPortion transferring(control, 0, 0.8);
    Handle(OcctProgress) progress = new OcctProgress(transferring, "writing faces");
    const bool done = writer.Transfer(document, progress->Start());
    control.throwIfCancelled();
    if (!done)
        throw Problem(Message("Export", "The parts could not be put into IGES."));
    writer.ComputeModel();
    std::ostringstream bytes;
    if (!writer.Write(bytes))
        throw Problem(Message("Export", "The IGES text could not be written."));
    return std::move(bytes).str();
}

std::string writeBrep(const std::vector<CadPartToWrite>& parts)
{
    TopoDS_Compound all;
    const BRep_Builder builder;
    builder.MakeCompound(all);
    for (const CadPartToWrite& part : parts)
        builder.Add(all, part.shape);
    const TopoDS_Shape& shape = parts.size() == 1 ? parts.front().shape : all;
    std::ostringstream bytes;
    bytes << "DBRep_DrawableShape\n"; // as files begin that OpenCASCADE writes under a name
    BRepTools::Write(shape, bytes, false, false, TopTools_FormatVersion_VERSION_1);
    if (!bytes)
        throw Problem(Message("Export", "The BREP text could not be written."));
    return std::move(bytes).str();
}

} // namespace

std::string writeCad(FormatKind kind, const std::vector<CadPartToWrite>& parts, const PartNode& tree,
                     const ExportOptions& options, TaskControl& control)
{
    if (kind == FormatKind::Brep)
        return writeBrep(parts);
    ScopedDocument document;
    const NamedShapes shapes = fillDocument(parts, tree, kind == FormatKind::Step, *document);
    control.throwIfCancelled();
    if (kind == FormatKind::Step)
        return writeStep(*document, shapes, options, control);
    if (kind == FormatKind::Iges)
        return writeIges(*document, options, control);
    throw Problem(Message::verbatim("writeCad: no CAD format"));
}

} // namespace knead
