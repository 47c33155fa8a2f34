#pragma once

#include "core/session/skin_place.h"
#include "core/skin/skin_stress.h"

#include <limits>
#include <vector>

namespace knead {

/// What is read at a place of the skin.
enum class ProbeQuantity { displacement, strain, stress, force };

/// What a probe read at a moment. What is not known is not a number.
struct ProbeSample {
    static constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

    double time = 0;         ///< simulated [s]
    double displacement = 0; ///< from rest [m]
    double strain = unknown; ///< see equivalentStrain()
    double stress = unknown; ///< von Mises [Pa]
    double force = 0;        ///< of the material on all tools together, sum of their sizes [N]
};

/// Where a probe is, as its readings need it.
struct ProbePlace {
    std::shared_ptr<const FilledBody> body;
    BodyId id = 0;
    std::vector<ObjectShare> shares;
    std::shared_ptr<const SkinStress> stress; ///< of this one point
    SkinPlace place;
    Vec3 carried = Vec3::Zero(); ///< from the opened part to where it was when the body was filled [m]
};
/// Takes the longer the more objects the body has.
ProbePlace probePlace(const SkinPlace& place, const FilledBodies& bodies);

/// One sample per probe. Any thread.
/// @param withStrains strain and stress too, as the skin has them there (see SkinStress)
std::vector<ProbeSample> readProbes(const std::vector<ProbePlace>& probes, const Snapshot& snapshot, bool withStrains);

/// The same of a frame of the film, which knows of no stress in material that has flowed.
struct PlaybackFrame;
std::vector<ProbeSample> readProbes(const std::vector<ProbePlace>& probes, const PlaybackFrame& frame,
                                    bool withStrains);

} // namespace knead
