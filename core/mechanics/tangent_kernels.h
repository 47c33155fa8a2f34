#pragma once

#include "core/mechanics/lattice_kernels.h"

#include <cstddef>
#include <vector>

/// The innermost loops of the implicit scheme: over stretches of connections, as in lattice_kernels.h, and over objects.
/// Compiled for several instruction sets and dispatched at run time, with the same bits on each.
namespace knead::kernels {

/// Arrays of a stretch of objects for the change of their dilatation with the places around them.
struct GradientArguments {
    const double* const* shape;        ///< 9: M = sum k d o^T, column-wise
    const double* const* inverseShape; ///< 6: uu vv ww uv uw vw of K^-1 = (sum k o o^T)^-1
    const double* bulk;                ///< (lambda - mu) V [J]
    double spacing;                    ///< a [m]
    double step;                       ///< h [s]
    double* const* gradient;           ///< 9, written: G = F^-T K^-1 / a, column-wise [m/N / m]
    double* weight;                    ///< written: h^2 (lambda - mu) V where that is positive, else 0 [J s^2]
};

/// The kernels of one instruction set.
struct TangentKernels {
    /// Adds sign from to target.
    void (*addScaled)(std::size_t count, double sign, const ConstVectors& from, const Vectors& target);

    /// Adds sign k d to one column of the shape matrices, d from self to neighbor.
    void (*addShape)(std::size_t count, const ConstVectors& self, const ConstVectors& neighbor, const double* stiffness,
                     double sign, const Vectors& column);

    /// Writes what a connection adds to the operator M + h C + h^2 K: n n^T times h k (h + dampingTime) along it, and h^2 k
    /// max(0, 1 - l / L) across. As `root`, the vector whose dyad is the difference of the two, and `across` [kg].
    void (*connectionTangent)(std::size_t count, const ConstVectors& self, const ConstVectors& neighbor,
                              const double* stiffness, const double* nominalLength, const double* dampingTime,
                              double step, const Vectors& root, double* across);

    /// Writes (root root^T + across) (u_neighbor - u_self).
    void (*connectionPull)(std::size_t count, const ConstVectors& self, const ConstVectors& neighbor,
                           const ConstVectors& root, const double* across, const Vectors& pull);

    /// Adds root root^T + across to the diagonal blocks of objects: xx yy zz xy xz yz.
    void (*addConnectionBlocks)(std::size_t count, const ConstVectors& root, const double* across,
                                double* const* blocks);

    void (*dilatationGradient)(std::size_t count, const GradientArguments& arguments);

    /// Writes sum over c of steps[c] gradient column c: the gradient towards one lattice direction.
    void (*combineColumns)(std::size_t count, const double* const* gradient, const double* steps,
                           const Vectors& combined);

    /// Adds k gradient . (u_neighbor - u_self) to the rate of dilatation of the objects whose gradients are given.
    void (*addDilatationRate)(std::size_t count, const ConstVectors& self, const ConstVectors& neighbor,
                              const double* stiffness, const ConstVectors& gradient, double* rate);

    /// Adds k (p_self g_self + p_neighbor g_neighbor) to the pull, where p = rate weight.
    void (*addPressurePull)(std::size_t count, const double* stiffness, const double* const (&pressure)[2],
                            const ConstVectors (&gradient)[2], const Vectors& pull);

    /// Adds a . b to sums[i % sumLanes].
    void (*dot)(std::size_t count, const double* a, const double* b, double* sums);

    /// x += factor p, r -= factor q.
    void (*descend)(std::size_t count, double factor, const double* p, const double* q, double* x, double* r);

    /// p = z + factor p.
    void (*turn)(std::size_t count, double factor, const double* z, double* p);

    /// z = B r with symmetric blocks xx yy zz xy xz yz.
    void (*multiplyBlocks)(std::size_t count, const double* const* blocks, const ConstVectors& r, const Vectors& z);

    const char* name; ///< "x86-64", "AVX2", "AVX-512"
};

/// All sets that this machine can run, the plainest first. They give the same bits.
const std::vector<TangentKernels>& availableTangents();

/// The widest available set.
const TangentKernels& bestTangents();

} // namespace knead::kernels
