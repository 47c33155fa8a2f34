#pragma once

#include "core/aggregate/pieces.h"
#include "core/mechanics/joints.h"
#include "core/mechanics/structural_connections.h"

#include <cstdint>
#include <optional>

namespace knead {

/// The connected pieces of one body: of objects that hang together by live structural connections, and by skins of the body
/// that have grown together. What merely sticks are two pieces.
///
/// They are found when something broke or was joined since they were found last, and not else: a search costs about as
/// much as three steps.
class PiecesOfBody {
public:
    /// @param body its number in the joints
    /// @param joints of the scene
    const Pieces& find(const StructuralConnections& connections, std::uint32_t body, const Joints& joints);

    /// The body is at another moment, of which nothing is known.
    void forget() { m_known.reset(); }

    std::size_t searches() const { return m_searches; } ///< so far

private:
    struct Seen {
        std::size_t broken = 0;
        std::uint64_t joints = 0; ///< version
        std::uint64_t healed = 0; ///< hash of the healed joints within the body
    };

    std::optional<Seen> m_known; ///< what m_pieces belong to
    Pieces m_pieces;
    std::size_t m_searches = 0;
};

} // namespace knead
