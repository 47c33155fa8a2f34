#pragma once

#include "core/session/render_mesh.h"

#include <optional>
#include <span>
#include <vector>

namespace knead {

/// Which feature edges of a closed surface may be seen from somewhere: an edge whose triangles both look away lies
/// behind the material. Depth alone does not tell near the outline, where such an edge begins: it would stick out as a
/// dash of a few pixels.
class EdgeSight {
public:
    /// @param mesh of a closed surface that is seen from outside
    explicit EdgeSight(const RenderMesh& mesh);

    /// Per edge of the mesh. @param points x y z per render vertex [m]
    /// @param eye where it is [m]; none: far away
    /// @param towardsEye unit, of the middle of the view
    std::vector<bool> seenFrom(std::span<const float> points, const std::optional<Vec3>& eye,
                               const Vec3& towardsEye) const;

private:
    using Triangle = std::array<std::uint32_t, 3>;
    std::vector<std::array<Triangle, 2>> m_sides; ///< per edge; where there is only one, it is there twice
};

} // namespace knead
