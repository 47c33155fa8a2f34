#include "io/step_names.h"

#include <Interface_InterfaceModel.hxx>
#include <STEPControl_Reader.hxx>
#include <StepRepr_NextAssemblyUsageOccurrence.hxx>
#include <TCollection_HAsciiString.hxx>

#include <string_view>

namespace knead {

namespace {

constexpr std::string_view mark = "~|~"; // nobody ends a name like that

} // namespace

void markForeignNames(const STEPControl_Reader& reader)
{
    const Handle(Interface_InterfaceModel) model = reader.Model();
    for (int i = 1; !model.IsNull() && i <= model->NbEntities(); ++i) {
        const auto instance = Handle(StepRepr_NextAssemblyUsageOccurrence)::DownCast(model->Value(i));
        if (instance.IsNull() || instance->Name().IsNull() || instance->Name()->Length() == 0 ||
            instance->Name()->UsefullLength() > 0)
            continue;
        const std::string name = instance->Name()->ToCString() + std::string(mark);
        instance->SetName(new TCollection_HAsciiString(name.c_str()));
    }
}

std::string withoutNameMark(std::string name)
{
    if (name.ends_with(mark))
        name.resize(name.size() - mark.size());
    return name;
}

} // namespace knead
