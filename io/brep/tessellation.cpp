#include "io/brep/tessellation.h"

#include "io/brep/face_triangulation.h"
#include "io/brep/millimeter.h"
#include "io/mesh/volume_fit.h"

#include <BRepMesh_IncrementalMesh.hxx>
#include <BRep_Tool.hxx>
#include <IMeshTools_Parameters.hxx>
#include <Poly_PolygonOnTriangulation.hxx>
#include <Poly_Triangulation.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Vertex.hxx>

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

namespace knead {

namespace {

constexpr double finestDeflection = 1e-4; // [mm]

Vec3 toVec3(const gp_Pnt& point)
{
    return millimeter * Vec3(point.X(), point.Y(), point.Z());
}

/// Collects faces with nodes of their own, then joins the nodes that lie on common edges and vertices.
class MeshCollector {
public:
    MeshCollector(const TopoDS_Shape& shape, VertexPlace place, double deflection)
        : m_place(place)
        , m_deflection(deflection)
    {
        TopExp::MapShapes(shape, TopAbs_FACE, m_faces);
        TopExp::MapShapes(shape, TopAbs_EDGE, m_edges);
        TopExp::MapShapes(shape, TopAbs_VERTEX, m_vertices);
        m_nodesOfEdge.resize(static_cast<std::size_t>(m_edges.Extent()));
        m_nodeOfVertex.assign(static_cast<std::size_t>(m_vertices.Extent()), none);
    }

    TriangleMesh run()
    {
        for (int face = 1; face <= m_faces.Extent(); ++face)
            addFace(TopoDS::Face(m_faces(face)), static_cast<std::uint32_t>(face - 1));
        if (m_place == VertexPlace::volumeTrue)
            moveVertices();
        return joined();
    }

private:
    static constexpr std::uint32_t none = 0xffffffffU;

    void addFace(const TopoDS_Face& face, std::uint32_t index)
    {
        TopLoc_Location location;
        const Handle(Poly_Triangulation)& triangulation = BRep_Tool::Triangulation(face, location);
        if (triangulation.IsNull())
            return;
        const auto first = static_cast<std::uint32_t>(m_mesh.vertices.size());
        const gp_Trsf placement = location.Transformation();
        for (int node = 1; node <= triangulation->NbNodes(); ++node)
            m_mesh.vertices.push_back(toVec3(triangulation->Node(node).Transformed(placement)));
        while (m_parent.size() < m_mesh.vertices.size())
            m_parent.push_back(static_cast<std::uint32_t>(m_parent.size()));

        const bool flipped = (face.Orientation() == TopAbs_REVERSED) != placement.IsNegative();
        for (int t = 1; t <= triangulation->NbTriangles(); ++t) {
            int a = 0;
            int b = 0;
            int c = 0;
            triangulation->Triangle(t).Get(a, b, c);
            if (flipped)
                std::swap(b, c);
            const auto node = [&](int n) { return first + static_cast<std::uint32_t>(n) - 1; };
            m_mesh.triangles.push_back({node(a), node(b), node(c)});
            m_mesh.faceOfTriangle.push_back(index);
        }
        if (m_place == VertexPlace::volumeTrue)
            m_fit.addFace(face, *triangulation, m_mesh, first);
        for (TopExp_Explorer edges(face, TopAbs_EDGE); edges.More(); edges.Next())
            addEdge(TopoDS::Edge(edges.Current()), triangulation, location, first);
    }

    /// A seam has two lines of nodes on the face: the explorer meets it in both orientations.
    void addEdge(const TopoDS_Edge& edge, const Handle(Poly_Triangulation) & triangulation,
                 const TopLoc_Location& location, std::uint32_t first)
    {
        const Handle(Poly_PolygonOnTriangulation)& polygon =
            BRep_Tool::PolygonOnTriangulation(edge, triangulation, location);
        if (polygon.IsNull())
            return;
        std::vector<std::uint32_t> nodes;
        for (int i = 1; i <= polygon->NbNodes(); ++i)
            nodes.push_back(first + static_cast<std::uint32_t>(polygon->Node(i)) - 1);

        if (BRep_Tool::Degenerated(edge)) { // all of it is one point of space: a pole, an apex
            for (const std::uint32_t node : nodes)
                join(node, nodes.front());
        } else {
            joinWithEarlier(edge, nodes);
        }
        const auto forward = TopoDS::Edge(edge.Oriented(TopAbs_FORWARD)); // as the polygon runs
        joinAtVertex(TopExp::FirstVertex(forward), nodes.front());
        joinAtVertex(TopExp::LastVertex(forward), nodes.back());
    }

    void joinWithEarlier(const TopoDS_Edge& edge, const std::vector<std::uint32_t>& nodes)
    {
        std::vector<std::uint32_t>& earlier = m_nodesOfEdge[static_cast<std::size_t>(m_edges.FindIndex(edge)) - 1];
        if (earlier.empty())
            earlier = nodes;
        if (earlier.size() != nodes.size()) // then the mesh stays open there, which the caller sees
            return;
        for (std::size_t i = 0; i < nodes.size(); ++i)
            join(nodes[i], earlier[i]);
    }

    void joinAtVertex(const TopoDS_Vertex& vertex, std::uint32_t node)
    {
        if (vertex.IsNull())
            return;
        std::uint32_t& known = m_nodeOfVertex[static_cast<std::size_t>(m_vertices.FindIndex(vertex)) - 1];
        if (known == none)
            known = node;
        join(node, known);
    }

    std::uint32_t find(std::uint32_t node)
    {
        while (m_parent[node] != node)
            node = m_parent[node] = m_parent[m_parent[node]];
        return node;
    }

    void join(std::uint32_t a, std::uint32_t b)
    {
        a = find(a);
        b = find(b);
        m_parent[std::max(a, b)] = std::min(a, b);
    }

    void moveVertices()
    {
        std::vector<std::uint32_t> points;
        for (std::uint32_t node = 0; node < m_parent.size(); ++node)
            points.push_back(find(node));
        const std::vector<Vec3> moves = m_fit.moves(m_mesh, points, m_deflection);
        for (std::size_t node = 0; node < moves.size(); ++node)
            m_mesh.vertices[node] += moves[node];
    }

    TriangleMesh joined()
    {
        TriangleMesh result;
        std::vector<std::uint32_t> place(m_mesh.vertices.size(), none);
        const auto placeOf = [&](std::uint32_t node) {
            std::uint32_t& known = place[find(node)];
            if (known == none) {
                known = static_cast<std::uint32_t>(result.vertices.size());
                result.vertices.push_back(m_mesh.vertices[find(node)]);
            }
            return known;
        };
        for (std::size_t t = 0; t < m_mesh.triangles.size(); ++t) {
            const TriangleMesh::Triangle& old = m_mesh.triangles[t];
            if (find(old[0]) == find(old[1]) || find(old[1]) == find(old[2]) || find(old[2]) == find(old[0]))
                continue;
            result.triangles.push_back({placeOf(old[0]), placeOf(old[1]), placeOf(old[2])});
            result.faceOfTriangle.push_back(m_mesh.faceOfTriangle[t]);
        }
        return result;
    }

    VertexPlace m_place;
    double m_deflection; // [m]
    TopTools_IndexedMapOfShape m_faces;
    TopTools_IndexedMapOfShape m_edges;
    TopTools_IndexedMapOfShape m_vertices;
    TriangleMesh m_mesh;
    VolumeFit m_fit;
    std::vector<std::uint32_t> m_parent;
    std::vector<std::vector<std::uint32_t>> m_nodesOfEdge;
    std::vector<std::uint32_t> m_nodeOfVertex;
};

} // namespace

Tessellation tessellationFor(double diagonal, const ImportOptions& options)
{
    return {options.linearDeflection > 0 ? options.linearDeflection : options.relativeDeflection * diagonal,
            options.angularDeflection};
}

TriangleMesh tessellate(const TopoDS_Shape& shape, const Tessellation& tessellation)
{
    IMeshTools_Parameters parameters;
    parameters.Deflection = std::max(tessellation.deflection / millimeter, finestDeflection);
    parameters.Angle = tessellation.angle;
    parameters.InParallel = true;
    const BRepMesh_IncrementalMesh triangulated(shape, parameters);
    mendTriangles(shape, {parameters.Deflection * millimeter, tessellation.angle});
    return collectTriangles(shape, tessellation, VertexPlace::onFaces);
}

TriangleMesh collectTriangles(const TopoDS_Shape& shape, const Tessellation& tessellation, VertexPlace place)
{
    return MeshCollector(shape, place, tessellation.deflection).run();
}

} // namespace knead
