#pragma once

#include "core/deformation/displacement_field.h"
#include "core/geometry/triangle_mesh.h"
#include "core/message/message.h"
#include "core/task/task_control.h"

#include <vector>

namespace knead {

/// What a scanned mesh tells of how a part is deformed.
struct ScanField {
    DisplacementField field;  ///< at points evenly over the surface of the part [m]
    Pose toPart;              ///< the rigid motion that took the scan to the part first
    std::size_t samples = 0;  ///< points of the part that were looked at
    std::size_t outliers = 0; ///< of these, where the scan says nothing to go by: left out of the field
    double farthest = 0;      ///< of outliers from the scan [m]
    Vec3 farthestPlace = Vec3::Zero();
    std::vector<Message> remarks; ///< sentences for the person
};

struct ScanOptions {
    std::size_t samples = 20'000; ///< on the part
    bool staysInPlace = false;    ///< the scan is in the part's axes already
    double mostDistance = 0.25; ///< along a normal, from the part to the scan, that is deformation, of the part's size
};

/// From each point of the part along its normal to the scan. A point counts when the scan is there: its surface looks the same way, not
/// farther than allowed, the way back from it ends near the point, and points beside it say about the same. What a normal does not tell,
/// motion along the surface, follows from the points around, so that the field is smooth at edges; noise is smoothed with it. Then it
/// looks again from where points have come to, until they stay: parts may have moved farther than they are thick.
/// @throws Problem when the scan is none of this part. @throws Cancelled
ScanField scanField(const TriangleMesh& scan, const TriangleMesh& part, const ScanOptions& options = {},
                    TaskControl& control = TaskControl::none());

} // namespace knead
