#pragma once

#include "core/geometry/triangle_mesh.h"
#include "core/skin/label_seams.h"
#include "core/skin/labeled_nodes.h"
#include "core/task/task_control.h"

#include <cstdint>
#include <vector>

namespace knead {

/// Cuts a closed surface along the borders of labels, closes the parts with what of these borders is inside, and makes pieces of
/// them.
/// @param salt a number that tells attempts apart
/// @return by piece; pieces without any material are left out
/// @throws DegenerateCut when the cut would not be sound: another salt, or another shift of the nodes, may do
/// @throws Cancelled
std::vector<SewnMesh> cutByLabels(const TriangleMesh& skin, const LabeledNodes& nodes, const LabelSeams& seams,
                                  std::uint64_t salt, TaskControl& control);

} // namespace knead
