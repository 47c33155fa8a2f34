#include "app/hexadecimal.h"
#include "app/python/bindings.h"
#include "app/python/handles.h"
#include "app/python/script_control.h"
#include "app/python/tool_words.h"
#include "app/python/words.h"
#include "core/message/message.h"
#include "core/simulation/moment.h"
#include "io/export/job_file.h"

#include <pybind11/eigen.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <algorithm>
#include <filesystem>
#include <limits>
#include <utility>
#include <variant>

namespace py = pybind11;

namespace knead::python {

namespace {

constexpr double betweenCallbacks = 1.0 / 60; // of simulated time [s]

LivePointer simulationOf(std::vector<std::shared_ptr<FilledPart>> fillings, const Vec3& gravity,
                         std::optional<double> floor, double floorFriction, double floorAdhesion,
                         const std::string& integrator, std::optional<double> timeStep, bool glued, bool refilling,
                         const std::string& vicinity, std::optional<double> massScalingTimeStep)
{
    Scene world{.gravity = gravity,
                .floorHeight = floor,
                .touching = glued ? Touching::glued : Touching::separate,
                .integrator = choiceCalled(integrator, integratorWords()),
                .vicinity = choiceCalled(vicinity, vicinityWords()),
                .timeStep = timeStep,
                .massScalingTimeStep = massScalingTimeStep,
                .refilling = refilling};
    if (floor) {
        world.floorFriction = floorFriction;
        world.floorAdhesion = floorAdhesion;
    }
    return std::make_shared<LiveSimulation>(std::move(fillings), std::move(world));
}

std::vector<BodyHandle> bodiesOf(LiveSimulation& simulation)
{
    std::vector<BodyHandle> bodies;
    for (BodyId body = 0; body < simulation.bodies().size(); ++body)
        bodies.push_back({simulation.shared_from_this(), body});
    return bodies;
}

FixtureHandle fix(const LivePointer& simulation, std::size_t body, const std::optional<std::pair<Vec3, Vec3>>& corners,
                  const std::vector<std::uint32_t>& faces, std::vector<ObjectIndex> objects, const std::string& name,
                  const Vec3& velocity)
{
    if (body >= simulation->bodies().size())
        throw py::index_error("there is no such body");
    const auto box = corners ? std::optional(Box(corners->first, corners->second)) : std::nullopt;
    const Fixture how{.name = name, .objects = ascending(std::move(objects)), .velocity = velocity};
    const FixtureId id = withoutLock([&] { return simulation->fix(static_cast<BodyId>(body), box, faces, how); });
    return {simulation, id};
}

ToolHandle addTool(const LivePointer& simulation, const std::string& kind, const SizeWords& size, const Vec3& position,
                   const std::optional<RotationWords>& rotation, const std::string& name,
                   const std::vector<py::tuple>& frames, const std::optional<Vec3>& velocity,
                   const Vec3& angularVelocity, double friction, double adhesion, double speedLimit,
                   std::optional<double> forceLimit, bool rolls)
{
    Manipulator tool{.name = name.empty() ? kind : name,
                     .pose = poseOf(position, rotation, Quaternion::Identity()),
                     .friction = friction,
                     .speedLimit = speedLimit,
                     .forceLimit = forceLimit.value_or(std::numeric_limits<double>::infinity()),
                     .kind = toolKindCalled(kind),
                     .adhesion = adhesion,
                     .rollsFreely = rolls};
    tool.size = sizeOf(tool.kind, size);
    if (!frames.empty() && velocity)
        throw py::type_error("a tool follows keyframes or drives at a velocity, not both");
    if (!frames.empty()) { // it is where it stands at time 0
        std::vector<KeyFrame> all{{0, tool.pose}};
        std::ranges::copy(framesOf(frames, tool.pose), std::back_inserter(all));
        tool.motion = FollowKeyFrames{std::move(all)};
    } else if (velocity || !angularVelocity.isZero(0)) {
        tool.motion = DriveAt{velocity.value_or(Vec3::Zero()), angularVelocity};
    }
    const ToolId id = withoutLock([&] { return simulation->addTool(tool); });
    return {simulation, id};
}

void step(LiveSimulation& simulation, std::uint64_t steps)
{
    computing(py::none(), [&](TaskControl& control) { simulation.step(steps, control); });
}

/// Time goes on; every now and then the script may look.
void run(const LivePointer& simulation, double seconds, const py::object& callback, double every)
{
    if (!(seconds >= 0) || !(every > 0))
        throw py::value_error("run() takes seconds of 0 or more, and `every` above 0");
    const double start = withoutLock([&] { return simulation->time(); });
    const double end = start + seconds;
    for (std::uint64_t i = 1;; ++i) {
        const double next = callback.is_none() ? end : std::min(end, start + static_cast<double>(i) * every);
        computing(py::none(), [&](TaskControl& control) { simulation->advanceTo(next, control); });
        if (!callback.is_none() && callback(simulation).is(py::bool_(false)))
            return;
        if (next >= end)
            return;
    }
}

py::dict settle(LiveSimulation& simulation, double duration, py::object progress)
{
    const StaticReport report =
        computing(std::move(progress), [&](TaskControl& control) { return simulation.settle(duration, control); });
    return py::dict(py::arg("residual") = report.residual, py::arg("iterations") = report.iterations);
}

py::object exportTo(LiveSimulation& simulation, const std::filesystem::path& path, const std::string& unit,
                    double tolerance, bool ap214, bool text, py::object progress)
{
    const ExportOptions options{.unit = unit, .tolerance = tolerance, .useAp214 = ap214, .isText = text};
    const WrittenExports written =
        computing(std::move(progress), [&](TaskControl& control) { return simulation.write(path, options, control); });
    return written.reports.empty() ? py::none() : fromJson(reportToJson(written.reports.front()));
}

py::dict energyOf(LiveSimulation& simulation)
{
    const SeenStatePointer state = withoutLock([&] { return simulation.state(); });
    const EnergyLedger& energy = state->snapshot().energy;
    return py::dict(py::arg("kinetic") = energy.kinetic, py::arg("elastic") = energy.elastic,
                    py::arg("gravity") = energy.gravity, py::arg("tool_work") = energy.toolWork,
                    py::arg("dissipated") = energy.dissipated(), py::arg("imbalance") = energy.imbalance);
}

struct KeptMoment {
    MomentPointer moment;
    std::weak_ptr<LiveSimulation> simulation; ///< that it is of
};

KeptMoment keep(LiveSimulation& simulation)
{
    return withoutLock([&] { return KeptMoment{simulation.keepMoment(), simulation.weak_from_this()}; });
}

void goBackTo(LiveSimulation& simulation, const KeptMoment& kept)
{
    if (kept.simulation.lock().get() != &simulation)
        throw Problem(Message("Python", "This moment is of another simulation; go to one that this one has kept."));
    withoutLock([&] { simulation.goTo(kept.moment); });
}

void bindContents(SimulationType& type)
{
    type.def_property_readonly("bodies", &bodiesOf, "Its bodies, in the order of its fillings.")
        .def("fix", &fix, py::arg("body") = 0, py::kw_only(), py::arg("box") = py::none(),
             py::arg("faces") = std::vector<std::uint32_t>(), py::arg("objects") = std::vector<ObjectIndex>(),
             py::arg("name") = "fixture", py::arg("velocity") = Vec3(Vec3::Zero()),
             "Holds the objects of a body, by its number, that lie in a box (lowest corner, highest corner) [m] at "
             "rest, and at "
             "CAD faces, and those that are named by their numbers; with a velocity [m/s] a grip pulls them along. "
             "Raises Error when none lies there.")
        .def("add_tool", &addTool, py::arg("kind"), py::arg("size"), py::arg("position"), py::kw_only(),
             py::arg("rotation") = py::none(), py::arg("name") = "", py::arg("keyframes") = std::vector<py::tuple>(),
             py::arg("velocity") = py::none(), py::arg("angular_velocity") = Vec3(Vec3::Zero()),
             py::arg("friction") = 0.4, py::arg("adhesion") = 0.0, py::arg("speed_limit") = 0.5,
             py::arg("force_limit") = py::none(), py::arg("rolls") = false,
             "Adds a rigid tool: \"box\", \"ball\" (size: its diameter), \"cylinder\" (diameter, length), \"wedge\" or "
             "\"plate\", "
             "sizes and the place of its center in m, turned by a quaternion (w, x, y, z). It stands still, follows "
             "keyframes "
             "(time [s], position, perhaps rotation), or drives at a velocity [m/s, rad/s]. friction 0 .. 2, adhesion "
             "[Pa], "
             "speed_limit [m/s], force_limit [N]; `rolls`: a ball or cylinder turns freely over material.");
}

void bindTime(SimulationType& type)
{
    type.def(
        "step_to",
        [](LiveSimulation& simulation, std::uint64_t steps) {
            computing(py::none(), [&](TaskControl& control) { simulation.stepTo(steps, control); });
        },
        py::arg("step"),
        "Goes on until so many steps were taken since the start, as the trace of a session counts them. Ctrl+C as "
        "step(). Raises Error where they were taken before, and where there is numerical trouble on the way.");
    type.def("step", &step, py::arg("steps") = 1,
             "Goes on by so many steps of `time_step`. Ctrl+C stops between two of them, and the simulation may go on "
             "afterwards. Raises Error on numerical trouble; the state is then the last good one.")
        .def("run", &run, py::arg("seconds"), py::arg("callback") = py::none(), py::arg("every") = betweenCallbacks,
             "Goes on until the step nearest to so many seconds from now. `callback(simulation)` is called after every "
             "so many "
             "seconds of simulated time; it may look, add and move things, and returns False to end. Ctrl+C and errors "
             "as "
             "step().")
        .def("settle", &settle, py::arg("duration") = betweenCallbacks, py::arg("progress") = py::none(),
             "Puts the objects where there is balance without inertia; time goes on by the duration [s]. Raises Error "
             "when there "
             "is none, and changes nothing then.")
        .def(
            "reset", [](LiveSimulation& simulation) { withoutLock([&] { simulation.carryOut(Reset{}); }); },
            "Back to the start, with the present materials and fixtures.")
        .def("keep", &keep, "Keeps the state of now, for go_to().")
        .def("go_to", &goBackTo, py::arg("moment"),
             "Goes on from a moment that this simulation has kept, bit for bit. Raises Error for one of another.")
        .def_property_readonly(
            "time", [](LiveSimulation& simulation) { return withoutLock([&] { return simulation.time(); }); },
            "Simulated so far [s].")
        .def_property_readonly(
            "time_step", [](LiveSimulation& simulation) { return withoutLock([&] { return simulation.timeStep(); }); },
            "Of the next step [s].")
        .def_property_readonly(
            "steps", [](LiveSimulation& simulation) { return withoutLock([&] { return simulation.stepCount(); }); },
            "Taken so far.")
        .def_property_readonly(
            "state_hash",
            [](LiveSimulation& simulation) { return hexadecimal(withoutLock([&] { return simulation.stateHash(); })); },
            "Of the bits of positions and velocities: equal for equal histories on any number of threads, and what "
            "`knead run --json` prints.")
        .def_property_readonly("energy", &energyOf,
                               "Energies so far [J]. `tool_work` is done by tools, grips and loads.");
}

} // namespace

void bindBodies(py::module_& module);
void bindTools(py::module_& module);
void bindCommands(SimulationType& type);
void bindToolParts(py::module_& module);

void bindSimulation(py::module_& module)
{
    bindBodies(module);
    bindTools(module);
    bindToolParts(module);
    py::class_<KeptMoment>(module, "Moment", "A state of a simulation that was kept.")
        .def_property_readonly(
            "time", [](const KeptMoment& kept) { return kept.moment->steps.time; }, "When that was [s].");
    SimulationType type(module, "Simulation",
                        "Fillings with fixtures and tools, step by step. It uses all cores, and leaves the interpreter "
                        "to other threads while it computes, who may look and act "
                        "between two steps.");
    type.def(py::init(&simulationOf), py::arg("fillings"), py::kw_only(), py::arg("gravity") = Vec3(Vec3::Zero()),
             py::arg("floor") = py::none(), py::arg("floor_friction") = 0.4, py::arg("floor_adhesion") = 0.0,
             py::arg("integrator") = "automatic", py::arg("time_step") = py::none(), py::arg("glued") = false,
             py::arg("refilling") = true, py::arg("vicinity") = nameOf(Scene{}.vicinity),
             py::arg("mass_scaling_time_step") = py::none(),
             "gravity [m/s^2]; floor: z of a fixed floor [m], floor_friction 0 .. 2, floor_adhesion [Pa]; integrator: "
             "\"automatic\", \"semi-implicit-euler\", \"implicit-euler\", \"forward-euler\"; time_step [s] instead of "
             "the largest "
             "stable one; glued: bodies that touch at the start are one; refilling: material that yields is filled "
             "anew where "
             "its cells are no good any more; vicinity: how contacts are looked for, \"uniform-grid\" ..., which "
             "changes nothing else; mass_scaling_time_step [s]: what would need a shorter step gets more mass.");
    bindContents(type);
    bindCommands(type);
    bindTime(type);
    type.def("export", &exportTo, py::arg("path"), py::kw_only(), py::arg("unit") = "", py::arg("tolerance") = 0.0,
             py::arg("ap214") = false, py::arg("text") = false, py::arg("progress") = py::none(),
             "Writes all bodies as they are now. The ending is the format: STEP, IGES and BREP with smooth faces, "
             "meshes, or a "
             "picture (.png). unit: \"mm\", \"m\", \"inch\" ...; tolerance: largest distance between faces and skin "
             "[m], 0: 1e-4 of "
             "the size. Returns what was found when the file was read back, None for a picture. Raises Error.");
}

} // namespace knead::python
