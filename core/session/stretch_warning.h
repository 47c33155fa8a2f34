#pragma once

#include "core/simulation/snapshot.h"
#include "core/task/task_control.h"

#include <optional>

namespace knead {

/// Where material is about to break.
struct Overstretch {
    ObjectIndex object = 0;
    Vec3 place = Vec3::Zero(); ///< of the object [m]
    double share = 0;          ///< of what the material bears before it breaks; above 1 where it just does
};

/// From this share on a person is warned: strength scatters by 5 %, and a last pull of a fifth breaks it.
inline constexpr double warningShareOfBreaking = 0.8;

/// The object that is nearest to breaking, when that is near; none in material that never breaks. As connections break, see
/// ConnectionLaw: brittle material by the elastic stretch l / l0 - 1 of a connection over strength / E; ductile material by the
/// stretch h of an object, and no more than it has flowed, over the plastic strain that it can take. h is the largest principal Hencky
/// strain. It is an estimate: strength scatters, and beside cracks material breaks earlier.
///
/// On the calling thread alone, O(objects).
/// @throws Cancelled
std::optional<Overstretch> mostOverstretched(const Snapshot::BodyState& body,
                                             TaskControl& control = TaskControl::none());

} // namespace knead
