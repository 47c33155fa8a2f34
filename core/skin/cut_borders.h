#pragma once

#include "core/aggregate/aggregate.h"
#include "core/aggregate/connection_id.h"
#include "core/mechanics/vector_array.h"
#include "core/vicinity/point_grid.h"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace knead {

/// Where knives went between the parts of a body that has come apart, at rest: through known points of connections. Around any
/// place the nearest of these points say which plane the cut is, so that a flat cut is flat to rounding.
///
/// Immutable; any thread.
class CutBorders {
public:
    /// @param labels per object: of its part
    CutBorders(const Aggregate& aggregate, std::span<const BrokenConnection> broken,
               std::span<const std::uint32_t> labels);
    CutBorders(const CutBorders&) = delete;
    CutBorders& operator=(const CutBorders&) = delete;

    /// How high a place lies above the cut beside it [spacings].
    struct Height {
        std::uint32_t below = 0; ///< label of the part under the cut
        std::uint32_t above = 0; ///< of that over it
        double height = 0;
    };
    /// None where no cut is near, or where something tore, or more than two parts meet.
    std::optional<Height> at(const Vec3& place) const;

private:
    struct Crossing {
        std::uint32_t lower; ///< label
        std::uint32_t upper; ///< label
        Vec3 way;            ///< of the connection, upwards
        bool isCut;
    };

    double m_spacing;
    VectorArray m_points;
    std::vector<Crossing> m_crossings;
    std::optional<PointGrid> m_grid;
};

} // namespace knead
