#pragma once

#include "core/mechanics/joints.h"
#include "core/mechanics/point_spread.h"
#include "core/mechanics/rigid_surface.h"

#include <cstddef>
#include <vector>

namespace knead {

/// Friction on an object or a point of material, to see what it does once that has moved.
struct ContactFriction {
    ObjectRef object;
    const PointSpread* spread = nullptr; ///< of a point of that body, valid until the next step; null: the object
    Vec3 force;                          ///< [N]
    Vec3 velocity;     ///< of the surface it rubs on; 0 where the opposite object has its own entry [m/s]
    bool cuts = false; ///< it is of an edge: what it takes goes into the cut
};

/// What all contacts and joints of a scene do.
struct ContactReport {
    std::vector<SurfaceLoad> loads; ///< per surface
    double energy = 0;              ///< stored in contacts and joints [J]
    double brakingPower = 0;        ///< of dampers and friction on the rigid surfaces [W]
    std::vector<ContactFriction> frictions;
    double jointFrictionPower = 0;        ///< of friction in joints on relative motion [W]
    double plastic = 0;                   ///< flowed off in joints [J]
    double fracture = 0;                  ///< of joints that ended [J]
    double placed = 0;                    ///< came in where tools that were put into material push it out [J]
    std::size_t count = 0;                ///< contacts that touch
    std::size_t clinging = 0;             ///< those among them that are apart, see ContactStep::clings
    double crowding = 0;                  ///< largest stiffness of all contacts of an object by what one may have
    double steepness = 0;                 ///< largest d / d0 of contacts, see ContactParameters
    std::vector<ContactTangent> tangents; ///< of contacts and joints, in a trial
};

} // namespace knead
