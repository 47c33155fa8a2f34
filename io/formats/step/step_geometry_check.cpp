#include "io/formats/step/step_geometry_check.h"

#include <Interface_InterfaceModel.hxx>
#include <STEPControl_Reader.hxx>
#include <StepGeom_Axis1Placement.hxx>
#include <StepGeom_Axis2Placement2d.hxx>
#include <StepGeom_Axis2Placement3d.hxx>
#include <StepGeom_BSplineCurve.hxx>
#include <StepGeom_BSplineSurface.hxx>
#include <StepGeom_CartesianPoint.hxx>
#include <StepGeom_CompositeCurve.hxx>
#include <StepGeom_CompositeCurveSegment.hxx>
#include <StepGeom_Conic.hxx>
#include <StepGeom_Curve.hxx>
#include <StepGeom_CurveReplica.hxx>
#include <StepGeom_Direction.hxx>
#include <StepGeom_ElementarySurface.hxx>
#include <StepGeom_HArray1OfCartesianPoint.hxx>
#include <StepGeom_HArray1OfCompositeCurveSegment.hxx>
#include <StepGeom_HArray2OfCartesianPoint.hxx>
#include <StepGeom_Line.hxx>
#include <StepGeom_OffsetCurve3d.hxx>
#include <StepGeom_OffsetSurface.hxx>
#include <StepGeom_Pcurve.hxx>
#include <StepGeom_Polyline.hxx>
#include <StepGeom_RectangularTrimmedSurface.hxx>
#include <StepGeom_SurfaceCurve.hxx>
#include <StepGeom_SurfaceOfLinearExtrusion.hxx>
#include <StepGeom_SurfaceOfRevolution.hxx>
#include <StepGeom_TrimmedCurve.hxx>
#include <StepGeom_Vector.hxx>
#include <StepRepr_DefinitionalRepresentation.hxx>
#include <StepRepr_HArray1OfRepresentationItem.hxx>
#include <StepRepr_ItemDefinedTransformation.hxx>
#include <StepRepr_MappedItem.hxx>
#include <StepRepr_ProductDefinitionShape.hxx>
#include <StepRepr_PropertyDefinition.hxx>
#include <StepRepr_Representation.hxx>
#include <StepRepr_RepresentationItem.hxx>
#include <StepRepr_RepresentationMap.hxx>
#include <StepRepr_RepresentedDefinition.hxx>
#include <StepRepr_ShapeRepresentationRelationship.hxx>
#include <StepShape_BrepWithVoids.hxx>
#include <StepShape_ClosedShell.hxx>
#include <StepShape_ConnectedFaceSet.hxx>
#include <StepShape_ContextDependentShapeRepresentation.hxx>
#include <StepShape_EdgeCurve.hxx>
#include <StepShape_EdgeLoop.hxx>
#include <StepShape_FaceBound.hxx>
#include <StepShape_FaceSurface.hxx>
#include <StepShape_HArray1OfFaceBound.hxx>
#include <StepShape_HArray1OfOrientedClosedShell.hxx>
#include <StepShape_HArray1OfOrientedEdge.hxx>
#include <StepShape_Loop.hxx>
#include <StepShape_OrientedClosedShell.hxx>
#include <StepShape_OrientedEdge.hxx>
#include <StepShape_OrientedFace.hxx>
#include <StepShape_PolyLoop.hxx>
#include <StepShape_ShapeDefinitionRepresentation.hxx>
#include <StepShape_Vertex.hxx>
#include <StepShape_VertexPoint.hxx>

#include <algorithm>
#include <functional>
#include <unordered_map>
#include <vector>

namespace knead {

namespace {

constexpr int deepestChain = 100; // honest files stay under 4

/// Whether a kind of entity lacks what the CAD reader takes for granted.
struct Rule {
    Handle(Standard_Type) kind;
    std::function<bool(const Standard_Transient&)> isHollow;
};

template <typename Entity, typename Test>
Rule rule(Test test)
{
    return {STANDARD_TYPE(Entity),
            [test](const Standard_Transient& entity) { return test(static_cast<const Entity&>(entity)); }};
}

/// A list that is missing, or has a member that is.
template <typename List>
bool hasGap(const List& list)
{
    if (list.IsNull())
        return true;
    for (int i = list->Lower(); i <= list->Upper(); ++i)
        if (list->Value(i).IsNull())
            return true;
    return false;
}

/// What a curve is made of, where that is one other curve.
Handle(StepGeom_Curve) basisOf(const Handle(StepGeom_Curve) & curve)
{
    if (const auto trimmed = Handle(StepGeom_TrimmedCurve)::DownCast(curve); !trimmed.IsNull())
        return trimmed->BasisCurve();
    if (const auto onSurface = Handle(StepGeom_SurfaceCurve)::DownCast(curve); !onSurface.IsNull())
        return onSurface->Curve3d();
    if (const auto replica = Handle(StepGeom_CurveReplica)::DownCast(curve); !replica.IsNull())
        return replica->ParentCurve();
    if (const auto offset = Handle(StepGeom_OffsetCurve3d)::DownCast(curve); !offset.IsNull())
        return offset->BasisCurve();
    return {};
}

/// A curve that is made of itself, or of so many that the reader, which recurses once for each, runs out of stack.
bool isEndless(Handle(StepGeom_Curve) curve)
{
    for (int depth = 0; !curve.IsNull(); ++depth, curve = basisOf(curve))
        if (depth > deepestChain)
            return true;
    return false;
}

bool hasGapInGrid(const Handle(StepGeom_HArray2OfCartesianPoint) & grid)
{
    if (grid.IsNull())
        return true;
    for (int row = grid->LowerRow(); row <= grid->UpperRow(); ++row)
        for (int column = grid->LowerCol(); column <= grid->UpperCol(); ++column)
            if (grid->Value(row, column).IsNull())
                return true;
    return false;
}

std::vector<Rule> rulesForGeometry()
{
    return {
        rule<StepGeom_Direction>([](const auto& e) { return e.DirectionRatios().IsNull(); }),
        rule<StepGeom_Placement>([](const auto& e) { return e.Location().IsNull(); }),
        rule<StepGeom_Line>([](const auto& e) {
            // The reader looks at the point first, and gets over one without coordinates.
            return e.Pnt().IsNull() || e.Dir().IsNull() ||
                   (e.Dir()->Orientation().IsNull() && e.Pnt()->NbCoordinates() > 0);
        }),
        rule<StepGeom_Conic>([](const auto& e) { return e.Position().IsNull(); }),
        rule<StepGeom_Polyline>([](const auto& e) { return hasGap(e.Points()); }),
        rule<StepGeom_BSplineCurve>([](const auto& e) { return hasGap(e.ControlPointsList()); }),
        rule<StepGeom_TrimmedCurve>([](const auto& e) {
            return isEndless(e.BasisCurve()) || e.BasisCurve().IsNull() || e.Trim1().IsNull() || e.Trim2().IsNull();
        }),
        rule<StepGeom_CurveReplica>(
            [](const auto& e) { return e.ParentCurve().IsNull() || isEndless(e.ParentCurve()); }),
        rule<StepGeom_OffsetCurve3d>(
            [](const auto& e) { return e.BasisCurve().IsNull() || isEndless(e.BasisCurve()); }),
        rule<StepGeom_CompositeCurve>([](const auto& e) { return hasGap(e.Segments()); }),
        rule<StepGeom_CompositeCurveSegment>([](const auto& e) { return e.ParentCurve().IsNull(); }),
        rule<StepGeom_SurfaceCurve>([](const auto& e) { return e.Curve3d().IsNull() || isEndless(e.Curve3d()); }),
        rule<StepGeom_Pcurve>([](const auto& e) {
            return e.ReferenceToCurve().IsNull() || hasGap(e.ReferenceToCurve()->Items()) ||
                   e.ReferenceToCurve()->NbItems() == 0;
        }),
        rule<StepGeom_ElementarySurface>([](const auto& e) { return e.Position().IsNull(); }),
        rule<StepGeom_BSplineSurface>([](const auto& e) { return hasGapInGrid(e.ControlPointsList()); }),
        rule<StepGeom_SurfaceOfRevolution>(
            [](const auto& e) { return e.SweptCurve().IsNull() || e.AxisPosition().IsNull(); }),
        rule<StepGeom_SurfaceOfLinearExtrusion>([](const auto& e) {
            return e.SweptCurve().IsNull() || e.ExtrusionAxis().IsNull() || e.ExtrusionAxis()->Orientation().IsNull();
        }),
        rule<StepGeom_OffsetSurface>([](const auto& e) { return e.BasisSurface().IsNull(); }),
        rule<StepGeom_RectangularTrimmedSurface>([](const auto& e) { return e.BasisSurface().IsNull(); }),
    };
}

/// Not of shells: the reader gets over faces that they lack, and the losses are told.
std::vector<Rule> rulesForTopology()
{
    return {
        rule<StepShape_VertexPoint>([](const auto& e) { return e.VertexGeometry().IsNull(); }),
        rule<StepShape_EdgeCurve>(
            [](const auto& e) { return e.EdgeStart().IsNull() || e.EdgeEnd().IsNull() || e.EdgeGeometry().IsNull(); }),
        rule<StepShape_OrientedEdge>([](const auto& e) { return e.EdgeElement().IsNull(); }),
        rule<StepShape_EdgeLoop>([](const auto& e) { return hasGap(e.EdgeList()); }),
        rule<StepShape_PolyLoop>([](const auto& e) { return hasGap(e.Polygon()); }),
        rule<StepShape_FaceBound>([](const auto& e) { return e.Bound().IsNull(); }),
        rule<StepShape_FaceSurface>([](const auto& e) { return hasGap(e.Bounds()); }),
        rule<StepShape_OrientedFace>([](const auto& e) { return e.FaceElement().IsNull(); }),
        rule<StepShape_OrientedClosedShell>([](const auto& e) { return e.ClosedShellElement().IsNull(); }),
        rule<StepShape_BrepWithVoids>([](const auto& e) { return hasGap(e.Voids()); }),
        rule<StepRepr_MappedItem>([](const auto& e) { return e.MappingSource().IsNull(); }),
        rule<StepRepr_RepresentationMap>(
            [](const auto& e) { return e.MappingOrigin().IsNull() || e.MappedRepresentation().IsNull(); }),
        rule<StepShape_ContextDependentShapeRepresentation>([](const auto& e) {
            return e.RepresentationRelation().IsNull() || e.RepresentedProductRelation().IsNull();
        }),
        rule<StepShape_ShapeDefinitionRepresentation>([](const auto& e) {
            return e.Definition().PropertyDefinition().IsNull() || e.UsedRepresentation().IsNull();
        }),
        rule<StepRepr_ItemDefinedTransformation>(
            [](const auto& e) { return e.TransformItem1().IsNull() || e.TransformItem2().IsNull(); }),
    };
}

/// Members of another type than they should have are left out when the file is loaded.
class HollowSearch {
public:
    HollowSearch()
        : m_rules(rulesForGeometry())
    {
        const std::vector<Rule> more = rulesForTopology();
        m_rules.insert(m_rules.end(), more.begin(), more.end());
    }

    bool isHollow(const Standard_Transient& entity)
    {
        const std::vector<const Rule*>& rules = rulesFor(entity.DynamicType());
        return std::any_of(rules.begin(), rules.end(), [&](const Rule* one) { return one->isHollow(entity); });
    }

private:
    /// Found once for each type: asking every entity for every kind would take longer than reading.
    const std::vector<const Rule*>& rulesFor(const Handle(Standard_Type) & type)
    {
        const auto [known, isNew] = m_rulesOfType.try_emplace(type.get());
        if (isNew)
            for (const Rule& one : m_rules)
                if (type->SubType(one.kind))
                    known->second.push_back(&one);
        return known->second;
    }

    std::vector<Rule> m_rules;
    std::unordered_map<const Standard_Type*, std::vector<const Rule*>> m_rulesOfType;
};

} // namespace

std::vector<Handle(Standard_Transient)> hollowEntities(const STEPControl_Reader& reader)
{
    const Handle(Interface_InterfaceModel) model = reader.Model();
    HollowSearch search;
    std::vector<Handle(Standard_Transient)> result;
    for (int i = 1; i <= model->NbEntities(); ++i)
        if (search.isHollow(*model->Value(i)))
            result.push_back(model->Value(i));
    return result;
}

} // namespace knead
