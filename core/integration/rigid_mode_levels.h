#pragma once

#include "core/geometry/vec3.h"
#include "core/kernels/tangent_kernels.h"
#include "core/mechanics/vector_array.h"

#include <Eigen/Dense>

#include <array>
#include <cstdint>
#include <vector>

namespace knead {

/// Approximates the inverse of a matrix A between clusters that each move as rigid bodies do, six unknowns each: velocity, and
/// angular velocity times the cluster's size. In levels: clusters that hang together and lie in the same eight blocks are one
/// cluster of the next level, A_(l+1) = P_l^T A_l P_l with P how children move with their parents, until there are few enough
/// for a dense inverse. On each level a Gauss-Seidel sweep, what is left solved by the next one, and a sweep the other way
/// round: symmetric and positive definite.
class RigidModeLevels {
public:
    using Vec6 = Eigen::Matrix<double, 6, 1>;
    using Mat6 = Eigen::Matrix<double, 6, 6>;

    struct Cluster {
        Vec3 center = Vec3::Zero();          ///< [m]
        double size = 1;                     ///< [m]
        std::uint32_t body = 0;              ///< clusters of different bodies never become one
        std::array<std::int32_t, 3> block{}; ///< its place in the lattice, in blocks
        bool isAlone = false;                ///< it never becomes one with others
    };

    explicit RigidModeLevels(std::vector<Cluster> clusters);

    /// Block of A, at the start 0. @pre row >= column
    Mat6& block(std::uint32_t row, std::uint32_t column) { return m_blocks.at(row, column); }

    /// Finds levels and inverses from the blocks, which are gone then.
    void finish();

    /// @param load eight per cluster, of which six count @param motion the same, what they move by
    void solve(const std::vector<float>& load, std::vector<float>& motion);

    std::size_t clusters() const { return m_clusters.size(); }
    std::size_t levels() const { return m_levels.size() + 1; }

private:
    /// Blocks of the lower triangle, by rows of few.
    class Blocks {
    public:
        explicit Blocks(std::size_t rows)
            : m_rows(rows)
        {
        }
        Mat6& at(std::uint32_t row, std::uint32_t column); ///< at the start 0
        template <typename Visit>
        void forEach(Visit&& visit) const; ///< visit(row, column, matrix), ascending
        void sort();                       ///< before forEach()

    private:
        struct Entry {
            std::uint32_t column;
            std::uint32_t index;
        };
        std::vector<std::vector<Entry>> m_rows;
        std::vector<Mat6> m_values;
    };

    struct Level {
        std::vector<std::uint32_t> parent; ///< per cluster
        std::vector<Vec3> arm;             ///< from the parent's center, by its size
        std::vector<double> share;         ///< of the parent's size
        std::size_t parents = 0;

        // A by rows, see kernels::BlockRows.
        std::vector<std::uint32_t> begin;
        std::vector<std::uint32_t> behind;
        std::vector<std::uint32_t> columns;
        LaneVector<float> blocks;
        LaneVector<float> inverse;

        // Of solve().
        std::vector<float> left;
        std::vector<float> loadAbove;
        std::vector<float> motionAbove;

        kernels::BlockRows view() const;
        void setRows(const Blocks& lower);
        Mat6 prolongation(std::size_t child) const;
    };

    void solve(std::size_t level, const std::vector<float>& load, std::vector<float>& motion);
    Level nextLevel(std::vector<Cluster>& clusters, const Blocks& blocks) const;

    std::vector<Cluster> m_clusters;
    Blocks m_blocks;
    std::vector<Level> m_levels;
    Eigen::MatrixXd m_top; ///< inverse on the last level
};

/// P^T of a momentum on a member of a cluster: force and torque in the cluster's units.
/// @param arm from the cluster's center, by its size
inline RigidModeLevels::Vec6 restrictedTo(const Vec3& momentum, const Vec3& arm)
{
    RigidModeLevels::Vec6 mode;
    mode << momentum, arm.cross(momentum);
    return mode;
}

} // namespace knead
