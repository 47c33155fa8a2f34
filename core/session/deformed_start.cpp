#include "core/session/deformed_start.h"

#include "core/session/deformed_faces.h"
#include "core/session/deformed_frame.h"
#include "core/session/export_jobs.h"

#include <algorithm>
#include <utility>

namespace knead {

namespace {

constexpr double deformingShare = 0.6; // of the progress
constexpr double carriedShare = 0.65;

/// The surfaces that a frame shows, where the deformations take those that are meant.
std::vector<std::vector<Vec3>> carriedPlaces(const Frame& shown, const DeformationRequest& request,
                                             TaskControl& control)
{
    const std::shared_ptr<const SmoothMap> map = mapOf(std::span(*request.deformations), control);
    std::vector<std::vector<Vec3>> all;
    for (std::size_t b = 0; b < shown.bodies.size(); ++b) {
        std::vector<Vec3>& places = all.emplace_back(shown.bodies[b]->places);
        if (request.which.empty() || request.which[shown.filled[b]->part])
            evaluateInBlocks(*map, shown.bodies[b]->places, places);
        control.throwIfCancelled();
    }
    return all;
}

/// With the names of the parts that it is for.
std::vector<RecipeDeformation> saidOf(const Model& model, const DeformationRequest& request)
{
    std::vector<std::string> names;
    if (std::ranges::count(request.which, false) > 0)
        for (std::size_t p = 0; p < model.parts.size(); ++p) {
            if (!request.which[p])
                continue;
            std::optional<std::string> name = nameOfPartAlone(model, p);
            if (!name)
                return {};
            names.push_back(std::move(*name));
        }
    std::vector<RecipeDeformation> said = request.said;
    for (RecipeDeformation& deformation : said)
        deformation.bodies = names;
    return said;
}

} // namespace

std::optional<std::string> nameOfPartAlone(const Model& model, std::size_t part)
{
    const auto isAlone = [&model](const std::string& name) {
        const auto isCalled = [&name](const Part& any) { return any.name == name || any.path == name; };
        return !name.empty() && std::ranges::count_if(model.parts, isCalled) == 1;
    };
    for (const std::string& name : {model.parts[part].name, model.parts[part].path})
        if (isAlone(name))
            return name;
    return std::nullopt;
}

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
    TaskPortion carrying(control, deformingShare, carriedShare);
    CarriedSurfaces carried{carriedPlaces(*shown, request, carrying), deformed.origin};
    TaskPortion filling(control, carriedShare, 1);
    const auto fixturesIn = [&](const FilledModel& after) {
        return fixturesAfter(fixtures, before, after, deformed.origin, [&](BodyId body) {
            TriangleMesh mesh = shown->filled[body]->mesh;
            mesh.vertices = carried.places[body];
            return mesh;
        });
    };
    PreparedModel prepared =
        prepareInstead(before, {std::make_shared<const Model>(std::move(deformed.model)), deformed.origin},
                       *shown->snapshot, fixturesIn, filling);
    return {.prepared = std::move(prepared),
            .report = std::move(deformed.report),
            .said = deformed.isOfRest ? saidOf(*before.model, request) : std::vector<RecipeDeformation>(),
            .carried = std::move(carried)};
}

} // namespace knead
