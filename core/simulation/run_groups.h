#pragma once

#include "core/geometry/vec3.h"
#include "core/message/message.h"
#include "core/simulation/pace.h"
#include "core/simulation/scene.h"
#include "core/simulation/snapshot.h"

#include <cstdint>
#include <optional>

// What a run is described by, in groups that belong together. Moments keep these.
namespace knead {

/// What acts from outside, wherever something is.
struct Surroundings {
    Vec3 gravity = Vec3::Zero();       ///< [m/s^2]
    std::optional<double> floorHeight; ///< z [m]
    double floorFriction = 0;
    double floorAdhesion = 0; ///< [Pa]
};

/// How velocities and positions are advanced.
struct Scheme {
    Integrator wanted = Integrator::semiImplicitEuler;
    Integrator inUse = Integrator::semiImplicitEuler; ///< never automatic
    Message reason;                                   ///< a sentence on why it is the one
    Pace pace = Pace::full;
    int iterations = 0; ///< of the solver in the last implicit step

    bool isImplicit() const { return inUse == Integrator::implicitEuler; }
};

/// Where the run is in time, and how it goes on.
struct StepTimes {
    std::uint64_t count = 0; ///< steps taken
    double time = 0;         ///< [s]
    double length = 0;       ///< of the step under way, or else of the next one [s]
    double last = 0;         ///< by which positions moved last [s]; 0 at the start
    double stable = 0;       ///< largest stable one at the last look [s]
    double crowding = 1;     ///< contacts at a time that the time step allows an object
};

/// What is booked, beside what the state stores.
struct Accounts {
    EnergyLedger energy; ///< what came in and went out is kept up to date
    double atStart = 0;  ///< stored at the start [J]
    double placed = 0;   ///< stored in contacts by tools and a floor that were put into material, so far [J]
    /// What of the stored energy is not known right after going to a moment, since the forces of the last step are
    /// gone [J]: the ledger counts it until the next step.
    double unknown = 0;
};

/// What tells whether a run can go on.
struct RunWatch {
    std::uint64_t unsolved = 0;      ///< implicit steps so far whose equations were not solved
    std::uint32_t unsolvedInRow = 0; ///< the last ones
    bool isPlacedInside = false;     ///< a tool or the floor was put into material, and that is not booked yet
    bool wasSquashed = false;        ///< at the last look
    Health health;
};

} // namespace knead
