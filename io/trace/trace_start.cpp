#include "io/trace/trace_start.h"

#include "core/message/message.h"
#include "io/recipe/scene_words.h"

#include <algorithm>
#include <filesystem>

namespace knead {

namespace py = python_text;

namespace {

bool isFileThere(const std::string& path)
{
    std::error_code error;
    return std::filesystem::is_regular_file(path, error);
}

/// From the files they were read from, in the same way; else from the project.
std::string readingText(const Project& project, const TraceStart& start)
{
    const ImportChoices& import = project.import;
    py::Arguments arguments;
    if (start.start.model || import.paths.empty() || !std::ranges::all_of(import.paths, isFileThere)) {
        if (start.choices.projectPath.empty() || start.model != shownModel(project))
            throw Problem(Message("Trace", "The parts are in no file as they are here: save the project first, from "
                                           "which the script then takes them."));
        return "model = knead.read(" + py::path(start.choices.projectPath) + ")\n";
    }
    std::string paths;
    for (const std::string& path : import.paths)
        paths += (paths.empty() ? "" : ", ") + py::path(std::filesystem::absolute(path).lexically_normal().string());
    arguments.add(import.paths.size() == 1 ? paths : '[' + paths + ']');
    const ImportOptions& options = import.options;
    const ImportOptions usual;
    if (!options.unit.empty())
        arguments.add("unit", py::text(options.unit));
    if (!options.parts.empty()) {
        std::string parts;
        for (const std::string& part : options.parts)
            parts += (parts.empty() ? "" : ", ") + py::text(part);
        arguments.add("parts", '[' + parts + ']');
    }
    if (!options.heal)
        arguments.add("heal", "False");
    if (options.capsFlatOpenings)
        arguments.add("caps_flat_openings", "True");
    arguments.addUnless(usual.linearDeflection, "linear_deflection", options.linearDeflection)
        .addUnless(usual.angularDeflection, "angular_deflection", options.angularDeflection)
        .addUnless(usual.relativeDeflection, "relative_deflection", options.relativeDeflection);
    return "model = knead.read(" + arguments.all() + ")\n";
}

/// A body as it begins.
std::string bodyText(const TraceStart& start, BodyId id, const std::string& variable)
{
    const Body& body = start.start.scene.bodies[id];
    py::Arguments arguments;
    arguments.add("model.parts[" + std::to_string(start.start.partOfBody.at(id)) + ']')
        .add("spacing", py::number(body.aggregate->lattice.spacing))
        .add("material", py::material(body.material, start.choices.presets));
    if (!body.aggregate->weight.back().empty()) // only that arrangement has connections along the diagonals of cells
        arguments.add("published", "True");
    if (!start.partOf(id).canBeFilled())
        arguments.add("open", "True");
    std::string text = variable + " = knead.fill(" + arguments.all() + ")\n";
    if (body.kind != BodyKind::deformable)
        text += variable + ".kind = " + py::text(wordFor(body.kind, bodyKindWords())) + '\n';
    if (const std::string velocity = py::tuple(body.velocity); velocity != py::zeros)
        text += variable + ".velocity = " + velocity + '\n';
    if (const std::string velocity = py::tuple(body.angularVelocity); velocity != py::zeros)
        text += variable + ".angular_velocity = " + velocity + '\n';
    if (body.structuralFriction != 0)
        text += variable + ".structural_friction = " + py::number(body.structuralFriction) + '\n';
    for (const MaterialRegion& region : body.regions)
        text += variable + ".add_region(" +
                py::Arguments()
                    .add(py::material(region.material, start.choices.presets))
                    .add(py::list(region.objects))
                    .add("name", py::text(region.name))
                    .all() +
                ")\n";
    return text;
}

std::string simulationText(const Scene& scene, const std::string& bodies)
{
    py::Arguments arguments;
    arguments.add('[' + bodies + ']');
    arguments.addUnless(py::zeros, "gravity", py::tuple(scene.gravity));
    if (scene.floorHeight)
        arguments.add("floor", py::number(*scene.floorHeight))
            .addUnless(Scene{}.floorFriction, "floor_friction", scene.floorFriction)
            .addUnless(0, "floor_adhesion", scene.floorAdhesion);
    if (scene.integrator != Integrator::automatic)
        arguments.add("integrator", py::text(wordFor(scene.integrator, integratorWords())));
    if (scene.timeStep)
        arguments.add("time_step", py::number(*scene.timeStep));
    if (scene.massScalingTimeStep)
        arguments.add("mass_scaling_time_step", py::number(*scene.massScalingTimeStep));
    if (scene.touching == Touching::glued)
        arguments.add("glued", "True");
    if (!scene.refilling)
        arguments.add("refilling", "False");
    if (scene.vicinity != Scene{}.vicinity)
        arguments.add("vicinity", py::text(wordFor(scene.vicinity, vicinityWords())));
    return "sim = knead.Simulation(" + arguments.all() + ")\n";
}

} // namespace

std::string traceBeginning(const Project& project, const TraceStart& start, py::Names& names)
{
    std::string text =
        "# What was done in Knead. Run it with: knead python SCRIPT\n"
        "# All numbers are SI units: metres, seconds, newtons, pascals. A step is the number of those taken before.\n"
        "import knead\n\n";
    text += readingText(project, start);
    std::string bodies;
    for (BodyId body = 0; body < start.start.scene.bodies.size(); ++body) {
        const std::string variable = names.add(start.start.scene.bodies[body].name, "body");
        text += bodyText(start, body, variable);
        bodies += (bodies.empty() ? "" : ", ") + variable;
    }
    return text + simulationText(start.start.scene, bodies);
}

} // namespace knead
