#pragma once

#include "core/session/timeline.h"

#include <QString>

#include <cstdint>
#include <optional>
#include <vector>

namespace knead {

/// The forces of the material on tools and fixtures along the timeline, for plots and tables.
struct ForceRecord {
    struct Curve {
        bool isTool = true;
        std::uint32_t id = 0; ///< ToolId or FixtureId
        std::string name;
        std::vector<std::optional<Vec3>> forces; ///< per time [N]; none where it was not there
    };
    std::vector<double> times; ///< ascending [s]
    std::vector<Curve> curves; ///< tools first, by their ids
    double present = 0;        ///< of the simulation [s]
    double end = 0;            ///< [s]
};

/// @param withStrokes also of fingers and grips of brushes, which come and go with each stroke; see isNameOfStroke()
ForceRecord forceRecordOf(const Timeline& timeline, bool withStrokes);

/// What of a force is looked at.
enum class ForceComponent { magnitude, x, y, z };
double valueOf(const Vec3& force, ForceComponent component); ///< [N]

/// As a table for other programs: time, then x, y, z and magnitude of each; units in the header. A point separates decimals.
QString csvOf(const ForceRecord& record);

} // namespace knead
