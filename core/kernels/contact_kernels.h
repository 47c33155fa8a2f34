#pragma once

#include <cstddef>
#include <cstdint>

/// Contacts of points of material with a rigid surface in explicit steps, eight at a time: where the points are, where the surface is
/// nearest to them, the law of contact_law.h, and what it does to the objects that carry the points. See kernels.h for how they are
/// compiled and picked.
namespace knead::kernels {

/// Points of a stretch that the same objects carry, x = sum w_i x_i (PointSpread).
struct PointGroup {
    static constexpr std::size_t most = 8;
    std::uint32_t begin;
    std::uint32_t end;
    std::uint32_t weights; ///< where those of the first point are, those of the next are behind them
    std::uint32_t count;   ///< of objects
    std::uint32_t objects[most];
};
struct CarriedPoints {
    std::size_t groupCount;
    const PointGroup* groups;
    const double* weights;
};

/// What is known of an object, and what is done to it, one after the other: a vector is a whole number of objects.
inline constexpr std::size_t motionSize = 8;  ///< place [m], velocity [m/s], room for two
inline constexpr std::size_t effectSize = 16; ///< see ContactEffect, and room
enum ContactEffect : std::size_t {
    springForce = 0,   ///< 3: conservative part of the force [N]
    dampingForce = 3,  ///< 3: of damper and friction [N]
    frictionForce = 6, ///< 3: of friction alone [N]
    addedSlope = 9,    ///< a bound on the stiffness that it adds, by |w_i| [N/m]
    storedEnergy = 10, ///< in the spring [J]
    isTouched = 11,    ///< more than 0 where any point touches, by |w_i|
    contactEffectCount = 12,
};

/// Surfaces whose distance is a formula.
enum class SurfaceForm { floor, box, ball, cylinder };

struct PlacedForm {
    SurfaceForm form;
    double half[3]; ///< edges by two: [0] is the radius of balls and cylinders, [2] half the length of a cylinder [m]
    double rotation[9]; ///< by columns, local axes to the world
    double center[3];   ///< of a floor z is its height [m]
};

/// Columns of a stretch of points, up to a whole vector: behind the last point they are read and written, too. Outputs never overlap
/// inputs.
struct ContactColumns {
    std::size_t count;
    double duration;           ///< of the step [s]
    double rotation[9];        ///< of the surface, as in PlacedForm
    double center[3];          ///< [m]
    double surfaceVelocity[3]; ///< of the center [m/s]
    double angularVelocity[3]; ///< [rad/s]
    const double* place[3];    ///< [m]
    const double* velocity[3]; ///< [m/s]
    const double* overlap;     ///< > 0 where they touch; also behind the last point up to a whole vector [m]
    const double* normal[3];   ///< unit
    const double* weightSum;   ///< of |w_i|
    const double* stiffness;   ///< from here on see ContactParameters
    const double* damping;
    const double* friction;
    const double* inverseStiffening; ///< 1 / d0
    const double* steepest;
    const double* mass;
    const double* largestOverlap;
    const double* kept;      ///< pressureKept()
    const double* keptApart; ///< pressureKeptApart()
    double* hold[3];         ///< of FrictionMemory, in the frame of the surface [N]
    double* pressure;        ///< the same [N]
    double* effects;         ///< effectSize per point: written where any of eight touches, 0 for those that do not
};

/// Of all points of a stretch.
struct ContactTotals {
    std::size_t touching;
    double steepness; ///< largest d / d0, of no more than d1
};

struct ContactKernels {
    /// Places and velocities of points, as columns. @param motions motionSize per object
    void (*gatherPoints)(const CarriedPoints& points, const double* motions, double* const (&columns)[6]);

    /// Signed distances and outward normals. @param place columns
    void (*nearestOfForm)(const PlacedForm& form, std::size_t count, const double* const (&place)[3], double* distance,
                          double* const (&normal)[3]);

    /// contactForce() of an explicit step, without adhesion.
    ContactTotals (*contactLaw)(const ContactColumns& columns);

    /// Adds what is done to points that touch to the objects that carry them. @param effects effectSize per point
    void (*scatterEffects)(const CarriedPoints& points, const double* overlap, const double* effects, double* objects);
};

/// Speed that a contact may give in an explicit step, by what takes its end out of the overlap in one, but no more of that than bears
/// the largest pressures: a sound step stays below.
inline constexpr double mostTurned = 1.5;

} // namespace knead::kernels
