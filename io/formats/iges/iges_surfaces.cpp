#include "io/formats/iges/iges_surfaces.h"

#include <BRep_Builder.hxx>
#include <IGESCAFControl_Reader.hxx>
#include <IGESData_IGESEntity.hxx>
#include <IGESData_IGESModel.hxx>
#include <TDocStd_Document.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Shape.hxx>
#include <TransferBRep.hxx>
#include <Transfer_TransientProcess.hxx>
#include <XCAFDoc_ColorTool.hxx>
#include <XCAFDoc_DocumentTool.hxx>
#include <XCAFDoc_ShapeTool.hxx>
#include <XSControl_TransferReader.hxx>
#include <XSControl_WorkSession.hxx>

#include <algorithm>

namespace knead {

namespace {

constexpr int blanked = 1;
constexpr int physicallyDependent = 1; // a curve of a trimmed surface, or the surface that it trims
constexpr int dependentInBothWays = 3;

bool isHidden(const IGESData_IGESEntity& entity)
{
    const int dependence = entity.SubordinateStatus();
    return entity.BlankStatus() == blanked && dependence != physicallyDependent && dependence != dependentInBothWays;
}

TDF_Label labelOf(XCAFDoc_ShapeTool& shapes, const TopoDS_Shape& shape)
{
    TDF_Label label;
    if (shapes.Search(shape, label))
        return label;
    const TDF_Label whole = shapes.FindMainShape(shape);
    return whole.IsNull() ? label : shapes.AddSubShape(whole, shape);
}

/// Adds the names in a list that are not in it yet.
void addLayer(std::string& layers, const std::string& layer)
{
    if (!layer.empty() && (", " + layers + ", ").find(", " + layer + ", ") == std::string::npos)
        layers += (layers.empty() ? "" : ", ") + layer;
}

/// One surface of all loose shapes that are shown, or of all that are not.
CadNode joined(const CadNode& root, bool visible, const std::vector<CadNode>& loose, ShapeColors& colors)
{
    CadNode result;
    result.name = root.name;
    result.visible = visible;
    TopoDS_Compound surface;
    const BRep_Builder builder;
    builder.MakeCompound(surface);
    for (const CadNode& node : loose) {
        if (node.visible != visible)
            continue;
        builder.Add(surface, *node.shape);
        addLayer(result.layer, node.layer);
        for (TopExp_Explorer faces(*node.shape, TopAbs_FACE); faces.More(); faces.Next())
            if (node.color && !colors.find(faces.Current()))
                colors.set(faces.Current(), *node.color);
    }
    result.shape = std::make_shared<const TopoDS_Shape>(surface);
    return result;
}

} // namespace

void hideBlankedEntities(const IGESCAFControl_Reader& reader, const TDocStd_Document& document)
{
    const Handle(XCAFDoc_ShapeTool) shapes = XCAFDoc_DocumentTool::ShapeTool(document.Main());
    const Handle(XCAFDoc_ColorTool) colors = XCAFDoc_DocumentTool::ColorTool(document.Main());
    const Handle(Transfer_TransientProcess)& process = reader.WS()->TransferReader()->TransientProcess();
    const Handle(Interface_InterfaceModel) model = reader.Model();
    for (int i = 1; i <= model->NbEntities(); ++i) {
        const auto entity = Handle(IGESData_IGESEntity)::DownCast(model->Value(i));
        if (entity.IsNull() || !isHidden(*entity))
            continue;
        const TopoDS_Shape shape = TransferBRep::ShapeResult(process, entity);
        if (shape.IsNull())
            continue;
        if (const TDF_Label label = labelOf(*shapes, shape); !label.IsNull())
            colors->SetVisibility(label, false);
    }
}

void joinLooseSurfaces(CadDocument& document)
{
    std::vector<CadNode>& nodes = document.root.children;
    const auto isLoose = [](const CadNode& node) {
        return node.shape && !TopExp_Explorer(*node.shape, TopAbs_SOLID).More();
    };
    std::vector<CadNode> loose;
    std::copy_if(nodes.begin(), nodes.end(), std::back_inserter(loose), isLoose);
    if (loose.size() < 2)
        return;
    std::erase_if(nodes, isLoose);
    for (const bool visible : {true, false})
        if (std::any_of(loose.begin(), loose.end(), [&](const CadNode& node) { return node.visible == visible; }))
            nodes.push_back(joined(document.root, visible, loose, document.colors));
}

} // namespace knead
