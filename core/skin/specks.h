#pragma once

#include "core/geometry/triangle_mesh.h"

#include <cstdint>
#include <functional>
#include <vector>

namespace knead {

/// The triangles of a cut body before they are shared out, with points by number.
struct CutTriangles {
    struct Skin {
        TriangleMesh::Triangle points{};
        std::uint32_t face = 0;
        std::uint32_t label = 0;
    };
    struct Crack {
        TriangleMesh::Triangle points{}; ///< counter-clockwise seen from the front
        std::uint32_t back = 0;          ///< label
        std::uint32_t front = 0;         ///< label
    };
    std::vector<Skin> skin;
    std::vector<Crack> cracks;
};

/// Gives splinters away that a crack left beside the main shell of their label, for a border is only as fine as the lattice:
/// shells of less than `leastVolume` [m^3] take the label that most of their crack leads to, and that part of it vanishes.
/// The largest shell of a label stays, whatever its size, and so do voids. What was closed remains so.
void joinSpecks(CutTriangles& triangles, const std::function<Vec3(std::uint32_t point)>& placeOf, double leastVolume);

} // namespace knead
