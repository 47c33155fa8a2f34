#pragma once

#include "core/aggregate/aggregate.h"
#include "core/aggregate/connection_id.h"
#include "core/aggregate/pieces.h"
#include "core/mechanics/vector_array.h"
#include "core/vicinity/point_grid.h"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace knead {

/// The two sides (lips) of cracks that end within a piece: a knife is on its way through it, or a ring has been cut open.
///
/// Broken connections color their ends with two colors, and the nearest ends along connections that hold color all other objects of
/// the piece. So two lips part on the crack, and beyond its tip, where nothing is open, on a border that means nothing. Cracks
/// that cannot be colored, such as damage spread over many cells, have no lips, and neither have those of a few connections.
///
/// Immutable; any thread.
class CrackLips {
public:
    CrackLips(const Aggregate& aggregate, const Pieces& pieces, std::span<const BrokenConnection> broken);
    CrackLips(const CrackLips&) = delete;
    CrackLips& operator=(const CrackLips&) = delete;

    /// No piece has any.
    bool isEmpty() const { return !m_grid; }

    /// Per object, 0 or 1; 0 all over a piece without lips.
    const std::vector<std::uint8_t>& ofObject() const { return m_lip; }

    /// Of a place on the border between two lips: whether it is open there, as most of the connections around it are.
    bool isOpen(const Vec3& place) const;

    /// Whether a place is so near to an open border that what carries it has to be of its own lip.
    bool isBeside(const Vec3& place) const;

private:
    std::vector<std::uint8_t> m_lip;
    double m_spacing;
    VectorArray m_points;               ///< middles of connections from lip to lip
    std::vector<std::uint8_t> m_isOpen; ///< per point
    std::optional<PointGrid> m_grid;    ///< of the points; none without lips
};

} // namespace knead
