#include "io/cad_writer.h"

#include "core/model/length_units.h"
#include "io/occt_progress.h"
#include "io/step_order.h"
#include "io/worker/child_process.h"
#include "io/xcaf_document.h"

#include <APIHeaderSection_MakeHeader.hxx>
#include <BRepAdaptor_Surface.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <IGESCAFControl_Writer.hxx>
#include <IGESControl_Controller.hxx>
#include <IGESData_IGESModel.hxx>
#include <Interface_Static.hxx>
#include <Quantity_Color.hxx>
#include <STEPCAFControl_Controller.hxx>
#include <STEPCAFControl_Writer.hxx>
#include <StepData_StepModel.hxx>
#include <TCollection_ExtendedString.hxx>
#include <TCollection_HAsciiString.hxx>
#include <TDataStd_Name.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopLoc_Location.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <XCAFDoc_ColorTool.hxx>
#include <XCAFDoc_DocumentTool.hxx>
#include <XCAFDoc_LayerTool.hxx>
#include <XCAFDoc_ShapeTool.hxx>

#include <algorithm>
#include <map>
#include <stdexcept>
#include <utility>

namespace knead {

namespace {

Quantity_Color quantity(const Color& color)
{
    return {static_cast<double>(color.r), static_cast<double>(color.g), static_cast<double>(color.b),
            Quantity_TOC_sRGB};
}

TCollection_ExtendedString extended(const std::string& text)
{
    return {text.c_str(), true};
}

/// The parts as the document that OpenCASCADE's writers take.
class DocumentMaker {
public:
    DocumentMaker(const std::vector<CadPartToWrite>& parts, const Handle(TDocStd_Document) & document)
        : m_parts(parts)
        , m_shapes(XCAFDoc_DocumentTool::ShapeTool(document->Main()))
        , m_colors(XCAFDoc_DocumentTool::ColorTool(document->Main()))
        , m_layers(XCAFDoc_DocumentTool::LayerTool(document->Main()))
    {
        m_shapes->SetAutoNaming(false);
    }

    void add(const PartNode& tree)
    {
        for (const PartNode& child : tree.children)
            if (child.part)
                addProduct(m_parts[*child.part], atItsPlace(m_parts[*child.part].shape));
            else
                addAssembly(child);
        if (tree.part)
            addProduct(m_parts[*tree.part], atItsPlace(m_parts[*tree.part].shape));
        m_shapes->UpdateAssemblies();
    }

private:
    /// A part by itself has no instance that could say where it is.
    static TopoDS_Shape atItsPlace(const TopoDS_Shape& shape)
    {
        if (shape.Location().IsIdentity())
            return shape;
        return BRepBuilderAPI_Transform(shape.Located(TopLoc_Location()), shape.Location().Transformation(), true)
            .Shape();
    }

    TDF_Label addAssembly(const PartNode& node)
    {
        const TDF_Label assembly = m_shapes->NewShape();
        TDataStd_Name::Set(assembly, extended(node.name));
        for (const PartNode& child : node.children) {
            const TDF_Label component = child.part
                                            ? addInstance(assembly, m_parts[*child.part])
                                            : m_shapes->AddComponent(assembly, addAssembly(child), TopLoc_Location());
            TDataStd_Name::Set(component, extended(child.name));
        }
        return assembly;
    }

    TDF_Label addInstance(const TDF_Label& assembly, const CadPartToWrite& part)
    {
        const TDF_Label component = m_shapes->AddComponent(assembly, productOf(part), part.shape.Location());
        m_colors->SetVisibility(component, part.visible);
        return component;
    }

    /// Instances of one shape that look alike share a product.
    TDF_Label productOf(const CadPartToWrite& part)
    {
        std::vector<std::pair<const CadPartToWrite*, TDF_Label>>& products = m_products[part.shape.TShape().get()];
        for (const auto& [other, label] : products)
            if (other->color == part.color && other->faceColors == part.faceColors && other->layer == part.layer &&
                other->visible == part.visible && other->shape.Orientation() == part.shape.Orientation())
                return label;
        products.emplace_back(&part, addProduct(part, part.shape.Located(TopLoc_Location())));
        return products.back().second;
    }

    TDF_Label addProduct(const CadPartToWrite& part, const TopoDS_Shape& shape)
    {
        const TDF_Label label = m_shapes->AddShape(shape, false);
        TDataStd_Name::Set(label, extended(part.name));
        // The writer of OpenCASCADE 7.6 crashes on what is hidden and has no color.
        if (part.color || !part.visible)
            m_colors->SetColor(label, quantity(part.color.value_or(Color{})), XCAFDoc_ColorGen);
        m_colors->SetVisibility(label, part.visible);
        if (!part.layer.empty())
            m_layers->SetLayer(label, extended(part.layer));
        TopTools_IndexedMapOfShape faces;
        TopExp::MapShapes(shape, TopAbs_FACE, faces);
        const auto count = std::min(part.faceColors.size(), static_cast<std::size_t>(faces.Extent()));
        for (std::size_t i = 0; i < count; ++i)
            if (part.faceColors[i])
                m_colors->SetColor(m_shapes->AddSubShape(label, faces(static_cast<int>(i) + 1)),
                                   quantity(*part.faceColors[i]), XCAFDoc_ColorSurf);
        return label;
    }

    const std::vector<CadPartToWrite>& m_parts;
    Handle(XCAFDoc_ShapeTool) m_shapes;
    Handle(XCAFDoc_ColorTool) m_colors;
    Handle(XCAFDoc_LayerTool) m_layers;
    std::map<const void*, std::vector<std::pair<const CadPartToWrite*, TDF_Label>>> m_products; // by geometry
};

bool hasCurvedFace(const CadPartToWrite& part)
{
    for (TopExp_Explorer faces(part.shape, TopAbs_FACE); faces.More(); faces.Next())
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
    throw std::runtime_error("A CAD file cannot be written in " + unit + "; choose mm, cm, m, inch or ft.");
}

std::string nameOf(const NamelessFile& file)
{
    return "/proc/self/fd/" + std::to_string(file.descriptor());
}

// Same parts, same bytes: when a file was written is what the file system is for.
constexpr const char* noDate = "1970-01-01T00:00:00";

std::string writeStep(const Handle(TDocStd_Document) & document, bool hasCurvedFaces, const ExportOptions& options,
                      TaskControl& control)
{
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
        throw std::runtime_error("The parts could not be put into STEP.");
    APIHeaderSection_MakeHeader header(writer.ChangeWriter().Model());
    header.SetOriginatingSystem(new TCollection_HAsciiString("Knead"));
    header.SetPreprocessorVersion(new TCollection_HAsciiString("Knead, OpenCASCADE"));
    header.SetAuthorValue(1, new TCollection_HAsciiString(""));
    header.SetOrganizationValue(1, new TCollection_HAsciiString(""));
    header.SetName(new TCollection_HAsciiString(""));
    header.SetTimeStamp(new TCollection_HAsciiString(noDate));
    const NamelessFile file;
    if (writer.Write(nameOf(file).c_str()) != IFSelect_RetDone)
        throw std::runtime_error("The STEP text could not be written.");
    return withStylesInOrder(file.content());
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
        throw std::runtime_error("The parts could not be put into IGES.");
    writer.ComputeModel();
    const NamelessFile file;
    if (!writer.Write(nameOf(file).c_str()))
        throw std::runtime_error("The IGES text could not be written.");
    return file.content();
}

std::string writeBrep(const std::vector<CadPartToWrite>& parts)
{
    TopoDS_Compound all;
    const BRep_Builder builder;
    builder.MakeCompound(all);
    for (const CadPartToWrite& part : parts)
        builder.Add(all, part.shape);
    const NamelessFile file;
    const TopoDS_Shape& shape = parts.size() == 1 ? parts.front().shape : all;
    if (!BRepTools::Write(shape, nameOf(file).c_str(), false, false, TopTools_FormatVersion_VERSION_1))
        throw std::runtime_error("The BREP text could not be written.");
    return file.content();
}

} // namespace

std::string writeCad(FormatKind kind, const std::vector<CadPartToWrite>& parts, const PartNode& tree,
                     const ExportOptions& options, TaskControl& control)
{
    if (kind == FormatKind::Brep)
        return writeBrep(parts);
    ScopedDocument document;
    DocumentMaker(parts, *document).add(tree);
    control.throwIfCancelled();
    if (kind == FormatKind::Step)
        return writeStep(*document, std::any_of(parts.begin(), parts.end(), hasCurvedFace), options, control);
    if (kind == FormatKind::Iges)
        return writeIges(*document, options, control);
    throw std::runtime_error("writeCad: no CAD format");
}

} // namespace knead
