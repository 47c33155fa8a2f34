#include "core/integration/implicit_system.h"

#include "core/task/parallel.h"

#include <algorithm>

namespace knead {

namespace {

constexpr std::size_t blockSize = 4096;

constexpr std::size_t slotsApart = 16; // bodies begin on cache lines

} // namespace

void push(const LinkEnd& end, const Vec3& momentum, VectorArray& rows)
{
    if (end.row == LinkEnd::immovable)
        return;
    if (end.isRigid) {
        rows.add(end.row, momentum);
        rows.add(end.row + 1, end.arm.cross(momentum));
    } else {
        end.forEachRow([&](std::uint32_t row, double weight) { rows.add(row, weight * momentum); });
    }
}

std::size_t ImplicitSystem::addDeformable(const StructuralConnections& connections, const ObjectState& state)
{
    const std::size_t first = m_rows;
    m_deformables.push_back({TangentOperator(connections, state.mass), &state, first, m_slots});
    const RunSlots& slots = m_deformables.back().tangent.places();
    for (std::size_t i = 0; i < state.size(); ++i) {
        m_slot.push_back(static_cast<std::uint32_t>(m_slots + slots.of(static_cast<ObjectIndex>(i))));
        const bool held = state.inverseMass[i] == 0;
        m_isHeld.push_back(held ? 1 : 0);
        m_mass.push_back(state.mass[i]);
        if (held)
            m_held.push_back(static_cast<std::uint32_t>(first + i));
    }
    m_rows += state.size();
    m_slots += (slots.size() + slotsApart - 1) / slotsApart * slotsApart;
    return first;
}

std::size_t ImplicitSystem::addRigid()
{
    m_rigids.push_back({1, Mat3::Identity(), m_rows, m_slots});
    for (std::uint32_t s = 0; s < 2; ++s)
        m_slot.push_back(static_cast<std::uint32_t>(m_slots + s));
    m_slots += slotsApart;
    m_mass.insert(m_mass.end(), 2, 0.0);
    m_isHeld.insert(m_isHeld.end(), 2, 0);
    m_rows += 2;
    return m_rows - 2;
}

void ImplicitSystem::setRigid(std::size_t index, double mass, const Mat3& inertia)
{
    m_rigids[index].mass = mass;
    m_rigids[index].inertia = inertia;
}

void ImplicitSystem::setLinks(std::vector<Link> links)
{
    m_links = std::move(links);
    m_isSymmetric = std::ranges::all_of(m_links, [](const Link& link) { return link.drag.isZero(0); });
}

void ImplicitSystem::update(double step)
{
    for (DeformableBody& body : m_deformables)
        body.tangent.update(body.state->position, step);
}

void ImplicitSystem::clearHeld(VectorArray& u) const
{
    for (const std::uint32_t row : m_held)
        u.set(row, Vec3::Zero());
}

void ImplicitSystem::gather(const VectorArray& rows, double factor, FloatArray& bySlots) const
{
    if (bySlots.size() != m_slots)
        bySlots.resize(m_slots);
    forEachBlock(m_rows, blockSize, [&](std::size_t begin, std::size_t end) {
        for (std::size_t c = 0; c < 3; ++c) {
            const double* from = rows.component(c);
            float* to = bySlots.component(c);
            for (std::size_t i = begin; i < end; ++i)
                to[m_slot[i]] = static_cast<float>(factor * from[i]);
        }
    });
}

void ImplicitSystem::addTo(VectorArray& rows, double factor, const FloatArray& bySlots) const
{
    forEachBlock(m_rows, blockSize, [&](std::size_t begin, std::size_t end) {
        for (std::size_t c = 0; c < 3; ++c) {
            const float* from = bySlots.component(c);
            double* to = rows.component(c);
            for (std::size_t i = begin; i < end; ++i)
                to[i] += factor * static_cast<double>(from[m_slot[i]]);
        }
    });
}

double ImplicitSystem::multiply(const FloatArray& u, FloatArray& product)
{
    double energy = 0;
    for (DeformableBody& body : m_deformables)
        energy += body.tangent.multiply(u.data() + body.slot, product.data() + body.slot, u.stride());
    for (const RigidBody& body : m_rigids) {
        product.set(body.slot, body.mass * u.at(body.slot));
        product.set(body.slot + 1, body.inertia * u.at(body.slot + 1));
        for (const std::size_t slot : {body.slot, body.slot + 1})
            energy += u.at(slot).dot(product.at(slot));
    }
    const auto velocityOf = [&](const LinkEnd& end) -> Vec3 {
        if (end.row == LinkEnd::immovable)
            return Vec3::Zero();
        if (end.isRigid)
            return u.at(m_slot[end.row]) + u.at(m_slot[end.row] + 1).cross(end.arm);
        Vec3 velocity = Vec3::Zero();
        end.forEachRow([&](std::uint32_t row, double weight) { velocity += weight * u.at(m_slot[row]); });
        return velocity;
    };
    const auto give = [&](const LinkEnd& end, const Vec3& momentum) {
        if (end.row == LinkEnd::immovable)
            return;
        if (end.isRigid) {
            product.add(m_slot[end.row], momentum);
            product.add(m_slot[end.row] + 1, end.arm.cross(momentum));
        } else {
            end.forEachRow([&](std::uint32_t row, double weight) { product.add(m_slot[row], weight * momentum); });
        }
    };
    for (const Link& link : m_links) {
        const Vec3 between = velocityOf(link.first) - velocityOf(link.second);
        const Vec3 momentum = link.momentumOf(between);
        energy += between.dot(momentum);
        give(link.first, momentum);
        give(link.second, -momentum);
    }
    return energy;
}

} // namespace knead
