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
    const double* bulk;                ///< (lambda - mu) V [J]
    const double* restDilatation;      ///< theta at which there is no pressure
    double spacing;                    ///< a [m]
    double* const* stress;             ///< 9, written: (p / a) F^-T K^-1, column-wise, p = (lambda - mu) V theta
    double* theta;                     ///< written: ln det F - restDilatation, F = M K^-1 / a
};

/// det F below which the logarithm goes on as its tangent, so that squashed and inverted surroundings are pushed back with
/// a force that stays the gradient of an energy.
inline constexpr double smallestVolumeRatio = 0.1;

/// ln det F of surroundings that are flat; less when they are inside out.
inline constexpr double flatDilatation = -3.302585092994046;

/// The strain g that a volumetric energy 1/2 B g^2 is made of: theta, the logarithm of the volume ratio. Where B is negative
/// (Poisson's ratio below 1/4) and volume is lost, theta / (1 - theta), which is the same for small strains and cannot
/// outweigh the connections when material is squashed; it stays what it is once that is flat.
inline double volumetricStrain(double bulk, double theta, double restDilatation)
{
    if (bulk >= 0 || theta >= 0)
        return theta;
    const double flat = flatDilatation - restDilatation;
    const double least = theta < flat ? flat : theta;
    return least / (1 - least);
}

/// Arrays of a stretch of connections that flow. Strains are ln(L / l) less a third of the dilatation at the two ends.
struct FlowArguments {
    ConstVectors self;
    ConstVectors neighbor;
    const double* selfDilatation;
    const double* neighborDilatation;
    const double* stiffness;
    const double* yieldStrain;
    const double* hardening;
    const double* share; ///< of the strain beyond yield that flows off now, 0 .. 1
    double* nominalLength;
    double* plasticStrain; ///< sum of all flow so far
    double* dissipated;    ///< sumLanes partial sums [J]
};

/// Where the dilatation at an end is below this (a quarter of the volume left), connections do not flow: what F says about
/// the volume there is no longer reliable.
inline constexpr double leastFlowingDilatation = -1.4;

/// Partial sums that a reducing kernel keeps apart.
inline constexpr std::size_t sumLanes = 8;

/// The kernels of one instruction set.
struct Kernels {
    /// Writes the pull of the neighbors on one end of each connection: k (|d| - l) n to `force`, k dampingTime v_n n to
    /// `damping`. The other end feels the opposite. `stiffness` and `nominalLength` are in the order of the stretch.
    void (*connectionForces)(std::size_t count, const End& self, const End& neighbor, const double* stiffness,
                             const double* nominalLength, const double* dampingTime, const Vectors& force,
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

    void (*flow)(std::size_t count, const FlowArguments& arguments);

    /// Writes by how much each connection's strain L / l - 1 exceeds a limit.
    void (*excessStrain)(std::size_t count, const ConstVectors& self, const ConstVectors& neighbor,
                         const double* nominalLength, const double* limit, double* excess);

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
