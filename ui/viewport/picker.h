#pragma once

#include "core/geometry/plane_section.h"
#include "core/mechanics/manipulator.h"
#include "core/session/render_mesh.h"
#include "ui/viewport/camera.h"

#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

namespace knead {

/// What a ray meets first on a surface.
struct SurfaceHit {
    double distance = 0; ///< along the ray [m]
    std::uint32_t triangle = 0;
    std::uint32_t face = 0; ///< CAD face
    bool isCut = false;     ///< met is where a plane opens the material; the triangle is only behind that
};

/// The part of a ray along which it may meet something, as distances [m].
struct RayReach {
    double from = 0;
    double to = std::numeric_limits<double>::max();
};
/// What a section plane leaves of a ray. Empty (from > to) where all of it is cut off.
RayReach reachOf(const Ray& ray, const std::optional<CutPlane>& cut);

/// Finds where rays meet a deforming surface. The tree of triangles is built once; refit() follows the deformation in
/// linear time,
/// which is why picking on a running simulation costs milliseconds. Window thread only.
class SurfacePicker {
public:
    /// @param points x y z per render vertex at rest [m]; the mesh must outlive the picker
    SurfacePicker(const RenderMesh& mesh, std::span<const float> points);

    /// @param points as drawn now; must stay alive while picking
    void refit(std::span<const float> points);

    /// A ray that would come out of a closed surface, and whose reach begins within, meets a cut there.
    std::optional<SurfaceHit> pick(const Ray& ray, const RayReach& reach = {}) const;

private:
    struct Node {
        Eigen::AlignedBox3f box;
        std::uint32_t begin = 0; ///< triangles in m_order of a leaf
        std::uint32_t end = 0;   ///< equal to begin inside the tree
        std::uint32_t right = 0; ///< second child; the first one follows its parent
    };

    void build(std::uint32_t begin, std::uint32_t end, const std::vector<Eigen::Vector3f>& centers);
    bool facesAway(std::uint32_t triangle, const Vec3& direction) const;
    void intersectLeaf(const Node& node, const Ray& ray, const RayReach& reach, std::optional<SurfaceHit>& best) const;

    const RenderMesh& m_mesh;
    std::span<const float> m_points;
    std::vector<std::uint32_t> m_order;
    std::vector<Node> m_nodes; ///< parents before children
};

/// Distance along the ray to a tool [m]; empty when it misses.
std::optional<double> pickTool(const Ray& ray, const ToolShape& shape, const Pose& pose);

/// Distance along the ray to a box [m]; empty when it misses.
std::optional<double> pickBox(const Ray& ray, const Vec3& size, const Pose& pose);

} // namespace knead
