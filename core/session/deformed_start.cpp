#include "core/session/deformed_start.h"

#include "core/session/deformed_faces.h"
#include "core/session/export_jobs.h"

#include <utility>

namespace knead {

namespace {

constexpr double deformingShare = 0.6; // of the progress

/// A body's surface as the frame shows it, where the deformations take it.
/// @param map null: nowhere
TriangleMesh surfaceOf(const FilledBody& body, const BodyFrame& shown, const SmoothMap* map)
{
    TriangleMesh mesh = body.mesh;
    mesh.vertices = shown.places;
    if (map != nullptr)
        map->evaluate(shown.places, mesh.vertices);
    return mesh;
}

} // namespace

PreparedDeformation prepareDeformation(const FilledModel& before, const FramePointer& shown,
                                       const std::vector<FaceFixture>& fixtures, const DeformationRequest& request,
                                       const WriteAndRead& writeAndRead, TaskControl& control)
{
    PresentShape now{.partOfBody = {}, .snapshot = shown->snapshot};
    for (const auto& body : before.bodies)
        now.partOfBody.push_back(body->part);
    TaskPortion deforming(control, 0, deformingShare);
    DeformedModel deformed =
        deformedModel(*before.model, now, request.deformations, request.which, writeAndRead, deforming);
    TaskPortion filling(control, deformingShare, 1);
    std::shared_ptr<const SmoothMap> map;
    const auto fixturesIn = [&](const FilledModel& after) {
        return fixturesAfter(fixtures, before, after, deformed.origin, [&](BodyId body) {
            const std::size_t part = before.bodies[body]->part;
            const bool isMeant = request.which.empty() || request.which[part];
            if (isMeant && !map)
                map = mapOf(std::span(*request.deformations));
            return surfaceOf(*shown->filled[body], *shown->bodies[body], isMeant ? map.get() : nullptr);
        });
    };
    PreparedModel prepared = prepareInstead(before, std::make_shared<const Model>(std::move(deformed.model)),
                                            deformed.origin, *shown->snapshot, fixturesIn, filling);
    return {std::move(prepared), std::move(deformed.report)};
}

} // namespace knead
