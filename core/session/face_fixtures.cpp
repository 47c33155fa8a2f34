#include "core/session/face_fixtures.h"

#include "core/skin/former_shape.h"

#include <algorithm>

namespace knead {

namespace {

bool holds(const FaceFixture& fixture, BodyId body, std::uint32_t face)
{
    return fixture.body == body && std::ranges::count(fixture.faces, face) > 0;
}

/// Of some filling of the body that it is of.
std::vector<ObjectIndex> objectsOf(const FilledModel& content, const FaceFixture& fixture, const Aggregate& aggregate)
{
    const Part& part = content.model->parts[content.bodies[fixture.body]->part];
    const bool areThere =
        std::ranges::all_of(fixture.faces, [&](std::uint32_t face) { return face < part.faces.size(); });
    return areThere ? objectsAtFaces(aggregate, part.mesh, fixture.faces) : std::vector<ObjectIndex>();
}

std::vector<ObjectIndex> objectsOf(const FilledModel& content, const FaceFixture& fixture)
{
    return objectsOf(content, fixture, *content.bodies[fixture.body]->aggregate);
}

bool isTaken(const std::vector<FaceFixture>& fixtures, const std::string& name)
{
    return std::ranges::any_of(fixtures, [&](const FaceFixture& f) { return f.name == name; });
}

std::uint32_t freeKey(const std::vector<FaceFixture>& fixtures)
{
    std::uint32_t key = 1;
    for (const FaceFixture& fixture : fixtures)
        key = std::max(key, fixture.key + 1);
    return key;
}

/// No other fixture has it, also not one of a recipe.
std::string freeName(const std::vector<FaceFixture>& fixtures, std::uint32_t number)
{
    for (;; ++number) {
        std::string name = "Fixture " + std::to_string(number);
        if (!isTaken(fixtures, name))
            return name;
    }
}

/// That of the face, where the file gives it one.
std::string freeName(const std::vector<FaceFixture>& fixtures, std::uint32_t number, std::string ofFace)
{
    return ofFace.empty() || isTaken(fixtures, ofFace) ? freeName(fixtures, number) : std::move(ofFace);
}

} // namespace

const FaceFixture* FaceFixtures::find(std::uint32_t key) const
{
    const auto found = std::ranges::find(m_list, key, &FaceFixture::key);
    return found == m_list.end() ? nullptr : &*found;
}

void FaceFixtures::clear()
{
    *this = {};
}

std::vector<Command> FaceFixtures::remove(std::uint32_t key)
{
    const FaceFixture* fixture = find(key);
    if (fixture == nullptr)
        return {};
    std::vector<Command> commands;
    if (fixture->id)
        commands.emplace_back(RemoveFixture{*fixture->id});
    std::erase_if(m_list, [key](const FaceFixture& other) { return other.key == key; });
    return commands;
}

std::vector<Command> FaceFixtures::rename(std::uint32_t key, const std::string& name)
{
    const auto fixture = std::ranges::find(m_list, key, &FaceFixture::key);
    if (fixture == m_list.end())
        return {};
    fixture->name = name;
    if (!fixture->faces.empty())
        keepInMind(*fixture);
    return fixture->id ? std::vector<Command>{RenameFixture{*fixture->id, name}} : std::vector<Command>{};
}

FaceFixtures::Edit FaceFixtures::toggle(const FilledModel& content, BodyId body, std::uint32_t face,
                                        std::uint32_t active)
{
    const auto holding = std::ranges::find_if(m_list, [&](const FaceFixture& f) { return holds(f, body, face); });
    if (holding != m_list.end()) {
        if (holding->faces.size() == 1)
            return {0, remove(holding->key)};
        std::erase(holding->faces, face);
        return {0, hold(content, *holding)};
    }
    const auto chosen = std::ranges::find_if(
        m_list, [&](const FaceFixture& f) { return f.key == active && f.body == body && !f.faces.empty(); });
    if (chosen != m_list.end()) {
        chosen->faces.push_back(face);
        return {active, hold(content, *chosen)};
    }
    const std::uint32_t key = freeKey(m_list);
    m_list.push_back({.key = key,
                      .name = freeName(m_list, key, nameOfFace(content, body, face)),
                      .body = body,
                      .faces = {face},
                      .id = {}});
    return {key, hold(content, m_list.back())};
}

FaceFixtures::Edit FaceFixtures::add(const FilledModel& content, BodyId body, std::vector<std::uint32_t> faces)
{
    const std::uint32_t key = freeKey(m_list);
    const std::string ofFace = faces.size() == 1 ? nameOfFace(content, body, faces.front()) : std::string();
    m_list.push_back(
        {.key = key, .name = freeName(m_list, key, ofFace), .body = body, .faces = std::move(faces), .id = {}});
    return {key, hold(content, m_list.back())};
}

FaceFixtures::Edit FaceFixtures::addObjects(BodyId body, std::vector<ObjectIndex> objects)
{
    const std::uint32_t key = freeKey(m_list);
    m_list.push_back({.key = key, .name = freeName(m_list, key), .body = body, .faces = {}, .id = m_nextId});
    return {key, {AddFixture{{m_list.back().name, body, std::move(objects)}}}};
}

/// Other faces: the simulation gets another fixture in place of the one it has.
std::vector<Command> FaceFixtures::hold(const FilledModel& content, FaceFixture& fixture)
{
    keepInMind(fixture);
    std::vector<Command> commands;
    if (fixture.id)
        commands.emplace_back(RemoveFixture{*fixture.id});
    fixture.id.reset();
    std::vector<ObjectIndex> objects = objectsOf(content, fixture);
    if (!objects.empty()) {
        commands.emplace_back(AddFixture{{fixture.name, fixture.body, std::move(objects)}});
        fixture.id = m_nextId;
    }
    return commands;
}

void FaceFixtures::posted(const Command& command)
{
    if (std::holds_alternative<AddFixture>(command))
        ++m_nextId;
}

void FaceFixtures::keepInMind(const FaceFixture& fixture)
{
    FaceFixture known = fixture;
    known.id.reset();
    std::ranges::sort(known.faces);
    const bool isNew = std::ranges::none_of(m_known, [&](const FaceFixture& other) {
        return other.name == known.name && other.body == known.body && other.faces == known.faces;
    });
    if (isNew)
        m_known.push_back(std::move(known));
}

FaceFixture FaceFixtures::faceFixtureOf(const FilledModel& content, const Fixture& held) const
{
    const auto& former = content.bodies[held.body]->aggregate->former;
    const FaceFixture* likely = nullptr;
    for (const FaceFixture& known : m_known) {
        if (known.name != held.name || known.body != held.body)
            continue;
        likely = &known;
        const bool isThat = former ? objectsOf(content, known, firstFillingOf(*former->carriers())) == held.whenOpened
                                   : objectsOf(content, known) == held.objects;
        if (isThat)
            return known;
    }
    if (former && likely != nullptr) // it was made in a filling of before: no one knows its objects
        return *likely;
    return {.key = 0, .name = held.name, .body = held.body, .faces = {}, .id = {}};
}

void FaceFixtures::follow(const FilledModel& content, std::span<const std::optional<Fixture>> held)
{
    m_list.clear();
    for (std::size_t id = 0; id < held.size(); ++id) {
        if (!held[id])
            continue;
        FaceFixture fixture = faceFixtureOf(content, *held[id]);
        fixture.id = static_cast<FixtureId>(id);
        if (fixture.key == 0 || find(fixture.key) != nullptr)
            fixture.key = freeKey(m_list);
        m_list.push_back(std::move(fixture));
    }
    m_nextId = static_cast<FixtureId>(held.size());
}

bool FaceFixtures::agree(std::span<const FixtureId> ids, FixtureId count) const
{
    std::vector<FixtureId> own;
    for (const FaceFixture& fixture : m_list)
        if (fixture.id)
            own.push_back(*fixture.id);
    std::ranges::sort(own);
    return count == m_nextId && std::equal(own.begin(), own.end(), ids.begin(), ids.end());
}

std::vector<Fixture> sceneFixtures(const FilledModel& content, const std::vector<FaceFixture>& fixtures)
{
    std::vector<Fixture> result;
    for (const FaceFixture& fixture : fixtures)
        if (fixture.body < content.bodies.size())
            result.push_back({fixture.name, fixture.body, objectsOf(content, fixture)});
    std::erase_if(result, [](const Fixture& fixture) { return fixture.objects.empty(); });
    return result;
}

} // namespace knead
