// A recipe that the document was opened from goes on beside what the person does.
#include "ui/document/document.h"

namespace knead {

/// Those of the scene, and the faces that they hold.
void Document::beginFixtures(const PreparedContent& prepared)
{
    m_fixtures.clear();
    for (const FaceFixture& fixture : prepared.fixtures)
        m_fixtures.keepInMind(fixture);
    const std::vector<Fixture>& held = prepared.scene.fixtures;
    m_fixtures.follow(*m_content, std::vector<std::optional<Fixture>>(held.begin(), held.end()));
}

/// Of a start, as far as it was at a moment; null: it has none.
std::unique_ptr<Agenda> Document::agendaAt(std::uint32_t start, const Moment& moment, std::uint64_t hash) const
{
    const AgendaMaker& make = m_history.starts()[start].agenda;
    std::unique_ptr<Agenda> agenda = make ? make() : nullptr;
    if (agenda)
        agenda->wentTo(moment, hash);
    return agenda;
}

/// Fixtures that come and go by a recipe.
void Document::followAgenda()
{
    const Snapshot& now = *m_frame->snapshot;
    if (!m_hasAgenda || now.requests != m_simulation->requests() || m_fixtures.agree(now.fixtureIds, now.nextFixture))
        return;
    std::vector<std::optional<Fixture>> held(now.nextFixture);
    for (std::size_t i = 0; i < now.fixtures.size(); ++i)
        held[now.fixtureIds[i]] = now.fixtures[i];
    m_fixtures.follow(*m_content, held);
    if (m_selection.kind == Selection::Kind::Fixture && m_fixtures.find(m_selection.id) == nullptr)
        select({});
    emit changed(Change::Fixtures);
}

} // namespace knead
