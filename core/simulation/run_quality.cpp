#include "core/simulation/run_quality.h"

#include "core/message/number_text.h"

#include <utility>

namespace knead {

namespace {

// Beyond these something is worth a word.
constexpr double smallPenetration = 0.1; // [spacings]
constexpr double smallImbalance = 0.01;
constexpr double smallAddedMass = 0.01;
// Up to these nobody needs to stop working: a thumb that is pressed into clay or rubber as it comes reaches the half of them.
constexpr double minorPenetration = 0.5; // [spacings]
constexpr double minorImbalance = 0.05;

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
    const auto add = [&](Concern concern, Message sentence, bool isMinor = false) {
        remarks.push_back({concern, std::move(sentence), isMinor});
    };
    if (quality.unsolvedSteps > 0)
        add(Concern::unsolved,
            Message("Run",
                    "The equations of %1 of %2 steps could not be solved: forces and places are not to be trusted "
                    "there. Make tools slower, or choose a shorter time step.")
                .with(quality.unsolvedSteps, quality.steps));
    if (quality.imbalance > smallImbalance)
        add(Concern::imbalance,
            Message("Run",
                    "Energy is off by %1 % of all that went round. Choose a shorter time step, or make tools slower.")
                .with(inDigits(100 * quality.imbalance, 2)),
            quality.imbalance < minorImbalance);
    if (quality.penetration > smallPenetration)
        add(Concern::penetration,
            Message("Run",
                    "Tools or the floor went %1 spacings into material: shapes and forces there are rough. Press less "
                    "far, or choose a smaller spacing.")
                .with(inDigits(quality.penetration, 2)),
            quality.penetration < minorPenetration);
    if (quality.addedMass > smallAddedMass)
        add(Concern::addedMass,
            Message("Run",
                    "Mass scaling made %1 % of the mass: what swings and what is thrown is slower than it would be. "
                    "Choose a shorter time step for it.")
                .with(inDigits(100 * quality.addedMass, 3)));
    return remarks;
}

} // namespace knead
