#pragma once

#include "core/aggregate/aggregate.h"
#include "core/aggregate/material.h"
#include "core/geometry/triangle_mesh.h"
#include "core/mechanics/manipulator.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace knead {

using BodyId = std::uint32_t; ///< index into Scene::bodies; bodies are never renumbered
using FixtureId = std::uint32_t;

/// A body of the scene: an aggregate made of a material.
struct Body {
    std::string name;
    std::shared_ptr<const Aggregate> aggregate;
    Material material;
    Vec3 velocity = Vec3::Zero();        ///< at the start [m/s]
    Vec3 angularVelocity = Vec3::Zero(); ///< at the start, about the center of mass [rad/s]
};

/// Objects of a body that are held in place.
struct Fixture {
    std::string name;
    BodyId body = 0;
    std::vector<ObjectIndex> objects; ///< within the body, ascending
};

/// Everything a simulation starts from.
struct Scene {
    std::vector<Body> bodies;
    std::vector<Fixture> fixtures;         ///< their ids are their places here
    std::vector<Manipulator> manipulators; ///< their ids are their places here
    Vec3 gravity = Vec3::Zero();           ///< [m/s^2]
    std::optional<double> floorHeight;     ///< z of a fixed floor [m]
    double floorFriction = 0.4;
};

/// Objects held when CAD faces are fixed: those within half a spacing of the faces, and those beyond them outside.
/// @param faces indices into Part::faces
std::vector<ObjectIndex> objectsAtFaces(const Aggregate& aggregate, const TriangleMesh& mesh,
                                        const std::vector<std::uint32_t>& faces);

/// Objects inside a box, borders included.
std::vector<ObjectIndex> objectsInBox(const Aggregate& aggregate, const Box& box);

} // namespace knead
