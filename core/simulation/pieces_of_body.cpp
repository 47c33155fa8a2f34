#include "core/simulation/pieces_of_body.h"

#include "core/geometry/disjoint_sets.h"

#include <limits>
#include <vector>

namespace knead {

namespace {

bool hasGrownTogether(const Joint& joint, std::uint32_t body)
{
    return joint.healed && joint.first.body == body && joint.second.body == body;
}

/// FNV-1a over their ends.
std::uint64_t hashOfHealed(const Joints& joints, std::uint32_t body)
{
    std::uint64_t hash = 0xcbf29ce484222325ULL;
    for (const Joint& joint : joints.all())
        if (hasGrownTogether(joint, body))
            for (const ObjectIndex end : {joint.first.object, joint.second.object})
                hash = (hash ^ end) * 0x100000001b3ULL;
    return hash;
}

/// Numbered by their lowest objects.
Pieces piecesOf(DisjointSets& sets, std::size_t objects)
{
    constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();
    std::vector<std::uint32_t> pieceOfRoot(objects, none);
    Pieces pieces;
    pieces.ofObject.resize(objects);
    for (std::size_t object = 0; object < objects; ++object) {
        std::uint32_t& piece = pieceOfRoot[sets.find(object)];
        if (piece == none)
            piece = static_cast<std::uint32_t>(pieces.count++);
        pieces.ofObject[object] = piece;
    }
    return pieces;
}

} // namespace

const Pieces& PiecesOfBody::find(const StructuralConnections& connections, std::uint32_t body, const Joints& joints)
{
    const std::size_t broken = connections.changes().broken.size();
    if (m_known && m_known->broken == broken && m_known->joints == joints.version())
        return m_pieces;
    const std::uint64_t healed = hashOfHealed(joints, body);
    const bool isSame = m_known && m_known->broken == broken && m_known->healed == healed;
    m_known = Seen{.broken = broken, .joints = joints.version(), .healed = healed};
    if (isSame)
        return m_pieces;
    ++m_searches;
    const std::size_t objects = connections.aggregate().size();
    DisjointSets sets(objects);
    connections.forEachConnection([&](ObjectIndex lower, ObjectIndex upper) { sets.join(lower, upper); });
    for (const Joint& joint : joints.all())
        if (hasGrownTogether(joint, body))
            sets.join(joint.first.object, joint.second.object);
    m_pieces = piecesOf(sets, objects);
    return m_pieces;
}

} // namespace knead
