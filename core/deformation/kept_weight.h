#pragma once

#include "core/geometry/triangle_mesh.h"

#include <cstdint>
#include <vector>

namespace knead {

/// How much of a deformation there is beside surfaces that stay: 0 on them, 1 from a distance on.
///   w(X) = 1 / (1 + F),  F = k int_S (f / r)^5 (1 - r^2 / f^2)^5 dA / f^2,  r = |Y - X| < f,
/// with f seven tenths of the distance. k is such that w is a half at f / 2 from a plane; beside it w grows with the third power of
/// the distance. An integral over the surface has no creases where two surfaces are equally near, nor at edges or where triangles meet,
/// as a function of the distance would: w is twice continuously differentiable everywhere.
///
/// Triangles are integrated in closed form near by, farther away by their moments, those of a branch of a tree together; one blends
/// into the other. r is made larger by 1e-5 f, so that w is about 1e-15 on the surface, and not 0 / 0.
class KeptWeight {
public:
    /// @param fade distance from which on w is 1 [m]
    /// @pre the mesh has triangles, fade > 0
    KeptWeight(const TriangleMesh& mesh, double fade);

    double at(const Vec3& place) const;

private:
    /// Triangles near each other: a branch of the tree, or one of them.
    struct Branch {
        Vec3 center;       ///< of gravity
        double radius = 0; ///< around all there is in it
        double area = 0;
        Mat3 moment = Mat3::Zero(); ///< int (Y - center)(Y - center)' dA
        std::uint32_t first = 0;    ///< a triangle, or of two branches the first one
        bool isTriangle = false;
    };

    std::uint32_t grow(std::vector<std::uint32_t>& order, std::size_t begin, std::size_t end, std::uint32_t at);
    double integral(std::uint32_t branch, const Vec3& place) const;

    std::vector<std::array<Vec3, 3>> m_triangles; ///< in units of f
    std::vector<Branch> m_branches;               ///< the root first
    double m_perUnit = 1;                         ///< 1 / f [1/m]
};

} // namespace knead
