#include "io/previewer.h"

#include "core/message/message.h"
#include "core/model/readable_name.h"
#include "io/brep/occt_session.h"
#include "io/document/cad_document.h"
#include "io/formats/cad_format.h"
#include "io/formats/step/step_assembly_size.h"
#include "io/formats/step/step_check.h"

#include <IGESControl_Reader.hxx>
#include <IGESData_IGESModel.hxx>
#include <IGESGeom_TrimmedSurface.hxx>
#include <IGESSolid_Face.hxx>
#include <IGESSolid_ManifoldSolid.hxx>
#include <Interface_InterfaceModel.hxx>
#include <STEPControl_Reader.hxx>
#include <StepBasic_Product.hxx>
#include <StepBasic_ProductDefinition.hxx>
#include <StepBasic_ProductDefinitionFormation.hxx>
#include <StepRepr_NextAssemblyUsageOccurrence.hxx>
#include <StepShape_FaceSurface.hxx>
#include <StepShape_ManifoldSolidBrep.hxx>
#include <TCollection_HAsciiString.hxx>

#include <filesystem>
#include <fstream>
#include <unordered_map>
#include <unordered_set>
#include <vector>

namespace knead {

namespace {

constexpr int deepestShown = 4000; // levels, as the importer takes them

std::string textOf(const Handle(TCollection_HAsciiString) & text)
{
    return text.IsNull() ? std::string() : readableName(std::string_view(text->ToCString()));
}

std::string productName(const Handle(StepBasic_ProductDefinition) & definition)
{
    if (definition->Formation().IsNull() || definition->Formation()->OfProduct().IsNull())
        return {};
    const Handle(StepBasic_Product) product = definition->Formation()->OfProduct();
    const std::string name = textOf(product->Name());
    return isGeneratedName(name) ? textOf(product->Id()) : name;
}

/// As OpenCASCADE names the component of an assembly.
std::string instanceName(const Handle(StepRepr_NextAssemblyUsageOccurrence) & usage)
{
    const std::string description = usage->HasDescription() ? textOf(usage->Description()) : std::string();
    return description.empty() ? textOf(usage->Name()) : description;
}

/// The assembly as the products of a STEP file tell it.
class ProductTree {
public:
    ProductTree(const Interface_InterfaceModel& model, const std::string& fallbackName)
        : m_fallbackName(fallbackName)
    {
        std::unordered_set<const void*> used;
        for (int i = 1; i <= model.NbEntities(); ++i) {
            const auto usage = Handle(StepRepr_NextAssemblyUsageOccurrence)::DownCast(model.Value(i));
            if (usage.IsNull() || usage->RelatingProductDefinition().IsNull() ||
                usage->RelatedProductDefinition().IsNull())
                continue;
            m_usages[usage->RelatingProductDefinition().get()].push_back(usage);
            used.insert(usage->RelatedProductDefinition().get());
        }
        for (int i = 1; i <= model.NbEntities(); ++i) {
            const auto definition = Handle(StepBasic_ProductDefinition)::DownCast(model.Value(i));
            if (!definition.IsNull() && !used.contains(definition.get()))
                m_roots.push_back(definition);
        }
    }

    PartNode tree()
    {
        PartNode root{m_fallbackName, std::nullopt, {}};
        for (const auto& definition : m_roots)
            root.children.push_back(node(definition, bestPartName({}, productName(definition), m_fallbackName), 0));
        return root;
    }

    std::size_t leaves() const { return m_leaves; }

private:
    PartNode node(const Handle(StepBasic_ProductDefinition) & definition, const std::string& name, int depth)
    {
        PartNode result{name, std::nullopt, {}};
        const auto usages = m_usages.find(definition.get());
        if (usages == m_usages.end() || depth > deepestShown) {
            ++m_leaves;
            return result;
        }
        for (const auto& usage : usages->second) {
            const Handle(StepBasic_ProductDefinition) part = usage->RelatedProductDefinition();
            result.children.push_back(
                node(part, bestPartName(instanceName(usage), productName(part), name), depth + 1));
        }
        return result;
    }

    std::string m_fallbackName;
    std::unordered_map<const void*, std::vector<Handle(StepRepr_NextAssemblyUsageOccurrence)>> m_usages;
    std::vector<Handle(StepBasic_ProductDefinition)> m_roots;
    std::size_t m_leaves = 0;
};

template <class Entity>
std::size_t countOf(const Interface_InterfaceModel& model)
{
    std::size_t count = 0;
    for (int i = 1; i <= model.NbEntities(); ++i)
        count += model.Value(i)->IsKind(STANDARD_TYPE(Entity)) ? 1 : 0;
    return count;
}

void previewStep(const std::string& path, TaskControl& control, FilePreview& preview)
{
    TaskPortion checking(control, 0, 0.1);
    const StepCheck check = checkStepText(path, checking);
    preview.format = check.protocol.empty() ? "STEP" : "STEP " + check.protocol;
    control.report(0.1, "looking into the file");
    std::ifstream file(path, std::ios::binary);
    if (file.peek() == 0xEF) // the byte-order mark
        file.seekg(3);
    STEPControl_Reader reader;
    if (reader.ReadStream(shortName(path).c_str(), file) != IFSelect_RetDone)
        failReading(path, Message("Import",
                                  "the STEP text has errors that the reader cannot get over; export the file again."));
    if (countUnfoldedParts(reader, mostParts) >= mostParts)
        failReading(path, Message("Import", "the assembly unfolds to more than %1 parts; export the parts you need.")
                              .with(mostParts));
    const Interface_InterfaceModel& model = *reader.Model();
    preview.solids = countOf<StepShape_ManifoldSolidBrep>(model);
    preview.faces = countOf<StepShape_FaceSurface>(model);
    ProductTree products(model, preview.tree.name);
    preview.tree = products.tree();
    preview.parts = products.leaves();
}

void previewIges(const std::string& path, TaskControl& control, FilePreview& preview)
{
    control.report(0.1, "looking into the file");
    IGESControl_Reader reader;
    if (reader.ReadFile(path.c_str()) != IFSelect_RetDone)
        failReading(
            path,
            Message("Import",
                    "the IGES text has errors that the reader cannot get over; export the file again, best as STEP."));
    const Interface_InterfaceModel& model = *reader.Model();
    preview.solids = countOf<IGESSolid_ManifoldSolid>(model);
    preview.faces = countOf<IGESSolid_Face>(model) + countOf<IGESGeom_TrimmedSurface>(model);
}

} // namespace

FilePreview previewFile(const std::string& path, TaskControl& control)
{
    const FormatKind kind = recognizeFormat(path);
    FilePreview preview;
    preview.file = path;
    preview.size = std::filesystem::file_size(path);
    preview.format = formatOf(kind).name;
    preview.tree.name = partNameFor(path);
    if (kind == FormatKind::Step || kind == FormatKind::Iges) {
        const OcctSession session;
        guardOcct(path, [&] {
            kind == FormatKind::Step ? previewStep(path, control, preview) : previewIges(path, control, preview);
        });
    }
    control.throwIfCancelled();
    control.report(1, "done");
    return preview;
}

} // namespace knead
