#pragma once

#include "core/aggregate/lattice.h"

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

namespace knead {

class FormerShape;

/// What filling did about a surface that does not bound a volume by itself; all zero for a closed one.
struct SurfaceRepair {
    std::size_t removedTriangles = 0; ///< that were there twice
    std::size_t flippedTriangles = 0; ///< that faced the other way than those around them
    std::size_t decidedCells = 0;     ///< at holes and overlaps, decided by the winding number of the surface
    double doubtfulShare = 0;         ///< of the volume: material that could as well be none

    friend bool operator==(const SurfaceRepair&, const SurfaceRepair&) = default;
};

/// A point of the surface that a body was filled from, at rest.
struct SkinPoint {
    Vec3 place;      ///< [m]
    double area = 0; ///< of the surface that it stands for [m^2]

    friend bool operator==(const SkinPoint&, const SkinPoint&) = default;
};

/// The objects of one body and their structural connections, at rest. Immutable once filled; shared between threads.
/// Arrays have one entry per object.
struct Aggregate {
    Lattice lattice;

    /// Weight of the forward connection in each direction: the part of the cells around it that is material, in thin
    /// walls as withFittedMoments() says, at the skin as withBalancedSkin(); 1 in the bulk, 0 without connection. The
    /// sum of k l^2 is 6 E borneVolume. Empty for a direction that is not used.
    std::array<std::vector<double>, Lattice::directionCount> weight;
    std::vector<double> volume; ///< share of the body's volume [m^3]; their sum is filledVolume
    std::vector<double> depth;  ///< distance below the surface [m]; negative outside. Objects further than 2a inside
                                ///< carry a lower bound >= 2a instead of the exact value
    std::vector<std::uint32_t> face; ///< CAD face nearest to the object; noFace for deep objects and plain meshes

    std::vector<SkinPoint>
        skin; ///< what touches rigid surfaces, see skinPoints(); empty: the objects near the surface do

    double meshVolume = 0;   ///< of the mesh it was filled from, as far as that bounds one; else filledVolume [m^3]
    double filledVolume = 0; ///< as integrated cell by cell, thin slivers of cells included [m^3]
    std::size_t cells = 0;   ///< kept cells
    SurfaceRepair repair;    ///< what was needed to fill it

    /// What took the opened part to the shape that it was filled from; null: it was filled from the part as it was opened.
    std::shared_ptr<const FormerShape> former;

    static constexpr std::uint32_t noFace = 0xffffffffU;

    std::size_t size() const { return lattice.size(); }
    std::size_t connectionCount() const; ///< structural connections (weight > 0)

    /// Per object an eighteenth of the weights of its connections, times a^3: its volume, but in walls of less than 1.75 cells, see
    /// loosenThinWalls() [m^3].
    std::vector<double> borneVolume() const;

    /// Calls visit(direction, lower, upper) for every structural connection and its two objects, direction by direction.
    template <typename Visit>
    void forEachConnection(Visit&& visit) const
    {
        for (std::uint32_t d = 0; d < Lattice::directionCount; ++d)
            for (const Lattice::Segment& segment : lattice.segments[d])
                for (ObjectIndex lower = segment.begin; lower < segment.end; ++lower)
                    if (weight[d][lower] > 0)
                        visit(d, lower, lower + static_cast<ObjectIndex>(segment.offset));
    }
};

} // namespace knead
