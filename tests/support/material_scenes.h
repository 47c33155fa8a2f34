#pragma once

#include "core/aggregate/published_fill.h"
#include "support/scenes.h"

#include <cmath>

/// Scenes in which material flows, breaks, sticks and heals.
namespace knead::scenes {

/// As a potter's clay, a little softer than the bundled one.
inline Material clay()
{
    Material material;
    material.density = 1700;
    material.youngsModulus = 5e5;
    material.poissonRatio = 0.45;
    material.dampingRatio = 0.1;
    material.yieldStress = 5.2e3; // deviatoric yield strain of a connection 1 %
    material.relaxationTime = 0.002;
    return material;
}

/// A block on a floor with a plate above it that goes down by a share of its height, waits, and goes up again.
struct Press {
    double share = 0.3;
    double pressTime = 0.4;   ///< [s]
    double waitTime = 0.1;    ///< [s]
    double releaseTime = 0.1; ///< [s]
    double friction = 1;
};

inline Scene pressedBlock(const Body& block, double height, const Press& press)
{
    Scene scene;
    scene.bodies.push_back(block);
    scene.floorHeight = -height / 2;
    scene.floorFriction = press.friction;
    Manipulator plate{.name = "plate", .size = {3 * height, 3 * height, height / 2}};
    plate.kind = ToolKind::plate;
    plate.friction = press.friction;
    plate.speedLimit = 10;
    const double top = height / 2 + height / 4;
    const auto at = [&](double time, double down) {
        return KeyFrame{time, {Vec3(0, 0, top - down), Quaternion::Identity()}};
    };
    const double down = press.share * height;
    plate.pose.position = Vec3(0, 0, top);
    plate.motion = FollowKeyFrames{{at(0, 0), at(press.pressTime, down), at(press.pressTime + press.waitTime, down),
                                    at(press.pressTime + press.waitTime + press.releaseTime, -0.1 * height)}};
    scene.manipulators.push_back(plate);
    return scene;
}

/// Volume of a block of cells from the places of its objects: of the trilinear map of every cell, by Gauss's rule, which is exact for it.
inline double blockVolume(const Aggregate& aggregate, const std::vector<Vec3>& places)
{
    const double gauss = 0.5 / std::sqrt(3.0);
    double volume = 0;
    for (ObjectIndex i = 0; i < aggregate.size(); ++i) {
        Vec3 corner[8];
        bool whole = true;
        for (int c = 0; c < 8; ++c) {
            Lattice::Node node = aggregate.lattice.nodes[i];
            for (int axis = 0; axis < 3; ++axis)
                node[static_cast<std::size_t>(axis)] += c >> axis & 1;
            const ObjectIndex object = aggregate.lattice.find(node);
            whole = whole && object < aggregate.size();
            if (whole)
                corner[c] = places[object];
        }
        for (int point = 0; whole && point < 8; ++point) {
            Mat3 jacobian = Mat3::Zero();
            for (int c = 0; c < 8; ++c)
                for (int along = 0; along < 3; ++along) {
                    double slope = (c >> along & 1) != 0 ? 1 : -1;
                    for (int across = 0; across < 3; ++across)
                        if (across != along)
                            slope *= 0.5 + ((c ^ point) >> across & 1 ? -gauss : gauss);
                    jacobian.col(along) += slope * corner[c];
                }
            volume += std::abs(jacobian.determinant()) / 8;
        }
    }
    return volume;
}

/// Energy that passed through a simulation, to judge an imbalance by [J].
inline double turnover(const EnergyLedger& energy, double kineticAtStart = 0)
{
    return std::max({std::abs(energy.toolWork), energy.dissipated(), energy.kinetic + energy.elastic, kineticAtStart});
}

/// The bar of the paper: 5 x 5 x 17 spheres with 26 neighbors, structural friction, forward Euler and the half-partition; it
/// lies on a floor while a block is pushed against it.
inline Scene publishedBar()
{
    constexpr double a = 2e-3;
    Material jelly;
    jelly.density = 1000;
    jelly.youngsModulus = 300;
    jelly.dampingRatio = 0.3;
    Scene scene;
    scene.bodies.push_back(
        {.name = "bar",
         .aggregate = std::make_shared<const Aggregate>(fillAsPublished(shapes::box(a * Vec3(17, 5, 5)), a)),
         .material = jelly});
    scene.bodies[0].structuralFriction = 0.2;
    scene.integrator = Integrator::forwardEuler;
    scene.timeStep = 1e-4; // a quarter of what is stable: the scheme gains energy in proportion to it
    scene.vicinity = VicinityMethod::halfPartition;
    scene.gravity = Vec3(0, 0, -0.5);
    scene.floorHeight = -2.5 * a;
    Manipulator block{.name = "block", .size = {0.006, 0.02, 0.02}};
    block.pose.position = Vec3(0, 0.017, 0);
    block.motion = DriveAt{Vec3(0, -0.05, 0), Vec3::Zero()};
    scene.manipulators.push_back(block);
    return scene;
}

} // namespace knead::scenes
