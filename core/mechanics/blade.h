#pragma once

#include "core/mechanics/tool_shape.h"

#include <optional>

namespace knead {

/// What a tool cuts with, in its own frame.
struct Blade {
    Vec3 from = Vec3::Zero();    ///< one end of its edge [m]
    Vec3 to = Vec3::Zero();      ///< the other
    Vec3 forward = Vec3::Zero(); ///< the way that it cuts, unit; 0: a wire, which cuts any way across itself
    double height = 0;           ///< how far the tool reaches behind the edge, in its plane [m]; 0: a wire

    bool isWire() const { return forward.isZero(0); }
    double length() const { return (to - from).norm(); }
};

/// The edge of a wedge whose flanks meet at less than 45 degrees, or the axis of a cylinder that is thin as a wire: 30 times as long
/// as it is thick. Other tools do not cut.
std::optional<Blade> bladeOf(const ToolShape& shape);

/// A flank of a knife as material sees it that it cuts.
struct Flank {
    SurfacePoint plane;   ///< of the flank, which goes on ahead of the edge
    bool isAhead = false; ///< the place is ahead of the edge, which pushes nothing
};

/// On the side of +y (1) or of -y (-1), from a place in the tool's frame. None for places beside its ends and behind its back, which
/// see it as any tool.
std::optional<Flank> flankOf(const ToolShape& shape, int side, const Vec3& place);

/// Between the flanks of a wedge of that size [rad].
double wedgeAngle(const Vec3& size);

} // namespace knead
