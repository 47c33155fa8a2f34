#include "io/project/command_json.h"

#include "io/project/scene_fields.h"

namespace knead {

// --- the words and the fields of each command ---------------------------------------------------------------------------

template <>
inline constexpr const char* wordOf<SetMaterial> = "set-material";
template <class Fields>
void describe(Fields& fields, Field<Fields, SetMaterial> command)
{
    fields("body", command.body);
    fields("objects", command.objects);
    fields.object("material", command.material);
}

template <>
inline constexpr const char* wordOf<SetBodyKind> = "set-body-kind";
template <class Fields>
void describe(Fields& fields, Field<Fields, SetBodyKind> command)
{
    fields("body", command.body);
    fields.choice("kind", command.kind, bodyKindWords());
}

template <>
inline constexpr const char* wordOf<Renormalize> = "renormalize";
template <class Fields>
void describe(Fields& fields, Field<Fields, Renormalize> command)
{
    fields("body", command.body);
    fields("objects", command.objects);
    fields("duration_s", command.duration);
}

template <>
inline constexpr const char* wordOf<SetGravity> = "set-gravity";
template <class Fields>
void describe(Fields& fields, Field<Fields, SetGravity> command)
{
    fields("gravity_m_s2", command.gravity);
}

template <>
inline constexpr const char* wordOf<SetFloor> = "set-floor";
template <class Fields>
void describe(Fields& fields, Field<Fields, SetFloor> command)
{
    fields("height_m", command.height);
    fields("friction", command.friction);
    fields.numberIfAny("adhesion_pa", command.adhesion);
}

template <>
inline constexpr const char* wordOf<AddManipulator> = "add-manipulator";
template <class Fields>
void describe(Fields& fields, Field<Fields, AddManipulator> command)
{
    fields.object("manipulator", command.manipulator);
}

template <>
inline constexpr const char* wordOf<RemoveManipulator> = "remove-manipulator";
template <class Fields>
void describe(Fields& fields, Field<Fields, RemoveManipulator> command)
{
    fields("tool", command.tool);
}

template <>
inline constexpr const char* wordOf<SetManipulatorMotion> = "set-manipulator-motion";
template <class Fields>
void describe(Fields& fields, Field<Fields, SetManipulatorMotion> command)
{
    fields("tool", command.tool);
    describeVariant(fields, "motion", command.motion);
}

template <>
inline constexpr const char* wordOf<ReshapeManipulator> = "reshape-manipulator";
template <class Fields>
void describe(Fields& fields, Field<Fields, ReshapeManipulator> command)
{
    fields("tool", command.tool);
    fields.choice("kind", command.kind, toolKindWords());
    fields("size_m", command.size);
    fields("tool_part", command.part);
    fields("friction", command.friction);
    fields("speed_limit_m_s", command.speedLimit);
    fields("force_limit_n", command.forceLimit);
    fields.numberIfAny("adhesion_pa", command.adhesion);
    fields.flagIfSet("rolls_freely", command.rollsFreely);
}

template <>
inline constexpr const char* wordOf<PlaceManipulator> = "place-manipulator";
template <class Fields>
void describe(Fields& fields, Field<Fields, PlaceManipulator> command)
{
    fields("tool", command.tool);
    fields.object("pose", command.pose);
}

template <>
inline constexpr const char* wordOf<AddFixture> = "add-fixture";
template <class Fields>
void describe(Fields& fields, Field<Fields, AddFixture> command)
{
    fields.object("fixture", command.fixture);
}

template <>
inline constexpr const char* wordOf<RemoveFixture> = "remove-fixture";
template <class Fields>
void describe(Fields& fields, Field<Fields, RemoveFixture> command)
{
    fields("fixture", command.fixture);
}

template <>
inline constexpr const char* wordOf<MoveFixture> = "move-fixture";
template <class Fields>
void describe(Fields& fields, Field<Fields, MoveFixture> command)
{
    fields("fixture", command.fixture);
    fields("velocity_m_s", command.velocity);
    describeTurn(fields, command.turn);
}

template <>
inline constexpr const char* wordOf<SetIntegrator> = "set-integrator";
template <class Fields>
void describe(Fields& fields, Field<Fields, SetIntegrator> command)
{
    fields.choice("integrator", command.integrator, integratorWords());
}

template <>
inline constexpr const char* wordOf<SetPace> = "set-pace";
template <class Fields>
void describe(Fields& fields, Field<Fields, SetPace> command)
{
    fields.choice("pace", command.pace, paceWords());
}

template <>
inline constexpr const char* wordOf<Reset> = "reset";
template <>
inline constexpr const char* wordOf<KeepMoment> = "keep-moment";

template <>
inline constexpr const char* wordOf<FindBalance> = "find-balance";
template <class Fields>
void describe(Fields& fields, Field<Fields, FindBalance> command)
{
    fields("duration_s", command.duration);
}

template <>
inline constexpr const char* wordOf<Refill> = "refill";
template <class Fields>
void describe(Fields& fields, Field<Fields, Refill> command)
{
    fields("body", command.body);
    fields("spacing_m", command.spacing);
}

template <>
inline constexpr const char* wordOf<Cut> = "cut";
template <class Fields>
void describe(Fields& fields, Field<Fields, Cut> command)
{
    fields("body", command.body);
    fields("point_m", command.point);
    fields("normal", command.normal);
}

template <>
inline constexpr const char* wordOf<SetPartLook> = "set-part-look";
template <class Fields>
void describe(Fields& fields, Field<Fields, SetPartLook> command)
{
    fields("part", command.part);
    fields("name", command.name);
    fields("color", command.color);
}

template <>
inline constexpr const char* wordOf<RenameManipulator> = "rename-manipulator";
template <class Fields>
void describe(Fields& fields, Field<Fields, RenameManipulator> command)
{
    fields("tool", command.tool);
    fields("name", command.name);
}

template <>
inline constexpr const char* wordOf<RenameFixture> = "rename-fixture";
template <class Fields>
void describe(Fields& fields, Field<Fields, RenameFixture> command)
{
    fields("fixture", command.fixture);
    fields("name", command.name);
}

template <>
inline constexpr const char* wordOf<AddLoad> = "add-load";
template <class Fields>
void describe(Fields& fields, Field<Fields, AddLoad> command)
{
    fields.object("load", command.load);
}

template <>
inline constexpr const char* wordOf<RemoveLoad> = "remove-load";
template <class Fields>
void describe(Fields& fields, Field<Fields, RemoveLoad> command)
{
    fields("load", command.load);
}

template <>
inline constexpr const char* wordOf<SetLoad> = "set-load";
template <class Fields>
void describe(Fields& fields, Field<Fields, SetLoad> command)
{
    fields("load", command.load);
    fields.object("amount", command.amount);
    fields("ramp_s", command.ramp);
}

template <class Fields>
void describe(Fields& fields, Field<Fields, RecordedCommand> recorded)
{
    fields("step", recorded.step);
    describeVariant(fields, "command", recorded.command);
    fields.numberIfAny("objects_in_body", recorded.objectsInBody);
}

// --- lists of them ------------------------------------------------------------------------------------------------------

std::string commandsToJson(std::span<const RecordedCommand> commands, ToolPartTable& tools)
{
    FieldWriter fields(tools);
    std::string text;
    for (const RecordedCommand& command : commands) {
        describe(fields, command);
        text += (text.empty() ? "[" : ",\n") + fields.take();
    }
    return text.empty() ? "[]" : text + "]";
}

std::vector<RecordedCommand> commandsFromJson(const std::string& text, const std::string& source,
                                              const ToolPartTable& tools, std::size_t& longList)
{
    std::vector<RecordedCommand> commands;
    for (JsonNode& node : JsonNode::readText(text, source).items()) {
        const FieldReader fields(std::move(node), tools, longList);
        describe(fields, commands.emplace_back());
    }
    return commands;
}

// --- one of them ----------------------------------------------------------------------------------------------------------

std::string commandToJson(const Command& command, ToolPartTable& tools)
{
    FieldWriter fields(tools);
    describeVariant(fields, "command", command);
    return fields.take();
}

Command commandFromJson(const std::string& text, const std::string& source, const ToolPartTable& tools,
                        std::size_t& longList)
{
    const FieldReader fields(JsonNode::readText(text, source), tools, longList);
    Command command;
    describeVariant(fields, "command", command);
    return command;
}

} // namespace knead
