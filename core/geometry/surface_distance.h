#pragma once

#include "core/geometry/half_edges.h"
#include "core/geometry/triangle_mesh.h"

#include <cstdint>
#include <memory>
#include <optional>

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

    /// Builds the tree of boxes, O(n lg n), on all threads. @throws std::invalid_argument for an empty mesh.
    explicit SurfaceDistance(const TriangleMesh& mesh);
    /// The same, for who has found the half-edges of the mesh already.
    SurfaceDistance(const TriangleMesh& mesh, HalfEdges halfEdges);
    ~SurfaceDistance();
    SurfaceDistance(SurfaceDistance&&) noexcept;
    SurfaceDistance& operator=(SurfaceDistance&&) noexcept;

    Hit nearest(const Vec3& point) const;

    /// The same for a surface closer than `reach` [m]; none when it is farther. Quicker the less there is within reach.
    /// @param guess a triangle that may be near, such as the one nearest to a neighboring point; it changes only the time
    std::optional<Hit> nearestWithin(double reach, const Vec3& point, std::uint32_t guess = 0) const;

private:
    struct Search;
    std::unique_ptr<const Search> m_search;
};

} // namespace knead
