#pragma once

#include "core/aggregate/fill.h"
#include "core/simulation/simulation.h"
#include "support/shapes.h"

#include <memory>

/// Small scenes shared by tests and benchmarks.
namespace knead::scenes {

inline Body body(const TriangleMesh& mesh, double spacing, const Material& material = {},
                 const std::string& name = "body")
{
    return {.name = name,
            .aggregate = std::make_shared<const Aggregate>(fill(mesh, {.spacing = spacing})),
            .material = material};
}

/// A box centered at the origin, `cells` cells of size `spacing` along each axis, lattice nodes on its faces.
inline Body box(const Eigen::Vector3i& cells, double spacing, const Material& material = {})
{
    return body(shapes::box(spacing * cells.cast<double>()), spacing, material, "box");
}

/// A bar along x held at its low end.
inline Scene cantilever(const Eigen::Vector3i& cells, double spacing, const Material& material, const Vec3& gravity)
{
    Scene scene;
    scene.bodies.push_back(box(cells, spacing, material));
    const Aggregate& aggregate = *scene.bodies[0].aggregate;
    const double end = -0.5 * spacing * cells.x();
    scene.fixtures.push_back(
        {"clamp", 0, objectsInBox(aggregate, Box(Vec3(end - spacing / 2, -1, -1), Vec3(end + spacing / 2, 1, 1)))});
    scene.gravity = gravity;
    return scene;
}

/// Mean place of the objects of a snapshot's body.
inline Vec3 meanPosition(const Snapshot& snapshot, std::size_t body = 0)
{
    Vec3 sum = Vec3::Zero();
    for (const Vec3& place : snapshot.bodies[body].positions)
        sum += place;
    return sum / static_cast<double>(snapshot.bodies[body].positions.size());
}

} // namespace knead::scenes
