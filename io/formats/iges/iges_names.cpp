#include "io/formats/iges/iges_names.h"

#include "core/model/readable_name.h"

#include <IGESBasic_Name.hxx>
#include <IGESCAFControl_Reader.hxx>
#include <IGESData_IGESEntity.hxx>
#include <IGESData_IGESModel.hxx>
#include <TCollection_HAsciiString.hxx>
#include <TopoDS_Shape.hxx>
#include <TransferBRep.hxx>
#include <Transfer_TransientProcess.hxx>
#include <XSControl_TransferReader.hxx>
#include <XSControl_WorkSession.hxx>

#include <string_view>

namespace knead {

ShapeNotes<std::string> namesOfIgesSolids(const IGESCAFControl_Reader& reader)
{
    ShapeNotes<std::string> names;
    const Handle(Transfer_TransientProcess)& process = reader.WS()->TransferReader()->TransientProcess();
    const Handle(Interface_InterfaceModel) model = reader.Model();
    for (int i = 1; i <= model->NbEntities(); ++i) {
        const auto entity = Handle(IGESData_IGESEntity)::DownCast(model->Value(i));
        if (entity.IsNull() || entity->NbTypedProperties(STANDARD_TYPE(IGESBasic_Name)) == 0)
            continue;
        const TopoDS_Shape shape = TransferBRep::ShapeResult(process, entity);
        const auto property = Handle(IGESBasic_Name)::DownCast(entity->TypedProperty(STANDARD_TYPE(IGESBasic_Name), 1));
        if (shape.IsNull() || shape.ShapeType() != TopAbs_SOLID || property->Value().IsNull())
            continue;
        if (const std::string name = readableName(std::string_view(property->Value()->ToCString())); !name.empty())
            names.set(shape, name);
    }
    return names;
}

} // namespace knead
