#include "io/formats/step/step_names.h"

#include "core/model/readable_name.h"

#include <Interface_InterfaceModel.hxx>
#include <STEPConstruct.hxx>
#include <STEPControl_Reader.hxx>
#include <STEPControl_Writer.hxx>
#include <StepBasic_Product.hxx>
#include <StepData_StepModel.hxx>
#include <StepRepr_NextAssemblyUsageOccurrence.hxx>
#include <StepRepr_RepresentationItem.hxx>
#include <StepShape_FaceSurface.hxx>
#include <StepShape_SolidModel.hxx>
#include <TCollection_HAsciiString.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS_Shape.hxx>
#include <TransferBRep.hxx>
#include <Transfer_FinderProcess.hxx>
#include <Transfer_TransientProcess.hxx>
#include <XSControl_TransferReader.hxx>
#include <XSControl_TransferWriter.hxx>
#include <XSControl_WorkSession.hxx>

namespace knead {

namespace {

constexpr std::string_view mark = "~|~"; // nobody has it in a name

std::string textOf(const Handle(TCollection_HAsciiString) & text)
{
    return text.IsNull() ? std::string() : text->ToCString();
}

Handle(TCollection_HAsciiString) asText(const std::string& text)
{
    return new TCollection_HAsciiString(text.c_str());
}

/// Whether OpenCASCADE takes a name that is there for none.
bool isOverlooked(const Handle(TCollection_HAsciiString) & name)
{
    return !name.IsNull() && name->Length() > 0 && name->UsefullLength() == 0;
}

template <typename Entity, typename Action>
void forEach(const Handle(Interface_InterfaceModel) & model, Action action)
{
    for (int i = 1; !model.IsNull() && i <= model->NbEntities(); ++i)
        if (const auto entity = Handle(Entity)::DownCast(model->Value(i)); !entity.IsNull())
            action(entity);
}

} // namespace

void markNames(const STEPControl_Reader& reader)
{
    const Handle(Interface_InterfaceModel) model = reader.Model();
    forEach<StepRepr_NextAssemblyUsageOccurrence>(model, [](const auto& instance) {
        if (isOverlooked(instance->Name()))
            instance->SetName(asText(textOf(instance->Name()) + std::string(mark)));
    });
    forEach<StepBasic_Product>(model, [](const auto& product) {
        const std::string name = textOf(product->Name());
        const std::string id = textOf(product->Id());
        if (isOverlooked(product->Name()) || (!name.empty() && !id.empty() && id != name))
            product->SetName(asText(name + std::string(mark) + id));
    });
}

StepName withoutMark(std::u16string_view name)
{
    const std::size_t at = name.find(std::u16string(mark.begin(), mark.end()));
    if (at == std::u16string_view::npos)
        return {readableName(name), {}};
    return {readableName(name.substr(0, at)), readableName(name.substr(at + mark.size()))};
}

std::string withPartNumber(const std::string& name, const std::string& partNumber)
{
    return partNumber.empty() || partNumber == name ? name : name + std::string(mark) + partNumber;
}

void takePartNumbersApart(STEPControl_Writer& writer)
{
    forEach<StepBasic_Product>(writer.Model(), [](const auto& product) {
        const std::string both = textOf(product->Name());
        const std::size_t at = both.find(mark);
        if (at == std::string::npos)
            return;
        product->SetName(asText(both.substr(0, at)));
        product->SetId(asText(both.substr(at + mark.size())));
    });
}

ShapeNotes<std::string> namesOfStepShapes(const STEPControl_Reader& reader)
{
    ShapeNotes<std::string> names;
    const Handle(Transfer_TransientProcess)& process = reader.WS()->TransferReader()->TransientProcess();
    const auto take = [&](TopAbs_ShapeEnum kind) {
        return [&, kind](const Handle(StepRepr_RepresentationItem) & item) {
            const std::string name = readableName(std::string_view(textOf(item->Name())));
            if (isGeneratedName(name))
                return;
            const TopoDS_Shape shape = TransferBRep::ShapeResult(process, item);
            if (shape.IsNull())
                return;
            names.set(shape, name);
            for (TopExp_Explorer pieces(shape, kind); pieces.More(); pieces.Next()) // that reading divided it into
                names.set(pieces.Current(), name);
        };
    };
    forEach<StepShape_SolidModel>(reader.Model(), take(TopAbs_SOLID));
    forEach<StepShape_FaceSurface>(reader.Model(), take(TopAbs_FACE));
    return names;
}

void nameShapes(const NamedShapes& shapes, STEPControl_Writer& writer)
{
    const Handle(Transfer_FinderProcess)& process = writer.WS()->TransferWriter()->FinderProcess();
    for (const auto& [shape, name] : shapes) {
        const TopAbs_ShapeEnum kind = shape.ShapeType() == TopAbs_FACE ? TopAbs_FACE : TopAbs_SOLID;
        for (TopExp_Explorer named(shape, kind); named.More(); named.Next())
            if (const auto item = STEPConstruct::FindEntity(process, named.Current()); !item.IsNull())
                item->SetName(asText(name));
    }
}

} // namespace knead
