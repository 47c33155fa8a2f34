#include "io/step_lost_faces.h"

#include "io/number_words.h"

#include <Interface_InterfaceModel.hxx>
#include <STEPControl_Reader.hxx>
#include <StepShape_ConnectedFaceSet.hxx>
#include <StepShape_OrientedClosedShell.hxx>
#include <StepShape_OrientedOpenShell.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS_Shape.hxx>
#include <TransferBRep.hxx>
#include <Transfer_TransientProcess.hxx>
#include <XSControl_TransferReader.hxx>
#include <XSControl_WorkSession.hxx>

#include <cstddef>
#include <memory>

namespace knead {

namespace {

/// A shell as the file lists it; one that only turns another one has no faces of its own.
Handle(StepShape_ConnectedFaceSet) shellAt(const Interface_InterfaceModel& model, int place)
{
    const Handle(Standard_Transient) entity = model.Value(place);
    if (entity->IsKind(STANDARD_TYPE(StepShape_OrientedClosedShell)) ||
        entity->IsKind(STANDARD_TYPE(StepShape_OrientedOpenShell)))
        return {};
    return Handle(StepShape_ConnectedFaceSet)::DownCast(entity);
}

} // namespace

StepLosses findLosses(const STEPControl_Reader& reader)
{
    StepLosses losses;
    const Handle(Interface_InterfaceModel) model = reader.Model();
    const Handle(Transfer_TransientProcess) process = reader.WS()->TransferReader()->TransientProcess();
    std::size_t lostShells = 0;
    for (int i = 1; i <= model->NbEntities(); ++i) {
        const Handle(StepShape_ConnectedFaceSet) shell = shellAt(*model, i);
        if (shell.IsNull() || shell->CfsFaces().IsNull())
            continue;
        const TopoDS_Shape shape = TransferBRep::ShapeResult(process, shell);
        TopTools_IndexedMapOfShape faces;
        if (!shape.IsNull())
            TopExp::MapShapes(shape, TopAbs_FACE, faces);
        if (faces.IsEmpty())
            ++lostShells;
        else if (faces.Extent() < shell->NbCfsFaces())
            losses.incomplete.push_back(
                {std::make_shared<const TopoDS_Shape>(shape), faces.Extent(), shell->NbCfsFaces()});
    }
    if (lostShells > 0)
        losses.missing.push_back(countOf(lostShells, "shell") + " of the STEP file could not be read: the faces of " +
                                 (lostShells == 1 ? "it" : "them") + " are damaged or of an unknown kind.");
    return losses;
}

} // namespace knead
