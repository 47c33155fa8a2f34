#include "io/formats/step/step_pruning.h"

#include "core/message/message.h"
#include "io/formats/cad_format.h"
#include "io/formats/step/step_geometry_check.h"

#include <Interface_EntityIterator.hxx>
#include <Interface_Graph.hxx>
#include <Interface_InterfaceModel.hxx>
#include <STEPControl_Reader.hxx>
#include <StepGeom_CartesianPoint.hxx>
#include <StepGeom_CompositeCurveSegment.hxx>
#include <StepRepr_HArray1OfRepresentationItem.hxx>
#include <StepRepr_ItemDefinedTransformation.hxx>
#include <StepRepr_Representation.hxx>
#include <StepRepr_RepresentationItem.hxx>
#include <StepRepr_RepresentationMap.hxx>
#include <StepShape_ConnectedFaceSet.hxx>
#include <StepShape_ContextDependentShapeRepresentation.hxx>
#include <StepShape_Face.hxx>
#include <StepShape_HArray1OfFace.hxx>
#include <StepShape_ShapeDefinitionRepresentation.hxx>
#include <StepShape_ShapeRepresentation.hxx>
#include <StepVisual_StyledItem.hxx>
#include <TCollection_HAsciiString.hxx>
#include <XSControl_WorkSession.hxx>

#include <unordered_set>

namespace knead {

namespace {

using StepEntity = Handle(Standard_Transient);

/// What places and joins shapes: without it nothing says where they are.
bool isStructure(const StepEntity& entity)
{
    return entity->IsKind(STANDARD_TYPE(StepRepr_ItemDefinedTransformation)) ||
           entity->IsKind(STANDARD_TYPE(StepRepr_RepresentationMap)) ||
           entity->IsKind(STANDARD_TYPE(StepShape_ContextDependentShapeRepresentation)) ||
           entity->IsKind(STANDARD_TYPE(StepShape_ShapeDefinitionRepresentation));
}

class Pruner {
public:
    Pruner(STEPControl_Reader& reader, const std::string& path)
        : m_model(reader.Model())
        , m_graph(reader.WS()->Graph())
        , m_path(path)
    {
    }

    StepPruning run(const std::vector<StepEntity>& hollow)
    {
        for (const StepEntity& entity : hollow)
            mark(entity);
        for (std::size_t next = 0; next < m_marked.size(); ++next) {
            const StepEntity entity = m_marked[next];
            for (Interface_EntityIterator users = m_graph.Sharings(entity); users.More(); users.Next())
                leave(entity, users.Value());
        }
        if (m_faces + m_shapes > 0)
            m_result.damage = sentence(hollow);
        return std::move(m_result);
    }

private:
    void mark(const StepEntity& entity)
    {
        if (isStructure(entity))
            failReading(
                m_path,
                Message("Step",
                        "the entity %1 refers to something of the wrong kind or nothing at all; export the file again.")
                    .with(labelOf(entity)));
        if (m_seen.insert(entity.get()).second)
            m_marked.push_back(entity);
    }

    /// Takes an entity out of what uses it, or marks that as well when it cannot do without.
    void leave(const StepEntity& entity, const StepEntity& user)
    {
        if (const auto shell = Handle(StepShape_ConnectedFaceSet)::DownCast(user);
            !shell.IsNull() && entity->IsKind(STANDARD_TYPE(StepShape_Face)))
            leaveShell(entity, shell);
        else if (const auto shapes = Handle(StepShape_ShapeRepresentation)::DownCast(user); !shapes.IsNull())
            leaveRepresentation(entity, *shapes);
        else if (isStructure(user) || user->IsKind(STANDARD_TYPE(StepRepr_Representation)) ||
                 user->IsKind(STANDARD_TYPE(StepGeom_CompositeCurveSegment)) ||
                 (user->IsKind(STANDARD_TYPE(StepRepr_RepresentationItem)) &&
                  !user->IsKind(STANDARD_TYPE(StepVisual_StyledItem))))
            mark(user);
    }

    void leaveShell(const StepEntity& face, const Handle(StepShape_ConnectedFaceSet) & shell)
    {
        std::vector<Handle(StepShape_Face)> left;
        for (int i = 1; i <= shell->NbCfsFaces(); ++i)
            if (const Handle(StepShape_Face) one = shell->CfsFacesValue(i); one != face)
                left.push_back(one);
        ++m_result.lostFaces[shell.get()];
        ++m_faces;
        if (left.empty()) {
            mark(shell);
            return;
        }
        const Handle(StepShape_HArray1OfFace) faces = new StepShape_HArray1OfFace(1, static_cast<int>(left.size()));
        for (std::size_t i = 0; i < left.size(); ++i)
            faces->SetValue(static_cast<int>(i) + 1, left[i]);
        shell->SetCfsFaces(faces);
    }

    void leaveRepresentation(const StepEntity& entity, StepShape_ShapeRepresentation& representation)
    {
        std::vector<Handle(StepRepr_RepresentationItem)> left;
        for (int i = 1; i <= representation.NbItems(); ++i)
            if (const Handle(StepRepr_RepresentationItem) one = representation.ItemsValue(i); one != entity)
                left.push_back(one);
        if (left.empty()) // the reader expects one
            left.emplace_back(new StepGeom_CartesianPoint);
        ++m_shapes;
        const Handle(StepRepr_HArray1OfRepresentationItem) items =
            new StepRepr_HArray1OfRepresentationItem(1, static_cast<int>(left.size()));
        for (std::size_t i = 0; i < left.size(); ++i)
            items->SetValue(static_cast<int>(i) + 1, left[i]);
        representation.SetItems(items);
    }

    std::string labelOf(const StepEntity& entity) const { return m_model->StringLabel(entity)->ToCString(); }

    Message sentence(const std::vector<StepEntity>& hollow) const
    {
        const std::size_t more = hollow.size() - 1;
        const std::string first = labelOf(hollow.front());
        if (more == 0 && m_faces > 0)
            return Message("Step", "the entity %1 refers to something of the wrong kind or nothing at all; what needs "
                                   "it could not be read (faces: %2).")
                .with(first, m_faces);
        if (more == 0)
            return Message("Step", "the entity %1 refers to something of the wrong kind or nothing at all; what needs "
                                   "it could not be read (shapes: %2).")
                .with(first, m_shapes);
        if (m_faces > 0)
            return Message("Step", "the entity %1 and %2 more refer to something of the wrong kind or nothing at all; "
                                   "what needs them could not be read (faces: %3).")
                .with(first, more, m_faces);
        return Message("Step", "the entity %1 and %2 more refer to something of the wrong kind or nothing at all; what "
                               "needs them could not be read (shapes: %3).")
            .with(first, more, m_shapes);
    }

    Handle(Interface_InterfaceModel) m_model;
    const Interface_Graph& m_graph;
    const std::string& m_path;
    std::unordered_set<const Standard_Transient*> m_seen;
    std::vector<StepEntity> m_marked;
    std::size_t m_faces = 0;
    std::size_t m_shapes = 0;
    StepPruning m_result;
};

} // namespace

StepPruning pruneHollowEntities(STEPControl_Reader& reader, const std::string& path)
{
    const std::vector<StepEntity> hollow = hollowEntities(reader);
    return hollow.empty() ? StepPruning{} : Pruner(reader, path).run(hollow);
}

} // namespace knead
