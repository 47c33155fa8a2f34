#pragma once

#include "core/geometry/triangle_mesh.h"

#include <array>
#include <vector>

namespace knead {

/// The soft shadow that things cast on the plane under them, lit from above.
class PictureShadow {
public:
    /// @param up unit
    PictureShadow(const std::vector<const TriangleMesh*>& meshes, const Vec3& up);

    /// 0 in full light, 1 in full shadow, at the point of the ground seen along `forward` through `point`.
    double at(const Vec3& point, const Vec3& forward) const;

private:
    Eigen::Vector2d toMap(const Vec3& point) const;
    void cover(const std::array<Eigen::Vector2d, 3>& triangle);

    Vec3 m_up;
    Vec3 m_right;
    Vec3 m_ahead;
    double m_height = 0; ///< of the plane, along up [m]
    double m_left = 0;   ///< of the map [m]
    double m_near = 0;   ///< of the map [m]
    double m_cell = 1;   ///< [m]
    std::vector<float> m_map;
};

} // namespace knead
