// Faces that a person fixes, and those that a recipe does.
#include "ui/document/document.h"

#include "ui/language/said.h"
#include <utility>

namespace knead {

/// Those of the scene, and the faces that they hold.
void Document::beginFixtures(const PreparedModel& prepared)
{
    m_fixtures.clear();
    for (const FaceFixture& fixture : prepared.fixtures)
        m_fixtures.keepInMind(fixture);
    const std::vector<Fixture>& held = prepared.scene.fixtures;
    m_fixtures.follow(*m_content, std::vector<std::optional<Fixture>>(held.begin(), held.end()));
}

/// A recipe may have added others before those that were posted, so that ids are what the simulation says.
bool Document::areFixturesKnown() const
{
    return !m_hasScript || m_frame->snapshot->requests >= m_fixtureRequest;
}

/// @return whether the action has to wait until the ids of fixtures are known
bool Document::whenFixturesAreKnown(std::function<void()> action)
{
    if (areFixturesKnown())
        return false;
    m_whenKnown.push_back(std::move(action));
    return true;
}

/// Fixtures that come and go by a recipe.
void Document::followScript()
{
    if (!m_hasScript || !areFixturesKnown())
        return;
    followFixtures(*m_frame->snapshot);
    for (const auto& action : std::exchange(m_whenKnown, {}))
        action();
}

void Document::followFixtures(const Snapshot& now)
{
    if (m_fixtures.agree(now.fixtureIds, now.nextFixture))
        return;
    std::vector<std::optional<Fixture>> held(now.nextFixture);
    for (std::size_t i = 0; i < now.fixtures.size(); ++i)
        held[now.fixtureIds[i]] = now.fixtures[i];
    m_fixtures.follow(*m_content, held);
    if (m_selection.kind == Selection::Kind::Fixture && m_fixtures.find(m_selection.id) == nullptr)
        select({});
    emit changed(Change::Fixtures);
}

void Document::removeSelected()
{
    if (later([this] { removeSelected(); }) || whenFixturesAreKnown([this] { removeSelected(); }))
        return;
    if (refuseLocked(m_selection))
        return;
    if (m_selection.kind == Selection::Kind::Tool) {
        post(RemoveManipulator{m_selection.id});
    } else if (const FaceFixture* fixture = m_fixtures.find(m_selection.id);
               m_selection.kind == Selection::Kind::Fixture && fixture != nullptr) {
        const Message name = Message("Document", "Remove %1").with(fixture->name);
        postAll(m_fixtures.remove(m_selection.id), name);
        select({});
        emit changed(Change::Fixtures);
    }
}

void Document::toggleFace(BodyId body, std::uint32_t face)
{
    const auto again = [this, body, face] { toggleFace(body, face); };
    if (later(again) || whenFixturesAreKnown(again) || body >= m_content->bodies.size())
        return;
    if (m_content->model->parts[m_content->bodies[body]->part].faces.empty()) {
        emit notice(
            said(Message("Document", "\"%1\" is a mesh without CAD faces: open it as STEP, IGES or BREP to fix faces.")
                     .with(nameOfBody(body).toStdString())));
        return;
    }
    const bool isOfFixture = m_selection.kind == Selection::Kind::Fixture;
    if (refuseLocked({Selection::Kind::Body, body}) || (isOfFixture && refuseLocked(m_selection)))
        return;
    const std::uint32_t active = m_selection.kind == Selection::Kind::Fixture ? m_selection.id : 0;
    FaceFixtures::Edit edit = m_fixtures.toggle(*m_content, body, face, active);
    postAll(std::move(edit.commands),
            edit.key != 0 ? Message("Document", "Fix face") : Message("Document", "Free face"));
    if (edit.key != 0)
        select({Selection::Kind::Fixture, edit.key});
    else if (m_fixtures.find(active) == nullptr)
        select({});
    noticeEmptyFixtures();
    emit changed(Change::Fixtures);
}

void Document::noticeEmptyFixtures()
{
    for (const FaceFixture& fixture : m_fixtures.list())
        if (!fixture.id)
            emit notice(said(
                Message(
                    "Document",
                    "%1 holds no objects: its faces are smaller than the spacing. Choose a finer spacing and refill.")
                    .with(fixture.name)));
}

void Document::postAll(std::vector<Command> commands, const Message& name)
{
    for (Command& command : commands)
        post(std::move(command), name);
}

} // namespace knead
