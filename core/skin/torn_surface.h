#pragma once

#include "core/aggregate/aggregate.h"
#include "core/aggregate/connection_id.h"
#include "core/geometry/triangle_mesh.h"
#include "core/skin/skin.h"
#include "core/task/task_control.h"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace knead {

/// The surface of a body that has come apart, all pieces in one mesh, and the map that carries it, each piece by its own objects.
struct TornSurface {
    TriangleMesh mesh;                     ///< at rest as opened, closed; faces as in Fragment
    Skin skin;                             ///< of its vertices
    std::vector<std::uint8_t> lipOfVertex; ///< as in Fragment; 0 in pieces without lips
};

/// None where it hangs together, or where its cracks could not be made surfaces.
/// @param opened closed surface of the opened part, fine enough to bend
/// @throws Cancelled
std::optional<TornSurface> tornSurface(const Aggregate& aggregate, const TriangleMesh& opened,
                                       std::span<const BrokenConnection> broken,
                                       TaskControl& control = TaskControl::none());

} // namespace knead
