#include "core/mechanics/connection_forces.h"

#include "core/mechanics/connection_flow.h"
#include "core/mechanics/connection_stress.h"
#include "core/mechanics/connection_surroundings.h"
#include "core/mechanics/rubber_connections.h"
#include "core/mechanics/structural_friction.h"

#include <algorithm>

namespace knead {

namespace {

/// Places of a margin under the numbers of the objects they stand for.
kernels::ForceTarget target(VectorArray& force, VectorArray& damping, std::size_t begin)
{
    return {force.data() - begin, damping.data() - begin, static_cast<std::ptrdiff_t>(force.stride())};
}

/// The last place up to here where a vector of a block may begin.
constexpr std::size_t vectorBegin(std::size_t place)
{
    return place / laneCount * laneCount;
}

kernels::ForceDirection forceDirection(const ConnectionData& data, std::size_t d)
{
    kernels::ForceDirection direction{};
    direction.stiffness = data.stiffness[d].data();
    const kernels::ObjectNumber lengths = data.nominalLengths(d);
    direction.nominalLength = lengths.each;
    direction.uniformLength = lengths.all;
    direction.dampingTime = data.dampingTime[d].empty() ? nullptr : data.dampingTime[d].data();
    if (const RubberBody* body = data.rubber(); body != nullptr && body->isWhole) {
        direction.nominalLength = nullptr;
        direction.uniformLength = 0;
        direction.uniformShare = kernels::rubberSpringShare;
    } else if (body != nullptr) {
        direction.nominalLength = body->springLength[d].data();
        direction.springShare = body->springShare[d].data();
    }
    for (std::size_t c = 0; c < 3; ++c)
        if (const int component = Lattice::directions[d][c]; component != 0) {
            direction.column[direction.columns] = data.stress[c].data();
            direction.sign[direction.columns] = component;
            ++direction.columns;
        }
    return direction;
}

void addForcesOfBlock(ConnectionData& data, ObjectState& state, std::size_t begin, std::size_t end)
{
    using Directions = std::array<kernels::ForceDirection, Lattice::directionCount>;
    Directions all; // of those in use
    for (std::size_t d = 0; d < Lattice::directionCount; ++d)
        if (!data.stiffness[d].empty())
            all[d] = forceDirection(data, d);
    const kernels::ForceTarget inside = target(state.force, state.damping, 0);
    kernels::ForceTarget beyond = inside;
    const bool isLast = end == state.size();
    if (!isLast) {
        ConnectionData::Margin& margin = data.margins[begin / data.blockSize];
        margin.force.setZero();
        margin.damping.setZero();
        beyond = target(margin.force, margin.damping, margin.begin);
    }
    // Vectors that begin before this keep what they give to objects `offset` further on inside the block.
    const auto limit = [&](std::ptrdiff_t offset) {
        return isLast ? end : vectorBegin(end - static_cast<std::size_t>(offset) - laneCount);
    };
    kernels::ForceArguments arguments{
        .position = state.position.data(),
        .velocity = state.velocity.data(),
        .stride = static_cast<std::ptrdiff_t>(state.position.stride()),
        .dampingTime = data.laws.largestDampingTime(),
        .stressStride = data.hasBulk || data.tensors ? static_cast<std::ptrdiff_t>(data.stress[0].stride()) : 0};
    Directions near;
    Directions far;
    forEachRun(data.runs, begin, end, [&](const LatticeRun& run, std::size_t first, std::size_t last) {
        while (first < last) {
            std::size_t until = limit(0) > first ? std::min(last, limit(0)) : last;
            std::size_t nearCount = 0;
            std::size_t farCount = 0;
            for (std::size_t d = 0; d < Lattice::directionCount; ++d) {
                if ((run.forward >> d & 1U) == 0)
                    continue;
                const bool isNear = limit(run.ahead[d]) > first;
                kernels::ForceDirection& direction = isNear ? near[nearCount++] : far[farCount++];
                direction = all[d];
                direction.offset = run.ahead[d];
                if (isNear)
                    until = std::min(until, limit(run.ahead[d]));
            }
            arguments.begin = first;
            arguments.end = until;
            arguments.own = limit(0) > first ? inside : beyond;
            arguments.neighbors = inside;
            arguments.directions = near.data();
            arguments.directionCount = nearCount;
            if (nearCount > 0)
                kernels::best().addForces(arguments);
            arguments.neighbors = beyond;
            arguments.directions = far.data();
            arguments.directionCount = farCount;
            if (farCount > 0)
                kernels::best().addForces(arguments);
            first = until;
        }
    });
}

void addMargins(const ConnectionData& data, ObjectState& state, std::size_t begin, std::size_t end)
{
    const auto add = [&](const ConnectionData::Margin& margin) {
        const std::size_t first = std::max(margin.begin, begin);
        const std::size_t last = std::min(margin.begin + margin.force.size(), end);
        for (std::size_t c = 0; c < 3; ++c) {
            const auto addComponent = [&](VectorArray& to, const VectorArray& from) {
                double* target = to.component(c);
                const double* given = from.component(c);
                for (std::size_t i = first; i < last; ++i)
                    target[i] += given[i - margin.begin];
            };
            addComponent(state.force, margin.force);
            addComponent(state.damping, margin.damping);
        }
    };
    const std::size_t block = begin / data.blockSize;
    if (block > 0)
        add(data.margins[block - 1]);
    if (block < data.margins.size())
        add(data.margins[block]);
}

/// On one thread: only published arrangements have it.
void addFriction(const ConnectionData& data, ObjectState& state, double dt)
{
    for (std::uint32_t d = 0; d < Lattice::directionCount; ++d) {
        const kernels::ObjectNumber lengths = data.nominalLengths(d);
        const kernels::ObjectNumber times = numberOf(data.dampingTime[d], data.laws.largestDampingTime());
        forEachPair(data.aggregate->lattice, d, 0, state.size(), [&](ObjectIndex i, ObjectIndex j) {
            const double k = data.stiffness[d][i];
            if (k == 0)
                return;
            const Vec3 force =
                structuralFriction({.across = state.position.at(j) - state.position.at(i),
                                    .velocity = state.velocity.at(j) - state.velocity.at(i),
                                    .stiffness = k,
                                    .damping = k * valueAt(times, i),
                                    .nominalLength = valueAt(lengths, i),
                                    .reducedMass = state.mass[i] * state.mass[j] / (state.mass[i] + state.mass[j])},
                                   data.structuralFriction, dt);
            state.damping.add(i, force);
            state.damping.add(j, -force);
        });
    }
}

} // namespace

void findForces(ConnectionData& data, ObjectState& state, double dt, double flowTime)
{
    const bool flows = data.laws.anyYields() && flowTime > 0;
    if (flows || data.hasTrial)
        data.forgetEnergy();
    data.hasTrial = false;
    if (flows)
        findFlow(data, state.position, flowTime);
    else if (data.hasBulk || data.tensors)
        findStress(data, state.position, WantedOfLaw::forces);
    if (data.rubber() != nullptr && (!data.rubber()->springsAreKnown || data.laws.anyYields()))
        findSprings(data);
    forEachBlock(state.size(), data.blockSize, [&](std::size_t begin, std::size_t end) {
        for (VectorArray* array : {&state.force, &state.damping})
            for (std::size_t c = 0; c < 3; ++c)
                std::fill_n(array->component(c) + begin, end - begin, 0.0);
        addForcesOfBlock(data, state, begin, end);
    });
    if (!data.margins.empty())
        forEachBlock(state.size(), data.blockSize,
                     [&](std::size_t begin, std::size_t end) { addMargins(data, state, begin, end); });
    if (data.structuralFriction > 0 && dt > 0)
        addFriction(data, state, dt);
}

} // namespace knead
