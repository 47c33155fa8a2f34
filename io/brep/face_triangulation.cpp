#include "io/brep/face_triangulation.h"

#include "io/brep/face_redrawing.h"

#include <BRepGProp.hxx>
#include <BRep_Tool.hxx>
#include <GProp_GProps.hxx>
#include <Poly_PolygonOnTriangulation.hxx>
#include <Poly_Triangulation.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedDataMapOfShapeListOfShape.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

namespace knead {

namespace {

constexpr double wrongArea = 0.02; // relative; more than chords cut off

bool hasTriangles(const TopoDS_Face& face)
{
    TopLoc_Location location;
    const Handle(Poly_Triangulation)& triangulation = BRep_Tool::Triangulation(face, location);
    return !triangulation.IsNull() && triangulation->NbTriangles() > 0;
}

using NodePair = std::pair<int, int>; ///< the lower one first

/// The sides along which the triangles of a face end, or more than two of them meet.
std::set<NodePair> borderOf(const Poly_Triangulation& triangulation)
{
    std::map<NodePair, int> sides; // how many triangles have it one way, less those that have it the other way
    for (int t = 1; t <= triangulation.NbTriangles(); ++t) {
        int corners[3];
        triangulation.Triangle(t).Get(corners[0], corners[1], corners[2]);
        for (int i = 0; i < 3; ++i) {
            const auto [low, high] = std::minmax({corners[i], corners[(i + 1) % 3]});
            sides[NodePair(low, high)] += low == corners[i] ? 1 : -1;
        }
    }
    std::set<NodePair> border;
    for (const auto& [side, count] : sides)
        if (count != 0)
            border.insert(side);
    return border;
}

/// Whether the triangles of a face end exactly at the points of its edges.
bool endsAtEdges(const TopoDS_Face& face)
{
    TopLoc_Location location;
    const TopTools_MapOfShape slits = slitsOf(face);
    std::set<NodePair> border = borderOf(*BRep_Tool::Triangulation(face, location));
    for (TopExp_Explorer edges(face.Oriented(TopAbs_FORWARD), TopAbs_EDGE); edges.More(); edges.Next()) {
        const TopoDS_Edge& edge = TopoDS::Edge(edges.Current());
        if (edge.Orientation() != TopAbs_FORWARD && edge.Orientation() != TopAbs_REVERSED)
            continue;
        const Handle(Poly_PolygonOnTriangulation) polygon = polygonOf(edge, face);
        if (polygon.IsNull())
            return false;
        if (slits.Contains(edge))
            continue;
        for (int i = 1; i < polygon->NbNodes(); ++i) {
            const auto [low, high] = std::minmax({polygon->Node(i), polygon->Node(i + 1)});
            if (low != high && border.erase(NodePair(low, high)) == 0)
                return false;
        }
    }
    return border.empty();
}

/// Faces whose points at an edge are not those of the face that comes first there.
void addMismatches(const TopTools_IndexedDataMapOfShapeListOfShape& facesOfEdges, std::set<const void*>& bad)
{
    for (int e = 1; e <= facesOfEdges.Extent(); ++e) {
        const TopoDS_Edge& edge = TopoDS::Edge(facesOfEdges.FindKey(e));
        if (BRep_Tool::Degenerated(edge))
            continue;
        int count = 0;
        for (const TopoDS_Shape& face : facesOfEdges(e)) {
            if (bad.contains(face.TShape().get()))
                continue;
            const Handle(Poly_PolygonOnTriangulation) polygon = polygonOf(edge, TopoDS::Face(face));
            if (polygon.IsNull())
                continue;
            if (count == 0)
                count = polygon->NbNodes();
            else if (count != polygon->NbNodes())
                bad.insert(face.TShape().get());
        }
    }
}

/// Draws faces anew, whatever triangles they have.
void draw(const TopTools_IndexedMapOfShape& faces, const TopTools_IndexedDataMapOfShapeListOfShape& facesOfEdges,
          std::set<const void*> bad, const Tessellation& tessellation)
{
    for (int i = 1; i <= faces.Extent() && !bad.empty(); ++i) {
        const TopoDS_Face& face = TopoDS::Face(faces(i));
        if (bad.contains(face.TShape().get()) && redrawFace(face, facesOfEdges, bad, tessellation))
            bad.erase(face.TShape().get());
    }
}

double areaOfTriangles(const TopoDS_Face& face)
{
    TopLoc_Location location;
    const Handle(Poly_Triangulation)& triangulation = BRep_Tool::Triangulation(face, location);
    double area = 0;
    for (int t = 1; t <= triangulation->NbTriangles(); ++t) {
        int a = 0;
        int b = 0;
        int c = 0;
        triangulation->Triangle(t).Get(a, b, c);
        const gp_XYZ corner = triangulation->Node(a).XYZ();
        area += 0.5 * (triangulation->Node(b).XYZ() - corner).Crossed(triangulation->Node(c).XYZ() - corner).Modulus();
    }
    return area;
}

} // namespace

void mendTriangles(const TopoDS_Shape& shape, const Tessellation& tessellation)
{
    TopTools_IndexedMapOfShape faces;
    TopExp::MapShapes(shape, TopAbs_FACE, faces);
    std::set<const void*> bad;
    for (int i = 1; i <= faces.Extent(); ++i)
        if (const TopoDS_Face& face = TopoDS::Face(faces(i)); !hasTriangles(face) || !endsAtEdges(face))
            bad.insert(face.TShape().get());
    TopTools_IndexedDataMapOfShapeListOfShape facesOfEdges;
    TopExp::MapShapesAndAncestors(shape, TopAbs_EDGE, TopAbs_FACE, facesOfEdges);
    addMismatches(facesOfEdges, bad);
    draw(faces, facesOfEdges, std::move(bad), tessellation);
}

bool redrawFacesOfWrongArea(const TopoDS_Shape& shape, const Tessellation& tessellation)
{
    TopTools_IndexedMapOfShape faces;
    TopExp::MapShapes(shape, TopAbs_FACE, faces);
    std::set<const void*> bad;
    for (int i = 1; i <= faces.Extent(); ++i) {
        const TopoDS_Face& face = TopoDS::Face(faces(i));
        GProp_GProps properties;
        BRepGProp::SurfaceProperties(face, properties);
        if (hasTriangles(face) && std::abs(areaOfTriangles(face) - properties.Mass()) > wrongArea * properties.Mass())
            bad.insert(face.TShape().get());
    }
    if (bad.empty())
        return false;
    TopTools_IndexedDataMapOfShapeListOfShape facesOfEdges;
    TopExp::MapShapesAndAncestors(shape, TopAbs_EDGE, TopAbs_FACE, facesOfEdges);
    // Their points on edges are good, and those of the neighbors: they are what faces are drawn between.
    for (int i = 1; i <= faces.Extent(); ++i)
        if (const TopoDS_Face& face = TopoDS::Face(faces(i)); bad.contains(face.TShape().get()))
            redrawFace(face, facesOfEdges, {}, tessellation);
    return true;
}

} // namespace knead
