#include "io/export/faceted_solid.h"

#include "core/geometry/disjoint_sets.h"
#include "core/geometry/flat_faces.h"
#include "core/message/message.h"
#include "io/morph/millimetre_map.h"

#include <BRepCheck_Analyzer.hxx>
#include <BRep_Builder.hxx>
#include <Geom_Line.hxx>
#include <Geom_Plane.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopLoc_Location.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Iterator.hxx>
#include <TopoDS_Shell.hxx>
#include <TopoDS_Solid.hxx>
#include <TopoDS_Vertex.hxx>
#include <TopoDS_Wire.hxx>

#include <algorithm>
#include <map>
#include <unordered_map>
#include <utility>
#include <vector>

namespace knead {

namespace {

constexpr double leastEdge = 1e-8;      // [m], shorter ones are points to modelers
constexpr double planeTolerance = 1e-6; // [mm] of planes through three points; others get what they need
constexpr double slack = 1.01;          // of tolerances, for rounding

/// Topology around the flat faces of a mesh, everything shared.
class FacetMaker {
public:
    FacetMaker(const TriangleMesh& mesh, const std::vector<FlatFace>& faces)
        : m_mesh(mesh)
        , m_vertices(mesh.vertices.size())
        , m_tolerances(mesh.vertices.size(), planeTolerance)
    {
        for (const FlatFace& face : faces)
            for (const auto& loop : face.loops)
                for (const std::uint32_t vertex : loop)
                    m_tolerances[vertex] = std::max(
                        m_tolerances[vertex], slack * std::abs(face.normal.dot(place(vertex) - 1e3 * face.point)));
        m_edges.reserve(2 * mesh.triangles.size());
    }

    TopoDS_Face face(const FlatFace& flat)
    {
        const Vec3 point = 1e3 * flat.point;
        TopoDS_Face face;
        m_builder.MakeFace(face,
                           new Geom_Plane(toPoint(point), gp_Dir(flat.normal.x(), flat.normal.y(), flat.normal.z())),
                           planeTolerance);
        for (const std::vector<std::uint32_t>& loop : flat.loops)
            m_builder.Add(face, wire(loop));
        return face;
    }

private:
    Vec3 place(std::uint32_t vertex) const { return 1e3 * m_mesh.vertices[vertex]; }

    TopoDS_Wire wire(const std::vector<std::uint32_t>& loop)
    {
        TopoDS_Wire wire;
        m_builder.MakeWire(wire);
        for (std::size_t i = 0; i < loop.size(); ++i) {
            const std::uint32_t from = loop[i];
            const std::uint32_t to = loop[(i + 1) % loop.size()];
            m_builder.Add(
                wire,
                edge(std::min(from, to), std::max(from, to)).Oriented(from < to ? TopAbs_FORWARD : TopAbs_REVERSED));
        }
        wire.Closed(true);
        return wire;
    }

    const TopoDS_Vertex& vertex(std::uint32_t index)
    {
        TopoDS_Vertex& vertex = m_vertices[index];
        if (vertex.IsNull())
            m_builder.MakeVertex(vertex, toPoint(place(index)), m_tolerances[index]);
        return vertex;
    }

    /// From the vertex with the lower number to the other.
    const TopoDS_Edge& edge(std::uint32_t lower, std::uint32_t upper)
    {
        TopoDS_Edge& edge = m_edges[std::uint64_t{lower} << 32U | upper];
        if (edge.IsNull()) {
            const Vec3 along = place(upper) - place(lower);
            const double needed = std::max(m_tolerances[lower], m_tolerances[upper]);
            m_builder.MakeEdge(edge, new Geom_Line(toPoint(place(lower)), gp_Dir(along.x(), along.y(), along.z())),
                               needed);
            m_builder.UpdateVertex(vertex(lower), needed);
            m_builder.UpdateVertex(vertex(upper), needed);
            m_builder.Add(edge, vertex(lower).Oriented(TopAbs_FORWARD));
            m_builder.Add(edge, vertex(upper).Oriented(TopAbs_REVERSED));
            m_builder.Range(edge, 0, along.norm());
        }
        return edge;
    }

    const TriangleMesh& m_mesh;
    BRep_Builder m_builder;
    std::vector<TopoDS_Vertex> m_vertices;
    std::vector<double> m_tolerances; // of vertices [mm]
    std::unordered_map<std::uint64_t, TopoDS_Edge> m_edges;
};

/// A closed part of the surface.
struct FacetShell {
    TopoDS_Shell shell;
    Box box;
    double volume = 0; ///< negative around a void
};

/// Of faces that hang together, in the order of their first triangles.
std::vector<FacetShell> shellsOf(const TriangleMesh& mesh, const std::vector<FlatFace>& flat,
                                 const std::vector<TopoDS_Face>& faces)
{
    const BRep_Builder builder;
    DisjointSets sets(mesh.vertices.size());
    for (const TriangleMesh::Triangle& t : mesh.triangles) {
        sets.join(t[0], t[1]);
        sets.join(t[1], t[2]);
    }
    std::vector<FacetShell> shells;
    std::map<std::size_t, std::size_t> numbers; // of the shells, by set
    const auto shellAt = [&](std::uint32_t triangle) -> FacetShell& {
        const auto [found, isNew] = numbers.try_emplace(sets.find(mesh.triangles[triangle][0]), shells.size());
        if (isNew)
            builder.MakeShell(shells.emplace_back().shell);
        return shells[found->second];
    };
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
        FacetShell& shell = shellAt(t);
        const auto& [a, b, c] = mesh.triangles[t];
        shell.volume += mesh.vertices[a].dot(mesh.vertices[b].cross(mesh.vertices[c])) / 6;
        for (const std::uint32_t vertex : mesh.triangles[t])
            shell.box.extend(mesh.vertices[vertex]);
    }
    for (std::size_t i = 0; i < faces.size(); ++i)
        builder.Add(shellAt(flat[i].triangle).shell, faces[i]);
    for (FacetShell& shell : shells)
        shell.shell.Closed(true);
    return shells;
}

/// Each shell in the smallest one around it.
TopoDS_Shape solidsOf(const std::vector<FacetShell>& shells)
{
    const BRep_Builder builder;
    std::vector<std::pair<TopoDS_Solid, const FacetShell*>> solids;
    for (const FacetShell& shell : shells)
        if (shell.volume >= 0) {
            TopoDS_Solid solid;
            builder.MakeSolid(solid);
            builder.Add(solid, shell.shell);
            solids.emplace_back(solid, &shell);
        }
    if (solids.empty())
        throw Problem(Message("Export", "The surface bounds no volume."));
    for (const FacetShell& shell : shells) {
        if (shell.volume >= 0)
            continue;
        auto* around = &solids.front();
        for (auto& solid : solids)
            if (solid.second->box.contains(shell.box) &&
                (!around->second->box.contains(shell.box) || solid.second->volume < around->second->volume))
                around = &solid;
        builder.Add(around->first, shell.shell);
    }
    if (solids.size() == 1)
        return solids.front().first;
    TopoDS_Compound all;
    builder.MakeCompound(all);
    for (const auto& solid : solids)
        builder.Add(all, solid.first);
    return all;
}

FacetedSolid makeSolid(const TriangleMesh& mesh, const std::vector<FlatFace>& flat)
{
    std::vector<TopoDS_Face> faces;
    FacetMaker maker(mesh, flat);
    for (const FlatFace& face : flat)
        faces.push_back(maker.face(face));
    FacetedSolid result{.shape = solidsOf(shellsOf(mesh, flat, faces)), .origin = {}};
    if (mesh.faceOfTriangle.empty())
        return result;
    TopTools_IndexedMapOfShape numbers;
    TopExp::MapShapes(result.shape, TopAbs_FACE, numbers);
    result.origin.resize(static_cast<std::size_t>(numbers.Extent()));
    for (std::size_t i = 0; i < faces.size(); ++i)
        result.origin[static_cast<std::size_t>(numbers.FindIndex(faces[i])) - 1] =
            mesh.faceOfTriangle[flat[i].triangle];
    return result;
}

/// Whether the faces of several triangles pass the checks; how all fit together is known.
bool areSound(const TopoDS_Shape& shape)
{
    for (TopExp_Explorer faces(shape, TopAbs_FACE); faces.More(); faces.Next())
        if (faces.Current().NbChildren() > 1 || TopoDS_Iterator(faces.Current()).Value().NbChildren() > 3)
            if (!BRepCheck_Analyzer(faces.Current()).IsValid())
                return false;
    return true;
}

} // namespace

FacetedSolid facetedSolid(const TriangleMesh& given, double flatness)
{
    const TriangleMesh mesh = weld(given, leastEdge);
    if (const std::vector<FlatFace> merged = flatFaces(mesh, flatness); merged.size() < mesh.triangles.size())
        if (FacetedSolid solid = makeSolid(mesh, merged); areSound(solid.shape))
            return solid;
    return makeSolid(mesh, flatFaces(mesh, 0));
}

} // namespace knead
