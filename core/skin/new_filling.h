#pragma once

#include "core/mechanics/vector_array.h"
#include "core/skin/carried_cracks.h"
#include "core/skin/refilled.h"

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace knead {

/// A body that is to be filled anew. Holds on to what it is made of.
struct BodyToFill {
    const TriangleMesh& surface; ///< of the opened part
    const std::shared_ptr<const Aggregate>& aggregate;
    std::span<const Vec3> displacements; ///< one per object since it was filled [m]
    std::span<const BrokenConnection> broken;
    std::span<const GrownTogether> healed; ///< what makes pieces one again, see regrown()
};

/// Another filling of a body, and what of it belongs to what of the one before.
///
/// Pieces are filled each by itself, and their objects lie apart in one lattice, where none of them can be taken for a neighbor of
/// another: each piece was moved there as a whole.
struct NewFilling {
    std::shared_ptr<const Aggregate> aggregate; ///< with its former shape
    VectorArray places;     ///< of its objects now [m]: their nodes, or for pieces what these were moved from
    std::vector<Vec3> skin; ///< the same of its points of the skin
    std::vector<BrokenConnection> cracks; ///< of it, ascending
    std::vector<ObjectIndex> oldOfNew;    ///< the object of before that is nearest, of the same piece
    std::vector<ObjectIndex> newOfOld;    ///< the other way
    std::uint32_t pieces = 1;
    std::vector<std::uint32_t> pieceOfNew; ///< per object, < pieces
    std::vector<std::uint32_t> pieceOfOld;
};

/// What of the fits of former shapes goes on from one filling to the next. It saves time and changes no bit.
struct KnownFittings {
    std::shared_ptr<const ShapeFitting> whole;
    struct OfPiece {
        std::vector<ObjectIndex> carriers; ///< objects of the first filling that it is for
        std::shared_ptr<const ShapeFitting> fitting;
    };
    std::vector<OfPiece> pieces;
};

/// Fills a body as it is now: see refilled(). What has come apart is filled piece by piece, never across a crack; pieces that have grown
/// together where they were parted are one again.
/// @param spacing of the new filling [m], > 0
/// @param fittings of the filling before, or none; afterwards those of this one
/// @param move what the surface keeps clear of; null: nothing
/// @throws Problem when the shape cannot be filled; Cancelled
NewFilling newFilling(const BodyToFill& body, double spacing, KnownFittings& fittings, const MovePlaces& move = nullptr,
                      TaskControl& control = TaskControl::none());

} // namespace knead
