#pragma once

#include "core/geometry/surface_distance.h"
#include "core/task/task_control.h"

namespace knead {

/// How a scan lies on a part.
struct ScanPlacement {
    Pose toPart;        ///< takes places of the scan to the part
    double offset = 0;  ///< root mean square of the nearer nine tenths of the scan from the part, then [m]
    double overlap = 0; ///< share of the scan that is nearer to the part than a fiftieth of the part's size, 0..1
};

/// Where it lies as it came, when two thirds of it are on the part already; else the best of all ways to lay its principal axes on those
/// of the part. From there, by iterated closest points: point to plane, the farthest tenth left out. The scan may be noisy, incomplete
/// and of more than the part.
/// @param part of the mesh that is meant
/// @throws Cancelled
ScanPlacement placeScan(const TriangleMesh& scan, const TriangleMesh& partMesh, const SurfaceDistance& part,
                        TaskControl& control);

} // namespace knead
