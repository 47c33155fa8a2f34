#include "io/trace/trace_calls.h"

#include "core/message/message.h"
#include "io/project/command_json.h"
#include "io/recipe/recipe_places.h"
#include "io/recipe/scene_words.h"

#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace knead {

namespace py = python_text;

namespace {

constexpr const char* noTurn = "(1, 0, 0, 0)";

std::string wordOfTool(ToolKind kind)
{
    return py::text(std::string(nameOf(kind)));
}

std::string measuresText(ToolKind kind, const Vec3& size)
{
    if (kind == ToolKind::ball)
        return py::number(size.x());
    if (kind == ToolKind::cylinder)
        return '(' + py::number(size.x()) + ", " + py::number(size.z()) + ')';
    return py::tuple(size);
}

/// Whether the size is one that the form can have.
bool fits(ToolKind kind, const Vec3& size)
{
    return kind != ToolKind::part && fittingSize(kind, size) == size;
}

std::string framesText(const std::vector<KeyFrame>& frames, std::size_t first)
{
    std::string text;
    for (std::size_t i = first; i < frames.size(); ++i)
        text += (i > first ? ", (" : "(") + py::number(frames[i].time) + ", " + py::tuple(frames[i].pose.position) +
                ", " + py::tuple(frames[i].pose.rotation) + ')';
    return '[' + text + ']';
}

bool isFrameAt(const KeyFrame& frame, double time, const Pose& pose)
{
    return frame.time == time && frame.pose.position == pose.position &&
           frame.pose.rotation.coeffs() == pose.rotation.coeffs();
}

/// Whether add_tool() can say how it moves.
bool canBeginWith(const Motion& motion, const Pose& pose)
{
    if (const auto* follow = std::get_if<FollowKeyFrames>(&motion))
        return follow->frames.size() > 1 && isFrameAt(follow->frames.front(), 0, pose);
    return !std::holds_alternative<GoTo>(motion);
}

std::string limitText(double limit)
{
    return std::isinf(limit) ? "None" : py::number(limit);
}

} // namespace

struct TraceCalls::Words {
    TraceCalls& calls;
    const RecordedCommand& recorded;

    /// Of what the script has a variable for; else as it is.
    TraceCall on(const std::vector<std::string>& all, std::uint32_t id, const char* method, std::string arguments = {},
                 bool isOfMany = false) const
    {
        if (id >= all.size())
            return asItIs();
        return {.action = all[id] + '.' + method, .arguments = std::move(arguments), .isOfMany = isOfMany};
    }
    TraceCall onTool(ToolId id, const char* method, std::string arguments = {}, bool isOfMany = false) const
    {
        return on(calls.m_variables->tools, id, method, std::move(arguments), isOfMany);
    }
    TraceCall onFixture(FixtureId id, const char* method, std::string arguments = {}, bool isOfMany = false) const
    {
        return on(calls.m_variables->fixtures, id, method, std::move(arguments), isOfMany);
    }

    static TraceCall sim(const char* method, const py::Arguments& arguments)
    {
        return {.action = std::string("sim.") + method, .arguments = arguments.all()};
    }

    /// As a project keeps it.
    TraceCall asItIs() const
    {
        const std::size_t known = calls.m_parts.parts().size();
        const std::string json = commandToJson(recorded.command, calls.m_parts);
        py::Arguments arguments;
        arguments.add(py::literal(json));
        TraceCall call;
        if (json.find("\"tool_part\": ") != std::string::npos) {
            const std::string& project = calls.m_start->choices.projectPath;
            if (project.empty() || calls.m_parts.parts().size() > known)
                throw Problem(Message("Trace", "A tool is an imported part, which only a saved project keeps: save the "
                                               "project first."));
            if (!std::exchange(calls.m_hasParts, true))
                call.before = "tool_parts = knead.tool_parts(" + py::path(project) + ")\n";
            arguments.add("tool_parts");
        }
        call.action = "sim.carry_out";
        call.arguments = arguments.all();
        return call;
    }

    TraceCall named(std::vector<std::string> Variables::*all, const std::string& name, const char* other,
                    TraceCall call) const
    {
        auto variables = std::make_shared<Variables>(*calls.m_variables);
        call.result = ((*variables).*all).emplace_back(variables->names.add(name, other));
        calls.m_variables = std::move(variables);
        return call;
    }

    TraceCall operator()(const SetMaterial& c) const
    {
        py::Arguments arguments;
        arguments.add(py::material(c.material, calls.m_start->choices.presets)).addUnless(0, "body", c.body);
        if (!c.objects.empty())
            arguments.add("objects", py::list(c.objects));
        return sim("set_material", arguments);
    }
    TraceCall operator()(const SetBodyKind& c) const
    {
        return sim("set_body_kind",
                   py::Arguments().add(py::text(wordFor(c.kind, bodyKindWords()))).addUnless(0, "body", c.body));
    }
    TraceCall operator()(const Renormalize& c) const
    {
        py::Arguments arguments;
        arguments.add(std::to_string(c.body));
        if (!c.objects.empty())
            arguments.add("objects", py::list(c.objects));
        return sim("renormalize", arguments.addUnless(0, "duration", c.duration));
    }
    TraceCall operator()(const SetGravity& c) const
    {
        return sim("set_gravity", py::Arguments().add(py::tuple(c.gravity)));
    }
    TraceCall operator()(const SetFloor& c) const
    {
        return sim("set_floor", py::Arguments()
                                    .add(c.height ? py::number(*c.height) : "None")
                                    .addUnless(SetFloor{}.friction, "friction", c.friction)
                                    .addUnless(SetFloor{}.adhesion, "adhesion", c.adhesion));
    }
    TraceCall operator()(const AddManipulator& c) const
    {
        const Manipulator& tool = c.manipulator;
        const bool canBeSaid = fits(tool.kind, tool.size) && canBeginWith(tool.motion, tool.pose);
        return named(&Variables::tools, tool.name, "tool", canBeSaid ? adding(tool) : asItIs());
    }
    static TraceCall adding(const Manipulator& tool)
    {
        const Manipulator usual;
        py::Arguments arguments;
        arguments.add(wordOfTool(tool.kind))
            .add(measuresText(tool.kind, tool.size))
            .add(py::tuple(tool.pose.position))
            .addUnless(noTurn, "rotation", py::tuple(tool.pose.rotation))
            .add("name", py::text(tool.name))
            .addUnless(usual.friction, "friction", tool.friction)
            .addUnless(usual.adhesion, "adhesion", tool.adhesion)
            .addUnless(usual.speedLimit, "speed_limit", tool.speedLimit)
            .addUnless("None", "force_limit", limitText(tool.forceLimit));
        if (tool.rollsFreely)
            arguments.add("rolls", "True");
        if (const auto* drive = std::get_if<DriveAt>(&tool.motion))
            arguments.add("velocity", py::tuple(drive->velocity))
                .addUnless(py::zeros, "angular_velocity", py::tuple(drive->angularVelocity));
        if (const auto* follow = std::get_if<FollowKeyFrames>(&tool.motion))
            arguments.add("keyframes", framesText(follow->frames, 1));
        return sim("add_tool", arguments);
    }
    TraceCall operator()(const RemoveManipulator& c) const { return onTool(c.tool, "remove"); }
    TraceCall operator()(const SetManipulatorMotion& c) const
    {
        if (const auto* to = std::get_if<GoTo>(&c.motion))
            return onTool(c.tool, "go_to", poseText(to->target), true);
        if (const auto* drive = std::get_if<DriveAt>(&c.motion))
            return onTool(c.tool, "drive", py::tuple(drive->velocity) + ", " + py::tuple(drive->angularVelocity), true);
        if (const auto* follow = std::get_if<FollowKeyFrames>(&c.motion))
            return onTool(c.tool, "follow", framesText(follow->frames, 0), true);
        return onTool(c.tool, "hold", {}, true);
    }
    static std::string poseText(const Pose& pose) { return py::tuple(pose.position) + ", " + py::tuple(pose.rotation); }
    TraceCall operator()(const ReshapeManipulator& c) const
    {
        if (!fits(c.kind, c.size))
            return asItIs();
        py::Arguments arguments;
        arguments.add(wordOfTool(c.kind))
            .add(measuresText(c.kind, c.size))
            .add("friction", py::number(c.friction))
            .addUnless(0, "adhesion", c.adhesion)
            .add("speed_limit", py::number(c.speedLimit))
            .addUnless("None", "force_limit", limitText(c.forceLimit))
            .addUnless("False", "rolls", c.rollsFreely ? "True" : "False");
        return onTool(c.tool, "reshape", arguments.all());
    }
    TraceCall operator()(const PlaceManipulator& c) const { return onTool(c.tool, "place", poseText(c.pose), true); }
    TraceCall operator()(const AddFixture& c) const
    {
        const Fixture& fixture = c.fixture;
        const bool canBeSaid = !fixture.turn.turns() && !fixture.objects.empty();
        return named(&Variables::fixtures, fixture.name, "fixture", canBeSaid ? holding(fixture) : asItIs());
    }
    TraceCall holding(const Fixture& fixture) const
    {
        py::Arguments arguments;
        arguments.add(std::to_string(fixture.body));
        const RecipeRegion place = recorded.objectsInBody > 0
                                       ? laterPlaceOf(recorded.objectsInBody, fixture.objects)
                                       : placeOf(calls.m_start->aggregateOf(fixture.body),
                                                 &calls.m_start->partOf(fixture.body).mesh, fixture.objects);
        if (place.objects)
            arguments.add("objects", py::list(place.objects->numbers));
        else if (place.box)
            arguments.add("box", '(' + py::tuple(place.box->min()) + ", " + py::tuple(place.box->max()) + ')');
        else
            arguments.add("faces", py::list(place.faces));
        return sim("fix", arguments.add("name", py::text(fixture.name))
                              .addUnless(py::zeros, "velocity", py::tuple(fixture.velocity)));
    }
    TraceCall operator()(const RemoveFixture& c) const { return onFixture(c.fixture, "release"); }
    TraceCall operator()(const MoveFixture& c) const
    {
        py::Arguments arguments;
        arguments.add(py::tuple(c.velocity));
        if (c.turn.turns()) {
            arguments.add(py::tuple(c.turn.center)).add(py::tuple(c.turn.angularVelocity));
            if (!std::isinf(c.turn.angle))
                arguments.add(py::number(c.turn.angle));
        }
        return onFixture(c.fixture, "move", arguments.all(), true);
    }
    TraceCall operator()(const SetIntegrator& c) const
    {
        return sim("set_integrator", py::Arguments().add(py::text(wordFor(c.integrator, integratorWords()))));
    }
    TraceCall operator()(const SetPace& c) const
    {
        TraceCall call = sim("set_pace", py::Arguments().add(py::text(wordFor(c.pace, paceWords()))));
        call.isOfMany = true;
        return call;
    }
    TraceCall operator()(const Reset&) const { return sim("reset", {}); }
    TraceCall operator()(const KeepMoment&) const { return sim("keep", {}); }
    TraceCall operator()(const SetPartLook&) const { return asItIs(); }
    TraceCall operator()(const RenameManipulator& c) const { return onTool(c.tool, "rename", py::text(c.name)); }
    TraceCall operator()(const RenameFixture& c) const { return onFixture(c.fixture, "rename", py::text(c.name)); }
    TraceCall operator()(const AddLoad&) const { return asItIs(); }
    TraceCall operator()(const RemoveLoad&) const { return asItIs(); }
    TraceCall operator()(const SetLoad&) const
    {
        TraceCall call = asItIs();
        call.isOfMany = true;
        return call;
    }
    TraceCall operator()(const FindBalance& c) const
    {
        return sim("settle", py::Arguments().add(py::number(c.duration)));
    }
    TraceCall operator()(const Refill& c) const
    {
        return sim("refill", py::Arguments().add(std::to_string(c.body)).addUnless(0, "spacing", c.spacing));
    }
    TraceCall operator()(const Cut& c) const
    {
        return sim("cut",
                   py::Arguments().add(py::tuple(c.point)).add(py::tuple(c.normal)).addUnless(0, "body", c.body));
    }
};

TraceCalls::TraceCalls(std::shared_ptr<const TraceStart> start, py::Names names)
    : m_start(std::move(start))
    , m_variables(std::make_shared<const Variables>(Variables{.names = std::move(names)}))
{
    for (const std::shared_ptr<const ToolPart>& part : m_start->toolParts)
        m_parts.add(part);
}

TraceCall TraceCalls::of(const RecordedCommand& recorded)
{
    return std::visit(Words{*this, recorded}, recorded.command);
}

} // namespace knead
