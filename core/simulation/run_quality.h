#pragma once

#include "core/simulation/snapshot.h"

#include <cstdint>
#include <string>
#include <vector>

namespace knead {

/// How far the numbers of a run may be trusted.
struct RunQuality {
    double penetration = 0;          ///< of tools and the floor into material, largest [spacings]
    double imbalance = 0;            ///< of energy, as a share of all that went round, 0 .. 1
    double addedMass = 0;            ///< by mass scaling, as a share of all mass
    std::uint64_t unsolvedSteps = 0; ///< implicit ones whose equations were not solved as well as they must be
    std::uint64_t steps = 0;
};

RunQuality qualityOf(const Snapshot& now);

/// What a remark is about.
enum class Concern : std::uint8_t { unsolved, imbalance, penetration, addedMass };

/// Something that a person should know.
struct Remark {
    Concern concern;
    Message sentence;     ///< with what to do
    bool isMinor = false; ///< shapes suffice to look at and to work on; who takes numbers from the run should know
};

/// Empty when all is well.
std::vector<Remark> remarksOn(const RunQuality& quality);

} // namespace knead
