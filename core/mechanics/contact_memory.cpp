// What contacts keep of the past, and how they are made of it again. Part of Contacts.
#include "core/mechanics/contacts.h"

#include <algorithm>
#include <utility>

namespace knead {

Contacts::Memory Contacts::memory() const
{
    Memory memory{.joints = joints().all(), .frequency = m_frequency};
    const auto remember = [this](std::vector<Memory::Pair>& list, const ContactPair& pair, double value) {
        list.push_back({m_objects[pair.objects.first].ref, m_objects[pair.objects.second].ref, value});
    };
    for (const ContactPair& pair : m_kept.all())
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

/// Contact objects may be numbered otherwise than they were: first those of the skins, then the ends of connections
/// in the order of breaking. So whoever keeps a moment goes on from what is made of it, too.
Contacts::Contacts(std::vector<BodyView> bodies, VicinityMethod method, const Memory& memory)
    : m_objects(std::move(bodies))
    , m_joining(Joints(memory.joints))
    , m_surfaceContacts(m_objects.bodies())
    , m_listing(m_objects.bodies())
    , m_vicinity(makeVicinity(method))
{
    for (std::uint32_t b = 0; b < m_objects.bodies().size(); ++b) {
        const StructuralConnections& connections = *m_objects.bodies()[b].connections;
        const std::vector<BrokenConnection>& broken = connections.changes().broken;
        for (const ConnectionId& connection : broken)
            for (const ObjectIndex end : connections.endsOf(connection))
                m_objects.loosen({b, end});
        m_surfaceContacts.connectionsBroke(m_objects.bodies(), {}, b, 0);
        m_brokenSeen.push_back(broken.size());
    }
    for (const ObjectRef& object : memory.facingSlit)
        if (const std::uint32_t number = m_objects.numberOf(object); number < m_objects.size())
            m_objects.markSlit(number);
    updateParameters(memory.frequency);
    m_kept = KeptLengths(pairsOf(memory.keptLengths));
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
    m_pairs = merged(m_pairs, pairsOf(objects));
    for (const Memory::Held& each : holds) {
        std::uint32_t first = m_objects.numberOf(each.first);
        std::uint32_t second = m_objects.numberOf(each.second);
        const double sign = first < second ? 1 : -1; // the force is on the first
        if (second < first)
            std::swap(first, second);
        if (const auto found = findPair(m_pairs, {first, second}); found != m_pairs.end())
            found->friction = {sign * each.friction.hold, each.friction.pressure};
    }
}

/// Sorted, with the remembered values for nominal lengths.
std::vector<ContactPair> Contacts::pairsOf(const std::vector<Memory::Pair>& remembered) const
{
    std::vector<ContactPair> pairs;
    for (const Memory::Pair& pair : remembered) {
        const auto [first, second] = std::minmax({m_objects.numberOf(pair.first), m_objects.numberOf(pair.second)});
        if (first < second && second < m_objects.size())
            pairs.push_back({.objects = {first, second}, .nominalLength = pair.value, .parameters = {}});
    }
    std::sort(pairs.begin(), pairs.end());
    return pairs;
}

} // namespace knead
