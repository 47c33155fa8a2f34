#pragma once

#include "core/aggregate/material_map.h"
#include "core/mechanics/object_state.h"
#include "core/mechanics/structural_connections.h"

#include <cstdint>

namespace knead {

/// How a body takes part. Moments keep the numbers.
enum class BodyKind : std::uint8_t {
    deformable = 0,
    rigid = 1, ///< keeps its shape and moves with six degrees of freedom
    glue = 2,  ///< keeps its shape and place; its adhesion and friction hold for all that touches it
};

/// A body as contacts see it. The owner keeps what it points at alive and in place.
struct ContactBody {
    ObjectState* state;
    const StructuralConnections* connections;
    const MaterialMap* materials;
    BodyKind kind = BodyKind::deformable;

    const Material& materialOf(ObjectIndex object) const { return materials->of(object); }
    double spacing() const { return connections->aggregate().lattice.spacing; }
};

} // namespace knead
