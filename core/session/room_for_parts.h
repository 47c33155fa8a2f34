#pragma once

#include "core/model/part.h"
#include "core/simulation/snapshot.h"
#include "core/task/task_control.h"

#include <memory>
#include <optional>
#include <vector>

namespace knead {

/// Where parts have room beside others and tools: solid things do not begin inside of each other, nor under the floor where they fall.
class RoomForParts {
public:
    /// @param depth that things which fit together may reach into each other [m]; walls that are thinner than twice that, by half of
    /// them
    RoomForParts(const Snapshot& now, double depth);
    ~RoomForParts();
    RoomForParts(const RoomForParts&) = delete;
    RoomForParts& operator=(const RoomForParts&) = delete;

    void add(const Model& model);

    /// By what the parts of a model are to be moved. None where they fit as they lie; else onto the floor, where gravity pulls and they
    /// reach below it; and where that is inside of something, to beside all of it, along x, on the floor.
    /// @throws Cancelled
    Vec3 wayFor(const Model& model, TaskControl& control = TaskControl::none()) const;

private:
    class Solid;
    using Solids = std::vector<std::unique_ptr<Solid>>;

    static Solids solidsOf(const Model& model);
    bool isInside(const Solids& solids, const Vec3& by, TaskControl& control) const;
    Vec3 beside(const Box& box) const;

    double m_depth;
    std::optional<double> m_floor;
    bool m_falls;
    Box m_parts;
    Solids m_solids; ///< of parts and tools
    std::vector<Box> m_tools;
};

} // namespace knead
