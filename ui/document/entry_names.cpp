#include "ui/document/entry_names.h"

#include "ui/language/said.h"
#include "ui/units.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <variant>

namespace knead {

namespace {

/// Names what commands do.
class Namer {
public:
    Namer(const FilledModel& content, const Snapshot& now)
        : m_content(content)
        , m_now(now)
    {
    }

    Message operator()(const SetMaterial& command) const
    {
        return Message("EntryNames", "Material of %1").with(body(command.body));
    }
    Message operator()(const SetBodyKind& command) const
    {
        return (command.kind == BodyKind::rigid  ? Message("EntryNames", "%1 becomes rigid")
                : command.kind == BodyKind::glue ? Message("EntryNames", "%1 becomes glue")
                                                 : Message("EntryNames", "%1 becomes deformable"))
            .with(body(command.body));
    }
    Message operator()(const Renormalize&) const { return Message("EntryNames", "Re-normalize"); }
    Message operator()(const SetGravity& command) const
    {
        return command.gravity.isZero() ? Message("EntryNames", "Gravity off") : Message("EntryNames", "Gravity on");
    }
    Message operator()(const SetFloor& command) const
    {
        return command.height ? Message("EntryNames", "Floor on") : Message("EntryNames", "Floor off");
    }
    Message operator()(const AddManipulator& command) const
    {
        return Message("EntryNames", "Add %1").with(command.manipulator.name);
    }
    Message operator()(const RemoveManipulator& command) const
    {
        return Message("EntryNames", "Remove %1").with(tool(command.tool));
    }
    Message operator()(const SetManipulatorMotion& command) const
    {
        return std::holds_alternative<HoldStill>(command.motion)
                   ? Message("EntryNames", "Stop %1").with(tool(command.tool))
                   : Message("EntryNames", "Push with %1").with(tool(command.tool));
    }
    Message operator()(const ReshapeManipulator& command) const
    {
        return Message("EntryNames", "Change %1").with(tool(command.tool));
    }
    Message operator()(const PlaceManipulator& command) const
    {
        return Message("EntryNames", "Move %1").with(tool(command.tool));
    }
    Message operator()(const AddFixture& command) const
    {
        return Message("EntryNames", "Fix %1").with(command.fixture.name);
    }
    Message operator()(const RemoveFixture& command) const
    {
        return Message("EntryNames", "Remove %1").with(fixture(command.fixture));
    }
    Message operator()(const MoveFixture& command) const
    {
        return Message("EntryNames", "Move %1").with(fixture(command.fixture));
    }
    Message operator()(const SetIntegrator& command) const
    {
        switch (command.integrator) {
        case Integrator::semiImplicitEuler:
            return Message("EntryNames", "Semi-implicit steps");
        case Integrator::forwardEuler:
            return Message("EntryNames", "Forward steps");
        case Integrator::implicitEuler:
            return Message("EntryNames", "Implicit steps");
        case Integrator::automatic:
            break;
        }
        return Message("EntryNames", "Automatic steps");
    }
    Message operator()(const SetPace&) const { return {}; } // by itself, to keep up
    Message operator()(const Reset&) const { return Message("EntryNames", "Reset"); }
    Message operator()(const KeepMoment&) const { return {}; }
    Message operator()(const SetPartLook& command) const
    {
        return command.name.empty() ? Message("EntryNames", "Look of a part")
                                    : Message("EntryNames", "Look of %1").with(command.name);
    }
    Message operator()(const RenameManipulator& command) const
    {
        return Message("EntryNames", "Rename to %1").with(command.name);
    }
    Message operator()(const AddLoad& command) const { return Message("EntryNames", "Add %1").with(command.load.name); }
    Message operator()(const RemoveLoad& /*command*/) const { return Message("EntryNames", "Remove %1").with(load()); }
    Message operator()(const Refill& command) const
    {
        return Message("EntryNames", "Refill %1").with(body(command.body));
    }
    Message operator()(const Cut& command) const { return Message("EntryNames", "Cut %1").with(body(command.body)); }
    Message operator()(const FindBalance& /*command*/) const { return Message("EntryNames", "Find balance"); }
    Message operator()(const SetLoad& /*command*/) const { return Message("EntryNames", "Change %1").with(load()); }
    Message operator()(const RenameFixture& command) const
    {
        return Message("EntryNames", "Rename to %1").with(command.name);
    }

private:
    static Message load() { return Message("EntryNames", "the load"); }
    Message body(BodyId id) const
    {
        return id < m_content.bodies.size() ? Message::verbatim(m_content.bodies[id]->name)
                                            : Message("EntryNames", "the body");
    }
    Message tool(ToolId id) const
    {
        const auto found =
            std::find_if(m_now.tools.begin(), m_now.tools.end(), [id](const ToolState& tool) { return tool.id == id; });
        return found == m_now.tools.end() ? Message("EntryNames", "the tool") : Message::verbatim(found->name);
    }
    Message fixture(FixtureId id) const
    {
        const auto found = std::find(m_now.fixtureIds.begin(), m_now.fixtureIds.end(), id);
        return found == m_now.fixtureIds.end()
                   ? Message("EntryNames", "the fixture")
                   : Message::verbatim(m_now.fixtures[static_cast<std::size_t>(found - m_now.fixtureIds.begin())].name);
    }

    const FilledModel& m_content;
    const Snapshot& m_now;
};

/// What a command is about; nothing for one that only goes with others.
std::optional<EntryKind> kindOf(const Command& command)
{
    switch (command.index()) { // in the order of Command
    case 0:
    case 1:
        return EntryKind::Material;
    case 2:
        return EntryKind::Renormalize;
    case 3:
    case 4:
    case 13:
        return EntryKind::Scene;
    case 5:
        return EntryKind::AddTool;
    case 6:
        return EntryKind::RemoveTool;
    case 7:
        return EntryKind::Push;
    case 8:
    case 9:
        return EntryKind::MoveTool;
    case 10:
    case 11:
    case 12:
    case 19:
    case 20:
    case 21:
        return EntryKind::Fixture;
    case 22:
        return EntryKind::Balance;
    case 25:
        return EntryKind::Cut;
    case 24:
        return EntryKind::Start;
    case 14:
        return EntryKind::Reset;
    case 16:
    case 17:
    case 18:
        return EntryKind::Look;
    default:
        return {};
    }
}
static_assert(std::variant_size_v<Command> == 26);

} // namespace

EntryKind kindOf(const HistoryRecord& record, bool beginsStart)
{
    if (beginsStart)
        return EntryKind::Start;
    for (const RecordedCommand& recorded : record.commands)
        if (const auto kind = kindOf(recorded.command))
            return *kind;
    return EntryKind::Simulate;
}

const char* iconOf(EntryKind kind)
{
    switch (kind) {
    case EntryKind::Start:
        return "open";
    case EntryKind::Simulate:
        return "play";
    case EntryKind::Push:
        return "push";
    case EntryKind::AddTool:
        return "add-block";
    case EntryKind::MoveTool:
        return "block";
    case EntryKind::RemoveTool:
        return "delete";
    case EntryKind::Material:
        return "material";
    case EntryKind::Fixture:
        return "fix";
    case EntryKind::Renormalize:
        return "renormalize";
    case EntryKind::Balance:
        return "balance";
    case EntryKind::Cut:
        return "cut";
    case EntryKind::Reset:
        return "reset";
    case EntryKind::Look:
        return "rename";
    case EntryKind::Scene:
        break;
    }
    return "gravity";
}

Message nameOf(const Command& command, const FilledModel& content, const Snapshot& now)
{
    return std::visit(Namer(content, now), command);
}

Message simulatedName(double seconds)
{
    return Message("EntryNames", "Simulate %1").with(timePhrase(seconds));
}

Message timePhrase(double seconds)
{
    const auto number = [](double value, int digits) { return localNumber(value, 'f', digits).toStdString(); };
    if (seconds == 0)
        return Message("EntryNames", "0 s");
    if (std::abs(seconds) < 0.0995)
        return Message("EntryNames", "%1 ms").with(number(1000 * seconds, std::abs(seconds) < 0.00995 ? 1 : 0));
    return Message("EntryNames", "%1 s").with(number(seconds, std::abs(seconds) < 9.95 ? 2 : 1));
}

QString timeText(double seconds)
{
    return said(timePhrase(seconds));
}

QString mergeKeyOf(const Command& command)
{
    const auto* place = std::get_if<PlaceManipulator>(&command);
    return place == nullptr ? QString() : QStringLiteral("place %1").arg(place->tool);
}

} // namespace knead
