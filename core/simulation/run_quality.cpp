#include "core/simulation/run_quality.h"

#include <array>
#include <cstdio>
#include <utility>

namespace knead {

namespace {

// Beyond these something is worth a word.
constexpr double smallPenetration = 0.1; // [spacings]
constexpr double smallImbalance = 0.01;
constexpr double smallAddedMass = 0.01;

template <typename... Values>
std::string text(const char* format, Values... values)
{
    std::array<char, 320> written{};
    std::snprintf(written.data(), written.size(), format, values...);
    return written.data();
}

} // namespace

RunQuality qualityOf(const Snapshot& now)
{
    return {.penetration = now.penetration,
            .imbalance = now.energy.imbalanceShare(),
            .addedMass = now.addedMass,
            .unsolvedSteps = now.unsolvedSteps,
            .steps = now.step};
}

std::vector<Remark> remarksOn(const RunQuality& quality)
{
    std::vector<Remark> remarks;
    const auto add = [&](Concern concern, std::string sentence) { remarks.push_back({concern, std::move(sentence)}); };
    if (quality.unsolvedSteps > 0)
        add(Concern::unsolved,
            text("The equations of %llu of %llu steps could not be solved: forces and places are not to be "
                 "trusted there. Make tools slower, or choose a shorter time step.",
                 static_cast<unsigned long long>(quality.unsolvedSteps),
                 static_cast<unsigned long long>(quality.steps)));
    if (quality.imbalance > smallImbalance)
        add(Concern::imbalance,
            text("Energy is off by %.2g %% of all that went round. Choose a shorter time step, or make tools slower.",
                 100 * quality.imbalance));
    if (quality.penetration > smallPenetration)
        add(Concern::penetration,
            text("Tools or the floor went %.2g spacings into material: shapes and forces there are rough. "
                 "Press less far, or choose a smaller spacing.",
                 quality.penetration));
    if (quality.addedMass > smallAddedMass)
        add(Concern::addedMass,
            text("Mass scaling made %.3g %% of the mass: what swings and what is thrown is slower than it "
                 "would be. Choose a shorter time step for it.",
                 100 * quality.addedMass));
    return remarks;
}

} // namespace knead
