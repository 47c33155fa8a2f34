#pragma once

#include "core/geometry/smooth_map.h"

#include <gp_Trsf.hxx>

#include <optional>
#include <span>

namespace knead {

/// The rigid motion that a map is for all points, up to a tolerance; the identity where it leaves them in place.
std::optional<gp_Trsf> rigidMotionOf(const SmoothMap& map, std::span<const Vec3> points, double tolerance);

/// A curve or surface, moved; a copy when the motion is the identity. Two faces that share a surface must not go on to:
/// an edge keeps one curve for each surface, and where that is closed in itself the sides of its seam have two.
template <typename GeometryHandle>
GeometryHandle moved(const GeometryHandle& geometry, const gp_Trsf& motion)
{
    if (motion.Form() == gp_Identity)
        return GeometryHandle::DownCast(geometry->Copy());
    return GeometryHandle::DownCast(geometry->Transformed(motion));
}

} // namespace knead
