// What contacts keep of the past, and how they are made of it again. Part of Contacts.
#include "core/mechanics/contacts.h"

#include <algorithm>
#include <utility>

namespace knead {

Contacts::Memory Contacts::memory() const
{
    Memory memory{.joints = m_joints.all(), .frequency = m_frequency};
    const auto remember = [this](std::vector<Memory::Pair>& list, const ContactPair& pair, double value) {
        list.push_back({m_objects[pair.objects.first].ref, m_objects[pair.objects.second].ref, value});
    };
    for (const ContactPair& pair : m_keptDistances)
        remember(memory.keptLengths, pair, pair.nominalLength);
    for (const ContactPair& pair : m_pairs)
        if (pair.pressed > 0)
            remember(memory.pressedTimes, pair, pair.pressed);
    for (const ContactPair& pair : m_pairs)
        if (!pair.friction.isEmpty())
            memory.holds.push_back(
                {m_objects[pair.objects.first].ref, m_objects[pair.objects.second].ref, pair.friction});
    memory.touches = m_surfaceContacts.memory();
    memory.edges = m_edges.memory();
    for (const ContactObject& object : m_objects)
        if (object.facesSlit)
            memory.facingSlit.push_back(object.ref);
    return memory;
}

/// Contact objects may be numbered otherwise than they were: first those of the skins, then the ends of connections in the
/// order of breaking. So whoever keeps a moment goes on from what is made of it, too.
Contacts::Contacts(std::vector<BodyView> bodies, VicinityMethod method, const Memory& memory)
    : m_bodies(std::move(bodies))
    , m_brokenSeen(m_bodies.size(), 0)
    , m_vicinity(makeVicinity(method))
    , m_joints(memory.joints)
    , m_surfaceContacts(m_bodies)
{
    addSkins();
    for (std::uint32_t b = 0; b < m_bodies.size(); ++b) {
        const std::vector<BrokenConnection>& broken = m_bodies[b].connections->changes().broken;
        for (const ConnectionId& connection : broken)
            for (const ObjectIndex end : m_bodies[b].connections->endsOf(connection))
                loosen(b, end);
        m_surfaceContacts.connectionsBroke(m_bodies, {}, b, 0);
        m_brokenSeen[b] = broken.size();
    }
    for (const ObjectRef& object : memory.facingSlit)
        if (const std::uint32_t index = m_indexOf[object.body][object.object]; index < m_objects.size())
            m_objects[index].facesSlit = true;
    updateParameters(memory.frequency);
    m_keptDistances = pairsOf(memory.keptLengths);
    m_pairs = pairsOf(memory.pressedTimes); // the next listing takes their times and holds over
    for (ContactPair& pair : m_pairs)
        pair.pressed = std::exchange(pair.nominalLength, 0);
    addHolds(memory.holds);
    m_surfaceContacts.restore(memory.touches);
    m_edges.restore(memory.edges);
}

/// To the pairs there are, and to new ones.
void Contacts::addHolds(const std::vector<Memory::Held>& holds)
{
    std::vector<Memory::Pair> objects;
    for (const Memory::Held& held : holds)
        objects.push_back({held.first, held.second, 0});
    std::vector<ContactPair> held = pairsOf(objects);
    std::vector<ContactPair> all;
    const auto inOrder = [](const ContactPair& a, const ContactPair& b) { return a.objects < b.objects; };
    std::set_union(m_pairs.begin(), m_pairs.end(), held.begin(), held.end(), std::back_inserter(all), inOrder);
    m_pairs = std::move(all);
    for (const Memory::Held& each : holds) {
        std::uint32_t first = m_indexOf[each.first.body][each.first.object];
        std::uint32_t second = m_indexOf[each.second.body][each.second.object];
        const double sign = first < second ? 1 : -1; // the force is on the first
        if (second < first)
            std::swap(first, second);
        const auto found = std::lower_bound(m_pairs.begin(), m_pairs.end(),
                                            ContactPair{.objects = {first, second}, .parameters = {}}, inOrder);
        if (found != m_pairs.end() && found->objects == VicinityPair{first, second})
            found->friction = {sign * each.friction.hold, each.friction.pressure};
    }
}

/// Sorted, with the remembered values for nominal lengths.
std::vector<Contacts::ContactPair> Contacts::pairsOf(const std::vector<Memory::Pair>& remembered) const
{
    std::vector<ContactPair> pairs;
    for (const Memory::Pair& pair : remembered) {
        const auto [first, second] =
            std::minmax(m_indexOf[pair.first.body][pair.first.object], m_indexOf[pair.second.body][pair.second.object]);
        if (first < second && second < m_objects.size())
            pairs.push_back({.objects = {first, second}, .nominalLength = pair.value, .parameters = {}});
    }
    std::sort(pairs.begin(), pairs.end(),
              [](const ContactPair& a, const ContactPair& b) { return a.objects < b.objects; });
    return pairs;
}

} // namespace knead
