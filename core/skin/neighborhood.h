#pragma once

#include "core/aggregate/aggregate.h"
#include "core/aggregate/lattice_rows.h"

#include <array>
#include <compare>
#include <cstdint>
#include <span>
#include <vector>

namespace knead {

/// The material that points of one cell of the lattice belong to.
struct SkinOwner {
    enum class Kind : std::uint8_t {
        cell,   ///< itself, since it is kept
        around, ///< the kept cells around it, as these are near to a point
        object, ///< one object, since none of them is kept
    };
    Lattice::Node node{}; ///< the lowest corner of the cell, or the object
    Kind kind = Kind::object;
    auto operator<=>(const SkinOwner&) const = default;
};

/// Points and the material that they belong to. Those of one owner share its neighborhood.
struct OwnedPoints {
    std::vector<SkinOwner> owners;    ///< per point
    std::vector<std::uint32_t> order; ///< the points, by owner

    /// Of a place in that order.
    const SkinOwner& ownerAt(std::size_t place) const { return owners[order[place]]; }
    bool isFirstOfOwner(std::size_t place) const { return place == 0 || ownerAt(place) != ownerAt(place - 1); }
};

/// The objects that may carry the points of an owner.
struct Neighborhood {
    SkinOwner owner;
    std::vector<Lattice::Node> cells; ///< the owner's kept cells, by their lowest corners; none for an object
    std::vector<ObjectIndex> objects; ///< ascending

    /// From which corners of these cells objects were reached; each set is there once. Bit 16 (u + 1) + 4 (v + 1) + w + 1 stands
    /// for the corner at (u, v, w) from the owner.
    std::vector<std::uint64_t> walks;
    std::vector<std::uint16_t> walksOf; ///< per object: which of these

    /// Objects from the middle of the owner outward, as fits around its points go through them.
    struct Outward {
        std::vector<std::uint16_t> order; ///< indices into `objects`
        std::array<std::vector<float>, 3>
            steps; ///< from the middle, per object of `order`; filled up to a multiple of kernels::fitLanes by what is far away
        std::vector<std::uint16_t> within; ///< [k]: how many are nearer to the middle than k / 4
    } outward;

    /// The middle of the owner [lattice coordinates].
    Vec3 middle() const;

    /// How many of `outward` may be nearer than that to a point.
    /// @param away how far the point is from the middle
    std::size_t mostWithin(double radius, double away) const;

    /// How far objects belong to the material around a point, from 0 to 1: what they are to the corners of the cell that it is in,
    /// interpolated between these; beside all kept cells, of the nearest of them, those about as near each having its part. So it
    /// changes continuously from place to place, where objects that can only be reached around a gap come in, as long as a kept
    /// cell is nearer than two thirds of a cell; farther off, across gaps of two cells that a web too thin for the lattice spans,
    /// it may jump from one side to the other.
    /// @param coordinates of the point in the lattice
    /// @return per set of walks; an object has that of its own
    std::vector<double> sharesOfSets(const Vec3& coordinates) const;
};

/// Objects in the order of Outward. @param nodes of the objects of a neighborhood
Neighborhood::Outward outwardOrder(const std::vector<Lattice::Node>& nodes, const Vec3& middle);

/// The objects that may carry a point of the surface: those reached along connections from the cell that owns it.
/// The aggregate must outlive it; its members may be called from any thread.
class NeighborhoodFinder {
public:
    explicit NeighborhoodFinder(const Aggregate& aggregate);

    /// The cell that contains a point [lattice coordinates], or the nearest object where no kept cell is close.
    SkinOwner owner(const Vec3& coordinates) const;

    /// Those of many points [m]. Uses several threads.
    OwnedPoints ownersOf(std::span<const Vec3> points) const;

    /// Objects at most three steps along connections from the corners of the owner's cells, or from its object.
    Neighborhood gather(const SkinOwner& owner) const;

private:
    bool isKept(const Lattice::Node& cell) const;
    /// Kept cells among those around a cell, not more than so many.
    std::vector<Lattice::Node> keptAround(const Lattice::Node& cell, std::size_t most) const;

    const Lattice& m_lattice;
    LatticeRows m_rows;
    std::vector<std::uint16_t> m_links; ///< per object: a bit for each direction with a forward connection
};

} // namespace knead
