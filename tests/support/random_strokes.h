#pragma once

#include "core/geometry/turn.h"
#include "core/simulation/simulation.h"
#include "support/fuzz_random.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace knead::scenes {

/// Strokes of random tools on the first body of a simulation, one after the other, as a hand kneads: a tool comes from somewhere above
/// or beside, goes in, is often dragged along, and is taken away again. The same strokes for the same seed.
class RandomStrokes {
public:
    /// @param depth of a stroke by the least extent of the body, at most
    RandomStrokes(Simulation& simulation, std::uint64_t seed, double depth = 0.7)
        : m_simulation(simulation)
        , m_random(seed)
        , m_depth(depth)
    {
    }

    /// @return whether the simulation goes on
    bool stroke()
    {
        const auto shot = m_simulation.snapshot();
        Box box;
        for (const Vec3& place : shot->bodies[0].positions)
            box.extend(place);
        const double spacing = shot->bodies[0].aggregate->lattice.spacing;
        const double floor = shot->floorHeight.value_or(-1e3);
        const Vec3 from = direction();
        Manipulator tool = randomTool(from, box);
        const Vec3 half = 0.5 * box.sizes();
        const Vec3 aim = box.center() +
                         Vec3(within(-0.6, 0.6) * half.x(), within(-0.6, 0.6) * half.y(), within(-0.3, 0.6) * half.z());
        tool.pose.position = aim + clearOf(shot->bodies[0].positions, tool, aim, from, spacing, floor) * from;
        const double low = floor + 0.25 * tool.size.minCoeff();
        Pose deep = tool.pose;
        deep.position -= (spacing + within(0.2, 1) * m_depth * 2 * half.minCoeff()) * from;
        deep.position.z() = std::max(deep.position.z(), low);
        Pose dragged = deep;
        if (within(0, 1) < 0.5) {
            const Vec3 way(within(-1, 1), within(-1, 1), within(-1, 1));
            dragged.position += within(0, half.minCoeff()) * (way - way.dot(from) * from).normalized();
            dragged.position.z() = std::max(dragged.position.z(), deep.position.z());
        }
        const Pose away = tool.pose;
        m_simulation.post(AddManipulator{tool});
        m_simulation.step();
        for (const Pose& pose : {deep, dragged, away})
            if (!go(tool, pose))
                return false;
        m_simulation.post(RemoveManipulator{m_next++});
        m_simulation.step();
        return m_simulation.health().ok;
    }

private:
    double within(double low, double high)
    {
        return low + (high - low) * static_cast<double>(m_random.below(1 << 20)) / (1 << 20);
    }

    Vec3 direction()
    {
        const double tilt = within(0, 0.5 * std::numbers::pi);
        const double around = within(0, 2 * std::numbers::pi);
        return {std::sin(tilt) * std::cos(around), std::sin(tilt) * std::sin(around), std::cos(tilt)};
    }

    Manipulator randomTool(const Vec3& from, const Box& box)
    {
        constexpr std::array kinds{ToolKind::ball, ToolKind::cylinder, ToolKind::box, ToolKind::plate};
        Manipulator tool{.name = "stroke"};
        tool.kind = kinds[m_random.below(kinds.size())];
        const double length = box.sizes().maxCoeff();
        const double width = within(0.13, 0.4) * length;
        if (tool.kind == ToolKind::ball)
            tool.size = Vec3::Constant(width);
        else if (tool.kind == ToolKind::cylinder)
            tool.size = Vec3(width, width, within(0.3, 1.3) * length);
        else if (tool.kind == ToolKind::box)
            tool.size = Vec3(width, within(0.13, 0.5) * length, within(0.13, 0.5) * length);
        else
            tool.size = Vec3(within(0.5, 1.6) * length, within(0.5, 1.6) * length, 0.07 * length);
        const Vec3 axis = tool.kind == ToolKind::cylinder ? Vec3::UnitX() : Vec3::UnitZ();
        tool.pose.rotation = turnOnto(axis, from) * Quaternion(Eigen::AngleAxisd(within(0, std::numbers::pi), axis));
        tool.friction = within(0, 0.8);
        tool.forceLimit = within(5, 60);
        tool.speedLimit = within(0.03, 0.2);
        return tool;
    }

    /// How far along a way the tool has to be so that it touches nothing.
    static double clearOf(const std::vector<Vec3>& places, const Manipulator& tool, const Vec3& aim, const Vec3& way,
                          double spacing, double floor)
    {
        const double step = 0.2 * spacing;
        RigidSurface surface{.id = 0, .shape = tool.shape(), .pose = tool.pose};
        for (double distance = 0;; distance += step) {
            surface.pose.position = aim + distance * way;
            const bool isClear = std::ranges::none_of(
                places, [&](const Vec3& place) { return surface.nearest(place).distance < spacing; });
            if ((isClear && surface.pose.position.z() > floor + 0.5 * tool.size.minCoeff()) || distance > 1)
                return distance;
        }
    }

    bool go(const Manipulator& tool, const Pose& pose)
    {
        m_simulation.post(SetManipulatorMotion{m_next, GoTo{pose}});
        const Vec3 here = m_simulation.snapshot()->tools.back().pose.position;
        const double end = m_simulation.time() + (pose.position - here).norm() / tool.speedLimit + 0.1;
        while (m_simulation.time() < end && m_simulation.health().ok)
            m_simulation.step();
        return m_simulation.health().ok;
    }

    Simulation& m_simulation;
    fuzz::Random m_random;
    double m_depth;
    ToolId m_next = 0;
};

} // namespace knead::scenes
