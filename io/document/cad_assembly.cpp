#include "io/document/cad_assembly.h"

#include "core/message/message.h"
#include "core/model/readable_name.h"
#include "io/formats/step/step_names.h"

#include <Quantity_Color.hxx>
#include <TDF_LabelIntegerMap.hxx>
#include <TDF_LabelSequence.hxx>
#include <TDataStd_Name.hxx>
#include <TDocStd_Document.hxx>
#include <TopExp_Explorer.hxx>
#include <TopLoc_Location.hxx>
#include <TopoDS_Shape.hxx>
#include <XCAFDoc_ColorTool.hxx>
#include <XCAFDoc_DocumentTool.hxx>
#include <XCAFDoc_LayerTool.hxx>
#include <XCAFDoc_ShapeTool.hxx>

#include <algorithm>

namespace knead {

namespace {

constexpr int deepestAssembly = 4000; // the walk recurses once a level

TDF_LabelSequence componentsOf(const TDF_Label& label)
{
    TDF_LabelSequence components;
    XCAFDoc_ShapeTool::GetComponents(label, components);
    return components;
}

TDF_Label referredBy(const TDF_Label& component)
{
    TDF_Label product;
    return XCAFDoc_ShapeTool::GetReferredShape(component, product) ? product : component;
}

std::string readable(const TCollection_ExtendedString& text)
{
    return readableName(std::u16string_view(text.ToExtString(), static_cast<std::size_t>(text.Length())));
}

StepName nameOf(const TDF_Label& label)
{
    Handle(TDataStd_Name) name;
    if (!label.FindAttribute(TDataStd_Name::GetID(), name))
        return {};
    const TCollection_ExtendedString& text = name->Get();
    return withoutMark(std::u16string_view(text.ToExtString(), static_cast<std::size_t>(text.Length())));
}

/// What a node is called, and the product that it is an instance of.
void takeNames(const std::string& instance, const StepName& product, const std::string& fallback, CadNode& node)
{
    const std::string named = isGeneratedName(product.name) ? product.partNumber : product.name;
    node.name = bestPartName(instance, named, fallback);
    if (!isGeneratedName(named) && named != node.name)
        node.product = named;
    if (product.partNumber != named)
        node.partNumber = product.partNumber;
}

std::optional<Color> colorOf(const Handle(XCAFDoc_ColorTool) & tool, const TDF_Label& label)
{
    Quantity_Color color;
    for (const XCAFDoc_ColorType type : {XCAFDoc_ColorSurf, XCAFDoc_ColorGen, XCAFDoc_ColorCurv})
        if (tool->GetColor(label, type, color)) {
            Standard_Real r = 0;
            Standard_Real g = 0;
            Standard_Real b = 0;
            color.Values(r, g, b, Quantity_TOC_sRGB);
            return Color{static_cast<float>(r), static_cast<float>(g), static_cast<float>(b)};
        }
    return std::nullopt;
}

bool hasFaces(const CadNode& node)
{
    return node.shape && TopExp_Explorer(*node.shape, TopAbs_FACE).More();
}

/// A product whose shape is in another representation arrives as an assembly of nameless parts, which then have its name: one
/// with the faces, perhaps others with axes and planes.
CadNode withoutSecondSelf(CadNode node)
{
    std::erase_if(node.children, [&](const CadNode& child) {
        return child.name == node.name && child.children.empty() && !hasFaces(child);
    });
    const bool isItself =
        node.children.size() == 1 && node.children.front().shape && node.children.front().name == node.name;
    if (!isItself)
        return node;
    CadNode self = std::move(node.children.front());
    self.product = std::move(node.product);
    self.partNumber = std::move(node.partNumber);
    return self;
}

class AssemblyWalk {
public:
    AssemblyWalk(const TDocStd_Document& document, const std::string& path, const std::string& fallbackName)
        : m_shapes(XCAFDoc_DocumentTool::ShapeTool(document.Main()))
        , m_colorTool(XCAFDoc_DocumentTool::ColorTool(document.Main()))
        , m_layerTool(XCAFDoc_DocumentTool::LayerTool(document.Main()))
        , m_path(path)
        , m_fallbackName(fallbackName)
    {
    }

    CadAssembly run()
    {
        TDF_LabelSequence roots;
        m_shapes->GetFreeShapes(roots);
        checkSize(roots);
        for (const TDF_Label& root : roots)
            m_result.roots.push_back(node(root, root, TopLoc_Location(), fileAsParent()));
        return std::move(m_result);
    }

private:
    /// Counts instances without visiting them: 24 levels of two are 16 million parts in 40 kB.
    int countParts(const TDF_Label& product, int depth)
    {
        if (depth > deepestAssembly)
            failReading(m_path,
                        Message("Import", "the assembly is nested more than %1 levels deep; export a part of it.")
                            .with(deepestAssembly));
        if (const int* known = m_partCounts.Seek(product))
            return *known;
        int count = 0;
        if (XCAFDoc_ShapeTool::IsAssembly(product)) {
            for (const TDF_Label& component : componentsOf(product))
                count = std::min(count + countParts(referredBy(component), depth + 1), 2 * mostParts);
        } else {
            count = 1;
        }
        m_partCounts.Bind(product, count);
        return count;
    }

    void checkSize(const TDF_LabelSequence& roots)
    {
        int count = 0;
        for (const TDF_Label& root : roots)
            count = std::min(count + countParts(referredBy(root), 0), 2 * mostParts);
        if (count > mostParts)
            failReading(
                m_path,
                Message("Import", "the assembly has more than %1 parts; export the parts you need.").with(mostParts));
    }

    CadNode fileAsParent() const
    {
        CadNode parent;
        parent.name = m_fallbackName;
        return parent;
    }

    /// A label is hidden by itself, or when all layers that it is on are.
    ShapeDisplay displayOf(const TDF_Label& label) const
    {
        ShapeDisplay display{m_colorTool->IsVisible(label), {}};
        TDF_LabelSequence layers;
        m_layerTool->GetLayers(label, layers);
        bool anyShown = layers.IsEmpty();
        for (const TDF_Label& layer : layers) {
            anyShown = anyShown || m_layerTool->IsVisible(layer);
            const std::string name = layerName(layer);
            if (!name.empty())
                display.layer += (display.layer.empty() ? "" : ", ") + name;
        }
        display.visible = display.visible && anyShown;
        return display;
    }

    std::string layerName(const TDF_Label& label) const
    {
        TCollection_ExtendedString name;
        return m_layerTool->GetLayer(label, name) ? readable(name) : std::string();
    }

    void takeDisplay(const TDF_Label& instance, const TDF_Label& product, const CadNode& parent, CadNode& result) const
    {
        const ShapeDisplay own = displayOf(instance);
        const ShapeDisplay ofProduct = displayOf(product);
        result.visible = parent.visible && own.visible && ofProduct.visible;
        result.layer = !own.layer.empty() ? own.layer : !ofProduct.layer.empty() ? ofProduct.layer : parent.layer;
    }

    CadNode node(const TDF_Label& instance, const TDF_Label& product, const TopLoc_Location& placement,
                 const CadNode& parent)
    {
        CadNode result;
        takeNames(instance == product ? std::string() : nameOf(instance).name, nameOf(product), parent.name, result);
        result.color = colorOf(m_colorTool, instance);
        if (!result.color)
            result.color = colorOf(m_colorTool, product);
        if (!result.color)
            result.color = parent.color;
        takeDisplay(instance, product, parent, result);
        if (XCAFDoc_ShapeTool::IsAssembly(product)) {
            for (const TDF_Label& component : componentsOf(product))
                result.children.push_back(node(component, referredBy(component),
                                               placement * XCAFDoc_ShapeTool::GetLocation(component), result));
            return withoutSecondSelf(std::move(result));
        }
        rememberSubShapes(product);
        const TopoDS_Shape shape = XCAFDoc_ShapeTool::GetShape(product);
        if (!shape.IsNull())
            result.shape = std::make_shared<const TopoDS_Shape>(shape.Moved(placement));
        return result;
    }

    void rememberSubShapes(const TDF_Label& product)
    {
        TDF_LabelSequence parts;
        XCAFDoc_ShapeTool::GetSubShapes(product, parts);
        for (const TDF_Label& part : parts) {
            const TopoDS_Shape shape = XCAFDoc_ShapeTool::GetShape(part);
            if (const auto color = colorOf(m_colorTool, part))
                m_result.colors.set(shape, *color);
            if (const ShapeDisplay display = displayOf(part); !display.visible || !display.layer.empty())
                m_result.displays.set(shape, display);
        }
    }

    Handle(XCAFDoc_ShapeTool) m_shapes;
    Handle(XCAFDoc_ColorTool) m_colorTool;
    Handle(XCAFDoc_LayerTool) m_layerTool;
    const std::string& m_path;
    const std::string& m_fallbackName;
    TDF_LabelIntegerMap m_partCounts; // per product; instances share it
    CadAssembly m_result;
};

} // namespace

CadAssembly readAssembly(const TDocStd_Document& document, const std::string& path, const std::string& fallbackName)
{
    return AssemblyWalk(document, path, fallbackName).run();
}

} // namespace knead
