#include "core/session/added_start.h"

#include "core/model/added_model.h"
#include "core/model/joined_model.h"
#include "core/session/deformed_faces.h"
#include "core/session/room_for_parts.h"

#include <algorithm>
#include <filesystem>
#include <stdexcept>
#include <utility>

namespace knead {

namespace {

constexpr double presentShare = 0.3; // of the progress
constexpr double importShare = 0.6;
constexpr double fittingShare = 0.25; // of the spacing: parts that fit together may reach so far into each other

/// Parts as they are now, and what becomes of them as files are read.
class Addition {
public:
    Addition(DeformedModel present, const Snapshot& now, double spacing)
        : m_model(std::move(present.model))
        , m_room(now, fittingShare * spacing)
    {
        m_room.add(m_model);
    }

    /// Reads a file once more where its parts have no room.
    void read(const std::string& path, ImportOptions options, const ImportFiles& import, TaskControl& control)
    {
        TaskPortion first(control, 0, 0.5);
        Model added = import({path}, options, first);
        options.shift = m_room.wayFor(added, first);
        if (!options.shift.isZero(0)) {
            TaskPortion again(control, 0.5, 1);
            added = import({path}, options, again);
            m_moved.push_back(path);
        }
        m_missing.insert(m_missing.end(), added.missing.begin(), added.missing.end());
        if (added.unitRemark)
            m_missing.push_back(doubtOfOneAmongOthers(*added.unitRemark));
        m_room.add(added);
        m_model = withAdded(std::move(m_model), std::move(added));
    }

    void miss(const Message& why) { m_missing.push_back(why); }

    Model takeModel() { return std::move(m_model); }
    std::vector<std::string> takeMoved() { return std::move(m_moved); }
    std::vector<Message> takeMissing() { return std::move(m_missing); }

private:
    Model m_model;
    RoomForParts m_room;
    std::vector<std::string> m_moved;
    std::vector<Message> m_missing;
};

Message nothingToShow(const std::string& path)
{
    return Message("Filling", "%1: the file holds no solid and no surface; export the part as a solid.")
        .with(std::filesystem::path(path).filename().string());
}

/// Names of fixtures that hold nothing any more.
std::vector<std::string> freedFixtures(const Snapshot& before, const Scene& after)
{
    std::vector<std::string> freed;
    for (const Fixture& fixture : before.fixtures)
        if (std::ranges::count(after.fixtures, fixture.name, &Fixture::name) == 0)
            freed.push_back(fixture.name);
    return freed;
}

} // namespace

PreparedAddition prepareAddition(const FilledModel& before, const FramePointer& shown,
                                 const std::vector<FaceFixture>& fixtures, const AdditionRequest& request,
                                 const ImportFiles& import, const WriteAndRead& writeAndRead, TaskControl& control)
{
    TaskPortion following(control, 0, presentShare);
    PresentShape now{.partOfBody = {}, .snapshot = shown->snapshot};
    for (const auto& body : before.bodies)
        now.partOfBody.push_back(body->part);
    DeformedModel present = deformedModel(*before.model, now, nullptr, {}, writeAndRead, following);
    const std::size_t first = present.model.parts.size();
    const ExportReport report = present.report;
    CarriedSurfaces carried{.places = {}, .origin = present.origin};
    for (const auto& body : shown->bodies)
        carried.places.push_back(body->places);

    TaskPortion importing(control, presentShare, importShare);
    const double size = before.box.diagonal().norm();
    Addition addition(std::move(present), *shown->snapshot, before.spacing > 0 ? before.spacing : size / 50);
    for (std::size_t i = 0; i < request.paths.size(); ++i)
        try {
            TaskPortion portion = TaskPortion::ofItem(importing, i, request.paths.size());
            addition.read(request.paths[i], request.options, import, portion);
        } catch (const Cancelled&) {
            throw;
        } catch (const std::runtime_error& error) {
            if (request.paths.size() == 1)
                throw;
            addition.miss(messageOf(error));
        }

    auto model = std::make_shared<const Model>(addition.takeModel());
    std::vector<Message> missing = addition.takeMissing();
    if (model->parts.size() == first)
        throw Problem(missing.empty() ? nothingToShow(request.paths.front()) : missing.front());
    carried.origin.resize(model->parts.size(), PartsInstead::none);
    const PartsInstead all{std::move(model), carried.origin, request.material};
    TaskPortion filling(control, importShare, 1);
    const auto fixturesIn = [&](const FilledModel& after) {
        return fixturesAfter(fixtures, before, after, all.origin, [&](BodyId body) {
            TriangleMesh mesh = shown->filled[body]->mesh;
            mesh.vertices = carried.places[body];
            return mesh;
        });
    };
    PreparedModel prepared = prepareInstead(before, all, *shown->snapshot, fixturesIn, filling);
    std::vector<std::string> freed = freedFixtures(*shown->snapshot, prepared.scene);
    return {.done = {.prepared = std::move(prepared), .report = report, .said = {}, .carried = std::move(carried)},
            .first = first,
            .moved = addition.takeMoved(),
            .missing = std::move(missing),
            .freed = std::move(freed)};
}

} // namespace knead
