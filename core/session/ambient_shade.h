#pragma once

#include "core/simulation/snapshot.h"

#include <array>
#include <span>
#include <vector>

namespace knead {

/// Where material is at one moment, as a grid with coarser ones above it, each cell of which is the mean of eight: how much light of
/// its surroundings a place of a surface gets. Immutable; its functions may be called on any number of threads.
class MaterialAround {
public:
    /// O(objects + cells); at most some four million cells, which are as wide as the widest spacing where they can be.
    explicit MaterialAround(std::span<const Snapshot::BodyState> bodies);

    /// How much light of its surroundings a place of a surface keeps: 1 on what is flat or bulges, less in hollows and corners and
    /// where something else is near. Light comes along the normal and along six directions u at 55 degrees to it. With H the width
    /// of cells of a grid, h that of the finest, and f the share of a cell that is material, between cells as it follows linearly
    /// from those around,
    ///
    ///     shade = 1 - ambientDarkest (1 - mean over u of product over grids of 1 - k f(x + u (1.5 H + h) / (u . n)))
    ///
    /// where the normal counts as much as two others, with k from 1 at the finest to 0.4 at the coarsest grid. So far above a flat surface, grids know nothing of it. (Cones through
    /// voxels: Crassin et al. 2011.)
    /// @param normal of unit length, outward
    double shade(const Vec3& place, const Vec3& normal) const;

private:
    static constexpr std::size_t gridCount = 4;

    struct Grid {
        Eigen::Array3i count = Eigen::Array3i::Zero();
        Eigen::Array3f last = Eigen::Array3f::Zero(); ///< number of the last cell
        std::vector<float> share;                     ///< x runs fastest

        std::size_t indexOf(const Eigen::Array3i& cell) const;
        void takeMeans(const Grid& finer);
    };

    void layOut(const Box& box, double spacing);
    void fillIn(const Snapshot::BodyState& body);

    // Places are counted in finest cells from the origin.
    float material(std::size_t grid, const Eigen::Array3f& place) const;
    float lightFrom(const Eigen::Array3f& place, const Eigen::Array3f& direction, float cosine) const;

    Vec3 m_origin = Vec3::Zero();
    double m_width = 0; ///< of the finest cells [m]; 0: there is no material
    std::array<Grid, gridCount> m_grids;
};

/// MaterialAround::shade() of each render vertex.
/// @param points, normals x y z per render vertex, as they are drawn
/// @return per render vertex; empty where all are fully lit
std::vector<float> ambientShades(std::span<const float> points, std::span<const float> normals,
                                 const MaterialAround& material);

/// What is taken off where no light gets.
inline constexpr double ambientDarkest = 0.8;

} // namespace knead
