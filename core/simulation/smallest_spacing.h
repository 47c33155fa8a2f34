#pragma once

#include "core/simulation/scene.h"

#include <algorithm>
#include <limits>
#include <vector>

namespace knead {

/// Of all bodies [m]; infinite without any.
inline double smallestSpacing(const std::vector<Body>& bodies)
{
    double spacing = std::numeric_limits<double>::infinity();
    for (const Body& body : bodies)
        spacing = std::min(spacing, body.aggregate->lattice.spacing);
    return spacing;
}

} // namespace knead
