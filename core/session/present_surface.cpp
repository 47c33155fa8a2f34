#include "core/session/present_surface.h"

#include "core/deformation/kept_faces.h"

#include <algorithm>
#include <utility>

namespace knead {

namespace {

constexpr double leastWay = 1e-9; // of the size of a part; what has moved less is where it was

const FilledBody& bodyShown(const FilledModel& content, const Frame& shown, BodyId body)
{
    return shown.filled.empty() ? *content.bodies[body] : *shown.filled[body];
}

bool isWhereItWas(const FilledBody& body, const BodyFrame& shown, const Part& part)
{
    const double least = leastWay * part.box.diagonal().norm();
    return !body.whole &&
           std::ranges::equal(shown.places, body.mesh.vertices,
                              [least](const Vec3& now, const Vec3& was) { return (now - was).norm() <= least; });
}

TriangleMesh surfaceOfBody(const FilledModel& content, const Frame& shown, BodyId body)
{
    const FilledBody& filled = bodyShown(content, shown, body);
    const Part& part = content.model->parts[filled.part];
    if (isWhereItWas(filled, *shown.bodies[body], part))
        return part.mesh;
    TriangleMesh mesh = filled.mesh;
    mesh.vertices = shown.bodies[body]->places;
    return mesh;
}

} // namespace

TriangleMesh presentSurface(const FilledModel& content, const Frame& shown)
{
    TriangleMesh all;
    for (std::size_t p = 0; p < content.model->parts.size(); ++p) {
        const auto body = std::ranges::find(content.bodies, p, [](const auto& filled) { return filled->part; });
        all = besides(std::move(all),
                      body == content.bodies.end()
                          ? content.model->parts[p].mesh
                          : surfaceOfBody(content, shown, static_cast<BodyId>(body - content.bodies.begin())));
    }
    return all;
}

TriangleMesh presentFaces(const FilledModel& content, const Frame& shown, BodyId body,
                          const std::set<std::uint32_t>& faces)
{
    return facesOf(surfaceOfBody(content, shown, body), faces);
}

} // namespace knead
