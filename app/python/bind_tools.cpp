#include "app/python/bindings.h"
#include "app/python/handles.h"
#include "app/python/tool_words.h"
#include "core/message/message.h"

#include <pybind11/eigen.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <limits>
#include <utility>

namespace py = pybind11;

namespace knead::python {

namespace {

/// A tool as it was seen last.
ToolState seenTool(const ToolHandle& handle)
{
    const SeenStatePointer state = withoutLock([&] { return handle.simulation->state(); });
    const std::vector<ToolState>& tools = state->snapshot().tools;
    const auto found = std::ranges::find(tools, handle.tool, &ToolState::id);
    if (found == tools.end())
        throw Problem(Message("Python", "This tool is no longer in the simulation."));
    return *found;
}

/// What something did in the last step; nothing before the first.
Reaction lastReaction(LiveSimulation& simulation, Reaction::Kind kind, std::uint32_t id)
{
    const std::vector<Reaction> all = withoutLock([&] { return simulation.reactions(); });
    for (const Reaction& reaction : all)
        if (reaction.kind == kind && reaction.id == id)
            return reaction;
    return {};
}

Reaction lastReaction(const ToolHandle& handle)
{
    return lastReaction(*handle.simulation, Reaction::Kind::tool, handle.tool);
}
Reaction lastReaction(const FixtureHandle& handle)
{
    return lastReaction(*handle.simulation, Reaction::Kind::fixture, handle.fixture);
}

void setMotion(const ToolHandle& handle, Motion motion)
{
    withoutLock([&] { handle.simulation->carryOut(SetManipulatorMotion{handle.tool, std::move(motion)}); });
}

/// As it is turned now, where a script does not say how.
Pose posed(const ToolHandle& handle, const Vec3& position, const std::optional<RotationWords>& rotation)
{
    return poseOf(position, rotation, rotation ? Quaternion::Identity() : seenTool(handle).pose.rotation);
}

void goTo(const ToolHandle& handle, const Vec3& position, const std::optional<RotationWords>& rotation)
{
    setMotion(handle, GoTo{posed(handle, position, rotation)});
}

void place(const ToolHandle& handle, const Vec3& position, const std::optional<RotationWords>& rotation)
{
    const Pose pose = posed(handle, position, rotation);
    withoutLock([&] { handle.simulation->carryOut(PlaceManipulator{handle.tool, pose}); });
}

void reshape(const ToolHandle& handle, const std::string& kind, const SizeWords& size, double friction, double adhesion,
             double speedLimit, std::optional<double> forceLimit, bool rolls)
{
    const ToolKind form = toolKindCalled(kind);
    const ReshapeManipulator command{.tool = handle.tool,
                                     .size = sizeOf(form, size),
                                     .friction = friction,
                                     .speedLimit = speedLimit,
                                     .forceLimit = forceLimit.value_or(std::numeric_limits<double>::infinity()),
                                     .kind = form,
                                     .part = nullptr,
                                     .adhesion = adhesion,
                                     .rollsFreely = rolls};
    withoutLock([&] { handle.simulation->carryOut(command); });
}

void move(const FixtureHandle& handle, const Vec3& velocity, const std::optional<Vec3>& center,
          const Vec3& angularVelocity, std::optional<double> angle)
{
    MoveFixture command{handle.fixture, velocity, {}};
    if (!angularVelocity.isZero(0)) {
        if (!center)
            throw py::type_error("a grip turns about a center");
        command.turn = {*center, angularVelocity, angle.value_or(std::numeric_limits<double>::infinity())};
    }
    withoutLock([&] { handle.simulation->carryOut(command); });
}

} // namespace

void bindTools(py::module_& module)
{
    py::class_<ToolHandle>(module, "Tool", "A rigid tool of a simulation.")
        .def_property_readonly("name", [](const ToolHandle& handle) { return seenTool(handle).name; })
        .def_property_readonly(
            "position", [](const ToolHandle& handle) { return seenTool(handle).pose.position; }, "Of its center [m].")
        .def_property_readonly(
            "rotation", [](const ToolHandle& handle) { return wordsOf(seenTool(handle).pose.rotation); },
            "A quaternion (w, x, y, z).")
        .def_property_readonly(
            "force", [](const ToolHandle& handle) { return lastReaction(handle).force; },
            "Of the material on it in the last step [N].")
        .def_property_readonly(
            "moment", [](const ToolHandle& handle) { return lastReaction(handle).moment; },
            "The same about its center [N m].")
        .def_property_readonly(
            "peak_force", [](const ToolHandle& handle) { return seenTool(handle).peakForce; },
            "The largest so far, means over what passed between two looks at the state [N].")
        .def(
            "hold", [](const ToolHandle& handle) { setMotion(handle, HoldStill{}); }, "Stands still from now on.")
        .def(
            "drive",
            [](const ToolHandle& handle, const Vec3& velocity, const Vec3& angularVelocity) {
                setMotion(handle, DriveAt{velocity, angularVelocity});
            },
            py::arg("velocity"), py::arg("angular_velocity") = Vec3(Vec3::Zero()),
            "Moves on at a velocity [m/s] and turns [rad/s, axes of the world] until told otherwise.")
        .def("go_to", &goTo, py::arg("position"), py::arg("rotation") = py::none(),
             "Goes to a place [m] in a straight line, no faster than its speed limit.")
        .def(
            "follow",
            [](const ToolHandle& handle, const std::vector<py::tuple>& frames) {
                setMotion(handle, FollowKeyFrames{framesOf(frames, seenTool(handle).pose)});
            },
            py::arg("keyframes"),
            "Follows (time, position) or (time, position, rotation), evenly between them; times of the simulation [s], "
            "ascending, places [m].")
        .def("place", &place, py::arg("position"), py::arg("rotation") = py::none(),
             "Is there at once [m], without pushing on the way, and stands still.")
        .def("reshape", &reshape, py::arg("kind"), py::arg("size"), py::kw_only(), py::arg("friction") = 0.4,
             py::arg("adhesion") = 0.0, py::arg("speed_limit") = 0.5, py::arg("force_limit") = py::none(),
             py::arg("rolls") = false, "Has another form from now on, said as in Simulation.add_tool().")
        .def(
            "rename",
            [](const ToolHandle& handle, const std::string& name) {
                withoutLock([&] { handle.simulation->carryOut(RenameManipulator{handle.tool, name}); });
            },
            py::arg("name"), "Is called so from now on.")
        .def(
            "remove",
            [](const ToolHandle& handle) {
                withoutLock([&] { handle.simulation->carryOut(RemoveManipulator{handle.tool}); });
            },
            "Takes it away.");

    py::class_<FixtureHandle>(module, "Fixture", "Objects that are held in place, or by a grip that moves.")
        .def_property_readonly(
            "force", [](const FixtureHandle& handle) { return lastReaction(handle).force; },
            "Of the material on it in the last step [N].")
        .def_property_readonly(
            "moment", [](const FixtureHandle& handle) { return lastReaction(handle).moment; },
            "The same about `center` [N m].")
        .def_property_readonly(
            "center", [](const FixtureHandle& handle) { return lastReaction(handle).about; },
            "The middle of its objects at rest [m].")
        .def("move", &move, py::arg("velocity"), py::arg("center") = py::none(),
             py::arg("angular_velocity") = Vec3(Vec3::Zero()), py::arg("angle") = py::none(),
             "Pulls its objects along at a velocity [m/s], and turns them about a center [m] that goes along, at an "
             "angular velocity [rad/s], until an angle [rad].")
        .def(
            "rename",
            [](const FixtureHandle& handle, const std::string& name) {
                withoutLock([&] { handle.simulation->carryOut(RenameFixture{handle.fixture, name}); });
            },
            py::arg("name"), "Is called so from now on.")
        .def(
            "release",
            [](const FixtureHandle& handle) {
                withoutLock([&] { handle.simulation->carryOut(RemoveFixture{handle.fixture}); });
            },
            "Lets go.");
}

} // namespace knead::python
