#include "ui/document/face_fixtures.h"

#include <algorithm>

namespace knead {

namespace {

bool contains(const std::vector<Fixture>& list, const Fixture& fixture)
{
    return std::any_of(list.begin(), list.end(), [&](const Fixture& other) {
        return other.name == fixture.name && other.body == fixture.body && other.objects == fixture.objects;
    });
}

bool areEqual(const std::vector<Fixture>& a, const std::vector<Fixture>& b)
{
    return a.size() == b.size() && std::all_of(a.begin(), a.end(), [&](const Fixture& f) { return contains(b, f); });
}

bool holds(const FaceFixture& fixture, BodyId body, std::uint32_t face)
{
    return fixture.body == body && std::count(fixture.faces.begin(), fixture.faces.end(), face) > 0;
}

} // namespace

const FaceFixture* FaceFixtures::find(std::uint32_t key) const
{
    const auto found = std::find_if(m_list.begin(), m_list.end(), [key](const FaceFixture& f) { return f.key == key; });
    return found == m_list.end() ? nullptr : &*found;
}

void FaceFixtures::clear()
{
    *this = {};
}

void FaceFixtures::remove(std::uint32_t key)
{
    std::erase_if(m_list, [key](const FaceFixture& fixture) { return fixture.key == key; });
    edited();
}

std::uint32_t FaceFixtures::toggle(BodyId body, std::uint32_t face, std::uint32_t active)
{
    edited();
    const auto holding =
        std::find_if(m_list.begin(), m_list.end(), [&](const FaceFixture& f) { return holds(f, body, face); });
    if (holding != m_list.end()) {
        std::erase(holding->faces, face);
        std::erase_if(m_list, [](const FaceFixture& fixture) { return fixture.faces.empty(); });
        return 0;
    }
    const auto chosen = std::find_if(m_list.begin(), m_list.end(),
                                     [&](const FaceFixture& f) { return f.key == active && f.body == body; });
    if (chosen != m_list.end()) {
        chosen->faces.push_back(face);
        return active;
    }
    const std::uint32_t key = m_nextKey++;
    m_list.push_back({key, "Fixture " + std::to_string(key), body, {face}});
    return key;
}

void FaceFixtures::refilled()
{
    m_isWantedKnown = false;
    m_isPosted = false;
}

void FaceFixtures::edited()
{
    m_isWantedKnown = false;
}

std::vector<Command> FaceFixtures::changes(const Snapshot& now, const Content& content)
{
    if (m_isPosted && !areEqual(now.fixtures, m_posted))
        return {};
    m_isPosted = false;
    const std::vector<Fixture>& target = wanted(content);
    std::vector<Command> commands;
    for (std::size_t f = 0; f < now.fixtures.size(); ++f)
        if (!contains(target, now.fixtures[f]))
            commands.emplace_back(RemoveFixture{now.fixtureIds[f]});
    for (const Fixture& fixture : target)
        if (!contains(now.fixtures, fixture))
            commands.emplace_back(AddFixture{fixture});
    if (!commands.empty()) {
        m_posted = target;
        m_isPosted = true;
    }
    return commands;
}

const std::vector<Fixture>& FaceFixtures::wanted(const Content& content)
{
    if (m_isWantedKnown)
        return m_wanted;
    m_wanted.clear();
    for (const FaceFixture& fixture : m_list) {
        const ContentBody& body = *content.bodies[fixture.body];
        const TriangleMesh& mesh = content.model->parts[body.part].mesh;
        m_wanted.push_back({fixture.name, fixture.body, objectsAtFaces(*body.aggregate, mesh, fixture.faces)});
    }
    std::erase_if(m_wanted, [](const Fixture& fixture) { return fixture.objects.empty(); });
    m_isWantedKnown = true;
    return m_wanted;
}

} // namespace knead
