#pragma once

#include "core/kernels/tensor_law.h"

#include <cstddef>
#include <cstdint>

/// The innermost loops over objects and over lattice connections, each over contiguous objects whose neighbors are contiguous
/// too. See kernels.h for how they are compiled and picked.
namespace knead::kernels {

struct Vectors {
    double* x;
    double* y;
    double* z;
};

/// Where a kernel adds: component c of object i at [c * stride + i].
struct ForceTarget {
    double* force;
    double* damping;
    std::ptrdiff_t stride;
};

/// The connections of one direction in a run of objects.
struct ForceDirection {
    std::ptrdiff_t offset;               ///< from an object to its neighbor, > 0
    const double* stiffness;             ///< k per object
    const double* nominalLength;         ///< l per object; none: the same for all
    const double* dampingTime;           ///< b / k per object; none: the same for all
    double uniformLength;                ///< [m]
    const double* springShare = nullptr; ///< of k, for the spring alone, per object; none: the same for all
    double uniformShare = 1;
    int columns;             ///< lattice columns that the direction has a part in, 1 to 3; for the volumetric forces
    const double* column[3]; ///< those columns of the stress, component c of object i at [c * stride + i]
    double sign[3];          ///< of the direction along each of them
};

/// Forces of the connections whose lower ends are a run of objects. Arrays begin at object 0. They are LaneVectors and
/// VectorArrays: up to a vector's width around the run is read, and added to (zeros).
struct ForceArguments {
    std::size_t begin; ///< objects of the run
    std::size_t end;
    const double* position; ///< component c of object i at [c * stride + i]
    const double* velocity;
    std::ptrdiff_t stride;
    const ForceDirection* directions;
    std::size_t directionCount;
    double dampingTime;          ///< b / k of directions that have none of their own [s]
    std::ptrdiff_t stressStride; ///< 0: no volumetric forces
    ForceTarget own;             ///< of the objects of the run
    ForceTarget neighbors;       ///< of their neighbors
};

/// The volumetric stress of a run of objects.
struct StressArguments {
    Surroundings at;
    const double* bulk;    ///< (lambda - mu) V [J]
    double* const* stress; ///< 9, written: (p / a) F^-T K^-1, column-wise, p = (lambda - mu) V theta
    double* theta;         ///< written: ln det F - restDilatation, F = (sum k d o^T) K^-1 / a
};

/// Objects that move on. Arrays begin at the first of them, which is the first of a vector; the last vector is done whole.
struct AdvanceArguments {
    std::size_t count;
    double dt;                 ///< [s]
    const double* gravity;     ///< 3 components [m/s^2]
    const double* weighedMass; ///< that gravity pulls at [kg]
    const double* inverseMass; ///< of inertia; 0: held
    const double* force;       ///< component c of object i at [c * stride + i], as in the following
    const double* damping;
    double* velocity;
    double* position;
    std::ptrdiff_t stride;
};

struct AdvanceReport {
    double dampingWork;  ///< of the damping on the objects, with the mean of old and new velocity [J]
    double squaredSpeed; ///< largest; not a number when one is none [m^2/s^2]
};

/// det F below which the logarithm goes on as its tangent, so that squashed and inverted surroundings are pushed back with
/// a force that stays the gradient of an energy.
inline constexpr double smallestVolumeRatio = 0.1;

/// det F, or what counts for it where it is less.
[[gnu::always_inline]] inline double boundedVolumeRatio(double determinant)
{
    return determinant > smallestVolumeRatio ? determinant : smallestVolumeRatio;
}

/// ln det F, with its tangent below smallestVolumeRatio.
/// @param logarithm of positive numbers
template <typename Logarithm>
[[gnu::always_inline]] inline double logarithmOfVolume(double determinant, const Logarithm& logarithm)
{
    const double below = determinant < smallestVolumeRatio ? determinant / smallestVolumeRatio - 1 : 0.0;
    return logarithm(boundedVolumeRatio(determinant)) + below;
}

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

/// Partial sums that a reducing kernel keeps apart.
inline constexpr std::size_t sumLanes = 8;

struct LatticeKernels {
    /// Adds the forces of connections, k share (|d| - l) n, and with a stress the volumetric ones, to `force`; those of their dampers,
    /// k dampingTime v_n n, to `damping`. Neighbors get the exact opposite.
    void (*addForces)(const ForceArguments& arguments);

    void (*volumetricStress)(const StressArguments& arguments);

    /// Forces, and flow, of objects with the law of tensor_law.h.
    void (*tensorLaw)(const TensorLawArguments& arguments);

    /// Forces of objects with the law of hyperelastic_law.h; others keep what they have.
    void (*hyperelasticLaw)(const HyperelasticArguments& arguments);

    /// Writes ln det F - restDilatation, and F by lattice column unless `gradient` is null.
    void (*deformation)(const Surroundings& at, double* theta, double* const* gradient);

    /// Writes ln(L / l).
    void (*naturalStrain)(std::size_t count, const ConstVectors& self, const ConstVectors& neighbor,
                          const double* nominalLength, double* strain);

    /// Nominal lengths follow a flow.
    void (*lengthen)(std::size_t count, const LengthArguments& arguments);

    /// Whether any connection (of stiffness > 0) is longer than `factor` times its nominal length.
    bool (*anyLonger)(std::size_t count, const ConstVectors& self, const ConstVectors& neighbor,
                      const double* stiffness, const double* nominalLength, double factor);

    /// Writes by how much each connection's strain L / l - 1 exceeds a limit.
    void (*excessStrain)(std::size_t count, const ConstVectors& self, const ConstVectors& neighbor,
                         const double* nominalLength, const double* limit, double* excess);

    /// Semi-implicit Euler: v += dt (f + b + w g) / m, x += dt v, with the mass w that is weighed.
    AdvanceReport (*advance)(const AdvanceArguments& arguments);
};

} // namespace knead::kernels
