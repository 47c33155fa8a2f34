#pragma once

#include "core/aggregate/aggregate.h"
#include "core/aggregate/connection_id.h"
#include "core/mechanics/object_strain.h"
#include "core/skin/fragments.h"
#include "core/skin/skin_fields.h"
#include "core/task/task_control.h"

#include <span>
#include <vector>

namespace knead {

/// The surface of a fragment when the objects have moved.
struct CarriedFragment {
    std::vector<Vec3> places; ///< of the vertices [m]
    SkinFields fields;        ///< at the vertices; empty when they were not asked for
    bool isRigid =
        false; ///< its objects are too few or too loosely connected for a skin: it moved as they did on the whole
};

/// The objects of a fragment that carry it: what dangles beside a crack on its last connections goes its own ways. All of them
/// where hardly any would be left.
/// @param isBroken see brokenDirections()
std::vector<ObjectIndex> carriersOf(const Aggregate& aggregate, const Fragment& fragment,
                                    std::span<const std::uint16_t> isBroken);

/// The same of any objects.
std::vector<ObjectIndex> firmOf(const Aggregate& aggregate, const std::vector<ObjectIndex>& objects,
                                std::span<const std::uint16_t> isBroken);

/// Carries each fragment by its own objects alone, those that do not dangle, along connections that still hold. A skin is taken for what it is when it
/// holds the volume that the deformation of the well connected objects says, within 1 %.
/// @param displacement per object of the aggregate [m]
/// @param relaxed of the body, for the fields; null: none are made
/// @param loaded objects of the body that something holds or presses on, for the fields
/// @return per fragment. @throws Cancelled
std::vector<CarriedFragment> carried(const Aggregate& aggregate, std::span<const Fragment> fragments,
                                     std::span<const BrokenConnection> broken, std::span<const Vec3> displacement,
                                     const RelaxedState* relaxed = nullptr, std::span<const ObjectIndex> loaded = {},
                                     TaskControl& control = TaskControl::none());

} // namespace knead
