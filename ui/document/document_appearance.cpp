// What a person calls, colors and locks.
#include "ui/document/document.h"

#include "ui/language/said.h"
#include <algorithm>
#include <utility>
#include <variant>

namespace knead {

QString Document::nameOfPart(std::size_t part) const
{
    const std::string chosen = m_appearance.chosenName(part);
    return QString::fromStdString(chosen.empty() ? m_content->model->parts[part].name : chosen);
}

QString Document::nameOfBody(BodyId body) const
{
    const FilledBody& content = *m_content->bodies[body];
    const std::string chosen = m_appearance.chosenName(content.part);
    return QString::fromStdString(chosen.empty() ? content.name : chosen);
}

void Document::renamePart(std::size_t part, const QString& name)
{
    const std::string wanted = name.trimmed().toStdString();
    if (wanted == m_appearance.chosenName(part))
        return;
    const std::string& shown = wanted.empty() ? m_content->model->parts[part].name : wanted;
    postLook(part, wanted, m_appearance.chosenColor(part), Message("Document", "Rename to %1").with(shown));
}

void Document::colorPart(std::size_t part, const std::optional<Color>& color)
{
    if (color == m_appearance.chosenColor(part))
        return;
    postLook(part, m_appearance.chosenName(part), color,
             Message("Document", "Color of %1").with(nameOfPart(part).toStdString()));
}

/// Says why nothing happens. @return whether there can be no such name
bool Document::refuseName(const QString& name, bool isTaken)
{
    if (isTaken)
        emit notice(said(
            Message("Document", "Something is called \"%1\" already: choose another name.").with(name.toStdString())));
    return isTaken || name.isEmpty();
}

void Document::renameTool(ToolId id, const QString& name)
{
    if (later([this, id, name] { renameTool(id, name); }))
        return;
    const ToolState* renamed = tool(id);
    const std::string wanted = name.trimmed().toStdString();
    const auto& tools = m_frame->snapshot->tools;
    const bool isTaken =
        std::any_of(tools.begin(), tools.end(), [&](const ToolState& other) { return other.name == wanted; });
    if (renamed == nullptr || renamed->name == wanted || refuseName(name.trimmed(), isTaken))
        return;
    post(RenameManipulator{id, wanted});
}

void Document::renameFixture(std::uint32_t key, const QString& name)
{
    const auto again = [this, key, name] { renameFixture(key, name); };
    if (later(again) || whenFixturesAreKnown(again))
        return;
    const std::string wanted = name.trimmed().toStdString();
    const auto& list = m_fixtures.list();
    const bool isTaken =
        std::any_of(list.begin(), list.end(), [&](const FaceFixture& other) { return other.name == wanted; });
    const FaceFixture* fixture = m_fixtures.find(key);
    if (fixture == nullptr || fixture->name == wanted || refuseName(name.trimmed(), isTaken) ||
        refuseLocked({Selection::Kind::Fixture, key}))
        return;
    postAll(m_fixtures.rename(key, wanted), Message("Document", "Rename to %1").with(name.trimmed().toStdString()));
    emit changed(Change::Fixtures);
}

void Document::postLook(std::size_t part, const std::string& name, const std::optional<Color>& color,
                        const Message& entry)
{
    post(SetPartLook{static_cast<std::uint32_t>(part), name, color ? textOf(*color) : std::string()}, entry);
}

/// Of the entry that is shown.
void Document::followAppearance()
{
    PartAppearance appearance;
    if (!m_history.isEmpty())
        appearance = PartAppearance::at(m_history.tree(), m_history.tree().current());
    if (appearance == m_appearance)
        return;
    m_appearance = std::move(appearance);
    emit appearanceChanged();
}

/// Of an entry that came: those of a branch were not posted here.
void Document::followAppearance(const std::vector<RecordedCommand>& commands)
{
    PartAppearance appearance = m_appearance;
    for (const RecordedCommand& recorded : commands)
        appearance.follow(recorded.command);
    if (std::exchange(m_appearance, appearance) != appearance)
        emit appearanceChanged();
}

std::string Document::lockKeyOf(const Selection& selection) const
{
    switch (selection.kind) {
    case Selection::Kind::Body:
        return selection.id < m_content->bodies.size() ? "part " + std::to_string(m_content->bodies[selection.id]->part)
                                                       : std::string();
    case Selection::Kind::Tool:
        return tool(selection.id) != nullptr ? "tool " + tool(selection.id)->name : std::string();
    case Selection::Kind::Fixture:
        if (const FaceFixture* fixture = m_fixtures.find(selection.id))
            return "fixture " + fixture->name;
        break;
    case Selection::Kind::None:
    case Selection::Kind::Region:
        break;
    }
    return {};
}

bool Document::isLocked(const Selection& selection) const
{
    const std::string key = lockKeyOf(selection);
    return !key.empty() && m_notes->isLocked(key);
}

void Document::setLocked(const Selection& selection, bool on)
{
    if (const std::string key = lockKeyOf(selection); !key.empty())
        m_notes->setLocked(key, on);
}

namespace {

/// What a command of a person changes.
struct Target {
    using Kind = Selection::Kind;
    using Result = std::optional<Selection>;
    Result operator()(const SetMaterial& c) const { return Selection{Kind::Body, c.body}; }
    Result operator()(const SetBodyKind& c) const { return Selection{Kind::Body, c.body}; }
    Result operator()(const Renormalize& c) const { return Selection{Kind::Body, c.body}; }
    Result operator()(const RemoveManipulator& c) const { return Selection{Kind::Tool, c.tool}; }
    Result operator()(const SetManipulatorMotion& c) const
    {
        if (std::holds_alternative<HoldStill>(c.motion)) // stopping is always allowed
            return {};
        return Selection{Kind::Tool, c.tool};
    }
    Result operator()(const ReshapeManipulator& c) const { return Selection{Kind::Tool, c.tool}; }
    Result operator()(const PlaceManipulator& c) const { return Selection{Kind::Tool, c.tool}; }
    Result operator()(const RenameManipulator& c) const { return Selection{Kind::Tool, c.tool}; }
    template <class Other>
    Result operator()(const Other&) const
    {
        return {};
    }
};

} // namespace

std::optional<Selection> Document::targetOf(const Command& command) const
{
    if (const auto* look = std::get_if<SetPartLook>(&command)) {
        for (BodyId body = 0; body < m_content->bodies.size(); ++body)
            if (m_content->bodies[body]->part == look->part)
                return Selection{Selection::Kind::Body, body};
        return {};
    }
    return std::visit(Target{}, command);
}

/// Says why nothing happens. @return whether it is locked
bool Document::refuseLocked(const Selection& target)
{
    if (!isLocked(target))
        return false;
    QString name;
    if (target.kind == Selection::Kind::Body)
        name = nameOfBody(target.id);
    else if (target.kind == Selection::Kind::Tool)
        name = QString::fromStdString(tool(target.id)->name);
    else if (const FaceFixture* fixture = m_fixtures.find(target.id))
        name = QString::fromStdString(fixture->name);
    constexpr qint64 silence = 3000; // a hand that pulls asks many times a second [ms]
    if (name == m_refused && m_sinceRefusal.isValid() && m_sinceRefusal.elapsed() < silence)
        return true;
    m_refused = name;
    m_sinceRefusal.start();
    emit notice(said(Message("Document", "\"%1\" is locked in the model tree: unlock it there to change it.")
                         .with(name.toStdString())));
    return true;
}

} // namespace knead
