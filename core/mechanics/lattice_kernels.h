#pragma once

#include <cstddef>
#include <vector>

/// The innermost loops over objects and over lattice connections, each over a contiguous stretch of objects whose neighbors
/// are contiguous too. Compiled for several instruction sets and dispatched at run time; the bits are the same on each, because every lane
/// does the same IEEE operations and fused multiply-add is off.
namespace knead::kernels {

/// Component pointers to the first object of a stretch.
struct ConstVectors {
    const double* x;
    const double* y;
    const double* z;
};
struct Vectors {
    double* x;
    double* y;
    double* z;
};

/// One end of a stretch of connections.
struct End {
    ConstVectors position;
    ConstVectors velocity;
};

/// Arrays of a stretch for the volumetric stress: lattice columns of 3x3 matrices, components of symmetric ones.
struct StressArguments {
    const double* const* shape;        ///< 9: M = sum k d o^T, column-wise
    const double* const* inverseShape; ///< 6: uu vv ww uv uw vw of K^-1 = (sum k o o^T)^-1
    const double* volume;              ///< V [m^3]
    double spacing;                    ///< a [m]
    double modulus;                    ///< lambda - mu [Pa]
    double* const* stress;             ///< 9, written: (p / a) F^-T K^-1, column-wise, p = (lambda - mu) V theta
    double* theta;                     ///< written: ln det F, F = M K^-1 / a
};

/// Smallest det F that the volumetric law follows; below it the pressure stays what it is there.
inline constexpr double smallestVolumeRatio = 0.1;

/// Partial sums that a reducing kernel keeps apart.
inline constexpr std::size_t sumLanes = 8;

/// The kernels of one instruction set.
struct Kernels {
    /// Writes the pull of the neighbors on one end of each connection: k (|d| - l) n to `force`, k dampingTime v_n n to
    /// `damping`. The other end feels the opposite. `stiffness` and `nominalLength` are in the order of the stretch.
    void (*connectionForces)(std::size_t count, const End& self, const End& neighbor, const double* stiffness,
                             const double* nominalLength, double dampingTime, const Vectors& force,
                             const Vectors& damping);

    /// Adds sign from to target.
    void (*addScaled)(std::size_t count, double sign, const ConstVectors& from, const Vectors& target);

    /// Adds sign k d to one column of the shape matrices, d from self to neighbor.
    void (*addShape)(std::size_t count, const ConstVectors& self, const ConstVectors& neighbor, const double* stiffness,
                     double sign, const Vectors& column);

    void (*volumetricStress)(std::size_t count, const StressArguments& arguments);

    /// Adds sign k (self + neighbor) to the force: the share of one lattice column in the volumetric forces.
    void (*addVolumetricForces)(std::size_t count, const ConstVectors& self, const ConstVectors& neighbor,
                                const double* stiffness, double sign, const Vectors& force);

    /// Semi-implicit Euler for one component: v += dt ((f + b) / m + g), x += dt v. Adds the work of b with the mean of old
    /// and new velocity to work[i % sumLanes], so that the sum does not depend on the width of the instructions.
    void (*advance)(std::size_t count, double dt, double gravity, const double* mass, const double* inverseMass,
                    const double* force, const double* damping, double* velocity, double* position, double* work);

    const char* name; ///< "x86-64", "AVX2", "AVX-512"
};

/// All sets that this machine can run, the plainest first. They give the same bits.
const std::vector<Kernels>& available();

/// The widest available set.
const Kernels& best();

} // namespace knead::kernels
