// The forces of a body's connections: part of StructuralConnections.
#include "core/mechanics/lattice_kernels.h"
#include "core/mechanics/lattice_stretches.h"
#include "core/mechanics/structural_connections.h"
#include "core/mechanics/structural_friction.h"
#include "core/task/parallel.h"

#include <algorithm>
#include <array>

namespace knead {

namespace {

/// Calls run(part) for the parts of runs that lie in begin .. end.
template <typename Run>
void forEachRun(const std::vector<LatticeRun>& runs, std::size_t begin, std::size_t end, Run run)
{
    auto next = std::partition_point(runs.begin(), runs.end(), [&](const LatticeRun& r) { return r.end <= begin; });
    for (; next != runs.end() && next->begin < end; ++next)
        run(*next, std::max<std::size_t>(next->begin, begin), std::min<std::size_t>(next->end, end));
}

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

} // namespace

/// Calls run() for the runs of objects whose stress is found together, on several threads.
void StructuralConnections::forEachSurroundings(const VectorArray& position,
                                                const std::function<void(const kernels::Surroundings&)>& run) const
{
    const auto stiffness = pointersTo<const double*>(m_stiffness);
    const auto inverseShape = pointersTo<const double*>(m_inverseShape);
    forEachBlock(position.size(), m_blockSize, [&](std::size_t begin, std::size_t end) {
        forEachRun(m_stressRuns, begin, end, [&](const LatticeRun& part, std::size_t first, std::size_t last) {
            run({.begin = first,
                 .end = last,
                 .position = position.data(),
                 .stride = static_cast<std::ptrdiff_t>(position.stride()),
                 .forward = part.forward,
                 .backward = part.backward,
                 .ahead = part.ahead.data(),
                 .behind = part.behind.data(),
                 .hasBehind = m_hasBehind.data(),
                 .stiffness = stiffness.data(),
                 .inverseShape = inverseShape.data(),
                 .restDilatation = m_changes.restDilatation.data(),
                 .spacing = m_aggregate->lattice.spacing});
        });
    });
}

/// Where the stress of objects goes, column by column.
std::array<double*, 9> StructuralConnections::stressColumns(std::size_t objects)
{
    std::array<double*, 9> stress{};
    for (VectorArray& column : m_stress)
        if (column.size() != objects)
            column.resize(objects);
    for (std::size_t c = 0; c < 9; ++c)
        stress[c] = m_stress[c / 3].component(c % 3);
    return stress;
}

void StructuralConnections::computeStress(const VectorArray& position, bool withEnergy)
{
    if (m_tensors) {
        applyTensorLaw(position, nullptr, withEnergy);
        return;
    }
    const std::array<double*, 9> stress = stressColumns(position.size());
    forEachSurroundings(position, [&](const kernels::Surroundings& at) {
        kernels::best().volumetricStress(
            {.at = at, .bulk = m_bulk.data(), .stress = stress.data(), .theta = m_theta.data()});
    });
    for (const ObjectIndex object : m_flat)
        m_theta[object] = 0;
}

kernels::ForceDirection StructuralConnections::forceDirection(std::size_t d) const
{
    kernels::ForceDirection direction{};
    direction.stiffness = m_stiffness[d].data();
    const LaneVector<double>& lengths = plasticState().nominalLength[d];
    direction.nominalLength = lengths.empty() ? nullptr : lengths.data();
    direction.dampingTime = m_dampingTime[d].empty() ? nullptr : m_dampingTime[d].data();
    direction.uniformLength = m_aggregate->lattice.direction(static_cast<int>(d)).norm();
    if (const RubberBody* body = rubber(); body != nullptr && body->isWhole) {
        direction.nominalLength = nullptr;
        direction.uniformLength = 0;
        direction.uniformShare = kernels::rubberSpringShare;
    } else if (body != nullptr) {
        direction.nominalLength = body->springLength[d].data();
        direction.springShare = body->springShare[d].data();
    }
    for (std::size_t c = 0; c < 3; ++c)
        if (const int component = Lattice::directions[d][c]; component != 0) {
            direction.column[direction.columns] = m_stress[c].data();
            direction.sign[direction.columns] = component;
            ++direction.columns;
        }
    return direction;
}

void StructuralConnections::addForcesOfBlock(ObjectState& state, std::size_t begin, std::size_t end)
{
    using Directions = std::array<kernels::ForceDirection, Lattice::directionCount>;
    Directions all; // of those in use
    for (std::size_t d = 0; d < Lattice::directionCount; ++d)
        if (!m_stiffness[d].empty())
            all[d] = forceDirection(d);
    const kernels::ForceTarget inside = target(state.force, state.damping, 0);
    kernels::ForceTarget beyond = inside;
    const bool isLast = end == state.size();
    if (!isLast) {
        Margin& margin = m_margins[begin / m_blockSize];
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
        .dampingTime = m_laws.largestDampingTime(),
        .stressStride = m_hasBulk || m_tensors ? static_cast<std::ptrdiff_t>(m_stress[0].stride()) : 0};
    Directions near;
    Directions far;
    forEachRun(m_runs, begin, end, [&](const LatticeRun& run, std::size_t first, std::size_t last) {
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

void StructuralConnections::addMargins(ObjectState& state, std::size_t begin, std::size_t end) const
{
    const auto add = [&](const Margin& margin) {
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
    const std::size_t block = begin / m_blockSize;
    if (block > 0)
        add(m_margins[block - 1]);
    if (block < m_margins.size())
        add(m_margins[block]);
}

void StructuralConnections::computeForces(ObjectState& state, double dt, double flowTime)
{
    const bool flows = yields() && flowTime > 0;
    if (flows || m_hasTrial)
        forgetEnergy();
    m_hasTrial = false;
    if (flows)
        flow(state.position, flowTime);
    else if (m_hasBulk || m_tensors)
        computeStress(state.position, false);
    if (rubber() != nullptr && (!rubber()->springsAreKnown || yields()))
        findSprings();
    forEachBlock(state.size(), m_blockSize, [&](std::size_t begin, std::size_t end) {
        for (VectorArray* array : {&state.force, &state.damping})
            for (std::size_t c = 0; c < 3; ++c)
                std::fill_n(array->component(c) + begin, end - begin, 0.0);
        addForcesOfBlock(state, begin, end);
    });
    if (!m_margins.empty())
        forEachBlock(state.size(), m_blockSize,
                     [&](std::size_t begin, std::size_t end) { addMargins(state, begin, end); });
    if (m_structuralFriction > 0 && dt > 0)
        addFriction(state, dt);
}

/// On one thread: only published arrangements have it.
void StructuralConnections::addFriction(ObjectState& state, double dt) const
{
    for (std::uint32_t d = 0; d < Lattice::directionCount; ++d)
        forEachForward(m_aggregate->lattice, d, 0, state.size(),
                       [&](std::size_t i, std::size_t j, std::size_t lower, std::size_t n) {
                           for (std::size_t s = 0; s < n; ++s) {
                               const double k = m_stiffness[d][lower + s];
                               if (k == 0)
                                   continue;
                               const double time =
                                   m_dampingTime[d].empty() ? m_laws.largestDampingTime() : m_dampingTime[d][lower + s];
                               const Vec3 force = knead::structuralFriction(
                                   {.across = state.position.at(j + s) - state.position.at(i + s),
                                    .velocity = state.velocity.at(j + s) - state.velocity.at(i + s),
                                    .stiffness = k,
                                    .damping = k * time,
                                    .nominalLength = nominalLength({d, static_cast<ObjectIndex>(lower + s)}),
                                    .reducedMass = state.mass[i + s] * state.mass[j + s] /
                                                   (state.mass[i + s] + state.mass[j + s])},
                                   m_structuralFriction, dt);
                               state.damping.add(i + s, force);
                               state.damping.add(j + s, -force);
                           }
                       });
}

} // namespace knead
