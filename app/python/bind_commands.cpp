#include "app/python/bindings.h"
#include "app/python/handles.h"
#include "app/python/script_control.h"
#include "app/python/words.h"
#include "app/recipe_files.h"
#include "core/document/project.h"
#include "core/message/message.h"
#include "io/project/command_json.h"

#include <pybind11/eigen.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <filesystem>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace py = pybind11;

namespace knead::python {

namespace {

/// A part that tools of a project are made of.
struct HeldToolPart {
    std::shared_ptr<const ToolPart> part;
};

std::vector<HeldToolPart> toolPartsIn(const std::filesystem::path& path)
{
    const Project project =
        computing(py::none(), [&](TaskControl& control) { return recipeFiles().readProject(path.string(), control); });
    std::vector<HeldToolPart> parts;
    for (std::shared_ptr<const ToolPart>& part : toolPartsOf(project))
        parts.push_back({std::move(part)});
    return parts;
}

Command commandOf(const py::dict& words, const std::vector<HeldToolPart>& toolParts)
{
    const auto text = py::module_::import("json").attr("dumps")(words).cast<std::string>();
    ToolPartTable table;
    for (const HeldToolPart& held : toolParts)
        table.add(held.part);
    std::size_t longList = std::numeric_limits<std::size_t>::max();
    return commandFromJson(text, "carry_out()", table, longList);
}

/// What a script holds of what was added.
py::object carryOut(const LivePointer& simulation, const py::dict& words, const std::vector<HeldToolPart>& toolParts)
{
    Command command = commandOf(words, toolParts);
    const bool isTool = std::holds_alternative<AddManipulator>(command);
    const bool isFixture = std::holds_alternative<AddFixture>(command);
    const std::optional<std::uint32_t> added = withoutLock([&] { return simulation->carryOut(std::move(command)); });
    if (isTool)
        return py::cast(ToolHandle{simulation, added.value()});
    if (isFixture)
        return py::cast(FixtureHandle{simulation, added.value()});
    return py::none();
}

void tell(LiveSimulation& simulation, const Command& command)
{
    withoutLock([&] { simulation.carryOut(command); });
}

using Objects = std::vector<ObjectIndex>;

void bindBodyCommands(SimulationType& type)
{
    type.def(
            "set_material",
            [](LiveSimulation& simulation, const Material& material, BodyId body, Objects objects) {
                tell(simulation, SetMaterial{body, material, ascending(std::move(objects))});
            },
            py::arg("material"), py::arg("body") = 0, py::arg("objects") = Objects(),
            "What a body, by its number, or some of its objects are made of from now on.")
        .def(
            "set_body_kind",
            [](LiveSimulation& simulation, const std::string& kind, BodyId body) {
                tell(simulation, SetBodyKind{body, choiceCalled(kind, bodyKindWords())});
            },
            py::arg("kind"), py::arg("body") = 0, "Makes a body \"deformable\", \"rigid\" or \"glue\".")
        .def(
            "renormalize",
            [](LiveSimulation& simulation, BodyId body, Objects objects, double duration) {
                tell(simulation, Renormalize{body, ascending(std::move(objects)), duration});
            },
            py::arg("body") = 0, py::kw_only(), py::arg("objects") = Objects(), py::arg("duration") = 0.0,
            "A body, or some of its objects, takes its present shape for its own: at once, or gradually [s], as in "
            "annealing.")
        .def(
            "refill",
            [](LiveSimulation& simulation, BodyId body, double spacing) {
                tell(simulation, Refill{body, spacing});
            },
            py::arg("body") = 0, py::kw_only(), py::arg("spacing") = 0.0,
            "Fills a body that yields anew, in the shape that it has, at a spacing [m]; 0: as it is.")
        .def(
            "cut",
            [](LiveSimulation& simulation, const Vec3& point, const Vec3& normal, BodyId body) {
                tell(simulation, Cut{body, point, normal});
            },
            py::arg("point"), py::arg("normal"), py::arg("body") = 0,
            "Cuts a body along a plane through a point [m], without force and work.");
}

void bindWorldCommands(SimulationType& type)
{
    type.def(
            "set_gravity",
            [](LiveSimulation& simulation, const Vec3& gravity) { tell(simulation, SetGravity{gravity}); },
            py::arg("gravity"), "[m/s^2]")
        .def(
            "set_floor",
            [](LiveSimulation& simulation, std::optional<double> height, double friction, double adhesion) {
                tell(simulation, SetFloor{height, friction, adhesion});
            },
            py::arg("height"), py::kw_only(), py::arg("friction") = SetFloor{}.friction, py::arg("adhesion") = 0.0,
            "A fixed floor at a height z [m], None: none; friction 0 .. 2, adhesion [Pa].")
        .def(
            "set_integrator",
            [](LiveSimulation& simulation, const std::string& integrator) {
                tell(simulation, SetIntegrator{choiceCalled(integrator, integratorWords())});
            },
            py::arg("integrator"), "Other steps from now on; the words are those of Simulation().")
        .def(
            "set_pace",
            [](LiveSimulation& simulation, const std::string& pace) {
                tell(simulation, SetPace{choiceCalled(pace, paceWords())});
            },
            py::arg("pace"), "How long and exact implicit steps are: \"full\", \"rough\", \"wide\" or \"exact\".");
}

} // namespace

void bindToolParts(py::module_& module)
{
    py::class_<HeldToolPart>(module, "ToolPart", "An imported part that tools of a project are made of.")
        .def_property_readonly(
            "size", [](const HeldToolPart& held) { return held.part->size(); }, "Of its box [m].");
    module.def("tool_parts", &toolPartsIn, py::arg("project"),
               "Imported parts that tools of a project are made of, in the order in which they were first used.");
}

void bindCommands(SimulationType& type)
{
    bindBodyCommands(type);
    bindWorldCommands(type);
    type.def("carry_out", &carryOut, py::arg("command"), py::arg("tool_parts") = std::vector<HeldToolPart>(),
             "Carries out a command as projects keep it: {\"command\": \"remove-fixture\", \"fixture\": 0}. Tools that "
             "are imported parts name these by their place in `tool_parts`. Returns the Tool or the Fixture that was "
             "added, else None. Raises Error.");
}

} // namespace knead::python
