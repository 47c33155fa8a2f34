#include "core/simulation/carried_contacts.h"

#include "core/aggregate/pieces.h"

#include <algorithm>
#include <cstdlib>
#include <utility>

namespace knead {

namespace {

/// What a filling connects.
class Connected {
public:
    Connected(const Aggregate& aggregate, const std::vector<BrokenConnection>& broken)
        : m_aggregate(aggregate)
        , m_isBroken(brokenDirections(aggregate, broken))
    {
    }

    /// Whether two objects hang together, directly or over a third one.
    bool are(ObjectIndex first, ObjectIndex second) const
    {
        const Lattice::Node& from = m_aggregate.lattice.nodes[first];
        const Lattice::Node& to = m_aggregate.lattice.nodes[second];
        for (std::size_t axis = 0; axis < 3; ++axis)
            if (std::abs(from[axis] - to[axis]) > 2)
                return false;
        if (areNeighbors(first, second))
            return true;
        for (std::size_t d = 0; d < Lattice::isotropicCount; ++d)
            for (const std::int32_t sign : {-1, 1}) {
                const Lattice::Node& o = Lattice::directions[d];
                const ObjectIndex third =
                    m_aggregate.lattice.find({from[0] + sign * o[0], from[1] + sign * o[1], from[2] + sign * o[2]});
                if (third < m_aggregate.size() && areNeighbors(first, third) && areNeighbors(third, second))
                    return true;
            }
        return false;
    }

private:
    bool areNeighbors(ObjectIndex one, ObjectIndex other) const
    {
        const auto [lower, upper] = std::minmax(one, other);
        const Lattice::Node& from = m_aggregate.lattice.nodes[lower];
        const Lattice::Node& to = m_aggregate.lattice.nodes[upper];
        const Lattice::Node step{to[0] - from[0], to[1] - from[1], to[2] - from[2]};
        const auto* const direction = std::ranges::find(Lattice::directions, step);
        if (direction == Lattice::directions.end())
            return false;
        const auto d = static_cast<std::size_t>(direction - Lattice::directions.begin());
        return !m_aggregate.weight[d].empty() && m_aggregate.weight[d][lower] > 0 && (m_isBroken[lower] >> d & 1U) == 0;
    }

    const Aggregate& m_aggregate;
    std::vector<std::uint16_t> m_isBroken;
};

} // namespace

void keepStretch(std::vector<Joint>& joints, std::uint32_t body, const PlaceOfObject& before, const PlaceOfObject& now)
{
    constexpr double least = 0.1; // of their length
    for (Joint& joint : joints)
        if (joint.first.body == body || joint.second.body == body) {
            const double was = (before(joint.second) - before(joint.first)).norm();
            const double is = (now(joint.second) - now(joint.first)).norm();
            joint.nominalLength = std::max(joint.nominalLength + is - was, least * is);
        }
}

void renumber(Contacts::Memory& memory, std::uint32_t body, const std::vector<ObjectIndex>& newOfOld,
              const Aggregate& aggregate, const std::vector<BrokenConnection>& broken)
{
    const auto isOfBody = [&](const auto& pair) { return pair.first.body == body || pair.second.body == body; };
    std::erase_if(memory.keptLengths, isOfBody);
    std::erase_if(memory.pressedTimes, isOfBody);
    std::erase_if(memory.holds, isOfBody);
    std::erase_if(memory.touches, [&](const SurfaceContacts::Touch& touch) { return touch.body == body; });
    std::erase_if(memory.facingSlit, [&](const ObjectRef& object) { return object.body == body; });
    for (Joint& joint : memory.joints)
        for (ObjectRef* end : {&joint.first, &joint.second})
            if (end->body == body)
                end->object = newOfOld[end->object];
    std::erase_if(memory.joints, [](const Joint& joint) { return joint.first == joint.second; });
    for (Joint& joint : memory.joints)
        if (joint.second < joint.first)
            std::swap(joint.first, joint.second);
    const Connected connected(aggregate, broken);
    std::erase_if(memory.joints, [&](const Joint& joint) {
        return joint.first.body == body && joint.second.body == body &&
               connected.are(joint.first.object, joint.second.object);
    });
    const auto ends = [](const Joint& joint) { return std::pair(joint.first, joint.second); };
    std::ranges::stable_sort(memory.joints, {}, ends);
    const auto doubles = std::ranges::unique(memory.joints, {}, ends);
    memory.joints.erase(doubles.begin(), doubles.end());
}

} // namespace knead
