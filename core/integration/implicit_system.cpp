#include "core/integration/implicit_system.h"

#include "core/task/parallel.h"

namespace knead {

namespace {

constexpr std::size_t blockSize = 4096;

Vec3 velocityOf(const LinkEnd& end, const VectorArray& u)
{
    if (end.row == LinkEnd::immovable)
        return Vec3::Zero();
    if (end.isRigid)
        return u.at(end.row) + u.at(end.row + 1).cross(end.arm);
    Vec3 velocity = Vec3::Zero();
    end.forEachRow([&](std::uint32_t row, double weight) { velocity += weight * u.at(row); });
    return velocity;
}

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
    m_deformables.push_back({TangentOperator(connections), &state, first});
    for (std::size_t i = 0; i < state.size(); ++i) {
        const bool held = state.inverseMass[i] == 0;
        m_isHeld.push_back(held ? 1 : 0);
        m_mass.push_back(state.mass[i]);
        if (held)
            m_held.push_back(static_cast<std::uint32_t>(first + i));
    }
    m_rows += state.size();
    return first;
}

std::size_t ImplicitSystem::addRigid()
{
    m_rigids.push_back({1, Mat3::Identity(), m_rows});
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

void ImplicitSystem::multiply(const VectorArray& u, VectorArray& product)
{
    forEachBlock(m_rows, blockSize, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            product.set(i, m_mass[i] * u.at(i));
        }
    });
    for (DeformableBody& body : m_deformables)
        body.tangent.addProduct(kernels::from(u, body.first), kernels::into(product, body.first));
    for (const RigidBody& body : m_rigids) {
        product.set(body.first, body.mass * u.at(body.first));
        product.set(body.first + 1, body.inertia * u.at(body.first + 1));
    }
    for (const Link& link : m_links) {
        const Vec3 momentum = link.matrix * (velocityOf(link.first, u) - velocityOf(link.second, u));
        push(link.first, momentum, product);
        push(link.second, -momentum, product);
    }
    clearHeld(product);
}

} // namespace knead
