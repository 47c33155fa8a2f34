#pragma once

#include "core/aggregate/lattice.h"

#include <array>
#include <cstdint>
#include <vector>

namespace knead {

/// A range of objects whose neighbors lie at the same distances in the numbering, so that a loop over them needs no index.
struct LatticeRun {
    using Offsets = std::array<std::int32_t, Lattice::directionCount>;

    ObjectIndex begin = 0;
    ObjectIndex end = 0;
    std::uint32_t forward = 0;  ///< bit d: some object has a neighbor in direction d
    std::uint32_t backward = 0; ///< bit d: some object is the neighbor in direction d of one before it
    Offsets ahead{};  ///< to the neighbor in direction d, > 0; 0 where there is none. An object may lack a neighbor
                      ///< that others of the run have; it has a connection of weight 0 to what is there instead
    Offsets behind{}; ///< back to the object that has this one as its neighbor, > 0; 0 where there is none. What is
                      ///< behind an object that lacks it may have a connection elsewhere: see neighborsBehind()
};

enum class RunNeighbors {
    ahead, ///< only those in forward directions matter: fewer runs
    all    ///< those on both sides
};

/// The runs of a lattice in order; together they cover all objects. A box is one run and a few short ones; other shapes have
/// one run per row or a few.
std::vector<LatticeRun> findRuns(const Lattice& lattice, RunNeighbors neighbors);

/// Per object: bit d where it is the neighbor in direction d of another.
std::vector<std::uint32_t> neighborsBehind(const Lattice& lattice);

} // namespace knead
