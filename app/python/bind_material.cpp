#include "app/python/bindings.h"
#include "app/resources.h"
#include "core/aggregate/material.h"
#include "core/message/message.h"
#include "io/material_library.h"

#include <pybind11/operators.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

namespace py = pybind11;

namespace knead::python {

namespace {

std::vector<MaterialPreset> presets()
{
    std::vector<MaterialPreset> all = readMaterials(materialsFile());
    const std::vector<MaterialPreset> own = readOwnMaterials(ownMaterialsFile());
    all.insert(all.end(), own.begin(), own.end());
    return all;
}

std::vector<std::string> presetNames()
{
    std::vector<std::string> names;
    for (const MaterialPreset& preset : presets())
        names.push_back(preset.id);
    return names;
}

Material presetCalled(const std::string& name)
{
    for (const MaterialPreset& preset : presets())
        if (preset.id == name)
            return preset.material;
    throw Problem(
        Message("Python", "There is no material \"%1\"; knead.Material.presets() lists their names.").with(name));
}

const MaterialField& fieldCalled(const std::string& key)
{
    const std::vector<MaterialField>& fields = materialFields();
    const auto found = std::ranges::find_if(fields, [&](const MaterialField& field) { return field.key == key; });
    if (found == fields.end())
        throw py::type_error("a material has no number " + key);
    return *found;
}

Material material(const std::optional<std::string>& preset, const py::kwargs& numbers)
{
    Material result = preset ? presetCalled(*preset) : Material{};
    for (const auto& [key, value] : numbers)
        result.*fieldCalled(key.cast<std::string>()).value = value.cast<double>();
    if (const std::vector<Message> problems = materialProblems(result); !problems.empty())
        throw Problem(problems.front());
    return result;
}

std::string description(const Material& material)
{
    std::string text;
    for (const MaterialField& field : materialFields())
        if (const double value = material.*field.value; value != Material{}.*field.value)
            text += (text.empty() ? "" : ", ") + (field.key + ("=" + py::repr(py::float_(value)).cast<std::string>()));
    return "knead.Material(" + text + ")";
}

std::string documentation(const MaterialField& field)
{
    const std::string unit = *field.unit == 0 ? "" : std::string(" [") + field.unit + "]";
    const std::string zero = *field.zero == 0 ? "" : std::string("; 0: ") + field.zero;
    return std::string(field.name) + unit + zero + ".";
}

} // namespace

void bindMaterial(py::module_& module)
{
    py::class_<Material> type(module, "Material",
                              "What a body is made of. The names of its numbers end in their units, as in recipes.");
    type.def(py::init(&material), py::arg("preset") = py::none(),
             "A preset by its name, or E = 1 MPa and 1100 kg/m^3, with numbers of one's own: "
             "Material(\"silicone-rubber\", youngs_modulus_pa=2e6). Raises Error for a number out of range.");
    type.def_static("presets", &presetNames, "Names of the materials that there are, one's own included.");
    type.def("__repr__", &description);
    type.def(py::self == py::self);
    for (const MaterialField& field : materialFields())
        type.def_property_readonly(
            field.key, [value = field.value](const Material& m) { return m.*value; }, documentation(field).c_str());
}

} // namespace knead::python
