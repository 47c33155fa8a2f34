#pragma once

#include "core/model/part.h"
#include "core/simulation/snapshot.h"

#include <functional>
#include <vector>

namespace knead {

/// Where parts have room beside others and tools: solid things do not begin inside of each other, nor under the floor where they fall.
class RoomForParts {
public:
    /// @param depth that things which fit together may reach into each other [m]
    RoomForParts(const Snapshot& now, double depth);

    void add(const Model& model);

    /// By what the parts of a model are to be moved. None where they fit as they lie; else onto the floor, where gravity pulls and they
    /// reach below it; and where that is inside of something, to beside all of it, along x, on the floor.
    Vec3 wayFor(const Model& model) const;

private:
    using Depth = std::function<double(const Vec3& place)>; ///< [m], negative outside
    struct Solid {
        Box box;
        Depth depthAt;
    };

    static std::vector<Solid> solidsOf(const Model& model);
    bool isInside(const std::vector<Solid>& solids, const Vec3& by) const;
    Vec3 beside(const Box& box) const;

    double m_depth;
    std::optional<double> m_floor;
    bool m_falls;
    Box m_parts;
    std::vector<Solid> m_solids; ///< of parts
    std::vector<Solid> m_tools;
};

} // namespace knead
