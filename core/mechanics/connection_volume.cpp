#include "core/mechanics/connection_volume.h"

#include "core/mechanics/connection_flow.h"
#include "core/mechanics/connection_stress.h"
#include "core/mechanics/connection_surroundings.h"
#include "core/task/block_sums.h"

#include <algorithm>
#include <cmath>

namespace knead {

namespace {

// Equivalent plastic strain from which on an object takes part a little, and wholly.
constexpr double flowedLittle = 0.1;
constexpr double flowedMuch = 0.3;
// Of ln V: less is not worth a change.
constexpr double leastGap = 5e-5;
// And more would be felt as a jump of pressure, as would a part of the yield stress [of ln V; of the stress].
constexpr double mostStep = 1e-3;
constexpr double mostOfYield = 0.3;
// What has flowed is not blamed for more, which is elsewhere; a surface of which more is missing is folded [of ln V].
constexpr double mostAdded = 0.03;
constexpr double mostLost = 0.06;

/// None of what is flat: it has no J.
double partOf(const ConnectionData& data, std::size_t object)
{
    if (data.inverseShape[0][object] == 0)
        return 0;
    const double flowed = data.changes.plastic.equivalentStrain[object];
    return std::clamp((flowed - flowedLittle) / (flowedMuch - flowedLittle), 0.0, 1.0);
}

/// That no material feels as more than a part of its yield stress.
double largestStep(const ConnectionData& data)
{
    double step = mostStep;
    for (const Material& material : data.materials->materials())
        if (material.yields())
            step = std::min(step, mostOfYield * material.yieldStress /
                                      (material.lameLambda() + 2.0 / 3 * material.shearModulus()));
    return step;
}

template <typename Term>
double sumOverObjects(const ConnectionData& data, Term&& term)
{
    return sumOverBlocks(data.aggregate->size(), data.blockSize, [&](std::size_t begin, std::size_t end) {
        double sum = 0;
        for (std::size_t i = begin; i < end; ++i)
            sum += term(i);
        return sum;
    });
}

} // namespace

double flowedShare(const ConnectionData& data)
{
    if (data.changes.plastic.equivalentStrain.empty())
        return 0;
    const std::vector<double>& volume = data.aggregate->volume;
    return sumOverObjects(data, [&](std::size_t i) { return partOf(data, i) * volume[i]; }) /
           sumOverObjects(data, [&](std::size_t i) { return volume[i]; });
}

double volumeAtRest(const ConnectionData& data)
{
    const std::vector<double>& volume = data.aggregate->volume;
    const LaneVector<double>& rest = data.changes.restDilatation;
    return sumOverObjects(data, [&](std::size_t i) { return volume[i] * std::exp(rest[i]); });
}

double keepVolume(ConnectionData& data, const VectorArray& position, double enclosed)
{
    const std::vector<double>& volume = data.aggregate->volume;
    LaneVector<double>& rest = data.changes.restDilatation;
    forEachSurroundings(data, position, [&](const kernels::Surroundings& at) {
        kernels::best().deformation(at, data.theta.data(), nullptr);
    });
    const double present = volumeAtRest(data);
    const double kept = keptVolume(data);
    const double pressed =
        sumOverObjects(data, [&](std::size_t i) { return volume[i] * std::exp(rest[i] + data.theta[i]); });
    const double whenFilled = sumOverObjects(data, [&](std::size_t i) { return volume[i]; });
    // What is to be added without pressure, in ln V, less what was: as far as what has flowed may take it.
    const double share = flowedShare(data);
    const double lost = std::log(pressed / (enclosed * whenFilled));
    const double gap = std::clamp(lost, -mostAdded * share, mostAdded * share) - std::log(present / kept);
    if (!(std::abs(gap) > leastGap) || std::abs(lost) > mostLost)
        return 0;
    const double most = largestStep(data);
    const double step = std::clamp(gap / share, -most, most);

    rejectFlow(data);
    const double before = storedEnergy(data, position);
    data.changes.keptVolume = kept;
    for (std::size_t i = 0; i < rest.size(); ++i)
        rest[i] += partOf(data, i) * step;
    ++data.lengthVersion;
    data.forgetEnergy();
    return before - storedEnergy(data, position);
}

} // namespace knead
