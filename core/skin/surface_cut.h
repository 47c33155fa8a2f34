#pragma once

#include "core/geometry/triangle_mesh.h"
#include "core/skin/labeled_nodes.h"
#include "core/task/task_control.h"

#include <cstdint>
#include <vector>

namespace knead {

/// The part of a cut surface with one label.
struct LabeledMesh {
    std::uint32_t label = 0;
    TriangleMesh mesh; ///< closed; faceOfTriangle as in Fragment
};

/// Cuts a closed surface along the borders of labels and closes the parts with what of these borders is inside.
/// @param salt a number that tells attempts apart
/// @return by label; labels without any material are left out
/// @throws DegenerateCut when the cut would not be sound: another salt, or another shift of the nodes, may do
/// @throws Cancelled
std::vector<LabeledMesh> cutByLabels(const TriangleMesh& skin, const LabeledNodes& nodes, std::uint64_t salt,
                                     TaskControl& control);

} // namespace knead
