#pragma once

#include "core/geometry/triangle_mesh.h"

#include <cstdint>
#include <memory>

namespace knead {

/// Finds the nearest point of a triangle mesh. Immutable after construction; queries may run on any number of threads.
/// The mesh must outlive it.
class SurfaceDistance {
public:
    struct Hit {
        Vec3 point = Vec3::Zero(); ///< nearest point of the surface [m]
        double distance = 0;       ///< unsigned [m]
        double signedDistance = 0; ///< negative inside a closed surface [m]; sign by angle-weighted pseudo-normals
        std::uint32_t triangle = 0;
    };

    /// Builds the bounding-volume tree, O(n lg n). @throws std::invalid_argument for an empty mesh.
    explicit SurfaceDistance(const TriangleMesh& mesh);
    ~SurfaceDistance();
    SurfaceDistance(SurfaceDistance&&) noexcept;
    SurfaceDistance& operator=(SurfaceDistance&&) noexcept;

    Hit nearest(const Vec3& point) const;

private:
    struct Tree;
    std::unique_ptr<const Tree> m_tree;
};

} // namespace knead
