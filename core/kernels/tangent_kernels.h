#pragma once

#include "core/aggregate/lattice_directions.h"
#include "core/kernels/lattice_kernels.h"
#include "core/kernels/slot_block.h"

#include <cstddef>

/// The innermost loops of the implicit scheme: over stretches of connections, as in lattice_kernels.h, and over objects.
/// See kernels.h for how they are compiled and picked.
namespace knead::kernels {

/// Arrays of a stretch of objects for the change of their dilatation with the places around them.
struct GradientArguments {
    const double* const* shape;        ///< 9: M = sum k d o^T, column-wise
    const double* const* inverseShape; ///< 6: uu vv ww uv uw vw of K^-1 = (sum k o o^T)^-1
    const double* bulk;                ///< (lambda - mu) V [J]
    double spacing;                    ///< a [m]
    double step;                       ///< h [s]
    float* const* gradient;            ///< 9, written: G = F^-T K^-1 / a, column-wise [m/N / m], times h
                                       ///< sqrt((lambda - mu) V) where that is positive, else 0
};

/// The operator of one body by slots, see RunSlots. Component c of an array is at [c * stride + slot].
struct SlotTangent {
    std::ptrdiff_t stride;
    std::ptrdiff_t vectorStride;                   ///< of the vectors that it is multiplied with
    const float* root[latticeDirectionCount];      ///< 3 components, at the lower slot of a connection; null: none such
    const float* across[latticeDirectionCount];    ///< [kg]
    const float* stiffness[latticeDirectionCount]; ///< k [N/m]
    const float* gradient; ///< 9 components: of each object's dilatation, times the root of its weight; null: none
    float* pressure;       ///< 9 components: the same, times its rate
    const float* mass;     ///< [kg]
};

/// A symmetric matrix of 6x6 blocks by rows, without those on the diagonal. A block has its columns one after the other, eight
/// numbers apart, of which six count; vectors have eight numbers per row as well, of which the last two are 0.
struct BlockRows {
    std::size_t rows;
    const std::uint32_t* begin;   ///< per row, into `columns` and `blocks`, and the end
    const std::uint32_t* behind;  ///< per row: where its columns beyond the diagonal begin
    const std::uint32_t* columns; ///< ascending in each row
    const float* blocks;
    const float* inverse; ///< of the blocks on the diagonal
};

struct TangentKernels {
    /// Adds sign k d to one column of the shape matrices, d from self to neighbor.
    void (*addShape)(std::size_t count, const ConstVectors& self, const ConstVectors& neighbor, const double* stiffness,
                     double sign, const Vectors& column);

    /// Writes what a connection adds to the operator M + h C + h^2 K: n n^T times h k (h + dampingTime) along it, and h^2 k
    /// max(0, 1 - l / L) across. As `root`, the vector whose dyad is the difference of the two, and `across` [kg].
    void (*connectionTangent)(std::size_t count, const ConstVectors& self, const ConstVectors& neighbor,
                              const double* stiffness, const double* nominalLength, const double* dampingTime,
                              double step, float* const (&root)[3], float* across);

    /// Writes the gradients times the root of their weights, for `SlotTangent`.
    void (*dilatationGradient)(std::size_t count, const GradientArguments& arguments);

    /// Adds a . b to sums[i % sumLanes].
    void (*dot)(std::size_t count, const double* a, const double* b, double* sums);

    // ---- By slots: arrays begin at slot 0, and have zeros where no object stands ----

    /// Writes tangent.pressure for velocities u.
    void (*slotPressures)(std::size_t count, const SlotBlock* blocks, const SlotTangent& tangent, const float* u);

    /// Writes A u, with pressures as slotPressures() left them. @return u A u of these blocks
    double (*slotProduct)(std::size_t count, const SlotBlock* blocks, const SlotTangent& tangent, const float* u,
                          float* product);

    /// Writes the 3x3 blocks on the diagonal: xx yy zz xy xz yz.
    void (*slotDiagonal)(std::size_t count, const SlotBlock* blocks, const SlotTangent& tangent,
                         double* const* diagonal);

    /// Inverts symmetric blocks xx yy zz xy xz yz; where there is nothing stays nothing.
    void (*invertBlocks)(std::size_t count, const double* const* blocks, float* const* inverse);

    /// x += factor p, r -= factor q.
    void (*descend)(std::size_t count, float factor, const float* p, const float* q, float* x, float* r);

    /// p = z + factor p.
    void (*turn)(std::size_t count, float factor, const float* z, float* p);

    /// z = B r with symmetric blocks xx yy zz xy xz yz. Component c at [c * stride].
    void (*multiplyBlocks)(std::size_t count, const float* const* blocks, const float* r, float* z,
                           std::ptrdiff_t stride);

    /// a . b
    double (*floatDot)(std::size_t count, const float* a, const float* b);

    /// Force and torque of momenta r in groups of four slots that begin at `fours`, into load[8], whose last two are 0.
    void (*restrictFours)(std::size_t count, const std::uint32_t* fours, const float* r, const float* arm,
                          std::ptrdiff_t stride, float* load);

    /// Adds what groups of four slots move by: group i with motions[8 motion[i]]..., turns last; -1: not at all.
    void (*prolongFours)(std::size_t count, const std::int32_t* motion, const float* motions, const float* arm,
                         float* z, std::ptrdiff_t stride);

    // ---- Gauss-Seidel sweeps over rows of blocks ----

    /// From x = 0 on, with ascending rows.
    void (*sweepAhead)(const BlockRows& rows, const float* load, float* x);

    /// What is left of the load after that.
    void (*leftAfterSweep)(const BlockRows& rows, const float* x, float* left);

    /// From x on, with descending rows.
    void (*sweepBack)(const BlockRows& rows, const float* load, float* x);
};

} // namespace knead::kernels
