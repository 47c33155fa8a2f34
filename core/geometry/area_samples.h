#pragma once

#include "core/geometry/triangle_mesh.h"

#include <cstddef>
#include <vector>

namespace knead {

/// Points spread evenly over the area of a surface: at equal steps of area, in the order of the triangles; within a triangle by the R2
/// sequence (Roberts 2018). The mesh must outlive it. Its functions may be called on any number of threads.
class AreaSamples {
public:
    struct Sample {
        Vec3 place = Vec3::Zero();
        Vec3 normal = Vec3::Zero(); ///< of unit length, to where triangles look; zero on one without area
        std::uint32_t triangle = 0;
    };

    /// @pre the mesh has triangles
    AreaSamples(const TriangleMesh& mesh, std::size_t count);

    std::size_t size() const { return m_count; }
    double area() const { return m_areaUpTo.back(); } ///< of the surface [m^2]
    Sample operator[](std::size_t i) const;

private:
    const TriangleMesh& m_mesh;
    std::size_t m_count;
    std::vector<double> m_areaUpTo; ///< the triangle's own included [m^2]
};

} // namespace knead
