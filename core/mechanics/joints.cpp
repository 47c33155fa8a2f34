#include "core/mechanics/joints.h"

#include <algorithm>
#include <cmath>

namespace knead {

namespace {

bool inOrder(const Joint& a, const Joint& b)
{
    return std::pair(a.first, a.second) < std::pair(b.first, b.second);
}

bool sameObjects(const Joint& a, const Joint& b)
{
    return a.first == b.first && a.second == b.second;
}

/// Moves the nominal length towards the length by what is beyond yield. @return energy [J]
double flow(Joint& joint, double length, double dt)
{
    if (!std::isfinite(joint.yieldStrain) || length <= 0)
        return 0;
    const double strain = std::log(length / joint.nominalLength);
    const double beyond = std::abs(strain) - joint.yieldStrain;
    if (beyond <= 0)
        return 0;
    const double amount = beyond * (joint.flowTime > 0 ? -std::expm1(-dt / joint.flowTime) : 1);
    const double before = length - joint.nominalLength;
    joint.nominalLength *= std::exp(strain > 0 ? amount : -amount);
    joint.plasticStrain += amount;
    const double after = length - joint.nominalLength;
    return 0.5 * joint.stiffness * (before * before - after * after);
}

} // namespace

void Joints::add(std::vector<Joint> joints)
{
    for (Joint& joint : joints)
        if (joint.second < joint.first)
            std::swap(joint.first, joint.second);
    std::sort(joints.begin(), joints.end(), inOrder);
    std::vector<Joint> merged;
    merged.reserve(m_joints.size() + joints.size());
    std::merge(m_joints.begin(), m_joints.end(), joints.begin(), joints.end(), std::back_inserter(merged), inOrder);
    // Of several between the same objects the older one comes first and stays, unless a later one is healed.
    std::size_t kept = 0;
    for (std::size_t i = 0; i < merged.size(); ++i) {
        if (i == 0 || !sameObjects(merged[kept - 1], merged[i]))
            merged[kept++] = merged[i];
        else if (merged[i].healed && !merged[kept - 1].healed)
            merged[kept - 1] = merged[i];
    }
    merged.resize(kept);
    m_joints = std::move(merged);
    ++m_version;
}

const Joint* Joints::find(const ObjectRef& a, const ObjectRef& b) const
{
    Joint wanted;
    wanted.first = std::min(a, b);
    wanted.second = std::max(a, b);
    const auto found = std::lower_bound(m_joints.begin(), m_joints.end(), wanted, inOrder);
    return found != m_joints.end() && sameObjects(*found, wanted) ? &*found : nullptr;
}

Joints::Report Joints::computeForces(std::span<ObjectState* const> bodies, const ContactStep& step)
{
    Report report;
    const auto endsNow = [&](Joint& joint) {
        ObjectState& a = *bodies[joint.first.body];
        ObjectState& b = *bodies[joint.second.body];
        const Vec3 across = b.position.at(joint.second.object) - a.position.at(joint.first.object);
        const double length = across.norm();
        if (!step.isTrial)
            report.plastic += flow(joint, length, step.duration);
        const double stretch = length - joint.nominalLength;
        const Vec3 n = length > 0 ? Vec3(across / length) : Vec3::Zero();
        const Vec3 velocity = b.velocity.at(joint.second.object) - a.velocity.at(joint.first.object);
        const bool worn = joint.plasticStrain > joint.ductility && stretch > 0;
        if (!step.isTrial && (worn || joint.stiffness * stretch > joint.tolerance)) {
            // In an explicit scheme its force has acted up to half a step ago: what it had then is set free.
            const double lag = step.isImplicit() ? 0 : 0.5 * step.duration;
            const double before = stretch - lag * velocity.dot(n);
            report.fracture += 0.5 * joint.stiffness * before * before;
            return true;
        }
        report.energy += 0.5 * joint.stiffness * stretch * stretch;
        const double normalSpeed = velocity.dot(n);
        const Vec3 pull = joint.stiffness * stretch * n;
        Vec3 brake = joint.damping * normalSpeed * n;
        const Vec3 slide = velocity - normalSpeed * n;
        double slip = 0; // friction by slide, in the implicit scheme [N s/m]
        if (const double speed = slide.norm(); step.isImplicit()) {
            slip = joint.friction * (pull + brake).norm() / std::max(speed, step.stickSpeed);
            brake += slip * slide;
            report.frictionPower -= slip * slide.squaredNorm();
        } else if (speed > 0 && joint.friction > 0) {
            const double reducedMass = a.mass[joint.first.object] * b.mass[joint.second.object] /
                                       (a.mass[joint.first.object] + b.mass[joint.second.object]);
            const double friction =
                std::min(joint.friction * (pull + brake).norm(), 0.5 * reducedMass * speed / step.duration);
            brake += friction / speed * slide;
            report.frictionPower -= friction * (speed - 0.5 * step.duration * friction / reducedMass);
        }
        if (step.isTrial) {
            const double sideways = length > 0 ? std::max(0.0, stretch / length) : 1;
            const Mat3 dyad = n * n.transpose();
            const Mat3 resistance = (step.duration * joint.stiffness + joint.damping) * dyad +
                                    (step.duration * joint.stiffness * sideways + slip) * (Mat3::Identity() - dyad);
            report.tangents.push_back(
                {.first = joint.first, .second = joint.second, .force = pull + brake, .resistance = resistance});
        }
        a.force.add(joint.first.object, pull);
        a.damping.add(joint.first.object, brake);
        b.force.add(joint.second.object, -pull);
        b.damping.add(joint.second.object, -brake);
        return false;
    };
    // remove_if may look at an element once only, and does, in order.
    const auto left = std::remove_if(m_joints.begin(), m_joints.end(), endsNow);
    report.ended = static_cast<std::size_t>(m_joints.end() - left);
    m_joints.erase(left, m_joints.end());
    m_version += report.ended > 0 ? 1 : 0;
    return report;
}

void Joints::addStiffness(std::uint32_t body, std::vector<double>& stiffness) const
{
    for (const Joint& joint : m_joints)
        for (const ObjectRef& end : {joint.first, joint.second})
            if (end.body == body)
                stiffness[end.object] += 2 * joint.stiffness;
}

} // namespace knead
