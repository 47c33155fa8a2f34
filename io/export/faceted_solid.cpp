#include "io/export/faceted_solid.h"

#include "core/geometry/mass_properties.h"
#include "io/morph/millimetre_map.h"

#include <BRep_Builder.hxx>
#include <Geom_Line.hxx>
#include <Geom_Plane.hxx>
#include <TopLoc_Location.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Shell.hxx>
#include <TopoDS_Solid.hxx>
#include <TopoDS_Vertex.hxx>
#include <TopoDS_Wire.hxx>

#include <algorithm>
#include <map>
#include <numeric>
#include <stdexcept>
#include <utility>
#include <vector>

namespace knead {

namespace {

constexpr double leastEdge = 1e-8; // [m], shorter ones are points to modelers
constexpr double tolerance = 1e-6; // [mm]; planes go through three points exactly, up to rounding

class FacetMaker {
public:
    explicit FacetMaker(const TriangleMesh& mesh)
        : m_mesh(mesh)
        , m_vertices(mesh.vertices.size())
    {
    }

    /// A shell of some of the triangles.
    TopoDS_Shell shell(const std::vector<std::size_t>& triangles)
    {
        TopoDS_Shell shell;
        m_builder.MakeShell(shell);
        for (const std::size_t triangle : triangles)
            m_builder.Add(shell, face(m_mesh.triangles[triangle]));
        shell.Closed(true);
        return shell;
    }

private:
    Vec3 place(std::uint32_t vertex) const { return 1e3 * m_mesh.vertices[vertex]; }

    const TopoDS_Vertex& vertex(std::uint32_t index)
    {
        TopoDS_Vertex& vertex = m_vertices[index];
        if (vertex.IsNull())
            m_builder.MakeVertex(vertex, toPoint(place(index)), tolerance);
        return vertex;
    }

    /// From the vertex with the lower number to the other.
    const TopoDS_Edge& edge(std::uint32_t lower, std::uint32_t upper)
    {
        TopoDS_Edge& edge = m_edges[{lower, upper}];
        if (edge.IsNull()) {
            const Vec3 along = place(upper) - place(lower);
            const double length = along.norm();
            m_builder.MakeEdge(edge, new Geom_Line(toPoint(place(lower)), gp_Dir(along.x(), along.y(), along.z())),
                               tolerance);
            m_builder.Add(edge, vertex(lower).Oriented(TopAbs_FORWARD));
            m_builder.Add(edge, vertex(upper).Oriented(TopAbs_REVERSED));
            m_builder.Range(edge, 0, length);
        }
        return edge;
    }

    TopoDS_Face face(const TriangleMesh::Triangle& triangle)
    {
        const Vec3 a = place(triangle[0]);
        const Vec3 along = place(triangle[1]) - a;
        Vec3 normal = along.cross(place(triangle[2]) - a);
        if (normal.norm() < 1e-12 * along.squaredNorm())
            normal = along.unitOrthogonal(); // three corners in a line: any plane through it will do
        TopoDS_Face face;
        m_builder.MakeFace(face,
                           new Geom_Plane(gp_Ax3(toPoint(a), gp_Dir(normal.x(), normal.y(), normal.z()),
                                                 gp_Dir(along.x(), along.y(), along.z()))),
                           tolerance);
        TopoDS_Wire wire;
        m_builder.MakeWire(wire);
        for (std::size_t i = 0; i < 3; ++i) {
            const std::uint32_t from = triangle[i];
            const std::uint32_t to = triangle[(i + 1) % 3];
            m_builder.Add(
                wire,
                edge(std::min(from, to), std::max(from, to)).Oriented(from < to ? TopAbs_FORWARD : TopAbs_REVERSED));
        }
        wire.Closed(true);
        m_builder.Add(face, wire);
        return face;
    }

    const TriangleMesh& m_mesh;
    BRep_Builder m_builder;
    std::vector<TopoDS_Vertex> m_vertices;
    std::map<std::pair<std::uint32_t, std::uint32_t>, TopoDS_Edge> m_edges;
};

/// Triangles that hang together, shell by shell.
std::vector<std::vector<std::size_t>> shellsOf(const TriangleMesh& mesh)
{
    std::vector<std::uint32_t> root(mesh.vertices.size());
    std::iota(root.begin(), root.end(), 0U);
    const auto find = [&](std::uint32_t vertex) {
        while (root[vertex] != vertex)
            vertex = root[vertex] = root[root[vertex]];
        return vertex;
    };
    for (const TriangleMesh::Triangle& triangle : mesh.triangles)
        for (const std::size_t corner : {1U, 2U})
            root[find(triangle[corner])] = find(triangle[0]);
    std::map<std::uint32_t, std::vector<std::size_t>> shells;
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
        shells[find(mesh.triangles[i][0])].push_back(i);
    std::vector<std::vector<std::size_t>> result;
    for (auto& [vertex, shell] : shells)
        result.push_back(std::move(shell));
    return result;
}

MassProperties propertiesOf(const TriangleMesh& mesh, const std::vector<std::size_t>& shell)
{
    TriangleMesh part;
    part.vertices = mesh.vertices;
    for (const std::size_t triangle : shell)
        part.triangles.push_back(mesh.triangles[triangle]);
    return massProperties(part);
}

} // namespace

TopoDS_Shape facetedSolid(const TriangleMesh& given)
{
    const TriangleMesh mesh = weld(given, leastEdge);
    FacetMaker maker(mesh);
    const BRep_Builder builder;
    struct Outside {
        TopoDS_Solid solid;
        Box box;
        double volume;
    };
    std::vector<Outside> solids;
    std::vector<std::pair<TopoDS_Shell, Box>> voids;
    for (const std::vector<std::size_t>& triangles : shellsOf(mesh)) {
        const MassProperties properties = propertiesOf(mesh, triangles);
        const TopoDS_Shell shell = maker.shell(triangles);
        if (properties.volume < 0) {
            voids.emplace_back(shell, properties.box);
            continue;
        }
        TopoDS_Solid solid;
        builder.MakeSolid(solid);
        builder.Add(solid, shell);
        solids.push_back({solid, properties.box, properties.volume});
    }
    if (solids.empty())
        throw std::runtime_error("The surface bounds no volume.");
    for (const auto& [shell, box] : voids) {
        Outside* around = &solids.front(); // the smallest one that holds the void
        for (Outside& solid : solids)
            if (solid.box.contains(box) && (!around->box.contains(box) || solid.volume < around->volume))
                around = &solid;
        builder.Add(around->solid, shell);
    }
    if (solids.size() == 1)
        return solids.front().solid;
    TopoDS_Compound all;
    builder.MakeCompound(all);
    for (const Outside& solid : solids)
        builder.Add(all, solid.solid);
    return all;
}

} // namespace knead
