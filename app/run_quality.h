#pragma once

#include "core/simulation/snapshot.h"

#include <nlohmann/json_fwd.hpp>

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

RunQuality qualityOf(const Snapshot& end);

/// What a person should know of it: a sentence each, with what to do. Empty when all is well.
std::vector<std::string> remarksOn(const RunQuality& quality);

/// As the keys of a report.
nlohmann::ordered_json qualityToJson(const RunQuality& quality);

} // namespace knead
