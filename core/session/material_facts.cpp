#include "core/session/material_facts.h"

#include <algorithm>

namespace knead {

namespace {

// A present-day core (README, "How fast it is"): connections of explicit steps in a second, what the volumetric term and flow
// multiply that by, and an object in an implicit step.
constexpr double connectionsPerSecond = 2.2e8;
constexpr double volumetricCost = 1.9;
constexpr double plasticCost = 0.5;
constexpr double implicitSecondsPerObject = 2.7e-6;
constexpr double latticePoissonRatio = 0.25; // without a volumetric term
constexpr double steppingShare = 0.85;       // of a frame that is left for steps

} // namespace

double expectedStepSeconds(const Snapshot& now)
{
    double cost = 0;
    for (const Material& material : now.materials) {
        const double bulk = material.poissonRatio == latticePoissonRatio ? 1 : volumetricCost;
        cost = std::max(cost, bulk + (material.yields() || material.breaks() ? plasticCost : 0));
    }
    return now.integrator == Integrator::implicitEuler
               ? cost * implicitSecondsPerObject * static_cast<double>(now.objects)
               : cost * static_cast<double>(now.connections) / connectionsPerSecond;
}

MaterialFacts factsOf(const FilledModel& content, const Snapshot& now, BodyId body, double secondsPerStep)
{
    MaterialFacts facts;
    facts.soundSpeed = now.materials[body].soundSpeed();
    facts.stableStep = now.stableStep;
    facts.isMeasured = secondsPerStep > 0;
    const double seconds = facts.isMeasured ? secondsPerStep : expectedStepSeconds(now);
    facts.ratio = seconds > 0 ? steppingShare * now.timeStep / seconds : 0;
    facts.cellsAcrossWall = content.fineness.cellsAcrossWall;
    return facts;
}

} // namespace knead
