#pragma once

#include "core/mechanics/blade.h"

#include <optional>

namespace knead {

/// The plane that an edge cuts in, now: along the edge and ahead of it.
struct CuttingFrame {
    Vec3 origin = Vec3::Zero();  ///< one end of the edge [m]
    Vec3 edge = Vec3::Zero();    ///< unit
    Vec3 forward = Vec3::Zero(); ///< unit; 0: not known, of a wire that does not move
    Vec3 normal = Vec3::Zero();  ///< unit; 0: the same

    /// @param way that a wire goes; a knife has its own
    CuttingFrame(const Blade& blade, const Pose& pose, const Vec3& way)
        : origin(pose.toWorld(blade.from))
        , edge(pose.rotation * (blade.to - blade.from).normalized())
        , forward(blade.isWire() ? Vec3((way - way.dot(edge) * edge).stableNormalized())
                                 : Vec3(pose.rotation * blade.forward))
        , normal(edge.cross(forward))
    {
    }

    double height(const Vec3& place) const { return (place - origin).dot(normal); } ///< above the plane [m]

    /// Where a line between two places goes through the plane.
    struct Crossing {
        double share = 0; ///< of the way from the first
        double along = 0; ///< the edge, from its end [m]
        double ahead = 0; ///< of the edge [m]
    };
    std::optional<Crossing> crossing(const Vec3& first, const Vec3& second) const
    {
        const double from = height(first);
        const double to = height(second);
        if ((from < 0) == (to < 0))
            return {};
        const double share = from / (from - to);
        const Vec3 place = first + share * (second - first) - origin;
        return Crossing{share, place.dot(edge), place.dot(forward)};
    }
};

} // namespace knead
