#include "app/run_quality.h"

#include <nlohmann/json.hpp>

#include <array>
#include <cstdio>

namespace knead {

namespace {

// Beyond these something is worth a word.
constexpr double smallPenetration = 0.5; // [spacings]
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

RunQuality qualityOf(const Snapshot& end)
{
    return {.penetration = end.penetration,
            .imbalance = end.energy.imbalanceShare(),
            .addedMass = end.addedMass,
            .unsolvedSteps = end.unsolvedSteps,
            .steps = end.step};
}

std::vector<std::string> remarksOn(const RunQuality& quality)
{
    std::vector<std::string> remarks;
    if (quality.unsolvedSteps > 0)
        remarks.push_back(text(
            "The equations of %llu of %llu steps could not be solved: forces and places are not to be "
            "trusted there. Make tools slower, or choose a shorter time step.",
            static_cast<unsigned long long>(quality.unsolvedSteps), static_cast<unsigned long long>(quality.steps)));
    if (quality.imbalance > smallImbalance)
        remarks.push_back(text("Energy is off by %.2g %% of all that went round. Choose a shorter time step, or make "
                               "tools slower.",
                               100 * quality.imbalance));
    if (quality.penetration > smallPenetration)
        remarks.push_back(
            text("Tools or the floor went %.2g spacings into material: shapes and forces there are rough. "
                 "Press less far, or choose a smaller spacing.",
                 quality.penetration));
    if (quality.addedMass > smallAddedMass)
        remarks.push_back(
            text("Mass scaling made %.3g %% of the mass: what swings and what is thrown is slower than it "
                 "would be. Choose a shorter time step for it.",
                 100 * quality.addedMass));
    return remarks;
}

nlohmann::ordered_json qualityToJson(const RunQuality& quality)
{
    return {{"penetration_spacings", quality.penetration},
            {"imbalance_share", quality.imbalance},
            {"added_mass_share", quality.addedMass},
            {"steps_not_converged", quality.unsolvedSteps}};
}

} // namespace knead
