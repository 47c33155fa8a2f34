#include "io/document/cad_document.h"

#include "core/message/message.h"
#include "core/model/length_units.h"
#include "core/model/readable_name.h"
#include "io/brep/occt_progress.h"
#include "io/document/cad_assembly.h"
#include "io/document/xcaf_document.h"
#include "io/formats/brep/brep_check.h"
#include "io/formats/iges/iges_check.h"
#include "io/formats/iges/iges_groups.h"
#include "io/formats/iges/iges_names.h"
#include "io/formats/iges/iges_surfaces.h"
#include "io/formats/step/step_assembly_size.h"
#include "io/formats/step/step_check.h"
#include "io/formats/step/step_face_sides.h"
#include "io/formats/step/step_lost_faces.h"
#include "io/formats/step/step_names.h"
#include "io/formats/step/step_pruning.h"
#include "io/formats/step/step_references.h"

#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <IGESCAFControl_Reader.hxx>
#include <IGESData_IGESModel.hxx>
#include <STEPCAFControl_Reader.hxx>
#include <STEPControl_Reader.hxx>
#include <TColStd_SequenceOfAsciiString.hxx>
#include <TDocStd_Document.hxx>
#include <TopoDS_Shape.hxx>

#include <fstream>
#include <type_traits>
#include <utility>

namespace knead {

namespace {

constexpr const char* transferStage = "making shapes";

/// The unit as a person writes it; as the file writes it when it is none that people use.
std::string displayUnit(const std::string& name)
{
    const LengthUnit* unit = findLengthUnit(name);
    return unit != nullptr ? unit->name : readableName(std::string_view(name));
}

std::string stepUnit(STEPControl_Reader& reader, const std::string& path, std::vector<Message>& warnings)
{
    TColStd_SequenceOfAsciiString lengths;
    TColStd_SequenceOfAsciiString angles;
    TColStd_SequenceOfAsciiString solidAngles;
    reader.FileUnits(lengths, angles, solidAngles);
    std::string unit;
    for (const TCollection_AsciiString& length : lengths) {
        const std::string one = displayUnit(length.ToCString());
        if (unit.empty())
            unit = one;
        else if (unit != one)
            warnings.push_back(
                Message("Import", "%1: the file mixes the length units %2 and %3; check the sizes of the parts.")
                    .with(shortName(path), unit, one));
    }
    return unit;
}

/// Makes shapes of what a STEP or IGES reader has read, and takes their assembly and colors over.
/// @return false when there are none
template <typename Reader>
bool transfer(Reader& reader, const std::string& path, TaskControl& control, CadDocument& result)
{
    TaskPortion transferring(control, 0.3, 1);
    Handle(OcctProgress) progress = new OcctProgress(transferring, transferStage);
    ScopedDocument document;
    const bool done = reader.Transfer(*document, progress->Start());
    control.throwIfCancelled();
    if (!done)
        return false;
    if constexpr (std::is_same_v<Reader, IGESCAFControl_Reader>)
        hideBlankedEntities(reader, **document);
    CadAssembly assembly = readAssembly(**document, path, result.root.name);
    result.root.children = std::move(assembly.roots);
    result.colors = std::move(assembly.colors);
    result.displays = std::move(assembly.displays);
    return true;
}

/// Makes shapes and nothing else of what was read.
void transferShapes(STEPControl_Reader& reader, TaskControl& control, CadDocument& result)
{
    TaskPortion transferring(control, 0.3, 1);
    Handle(OcctProgress) progress = new OcctProgress(transferring, transferStage);
    reader.TransferRoots(progress->Start());
    control.throwIfCancelled();
    const TopoDS_Shape shape = reader.OneShape();
    if (shape.IsNull())
        return;
    CadNode leaf;
    leaf.name = result.root.name;
    leaf.shape = std::make_shared<const TopoDS_Shape>(shape);
    result.root.children.push_back(std::move(leaf));
}

void readStep(const std::string& path, bool onlyShapes, TaskControl& control, CadDocument& result)
{
    TaskPortion checking(control, 0, 0.05);
    const StepCheck check = checkStepText(path, checking);
    result.format = check.protocol.empty() ? "STEP" : "STEP " + check.protocol;
    if (check.protocol.empty())
        result.warnings.push_back(
            Message("Import", "%1: its schema \"%2\" is none for CAD parts; check that nothing is missing.")
                .with(shortName(path), check.schema));

    control.report(0.05, "reading the file");
    std::ifstream file(path, std::ios::binary);
    if (file.peek() == 0xEF) // the byte-order mark, which recognizeFormat() saw whole; the reader cannot take it
        file.seekg(3);
    STEPCAFControl_Reader reader;
    reader.SetColorMode(true);
    reader.SetNameMode(true);
    reader.SetGDTMode(false); // crashes on some files
    reader.SetPropsMode(false);
    reader.SetLayerMode(true);
    reader.SetMatMode(false);
    if (reader.ChangeReader().ReadStream(path.c_str(), file) !=
        IFSelect_RetDone) // files are looked for beside the path
        failReading(path, Message("Import",
                                  "the STEP text has errors that the reader cannot get over; export the file again."));
    control.throwIfCancelled();
    const StepPruning pruned = pruneHollowEntities(reader.ChangeReader(), path);
    result.damage = pruned.damage;
    if (!pruned.damage.empty())
        result.warnings.push_back(aboutFile(path, pruned.damage));
    if (isCyclic(reader.Reader()))
        failReading(
            path,
            Message("Import", "an assembly in the file holds itself; export the file again, or its parts one by one."));
    if (countUnfoldedParts(reader.Reader(), mostParts) >= mostParts)
        failReading(path, Message("Import", "the assembly unfolds to more than %1 parts; export the parts you need.")
                              .with(mostParts));
    result.unit = stepUnit(reader.ChangeReader(), path, result.warnings);

    if (onlyShapes) {
        transferShapes(reader.ChangeReader(), control, result);
    } else {
        if (const Message missing = checkReferredFiles(reader.Reader(), path, control); !missing.empty())
            result.missing.push_back(missing);
        markNames(reader.Reader());
        if (!transfer(reader, path, control, result)) {
            const Message other = otherContent(path);
            failReading(path, other.empty()
                                  ? Message("Import", "no shape of the STEP file could be made; export the file again.")
                                  : other);
        }
    }
    result.names = namesOfStepShapes(reader.Reader());
    StepLosses losses = findLosses(reader.Reader(), pruned);
    result.incompleteShells = std::move(losses.incomplete);
    result.missing.insert(result.missing.end(), losses.missing.begin(), losses.missing.end());
    mendFaceSides(reader.Reader(), path, result);
}

std::string igesUnit(const IGESCAFControl_Reader& reader)
{
    const Handle(IGESData_IGESModel) model = Handle(IGESData_IGESModel)::DownCast(reader.Model());
    if (model.IsNull() || model->GlobalSection().UnitName().IsNull())
        return {};
    return displayUnit(model->GlobalSection().UnitName()->ToCString());
}

void readIges(const std::string& path, TaskControl& control, CadDocument& result)
{
    result.format = "IGES";
    checkIgesText(path, control);
    control.report(0.05, "reading the file");
    IGESCAFControl_Reader reader;
    reader.SetColorMode(true);
    reader.SetNameMode(true);
    reader.SetLayerMode(true);
    if (reader.ReadFile(path.c_str()) != IFSelect_RetDone)
        failReading(
            path,
            Message("Import",
                    "the IGES text has errors that the reader cannot get over; export the file again, best as STEP."));
    control.throwIfCancelled();
    result.unit = igesUnit(reader);

    keepMembersOnce(reader);
    if (!transfer(reader, path, control, result))
        failReading(path,
                    Message("Import", "no shape of the IGES file could be made; export the file again, best as STEP."));
    result.names = namesOfIgesSolids(reader);
    joinLooseSurfaces(result);
}

void readBrep(const std::string& path, TaskControl& control, CadDocument& result)
{
    result.format = "BREP";
    checkBrepText(path);
    TopoDS_Shape shape;
    std::ifstream file(path, std::ios::binary);
    file.exceptions(std::ios::failbit | std::ios::badbit); // else the reader loops for ever at the end of a cut file
    Handle(OcctProgress) progress = new OcctProgress(control, "reading the file");
    try {
        BRepTools::Read(shape, file, BRep_Builder(), progress->Start());
    } catch (const std::ios::failure&) {
        failReading(path, Message("Import", "the BREP file is cut off or damaged; get it again."));
    }
    control.throwIfCancelled();
    if (shape.IsNull())
        failReading(path,
                    Message("Import",
                            "the BREP file is damaged, or newer than the reader; save it again in an older version."));
    BRepTools::Clean(shape); // triangles stored in the file are of unknown quality
    CadNode leaf;
    leaf.name = result.root.name;
    leaf.shape = std::make_shared<const TopoDS_Shape>(shape);
    result.root.children.push_back(std::move(leaf));
}

} // namespace

const void* geometryOf(const TopoDS_Shape& shape)
{
    return shape.TShape().get();
}

CadDocument readCadDocument(const std::string& path, FormatKind kind, bool onlyShapes, TaskControl& control)
{
    CadDocument result;
    result.root.name = partNameFor(path);
    if (kind == FormatKind::Step)
        readStep(path, onlyShapes, control, result);
    else if (kind == FormatKind::Iges)
        readIges(path, control, result);
    else
        readBrep(path, control, result);
    return result;
}

} // namespace knead
