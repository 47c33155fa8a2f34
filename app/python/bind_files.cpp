#include "app/commands/morph_report.h"
#include "app/commands/run_json.h"
#include "app/morph_file.h"
#include "app/physical_morph.h"
#include "app/python/bindings.h"
#include "app/python/script_control.h"
#include "app/recipe_files.h"
#include "app/recipe_to_run.h"
#include "app/resources.h"
#include "core/message/message.h"
#include "core/session/recipe_runner.h"
#include "io/material_library.h"
#include "io/recipe/recipe_reader.h"

#include <nlohmann/json.hpp>
#include <pybind11/eigen.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <filesystem>
#include <map>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace py = pybind11;

namespace knead::python {

namespace {

std::string toJson(const py::handle& value)
{
    return py::module_::import("json").attr("dumps")(value).cast<std::string>();
}

std::vector<RecipeOverride> changesOf(const py::dict& settings)
{
    std::vector<RecipeOverride> changes;
    for (const auto& [path, value] : settings)
        changes.push_back({path.cast<std::string>(), toJson(value)});
    return changes;
}

using RecipeWords = std::variant<py::dict, std::filesystem::path>;

/// A recipe in a dict lies in a folder, from which its files are named.
RecipeToRun recipeOfScript(const RecipeWords& recipe, const std::filesystem::path& folder, const py::dict& settings)
{
    const std::vector<RecipeOverride> changes = changesOf(settings);
    if (const auto* path = std::get_if<std::filesystem::path>(&recipe))
        return recipeToRun(path->string(), changes);
    const std::string path = folder / "recipe";
    return {readRecipeText(toJson(std::get<py::dict>(recipe)), path, readMaterials(materialsFile()), changes), {}};
}

py::object run(const RecipeWords& words, const std::filesystem::path& out, const py::dict& settings,
               const std::filesystem::path& folder, const std::filesystem::path& csv,
               const std::filesystem::path& probes, py::object progress)
{
    const RecipeToRun ready = recipeOfScript(words, folder, settings);
    RunReport report = computing(std::move(progress), [&](TaskControl& control) {
        return runRecipe(ready.recipe, recipeFiles(), out, control, {}, {.forces = csv, .probes = probes});
    });
    for (const Message& remark : ready.remarks)
        report.warnings.push_back(remark.english());
    return fromJson(jsonOf(report));
}

using Wishes = std::variant<DeformationWish, std::vector<DeformationWish>, std::filesystem::path>;

std::vector<DeformationWish> wishesOf(const Wishes& wishes)
{
    if (const auto* path = std::get_if<std::filesystem::path>(&wishes))
        return {FieldWish{.path = path->string()}};
    if (const auto* one = std::get_if<DeformationWish>(&wishes))
        return {*one};
    return std::get<std::vector<DeformationWish>>(wishes);
}

py::object morph(const std::filesystem::path& part, const Wishes& wishes, const std::filesystem::path& out,
                 double factor, const std::vector<std::string>& parts, const std::string& unit, double tolerance,
                 py::object progress)
{
    MorphRequest request{.input = part, .output = out, .wishes = wishesOf(wishes), .parts = parts};
    for (DeformationWish& wish : request.wishes)
        if (auto* field = std::get_if<FieldWish>(&wish))
            field->factor *= factor;
    request.write = {.unit = unit, .tolerance = tolerance};
    const MorphReport report =
        computing(std::move(progress), [&](TaskControl& control) { return morphFile(std::move(request), control); });
    return fromJson(jsonOf(report));
}

py::object morphByGrips(const std::filesystem::path& part, const NumberWish& wish, const std::filesystem::path& out,
                        const std::string& material, std::optional<double> duration, bool letGo,
                        std::optional<std::size_t> objects, const std::vector<std::string>& parts,
                        const std::string& unit, double tolerance, py::object progress)
{
    const PhysicalMorphRequest request{.input = part,
                                       .output = out,
                                       .wishes = {wish},
                                       .parts = parts,
                                       .import = {},
                                       .write = {.unit = unit, .tolerance = tolerance},
                                       .physics = {material, duration, letGo, objects}};
    const RunReport report =
        computing(std::move(progress), [&](TaskControl& control) { return morphByPhysics(request, control); });
    return fromJson(jsonOf(report));
}

FieldWish fieldOf(const std::filesystem::path& path, double factor, std::optional<std::size_t> step,
                  const std::string& component, const std::string& unit, const std::vector<std::string>& keepFaces,
                  std::optional<double> fade, const std::string& lock, bool inPlace)
{
    FieldWish wish{.path = path, .factor = factor, .kept = keepFaces, .fade = fade};
    wish.choice = {.step = step, .name = component, .unit = unit, .isInPlace = inPlace};
    for (const char axis : lock) {
        if (axis < 'x' || axis > 'z')
            throw py::value_error("lock is some of \"xyz\"");
        wish.locked.at(static_cast<std::size_t>(axis - 'x')) = true;
    }
    return wish;
}

void bindNumberWish(py::module_& module, const char* name, NumberKind kind, const char* amount, const char* what)
{
    const auto make = [kind](double value, std::optional<Vec3> axis, std::optional<Vec3> side,
                             std::optional<Vec3> origin, std::optional<double> start, std::optional<double> end,
                             std::optional<double> radius, std::optional<double> neutral, std::optional<double> kFactor,
                             double stays, bool ease) {
        return NumberWish{kind, value, axis, side, origin, start, end, radius, neutral, kFactor, stays, ease};
    };
    module.def(name, make, py::arg(amount), py::kw_only(), py::arg("axis") = py::none(), py::arg("side") = py::none(),
               py::arg("origin") = py::none(), py::arg("start") = py::none(), py::arg("end") = py::none(),
               py::arg("radius") = py::none(), py::arg("neutral") = py::none(), py::arg("k_factor") = py::none(),
               py::arg("stays") = 0.0, py::arg("ease") = false, what);
}

void bindDeformations(py::module_& module)
{
    py::class_<NumberWish>(
        module, "NumberDeformation",
        "A deformation by number between two planes, `start` and `end` along `axis` from `origin` [m].");
    py::class_<FieldWish>(module, "FieldDeformation", "A deformation by displacements of another program.");
    bindNumberWish(module, "bend", NumberKind::bend, "angle",
                   "Bends into an arc by an angle [rad], toward `side`; `radius` [m] in place of `end`. `neutral` [m] "
                   "or `k_factor` "
                   "say which plane keeps its length.");
    bindNumberWish(module, "twist", NumberKind::twist, "angle", "Twists about the axis by an angle [rad].");
    bindNumberWish(module, "taper", NumberKind::taper, "factor",
                   "Lets cross-sections grow or shrink to so much at the second plane.");
    bindNumberWish(module, "stretch", NumberKind::stretch, "factor",
                   "Makes it so many times as long between the planes.");
    bindNumberWish(module, "shear", NumberKind::shear, "shift",
                   "Moves cross-sections toward `side`, by so much at the second plane [m].");
    bindNumberWish(module, "scale", NumberKind::scale, "factor", "Tapers and stretches alike.");
    module.def("field", &fieldOf, py::arg("path"), py::kw_only(), py::arg("factor") = 1.0, py::arg("step") = py::none(),
               py::arg("component") = "", py::arg("unit") = "", py::arg("keep_faces") = std::vector<std::string>(),
               py::arg("fade") = py::none(), py::arg("lock") = "", py::arg("in_place") = false,
               "Displacements of a file: results of a simulation, a table, a project, or a scan. `step` from 0, of a "
               "project the "
               "entry; keep_faces: CAD faces that stay, \"3,7\" or \"Lid:3,7\", and `fade` [m] over which the field "
               "fades toward "
               "them; lock: axes along which nothing moves; in_place: a scan has the axes of the part.");
}

} // namespace

void bindFiles(py::module_& module)
{
    bindDeformations(module);
    module.def(
        "example", [](const std::string& name) { return resourcesFolder() + "/examples/" + name; }, py::arg("name"),
        "Path of a bundled example: \"bracket.step\". Raises Error where Knead's own files are not found.");
    module.def("run", &run, py::arg("recipe"), py::arg("out") = ".", py::kw_only(), py::arg("settings") = py::dict(),
               py::arg("folder") = ".", py::arg("csv") = "", py::arg("probes") = "", py::arg("progress") = py::none(),
               "Carries out a recipe (a path, or a dict whose files are named from `folder`), or what was done in a "
               "project, as "
               "`knead run` does. `settings`: changes, {\"material.youngs_modulus_pa\": 2e6}; csv and probes: tables "
               "to write. "
               "Returns what `knead run --json` prints. Raises Error, with `report` where the run failed midway.");
    module.def("morph", &morph, py::arg("part"), py::arg("deformations"), py::arg("out"), py::kw_only(),
               py::arg("factor") = 1.0, py::arg("parts") = std::vector<std::string>(), py::arg("unit") = "",
               py::arg("tolerance") = 0.0, py::arg("progress") = py::none(),
               "Deforms the parts of a file and writes what comes of it, smooth faces as smooth faces, as `knead "
               "morph` does: by "
               "a field (a path, or field()), by bend(), twist() and the like, or by a list of them, one after the "
               "other. `factor` "
               "times the fields; `parts` by name or path, none: all. Returns what `knead morph --json` prints. Raises "
               "Error.");
    module.def("morph_by_physics", &morphByGrips, py::arg("part"), py::arg("deformation"), py::arg("out"),
               py::kw_only(), py::arg("material"), py::arg("duration") = py::none(), py::arg("let_go") = false,
               py::arg("objects") = py::none(), py::arg("parts") = std::vector<std::string>(), py::arg("unit") = "",
               py::arg("tolerance") = 0.0, py::arg("progress") = py::none(),
               "Lets the material between the planes of a bend(), twist(), stretch() or shear() find its own shape, "
               "while grips lead what lies beyond them, as `knead morph --physics` does. `material`: id of a preset, "
               "\"plasticine\"; `duration` of the way of the grips [s], none: 1; `let_go`: one grip opens at the end, "
               "and the "
               "material springs back; `objects`: about how many, none: 20000; `parts`: one, none: all. Returns what "
               "`knead run --json` prints. Raises Error.");
}

} // namespace knead::python
