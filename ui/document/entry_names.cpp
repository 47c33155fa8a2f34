#include "ui/document/entry_names.h"

#include "ui/units.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>
#include <optional>
#include <variant>

namespace knead {

namespace {

struct Words {
    Q_DECLARE_TR_FUNCTIONS(EntryNames)
};

/// Names what commands do.
class Namer {
public:
    Namer(const FilledModel& content, const Snapshot& now)
        : m_content(content)
        , m_now(now)
    {
    }

    QString operator()(const SetMaterial& command) const { return Words::tr("Material of %1").arg(body(command.body)); }
    QString operator()(const SetBodyKind& command) const
    {
        return (command.kind == BodyKind::rigid  ? Words::tr("%1 becomes rigid")
                : command.kind == BodyKind::glue ? Words::tr("%1 becomes glue")
                                                 : Words::tr("%1 becomes deformable"))
            .arg(body(command.body));
    }
    QString operator()(const Renormalize&) const { return Words::tr("Re-normalize"); }
    QString operator()(const SetGravity& command) const
    {
        return command.gravity.isZero() ? Words::tr("Gravity off") : Words::tr("Gravity on");
    }
    QString operator()(const SetFloor& command) const
    {
        return command.height ? Words::tr("Floor on") : Words::tr("Floor off");
    }
    QString operator()(const AddManipulator& command) const
    {
        return Words::tr("Add %1").arg(QString::fromStdString(command.manipulator.name));
    }
    QString operator()(const RemoveManipulator& command) const
    {
        return Words::tr("Remove %1").arg(tool(command.tool));
    }
    QString operator()(const SetManipulatorMotion& command) const
    {
        return std::holds_alternative<HoldStill>(command.motion) ? Words::tr("Stop %1").arg(tool(command.tool))
                                                                 : Words::tr("Push with %1").arg(tool(command.tool));
    }
    QString operator()(const ReshapeManipulator& command) const
    {
        return Words::tr("Change %1").arg(tool(command.tool));
    }
    QString operator()(const PlaceManipulator& command) const { return Words::tr("Move %1").arg(tool(command.tool)); }
    QString operator()(const AddFixture& command) const
    {
        return Words::tr("Fix %1").arg(QString::fromStdString(command.fixture.name));
    }
    QString operator()(const RemoveFixture& command) const
    {
        return Words::tr("Remove %1").arg(fixture(command.fixture));
    }
    QString operator()(const MoveFixture& command) const { return Words::tr("Move %1").arg(fixture(command.fixture)); }
    QString operator()(const SetIntegrator& command) const
    {
        switch (command.integrator) {
        case Integrator::semiImplicitEuler:
            return Words::tr("Semi-implicit steps");
        case Integrator::forwardEuler:
            return Words::tr("Forward steps");
        case Integrator::implicitEuler:
            return Words::tr("Implicit steps");
        case Integrator::automatic:
            break;
        }
        return Words::tr("Automatic steps");
    }
    QString operator()(const SetPace&) const { return {}; } // by itself, to keep up
    QString operator()(const Reset&) const { return Words::tr("Reset"); }
    QString operator()(const KeepMoment&) const { return {}; }
    QString operator()(const SetPartLook& command) const
    {
        return command.name.empty() ? Words::tr("Look of a part")
                                    : Words::tr("Look of %1").arg(QString::fromStdString(command.name));
    }
    QString operator()(const RenameManipulator& command) const
    {
        return Words::tr("Rename to %1").arg(QString::fromStdString(command.name));
    }
    QString operator()(const AddLoad& command) const
    {
        return Words::tr("Add %1").arg(QString::fromStdString(command.load.name));
    }
    QString operator()(const RemoveLoad& /*command*/) const { return Words::tr("Remove %1").arg(load()); }
    QString operator()(const Refill& command) const { return Words::tr("Refill %1").arg(body(command.body)); }
    QString operator()(const Cut& command) const { return Words::tr("Cut %1").arg(body(command.body)); }
    QString operator()(const FindBalance& /*command*/) const { return Words::tr("Find balance"); }
    QString operator()(const SetLoad& /*command*/) const { return Words::tr("Change %1").arg(load()); }
    QString operator()(const RenameFixture& command) const
    {
        return Words::tr("Rename to %1").arg(QString::fromStdString(command.name));
    }

private:
    static QString load() { return Words::tr("the load"); }
    QString body(BodyId id) const
    {
        return id < m_content.bodies.size() ? QString::fromStdString(m_content.bodies[id]->name)
                                            : Words::tr("the body");
    }
    QString tool(ToolId id) const
    {
        const auto found =
            std::find_if(m_now.tools.begin(), m_now.tools.end(), [id](const ToolState& tool) { return tool.id == id; });
        return found == m_now.tools.end() ? Words::tr("the tool") : QString::fromStdString(found->name);
    }
    QString fixture(FixtureId id) const
    {
        const auto found = std::find(m_now.fixtureIds.begin(), m_now.fixtureIds.end(), id);
        return found == m_now.fixtureIds.end()
                   ? Words::tr("the fixture")
                   : QString::fromStdString(
                         m_now.fixtures[static_cast<std::size_t>(found - m_now.fixtureIds.begin())].name);
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

QString nameOf(const Command& command, const FilledModel& content, const Snapshot& now)
{
    return std::visit(Namer(content, now), command);
}

QString simulatedName(double seconds)
{
    return Words::tr("Simulate %1").arg(timeText(seconds));
}

QString timeText(double seconds)
{
    if (seconds == 0)
        return Words::tr("0 s");
    if (std::abs(seconds) < 0.0995)
        return Words::tr("%1 ms").arg(localNumber(1000 * seconds, 'f', std::abs(seconds) < 0.00995 ? 1 : 0));
    return Words::tr("%1 s").arg(localNumber(seconds, 'f', std::abs(seconds) < 9.95 ? 2 : 1));
}

QString mergeKeyOf(const Command& command)
{
    const auto* place = std::get_if<PlaceManipulator>(&command);
    return place == nullptr ? QString() : QStringLiteral("place %1").arg(place->tool);
}

} // namespace knead
