#pragma once

#include "support/hard_parts.h"
#include "support/hard_surfaces.h"

namespace hard_shapes {

inline std::vector<HardShape> all()
{
    std::vector<HardShape> shapes;
    addCones(shapes);
    addRound(shapes);
    addFree(shapes);
    addRanges(shapes);
    addSections(shapes);
    addHollow(shapes);
    addWorked(shapes);
    addPlaced(shapes);
    addBored(shapes);
    return shapes;
}

} // namespace hard_shapes
