#include "io/shape_box.h"

#include <BRepAdaptor_Curve.hxx>
#include <BRepBndLib.hxx>
#include <BRep_Tool.hxx>
#include <Bnd_Box.hxx>
#include <Precision.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>

namespace knead {

namespace {

constexpr double millimeter = 1e-3;
constexpr int samplesPerEdge = 8;

Box toBox(const Bnd_Box& bounds)
{
    if (bounds.IsVoid() || bounds.IsOpen())
        return {};
    const gp_Pnt low = bounds.CornerMin();
    const gp_Pnt high = bounds.CornerMax();
    return {millimeter * Vec3(low.X(), low.Y(), low.Z()), millimeter * Vec3(high.X(), high.Y(), high.Z())};
}

/// Points of edges lie on faces, so their box is inside the box of the faces.
Box boxOfEdges(const TopoDS_Shape& shape)
{
    Box box;
    TopTools_IndexedMapOfShape edges;
    TopExp::MapShapes(shape, TopAbs_EDGE, edges);
    for (int i = 1; i <= edges.Extent(); ++i) {
        const TopoDS_Edge& edge = TopoDS::Edge(edges(i));
        if (BRep_Tool::Degenerated(edge) || !BRep_Tool::IsGeometric(edge))
            continue;
        const BRepAdaptor_Curve curve(edge);
        const double first = curve.FirstParameter();
        const double last = curve.LastParameter();
        if (Precision::IsInfinite(first) || Precision::IsInfinite(last))
            continue;
        for (int sample = 0; sample <= samplesPerEdge; ++sample) {
            const gp_Pnt point = curve.Value(first + (last - first) * sample / samplesPerEdge);
            box.extend(millimeter * Vec3(point.X(), point.Y(), point.Z()));
        }
    }
    return box;
}

} // namespace

Box boxOfFaces(const TopoDS_Shape& shape)
{
    Box box = boxOfEdges(shape);
    TopTools_IndexedMapOfShape faces;
    TopExp::MapShapes(shape, TopAbs_FACE, faces);
    for (int i = 1; i <= faces.Extent(); ++i) {
        Bnd_Box loose; // of control points: quick, and enough for faces inside of what is known already
        BRepBndLib::Add(faces(i), loose, false);
        if (!loose.IsVoid() && !loose.IsOpen() && box.contains(toBox(loose)))
            continue;
        Bnd_Box tight;
        BRepBndLib::AddOptimal(faces(i), tight, false, false);
        const Box ofFace = toBox(tight);
        if (ofFace.isEmpty())
            return {};
        box.extend(ofFace);
    }
    return box;
}

Box tightened(const Box& box, const Box& ofTriangles, double deflection)
{
    Box result = box;
    for (int axis = 0; axis < 3; ++axis) {
        if (ofTriangles.min()[axis] - box.min()[axis] > 2 * deflection)
            result.min()[axis] = ofTriangles.min()[axis];
        if (box.max()[axis] - ofTriangles.max()[axis] > 2 * deflection)
            result.max()[axis] = ofTriangles.max()[axis];
    }
    return result;
}

} // namespace knead
