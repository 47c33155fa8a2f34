#pragma once

#include "core/geometry/vec3.h"

#include <cstdint>
#include <string>

namespace knead {

/// Force and moment between the material and something that holds, pushes or loads it, in one step.
struct Reaction {
    enum class Kind : std::uint8_t {
        fixture, ///< what the material does to it
        tool,    ///< what the material does to it
        load,    ///< what it does to the material
    };
    Kind kind = Kind::fixture;
    std::uint32_t id = 0; ///< of the fixture, tool or load
    std::string name;
    Vec3 force = Vec3::Zero();  ///< [N]
    Vec3 moment = Vec3::Zero(); ///< about `about` [N m]
    Vec3 about =
        Vec3::Zero(); ///< the middle of a fixture's objects at rest, of a load's surface at rest, of a tool now [m]

    /// The moment about another point [N m]: M + (about - point) x F.
    Vec3 momentAbout(const Vec3& point) const { return moment + (about - point).cross(force); }
};

} // namespace knead
