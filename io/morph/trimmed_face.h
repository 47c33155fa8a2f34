#pragma once

#include "core/geometry/spline_fit.h"

#include <Geom2d_Curve.hxx>
#include <GeomAdaptor_Surface.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <gp_Trsf.hxx>
#include <gp_Vec2d.hxx>

#include <array>
#include <vector>

namespace knead {

/// An edge as a face sees it: its curves in the face's parameters, over the same range as its curve in space.
struct FaceEdge {
    TopoDS_Edge edge; ///< forward
    std::array<Handle(Geom2d_Curve), 2>
        curves; ///< along the edge; the second one for the other side of a seam, or null
    double first = 0;
    double last = 0;
    gp_Vec2d shift; ///< by whole periods, so that wires run on, and into the box of the face

    std::vector<Handle(Geom2d_Curve)> shifted() const; ///< one or two
};

/// What a face is made of, for those who build another one like it: its surface where it is in space, the curves of its edges,
/// and the box of parameters these bound. Wires of a periodic face may lie a period away from each other; `shift` brings them
/// together. May be used from several threads, one face each.
class TrimmedFace {
public:
    /// @param face forward
    /// @throws Problem, when an edge has no curve on the surface or the face is not bounded
    explicit TrimmedFace(const TopoDS_Face& face);

    const TopoDS_Face& face() const { return m_face; }
    const std::vector<FaceEdge>& edges() const { return m_edges; }
    const GeomAdaptor_Surface& surface() const { return m_surface; } ///< without the location
    const gp_Trsf& location() const { return m_location; }

    Vec2 low() const { return m_low; }
    Vec2 high() const { return m_high; }

    Vec3 at(const Vec2& parameters) const; ///< in space [mm]

    /// Longest paths of constant v and u through the box, roughly [mm].
    Vec2 lengths() const;

    /// Places along all edges, so many for each.
    std::vector<Vec2> borderSamples(int perEdge) const;

private:
    struct WireBox;

    Vec2 period() const;
    void addWire(const TopoDS_Shape& wire, WireBox& box);
    void bringTogether(std::vector<WireBox>& wires);
    void snapToBounds();

    TopoDS_Face m_face;
    GeomAdaptor_Surface m_surface;
    gp_Trsf m_location;
    std::vector<FaceEdge> m_edges;
    Vec2 m_low = Vec2::Constant(1e100);
    Vec2 m_high = Vec2::Constant(-1e100);
};

/// Places along the edges of a face in space, for SmoothMap::ofFace() [mm].
std::vector<Vec3> placesOnEdges(const TopoDS_Shape& face);

} // namespace knead
