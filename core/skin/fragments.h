#pragma once

#include "core/aggregate/aggregate.h"
#include "core/aggregate/connection_id.h"
#include "core/geometry/triangle_mesh.h"
#include "core/task/task_control.h"

#include <cstdint>
#include <span>
#include <vector>

namespace knead {

/// Broken connections of a crack that is seen: less than across one cell are none.
inline constexpr std::size_t leastSeenBroken = 12;

/// A piece of a broken body, at rest.
struct Fragment {
    /// CAD face of triangles that a crack made. Other triangles keep theirs, or Aggregate::noFace in a plain mesh.
    static constexpr std::uint32_t crackFace = 0xfffffffeU;

    TriangleMesh mesh;                ///< closed, facing outwards; vertices on a crack are the same bits on both sides
    std::vector<ObjectIndex> objects; ///< that hang together and carry it, ascending
    std::vector<ObjectIndex> dust;    ///< in too small pieces to have a shape: their material is part of the mesh
    double volume = 0;                ///< of the mesh [m^3]
    bool isUncut = false; ///< the cracks could not be made a surface: the mesh has other pieces in it as well

    /// Which of the two sides of a crack that ends within the piece the vertices are of, 1 or 2; 0 where none is near, or both are
    /// one. Empty where no such crack was opened.
    std::vector<std::uint8_t> lipOfVertex;
    std::vector<std::uint8_t> lipOfObject; ///< 1 or 2, per entry of objects; empty as well
};

struct FragmentOptions {
    std::size_t leastObjects = 4; ///< pieces of fewer objects are dust: they join the piece that most of their broken
                                  ///< connections lead to
    bool opensCracks = false;     ///< those, too, that end within a piece: their sides are part of its surface
};

/// Closed surfaces of the pieces that a body has been broken into, by their lowest objects. A body that has cracks but hangs
/// together gives one fragment with the surface as it is, unless they are to be opened, see CrackLips.
///
/// Each node of the lattice has a smooth share of each piece; a point belongs to the piece of its largest share. The cracks
/// between are cut out of tetrahedra of the lattice, and then the cracks and the surface are cut by each other, exactly, so
/// that each fragment is closed. Triangles of the surface that no crack crosses stay as they are.
/// Solids of a body that were never connected are cut each by itself. The result has the same bits on any number of threads.
/// @param skin closed surface of the body at rest, facing outwards: the one it was filled from, or refined
/// @throws std::invalid_argument for an aggregate without objects or a surface that is not closed. @throws Cancelled
std::vector<Fragment> fragmentsOf(const Aggregate& aggregate, const TriangleMesh& skin,
                                  std::span<const BrokenConnection> broken, const FragmentOptions& options = {},
                                  TaskControl& control = TaskControl::none());

/// Per object of an aggregate: which of its fragments it is of, as dust or not.
std::vector<std::uint32_t> fragmentOfObjects(const Aggregate& aggregate, const std::vector<Fragment>& fragments);

} // namespace knead
