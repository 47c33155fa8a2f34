#pragma once

#include <Eigen/Core>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <gp_Pnt.hxx>
#include <gp_Vec.hxx>

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

namespace knead {

/// The points that divide an edge, from its first to its last parameter.
struct EdgePoints {
    std::vector<double> parameters;
    std::vector<gp_Pnt> points; ///< where the edge lies in the shape [mm]
};

/// What is drawn of a face: where its surface lies, or is taken, and the points that its edges are divided by.
class SurfaceToDraw {
public:
    virtual ~SurfaceToDraw() = default;

    virtual gp_Pnt placeAt(const Eigen::Vector2d& parameters) const = 0;

    /// Not zero, of any length.
    virtual gp_Vec normalAt(const Eigen::Vector2d& parameters) const = 0;

    /// Along u and v [mm per unit of the parameter].
    virtual Eigen::Vector2d metricAt(const Eigen::Vector2d& parameters) const = 0;

    /// Asked for once for each run of a wire along an edge, always with the same answer. Edges without length, too.
    virtual EdgePoints pointsOf(const TopoDS_Edge& edge) = 0;
};

/// How fine triangles are drawn.
struct DrawingFineness {
    double deflection = 0;                                   ///< chord error [mm]
    double angle = 0;                                        ///< between neighboring chords [rad]
    double longestSide = std::numeric_limits<double>::max(); ///< [mm]
    double shortestSide = 0; ///< shorter ones are not divided, nor those within the deflection [mm]

    double undividedSide() const { return std::max(deflection, shortestSide); } ///< [mm]
};

/// Triangles of a face.
struct DrawnFace {
    /// A wire's way along an edge.
    struct Run {
        TopoDS_Edge edge; ///< oriented as in the wire
        std::vector<double> parameters;
        std::vector<std::uint32_t> points; ///< as the edge itself runs; none for a loop of two points
    };

    std::vector<Eigen::Vector2d> parameters;             ///< of the points
    std::vector<gp_Pnt> places;                          ///< of the points [mm]
    std::vector<std::array<std::uint32_t, 3>> triangles; ///< counter-clockwise in the parameters
    std::vector<Run> runs;
};

/// Draws a face in the plane of its parameters: its border first, triangles between the points of the border, then points
/// inside where triangles lie too far off the surface.
/// @pre it does not lie on both sides of an edge that is no seam
/// @return none when its wires do not close in the parameters
/// @throws Standard_Failure when something cannot be evaluated
std::optional<DrawnFace> drawFace(const TopoDS_Face& face, SurfaceToDraw& surface, const DrawingFineness& fineness);

} // namespace knead
