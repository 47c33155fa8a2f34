#include "io/document/document_of_parts.h"

#include "io/formats/step/step_names.h"

#include <BRepBuilderAPI_Transform.hxx>
#include <BRep_Builder.hxx>
#include <Quantity_Color.hxx>
#include <TCollection_ExtendedString.hxx>
#include <TDataStd_Name.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopLoc_Location.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS_Compound.hxx>
#include <XCAFDoc_ColorTool.hxx>
#include <XCAFDoc_DocumentTool.hxx>
#include <XCAFDoc_LayerTool.hxx>
#include <XCAFDoc_ShapeTool.hxx>

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <utility>

namespace knead {

namespace {

using PartsToWrite = std::vector<const CadPartToWrite*>;

Quantity_Color quantity(const Color& color)
{
    return {static_cast<double>(color.r), static_cast<double>(color.g), static_cast<double>(color.b),
            Quantity_TOC_sRGB};
}

TCollection_ExtendedString extended(const std::string& text)
{
    return {text.c_str(), true};
}

/// A part by itself has no instance that could say where it is.
TopoDS_Shape atItsPlace(const TopoDS_Shape& shape)
{
    if (shape.Location().IsIdentity())
        return shape;
    return BRepBuilderAPI_Transform(shape.Located(TopLoc_Location()), shape.Location().Transformation(), true).Shape();
}

/// What several instances may share: the same shapes in the same place within the product, which look alike.
bool isSameProduct(const PartsToWrite& a, const PartsToWrite& b)
{
    const auto within = [](const PartsToWrite& product, const CadPartToWrite& part) {
        return product.front()->shape.Location().Inverted() * part.shape.Location();
    };
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), [&](const CadPartToWrite* x, const CadPartToWrite* y) {
        return x->shape.TShape() == y->shape.TShape() && x->shape.Orientation() == y->shape.Orientation() &&
               within(a, *x) == within(b, *y) && x->color == y->color && x->faces == y->faces && x->layer == y->layer &&
               x->visible == y->visible;
    });
}

class DocumentMaker {
public:
    DocumentMaker(const std::vector<CadPartToWrite>& parts, bool isStep, const Handle(TDocStd_Document) & document)
        : m_parts(parts)
        , m_isStep(isStep)
        , m_shapes(XCAFDoc_DocumentTool::ShapeTool(document->Main()))
        , m_colors(XCAFDoc_DocumentTool::ColorTool(document->Main()))
        , m_layers(XCAFDoc_DocumentTool::LayerTool(document->Main()))
    {
        m_shapes->SetAutoNaming(false);
    }

    NamedShapes add(const PartNode& tree)
    {
        for (const PartNode& child : tree.children)
            if (const PartsToWrite product = partsOfProduct(child); !product.empty())
                addProduct(child, product, TopLoc_Location(), child.name);
            else
                addAssembly(child);
        if (tree.part)
            addProduct(tree, {&m_parts[*tree.part]}, TopLoc_Location(), m_parts[*tree.part].name);
        m_shapes->UpdateAssemblies();
        return std::move(m_names);
    }

private:
    /// The part of a leaf, or the bodies of a product where that can be written and read back as it is: loose surfaces would change
    /// places with solids, nothing of OpenCASCADE's writers hides bodies or names them in IGES, and a single one would be named as its
    /// product. Empty for an assembly.
    PartsToWrite partsOfProduct(const PartNode& node) const
    {
        if (node.part)
            return {&m_parts[*node.part]};
        if (!m_isStep || !node.holdsBodies || node.children.size() < 2)
            return {};
        PartsToWrite bodies;
        for (const PartNode& child : node.children) {
            if (!child.part || !child.children.empty())
                return {};
            const CadPartToWrite& part = m_parts[*child.part];
            const bool isLayered = !part.layer.empty() && part.shape.ShapeType() != TopAbs_SOLID;
            if (!part.visible || isLayered || !consistsOfSolids(part.shape))
                return {};
            bodies.push_back(&m_parts[*child.part]);
        }
        return bodies;
    }

    static bool consistsOfSolids(const TopoDS_Shape& shape)
    {
        return TopExp_Explorer(shape, TopAbs_SOLID).More() &&
               !TopExp_Explorer(shape, TopAbs_SHELL, TopAbs_SOLID).More() &&
               !TopExp_Explorer(shape, TopAbs_FACE, TopAbs_SHELL).More();
    }

    TDF_Label addAssembly(const PartNode& node)
    {
        const TDF_Label assembly = m_shapes->NewShape();
        TDataStd_Name::Set(assembly, extended(productName(node, node.name)));
        for (const PartNode& child : node.children) {
            const PartsToWrite product = partsOfProduct(child);
            const TDF_Label component = product.empty()
                                            ? m_shapes->AddComponent(assembly, addAssembly(child), TopLoc_Location())
                                            : addInstance(assembly, child, product);
            TDataStd_Name::Set(component, extended(child.name));
        }
        return assembly;
    }

    TDF_Label addInstance(const TDF_Label& assembly, const PartNode& node, const PartsToWrite& parts)
    {
        const TDF_Label component =
            m_shapes->AddComponent(assembly, productOf(node, parts), parts.front()->shape.Location());
        m_colors->SetVisibility(component, parts.size() > 1 || parts.front()->visible);
        return component;
    }

    TDF_Label productOf(const PartNode& node, const PartsToWrite& parts)
    {
        std::vector<std::pair<PartsToWrite, TDF_Label>>& products = m_products[parts.front()->shape.TShape().get()];
        for (const auto& [others, label] : products)
            if (isSameProduct(parts, others))
                return label;
        const TDF_Label label = addProduct(node, parts, parts.front()->shape.Location(), node.name);
        products.emplace_back(parts, label);
        return label;
    }

    /// @param place of the instance: what of the places of the shapes is not the product's own
    /// @param name of the instance
    TDF_Label addProduct(const PartNode& node, const PartsToWrite& parts, const TopLoc_Location& place,
                         const std::string& name)
    {
        std::vector<TopoDS_Shape> shapes;
        for (const CadPartToWrite* part : parts)
            shapes.push_back(atItsPlace(part->shape.Located(place.Inverted() * part->shape.Location())));
        TopoDS_Shape whole = shapes.front();
        if (parts.size() > 1) {
            TopoDS_Compound bodies;
            const BRep_Builder builder;
            builder.MakeCompound(bodies);
            for (const TopoDS_Shape& shape : shapes)
                builder.Add(bodies, shape);
            whole = bodies;
        }
        const TDF_Label label = m_shapes->AddShape(whole, false);
        TDataStd_Name::Set(label, extended(productName(node, name)));
        for (std::size_t i = 0; i < parts.size(); ++i) {
            m_names.emplace_back(shapes[i], parts[i]->name);
            dress(parts.size() == 1 ? label : m_shapes->AddSubShape(label, shapes[i]), label, *parts[i], shapes[i]);
        }
        return label;
    }

    /// @param label of the product or of one of its bodies
    void dress(const TDF_Label& label, const TDF_Label& product, const CadPartToWrite& part, const TopoDS_Shape& shape)
    {
        // The writer of OpenCASCADE 7.6 crashes on what is hidden and has no color.
        if (part.color || !part.visible)
            m_colors->SetColor(label, quantity(part.color.value_or(Color{})), XCAFDoc_ColorGen);
        m_colors->SetVisibility(label, part.visible);
        if (!part.layer.empty())
            m_layers->SetLayer(label, extended(part.layer));
        TopTools_IndexedMapOfShape faces;
        TopExp::MapShapes(shape, TopAbs_FACE, faces);
        const auto count = std::min(part.faces.size(), static_cast<std::size_t>(faces.Extent()));
        for (std::size_t i = 0; i < count; ++i) {
            const TopoDS_Shape& face = faces(static_cast<int>(i) + 1);
            if (part.faces[i].color)
                m_colors->SetColor(m_shapes->AddSubShape(product, face), quantity(*part.faces[i].color),
                                   XCAFDoc_ColorSurf);
            if (!part.faces[i].name.empty())
                m_names.emplace_back(face, part.faces[i].name);
        }
    }

    /// Programs take two products of one name for one. A bent instance is no longer what its product is: it goes by its own
    /// name, or else by a number.
    std::string productName(const PartNode& node, const std::string& instance)
    {
        const std::string own = node.product.empty() ? instance : node.product;
        std::string name = own;
        const bool isFirst = m_productNames.insert(name).second;
        if (!isFirst && !m_productNames.insert(name = instance).second)
            for (int number = 2; !m_productNames.insert(name = own + " (" + std::to_string(number) + ")").second;)
                ++number;
        return isFirst && m_isStep ? withPartNumber(name, node.partNumber) : name;
    }

    const std::vector<CadPartToWrite>& m_parts;
    bool m_isStep;
    Handle(XCAFDoc_ShapeTool) m_shapes;
    Handle(XCAFDoc_ColorTool) m_colors;
    Handle(XCAFDoc_LayerTool) m_layers;
    std::map<const void*, std::vector<std::pair<PartsToWrite, TDF_Label>>> m_products; // by geometry
    std::set<std::string> m_productNames;
    NamedShapes m_names;
};

} // namespace

NamedShapes fillDocument(const std::vector<CadPartToWrite>& parts, const PartNode& tree, bool isStep,
                         const Handle(TDocStd_Document) & document)
{
    return DocumentMaker(parts, isStep, document).add(tree);
}

} // namespace knead
