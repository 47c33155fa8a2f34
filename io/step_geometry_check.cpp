#include "io/step_geometry_check.h"

#include <Interface_InterfaceModel.hxx>
#include <STEPControl_Reader.hxx>
#include <StepGeom_Axis1Placement.hxx>
#include <StepGeom_Axis2Placement2d.hxx>
#include <StepGeom_Axis2Placement3d.hxx>
#include <StepGeom_CartesianPoint.hxx>
#include <StepGeom_Conic.hxx>
#include <StepGeom_Curve.hxx>
#include <StepGeom_Direction.hxx>
#include <StepGeom_ElementarySurface.hxx>
#include <StepGeom_Line.hxx>
#include <StepGeom_SurfaceOfLinearExtrusion.hxx>
#include <StepGeom_SurfaceOfRevolution.hxx>
#include <StepGeom_Vector.hxx>
#include <TCollection_HAsciiString.hxx>

namespace knead {

namespace {

/// Members of another type than they should have are left out when the file is loaded.
bool isHollow(const Handle(Standard_Transient) & entity)
{
    if (const auto line = Handle(StepGeom_Line)::DownCast(entity); !line.IsNull())
        return line->Pnt().IsNull() || line->Dir().IsNull();
    if (const auto conic = Handle(StepGeom_Conic)::DownCast(entity); !conic.IsNull())
        return conic->Position().IsNull();
    if (const auto placement = Handle(StepGeom_Placement)::DownCast(entity); !placement.IsNull())
        return placement->Location().IsNull();
    if (const auto surface = Handle(StepGeom_ElementarySurface)::DownCast(entity); !surface.IsNull())
        return surface->Position().IsNull();
    if (const auto swept = Handle(StepGeom_SurfaceOfRevolution)::DownCast(entity); !swept.IsNull())
        return swept->SweptCurve().IsNull() || swept->AxisPosition().IsNull();
    if (const auto swept = Handle(StepGeom_SurfaceOfLinearExtrusion)::DownCast(entity); !swept.IsNull())
        return swept->SweptCurve().IsNull() || swept->ExtrusionAxis().IsNull();
    return false;
}

} // namespace

std::optional<std::string> hollowEntity(const STEPControl_Reader& reader)
{
    const Handle(Interface_InterfaceModel) model = reader.Model();
    for (int i = 1; i <= model->NbEntities(); ++i)
        if (isHollow(model->Value(i)))
            return std::string(model->StringLabel(model->Value(i))->ToCString());
    return std::nullopt;
}

} // namespace knead
