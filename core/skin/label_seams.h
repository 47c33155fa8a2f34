#pragma once

#include "core/geometry/triangle_mesh.h"
#include "core/skin/specks.h"

#include <cstdint>
#include <functional>
#include <vector>

namespace knead {

/// Which labels are of one piece, and where the border between two of these is a crack.
struct LabelSeams {
    std::function<std::uint32_t(std::uint32_t label)> pieceOf;
    std::function<bool(const Vec3& place)> isOpen;
};

/// The surface of a piece whose labels were sewn together but for its cracks.
struct SewnMesh {
    static constexpr std::uint32_t manyLabels = 0xffffffffU;
    std::uint32_t piece = 0;
    TriangleMesh mesh;                        ///< closed; faceOfTriangle as in Fragment
    std::vector<std::uint32_t> labelOfVertex; ///< or manyLabels: on a border that is not open, or at the tip of a crack
};

/// Makes pieces of labels: where a border within a piece is not open it vanishes, and what met there is one. A crack that would hang
/// on an edge alone is closed there, so that edges have two triangles each, and so is what would be open away from the skin in a few
/// triangles.
/// @param placeOf of a point
/// @return by piece. @throws DegenerateCut when a piece would not be closed
std::vector<SewnMesh> sewn(const CutTriangles& triangles, const std::function<Vec3(std::uint32_t point)>& placeOf,
                           const LabelSeams& seams);

} // namespace knead
