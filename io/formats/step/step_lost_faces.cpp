#include "io/formats/step/step_lost_faces.h"

#include "core/message/message.h"
#include "io/brep/shape_measure.h"

#include <Interface_EntityIterator.hxx>
#include <Interface_Graph.hxx>
#include <Interface_InterfaceModel.hxx>
#include <STEPControl_Reader.hxx>
#include <StepShape_ConnectedFaceSet.hxx>
#include <StepShape_ManifoldSolidBrep.hxx>
#include <StepShape_OrientedClosedShell.hxx>
#include <StepShape_OrientedOpenShell.hxx>
#include <StepShape_ShellBasedSurfaceModel.hxx>
#include <TopoDS_Shape.hxx>
#include <TransferBRep.hxx>
#include <Transfer_TransientProcess.hxx>
#include <XSControl_TransferReader.hxx>
#include <XSControl_WorkSession.hxx>

#include <cstddef>
#include <memory>

namespace knead {

namespace {

/// Of a shell as the file lists it. One that only turns another one has none of its own.
int countNamedFaces(const Handle(Standard_Transient) & entity)
{
    if (entity->IsKind(STANDARD_TYPE(StepShape_OrientedClosedShell)) ||
        entity->IsKind(STANDARD_TYPE(StepShape_OrientedOpenShell)))
        return 0;
    const auto shell = Handle(StepShape_ConnectedFaceSet)::DownCast(entity);
    return shell.IsNull() || shell->CfsFaces().IsNull() ? 0 : shell->NbCfsFaces();
}

bool isSolidOrSurface(const Handle(Standard_Transient) & entity)
{
    return entity->IsKind(STANDARD_TYPE(StepShape_ManifoldSolidBrep)) ||
           entity->IsKind(STANDARD_TYPE(StepShape_ShellBasedSurfaceModel));
}

} // namespace

StepLosses findLosses(const STEPControl_Reader& reader, const StepPruning& pruned)
{
    StepLosses losses;
    const Handle(Interface_InterfaceModel) model = reader.Model();
    const Handle(Transfer_TransientProcess) process = reader.WS()->TransferReader()->TransientProcess();
    std::size_t lostShapes = 0;
    for (int i = 1; i <= model->NbEntities(); ++i) {
        const Handle(Standard_Transient) entity = model->Value(i);
        const auto lost = pruned.lostFaces.find(entity.get());
        const int named = countNamedFaces(entity) + (lost == pruned.lostFaces.end() ? 0 : lost->second);
        if (named == 0 && !isSolidOrSurface(entity))
            continue;
        const TopoDS_Shape shape = TransferBRep::ShapeResult(process, entity);
        const int read = shape.IsNull() ? 0 : countDistinct(shape, TopAbs_FACE);
        // The shell of a void has no shape of its own, and what nothing refers to is not part of the file's shapes.
        if (read == 0 && isSolidOrSurface(entity) && !reader.WS()->Graph().Sharings(entity).More())
            continue;
        if (read == 0)
            lostShapes += isSolidOrSurface(entity) ? 1 : 0;
        else if (read < named)
            losses.incomplete.push_back({std::make_shared<const TopoDS_Shape>(shape), read, named});
    }
    if (lostShapes > 0)
        losses.missing.push_back(
            lostShapes == 1
                ? Message("Step",
                          "1 shape of the STEP file could not be read: its faces are damaged or of an unknown kind.")
                : Message("Step",
                          "%1 shapes of the STEP file could not be read: its faces are damaged or of an unknown kind.")
                      .with(lostShapes));
    return losses;
}

} // namespace knead
