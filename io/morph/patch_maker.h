#pragma once

#include "io/brep/face_drawing.h"
#include "io/morph/millimetre_map.h"

#include <BRep_Builder.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Vertex.hxx>

#include <cstdint>
#include <functional>
#include <map>
#include <utility>
#include <vector>

namespace knead {

/// Makes triangles in the place of single faces of a shape that is carried along. Neighbors that stay smooth are met exactly: the
/// edge between is cut where triangles end, and each piece belongs to one of them.
class PatchMaker {
public:
    /// What the maker asks of the shape around.
    struct Surroundings {
        /// What an edge became, forward, with its curves on all faces that stay smooth.
        std::function<TopoDS_Edge(const TopoDS_Edge& source)> imageOf;
        /// What an edge is told from others by, wherever it lies.
        std::function<int(const TopoDS_Edge& source)> numberOf;
        /// Whether one of the faces at an edge stays smooth.
        std::function<bool(const TopoDS_Edge& source)> isBesideSmooth;
    };

    PatchMaker(const DrawingFineness& fineness, Surroundings surroundings);

    /// Triangles in the place of a face, their outside where its own is.
    /// @param face of the source, as it is oriented in the whole
    /// @param map what carries it
    /// @throws Problem, when it cannot be drawn
    std::vector<TopoDS_Face> facesFor(const TopoDS_Face& face, const MillimetreMap& map);

    /// The edges that were cut, by number, in pieces as they run.
    const std::map<int, std::vector<TopoDS_Edge>>& pieces() const { return m_pieces; }

private:
    class CarriedFace;
    using Ends = std::pair<std::size_t, std::size_t>; ///< numbers of vertices

    /// Where an edge is divided.
    struct Division {
        EdgePoints points;
        std::vector<TopoDS_Vertex> vertices;
    };

    const Division& divisionOf(const TopoDS_Edge& edge);
    Division divide(const TopoDS_Edge& edge);
    void cut(const TopoDS_Edge& edge, const TopoDS_Edge& image, const Division& division);
    std::size_t vertexNumber(const TopoDS_Vertex& vertex);
    TopoDS_Edge edgeBetween(const TopoDS_Vertex& from, const TopoDS_Vertex& to);
    TopoDS_Face triangle(const TopoDS_Vertex& a, const TopoDS_Vertex& b, const TopoDS_Vertex& c);

    DrawingFineness m_fineness;
    Surroundings m_surroundings;
    BRep_Builder m_builder;
    std::map<int, Division> m_divisions;              // of edges of the source, by number
    std::map<int, std::vector<TopoDS_Edge>> m_pieces; // of edges of the source, by number
    std::map<const void*, std::size_t> m_numbers;     // of vertices
    std::map<Ends, TopoDS_Edge> m_edges; // between vertices, straight ones and pieces; from first to second
};

} // namespace knead
