#include "core/integration/rigid_mode_preconditioner.h"

#include "core/integration/solver_settings.h"
#include "core/kernels/kernels.h"
#include "core/task/block_sums.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace knead {

namespace {

using Vec6 = RigidModeLevels::Vec6;

constexpr std::size_t slotsAtATime = 2048; // whole lanes of every kind
constexpr std::size_t clustersAtATime = 64;

void addBlock(std::array<LaneVector<double>, 6>& blocks, std::size_t slot, const Mat3& matrix)
{
    const double entries[] = {matrix(0, 0), matrix(1, 1), matrix(2, 2), matrix(0, 1), matrix(0, 2), matrix(1, 2)};
    for (std::size_t c = 0; c < 6; ++c)
        blocks[c][slot] += entries[c];
}

} // namespace

double scaleOf(const VectorArray& rows)
{
    double largest = 0;
    for (std::size_t c = 0; c < 3; ++c)
        for (std::size_t i = 0; i < rows.size(); ++i)
            largest = std::max(largest, std::abs(rows.component(c)[i]));
    if (!(largest > 0) || !std::isfinite(largest))
        return 1;
    return std::ldexp(1.0, -std::ilogb(largest));
}

void RigidModePreconditioner::updateBlocks(const ImplicitSystem& system)
{
    const std::size_t slots = system.slotCount();
    for (std::size_t c = 0; c < 6; ++c) {
        m_diagonal[c].assign(slots, 0);
        m_inverse[c].resize(slots);
        m_linked[c].resize(slots);
    }
    for (const ImplicitSystem::DeformableBody& body : system.deformables()) {
        std::array<double*, 6> own{};
        for (std::size_t c = 0; c < 6; ++c)
            own[c] = &m_diagonal[c][body.slot];
        body.tangent.findDiagonal(own);
    }
    for (const ImplicitSystem::RigidBody& body : system.rigids()) {
        addBlock(m_diagonal, body.slot, body.mass * Mat3::Identity());
        addBlock(m_diagonal, body.slot + 1, body.inertia);
    }
    forEachBlock(slots, slotsAtATime, [&](std::size_t begin, std::size_t end) { invert(m_diagonal, begin, end); });
    for (const std::uint32_t row : system.heldRows())
        for (std::size_t c = 0; c < 6; ++c)
            m_inverse[c][system.slotOf(row)] = 0;
    updateLinks(system);
}

/// What links add lies beside the diagonal, so that the next ones can take their place. Few rows have any, and these are gathered:
/// those that had some, and those that have.
void RigidModePreconditioner::updateLinks(const ImplicitSystem& system)
{
    m_isLinked.resize(system.rows(), 0);
    std::vector<std::uint32_t> changed = std::exchange(m_linkedRows, {});
    for (const std::uint32_t row : changed) {
        m_isLinked[row] = 0;
        for (std::size_t c = 0; c < 6; ++c)
            m_linked[c][system.slotOf(row)] = 0;
    }
    const auto add = [&](std::uint32_t row, const Mat3& matrix) {
        if (system.isHeld(row))
            return;
        addBlock(m_linked, system.slotOf(row), matrix);
        if (std::exchange(m_isLinked[row], std::uint8_t{1}) == 0)
            m_linkedRows.push_back(row);
    };
    for (const Link& link : system.links())
        for (const LinkEnd& end : {link.first, link.second}) {
            if (end.row == LinkEnd::immovable)
                continue;
            if (!end.isRigid) {
                end.forEachRow([&](std::uint32_t row, double weight) { add(row, weight * weight * link.matrix); });
                continue;
            }
            add(end.row, link.matrix);
            const Mat3 cross = crossMatrix(end.arm);
            add(end.row + 1, cross * link.matrix * cross.transpose());
        }
    std::erase_if(changed, [&](std::uint32_t row) { return m_isLinked[row] != 0; });
    changed.insert(changed.end(), m_linkedRows.begin(), m_linkedRows.end());

    std::array<std::vector<double>, 6> sums;
    std::array<std::vector<float>, 6> inverses;
    const double* blocks[6];
    float* inverse[6];
    for (std::size_t c = 0; c < 6; ++c) {
        sums[c].reserve(changed.size());
        for (const std::uint32_t row : changed)
            sums[c].push_back(m_diagonal[c][system.slotOf(row)] + m_linked[c][system.slotOf(row)]);
        inverses[c].resize(changed.size());
        blocks[c] = sums[c].data();
        inverse[c] = inverses[c].data();
    }
    kernels::best().invertBlocks(changed.size(), blocks, inverse);
    for (std::size_t c = 0; c < 6; ++c)
        for (std::size_t n = 0; n < changed.size(); ++n)
            m_inverse[c][system.slotOf(changed[n])] = inverses[c][n];
}

void RigidModePreconditioner::invert(const std::array<LaneVector<double>, 6>& diagonal, std::size_t begin,
                                     std::size_t end)
{
    const double* blocks[6];
    float* inverse[6];
    for (std::size_t c = 0; c < 6; ++c) {
        blocks[c] = &diagonal[c][begin];
        inverse[c] = &m_inverse[c][begin];
    }
    kernels::best().invertBlocks(end - begin, blocks, inverse);
}

void RigidModePreconditioner::begin(const FloatArray& r, FloatArray& z, std::size_t begin, std::size_t end) const
{
    const float* blocks[6];
    for (std::size_t c = 0; c < 6; ++c)
        blocks[c] = &m_inverse[c][begin];
    kernels::best().multiplyBlocks(end - begin, blocks, r.data() + begin, z.data() + begin,
                                   static_cast<std::ptrdiff_t>(r.stride()));
}

double RigidModePreconditioner::finish(const FloatArray& r, FloatArray& z)
{
    const auto stride = static_cast<std::ptrdiff_t>(r.stride());
    const kernels::Kernels& kernel = kernels::best();
    m_load.resize(8 * clusters());
    forEachBlock(clusters(), clustersAtATime, [&](std::size_t begin, std::size_t end) {
        for (std::size_t cluster = begin; cluster < end; ++cluster)
            kernel.restrictFours(m_foursBegin[cluster + 1] - m_foursBegin[cluster],
                                 m_fours.data() + m_foursBegin[cluster], r.data(), m_slotArm.data(), stride,
                                 &m_load[8 * cluster]);
    });
    const auto motionOf = [&](std::uint32_t cluster, std::size_t first) {
        const float* own = &m_motion[8 * static_cast<std::size_t>(cluster) + first];
        return Vec3(own[0], own[1], own[2]);
    };
    const auto addLoad = [&](std::uint32_t cluster, const Vec6& load) {
        for (int c = 0; c < 6; ++c)
            m_load[8 * static_cast<std::size_t>(cluster) + static_cast<std::size_t>(c)] += static_cast<float>(load[c]);
    };
    for (const OddSlot& odd : m_odd)
        addLoad(odd.cluster, restrictedTo(r.at(odd.slot), m_slotArm.at(odd.slot)));
    for (const RigidSlots& body : m_rigid)
        addLoad(body.cluster, (Vec6() << r.at(body.slot), r.at(body.slot + 1)).finished());
    m_levels->solve(m_load, m_motion);
    for (float& value : m_motion)
        value *= solverSettings.linear.clusterWeight;
    for (const RigidSlots& body : m_rigid) {
        z.add(body.slot, motionOf(body.cluster, 0));
        z.add(body.slot + 1, motionOf(body.cluster, 3));
    }
    return sumOverBlocks(r.size(), slotsAtATime, [&](std::size_t begin, std::size_t end) {
        kernel.prolongFours((end - begin) / lanes, &m_motionOf[begin / lanes], m_motion.data(),
                            m_slotArm.data() + begin, z.data() + begin, stride);
        auto odd = std::ranges::partition_point(m_odd, [&](const OddSlot& o) { return o.slot < begin; });
        for (; odd != m_odd.end() && odd->slot < end; ++odd) {
            const Vec3 turn = motionOf(odd->cluster, 3);
            z.add(odd->slot, motionOf(odd->cluster, 0) + turn.cross(m_slotArm.at(odd->slot)));
        }
        double sum = 0;
        for (std::size_t c = 0; c < 3; ++c)
            sum += kernel.floatDot(end - begin, r.component(c) + begin, z.component(c) + begin);
        return sum;
    });
}

double RigidModePreconditioner::apply(const FloatArray& r, FloatArray& z)
{
    forEachBlock(r.size(), slotsAtATime, [&](std::size_t begin, std::size_t end) { this->begin(r, z, begin, end); });
    return finish(r, z);
}

double RigidModePreconditioner::sizeOf(const ImplicitSystem& system, const VectorArray& momenta)
{
    const double scale = scaleOf(momenta);
    system.gather(momenta, scale, m_r);
    if (m_z.size() != m_r.size())
        m_z.resize(m_r.size());
    return apply(m_r, m_z) / (scale * scale);
}

} // namespace knead
