#pragma once

#include "core/aggregate/aggregate.h"
#include "core/aggregate/connection_id.h"
#include "core/geometry/smooth_map.h"
#include "core/geometry/triangle_mesh.h"
#include "core/skin/skin_map.h"

#include <memory>
#include <span>
#include <vector>

namespace knead {

/// What took an opened part to the shape that a body was filled from anew, as one smooth map: that of the skin (SkinMap) of objects
/// which lie in the opened part, its carriers. However often a body is filled, there is one such map, and never a chain of them; only
/// where it stretches more than its carriers can describe (mostStretch), the filling of then, which has a former shape of its own,
/// carries what comes after.
///
/// A body that had come apart then was filled anew piece by piece, and each piece has a map of its own, of those carriers that hang
/// together in it. Which piece a place on a crack belongs to it does not say: surfaces are cut first, see openedPieces().
///
/// Immutable; its members may be called from any thread.
class FormerShape final : public SmoothMap {
public:
    /// Beyond which its carriers lie too far apart in what it makes.
    static constexpr double mostStretch = 5;
    /// So many follow each other at most; the last one then has to do.
    static constexpr int mostStages = 4;

    /// @param carriers a filling of the opened part itself, or of a former shape that stretches too much
    /// @param displacements one per carrier [m]
    /// @param broken connections of the carriers that parted the pieces that were filled; empty: it was in one piece
    FormerShape(std::shared_ptr<const Aggregate> carriers, std::vector<Vec3> displacements,
                std::vector<BrokenConnection> broken = {});

    void evaluate(std::span<const Vec3> points, std::span<Vec3> places) const override
    {
        m_map.evaluate(points, places);
    }
    double featureSize() const override { return m_map.featureSize(); }

    /// By which a piece of the map as long as a spacing of the carriers gets longer at most, >= 1.
    double largestStretch() const;
    /// The same from where the carriers were filled.
    double stretchOfCarriers() const { return m_stretch; }
    /// How many there are of them, this one and those of its carriers, >= 1.
    int stages() const { return 1 + (m_carriers->former ? m_carriers->former->stages() : 0); }

    const std::shared_ptr<const Aggregate>& carriers() const { return m_carriers; }
    const std::vector<Vec3>& displacements() const { return m_map.displacements(); }
    const std::vector<BrokenConnection>& broken() const { return m_broken; }
    bool isInPieces() const { return !m_broken.empty(); }

private:
    std::shared_ptr<const Aggregate> m_carriers;
    std::vector<BrokenConnection> m_broken;
    std::shared_ptr<const Aggregate> m_connected; ///< the carriers without these
    SkinMap m_map;
    double m_stretch = 1;
};

/// Of a body: a filling of the opened part itself, whose objects lie where they were opened.
const Aggregate& firstFillingOf(const Aggregate& aggregate);

/// Where the objects of the first filling of a body were when this one was made, each as its piece was [m].
std::vector<Vec3> firstFillingWhenFilled(const Aggregate& aggregate);

/// Points of an opened part where an aggregate was filled from: its former shape, or where they are.
std::vector<Vec3> placesWhenFilled(const Aggregate& aggregate, std::span<const Vec3> points);

/// A surface of an opened part, split until no edge of what a map makes of it is longer than `maximumEdge` [m].
struct CarriedSurface {
    TriangleMesh mesh;        ///< of the opened part
    std::vector<Vec3> places; ///< where the map takes its vertices [m]
};

/// @param mostTriangles coarser when about so many would not do
CarriedSurface carriedSurface(const TriangleMesh& mesh, const SmoothMap& map, double maximumEdge,
                              std::size_t mostTriangles = 400'000);

/// The same where the map takes it.
TriangleMesh carriedMesh(const TriangleMesh& mesh, const SmoothMap& map, double maximumEdge, std::size_t mostTriangles);

} // namespace knead
