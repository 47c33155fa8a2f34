#include "example_parts.h"

#include <BRepAdaptor_Curve.hxx>
#include <BRepAlgoAPI_Cut.hxx>
#include <BRepAlgoAPI_Fuse.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <BRepFilletAPI_MakeFillet.hxx>
#include <BRepOffsetAPI_ThruSections.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <ShapeUpgrade_UnifySameDomain.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <gp_Ax1.hxx>
#include <gp_Ax2.hxx>
#include <gp_Elips.hxx>
#include <gp_Trsf.hxx>

#include <cmath>
#include <stdexcept>

namespace {

TopoDS_Shape cylinder(const gp_Pnt& foot, const gp_Dir& axis, double radius, double height)
{
    return BRepPrimAPI_MakeCylinder(gp_Ax2(foot, axis), radius, height).Shape();
}

TopoDS_Shape box(double x0, double y0, double z0, double x1, double y1, double z1)
{
    return BRepPrimAPI_MakeBox(gp_Pnt(x0, y0, z0), gp_Pnt(x1, y1, z1)).Shape();
}

/// One face where several lie in the same surface.
TopoDS_Shape unified(const TopoDS_Shape& shape)
{
    ShapeUpgrade_UnifySameDomain unify(shape);
    unify.Build();
    return unify.Shape();
}

/// Straight edges along an axis whose middle the test accepts.
template <typename Accept>
TopoDS_Shape rounded(const TopoDS_Shape& shape, double radius, Accept accept)
{
    BRepFilletAPI_MakeFillet fillet(shape);
    TopTools_IndexedMapOfShape edges;
    TopExp::MapShapes(shape, TopAbs_EDGE, edges);
    for (int i = 1; i <= edges.Extent(); ++i) {
        const TopoDS_Edge& edge = TopoDS::Edge(edges(i));
        const BRepAdaptor_Curve curve(edge);
        if (curve.GetType() != GeomAbs_Line)
            continue;
        const gp_Pnt middle = curve.Value(0.5 * (curve.FirstParameter() + curve.LastParameter()));
        if (accept(middle, curve.Line().Direction()))
            fillet.Add(radius, edge);
    }
    fillet.Build();
    if (!fillet.IsDone())
        throw std::runtime_error("The edges cannot be rounded.");
    return fillet.Shape();
}

bool isParallel(const gp_Dir& direction, const gp_Dir& axis)
{
    return direction.IsParallel(axis, 1e-6);
}

bool isNear(double a, double b)
{
    return std::abs(a - b) < 1e-6;
}

/// An elliptical cut through the grip [mm].
struct Section {
    double height;
    double forward; // of the middle, along x
    double width;   // half, along x
    double depth;   // half, along y
};

TopoDS_Shape loft(const std::vector<Section>& sections)
{
    BRepOffsetAPI_ThruSections builder(true, false);
    for (const Section& s : sections) {
        const bool deeper = s.depth > s.width;
        const gp_Ax2 place(gp_Pnt(s.forward, 0, s.height), gp_Dir(0, 0, 1), deeper ? gp_Dir(0, 1, 0) : gp_Dir(1, 0, 0));
        const gp_Elips ellipse(place, std::max(s.width, s.depth), std::min(s.width, s.depth));
        builder.AddWire(BRepBuilderAPI_MakeWire(BRepBuilderAPI_MakeEdge(ellipse).Edge()).Wire());
    }
    builder.Build();
    return builder.Shape();
}

/// The closed edges at both ends of something round.
TopoDS_Shape roundedRims(const TopoDS_Shape& shape, double radius)
{
    BRepFilletAPI_MakeFillet fillet(shape);
    TopTools_IndexedMapOfShape edges;
    TopExp::MapShapes(shape, TopAbs_EDGE, edges);
    for (int i = 1; i <= edges.Extent(); ++i) {
        const TopoDS_Edge& edge = TopoDS::Edge(edges(i));
        TopoDS_Vertex first;
        TopoDS_Vertex last;
        TopExp::Vertices(edge, first, last);
        if (first.IsSame(last)) // the seam runs between them
            fillet.Add(radius, edge);
    }
    fillet.Build();
    if (!fillet.IsDone())
        throw std::runtime_error("The rims cannot be rounded.");
    return fillet.Shape();
}

} // namespace

std::vector<ExampleBody> makeBar()
{
    return {{"Bar", box(0, 0, 0, 160, 20, 20), 0.86, 0.36, 0.22}};
}

std::vector<ExampleBody> makePaperBar()
{
    return {{"Paper bar", box(0, 0, 0, 10, 10, 34), 0.55, 0.62, 0.38}};
}

std::vector<ExampleBody> makeLump()
{
    return {{"Lump",
             unified(rounded(
                 box(0, 0, 0, 60, 40, 24), 5,
                 [](const gp_Pnt& p, const gp_Dir& d) { return isParallel(d, gp_Dir(0, 0, 1)) || isNear(p.Z(), 24); })),
             0.66, 0.47, 0.38}};
}

std::vector<ExampleBody> makePlate()
{
    const auto isCorner = [](const gp_Pnt& /*middle*/, const gp_Dir& d) { return isParallel(d, gp_Dir(0, 0, 1)); };
    return {{"Plate", rounded(box(0, 0, 0, 60, 44, 6), 5, isCorner), 0.56, 0.74, 0.73}};
}

std::vector<ExampleBody> makeBracket()
{
    constexpr double width = 50;  // along y
    constexpr double length = 70; // of the foot, along x
    constexpr double height = 60;
    constexpr double wall = 8;
    constexpr double holeRadius = 10;
    const gp_Dir x(1, 0, 0);
    const gp_Dir y(0, 1, 0);
    const gp_Dir z(0, 0, 1);

    TopoDS_Shape body = BRepAlgoAPI_Fuse(box(0, 0, 0, length, width, wall), box(0, 0, 0, wall, width, height)).Shape();
    body = unified(body);
    body = rounded(body, 6, [&](const gp_Pnt& p, const gp_Dir& d) { // the inner corner
        return isParallel(d, y) && isNear(p.X(), wall) && isNear(p.Z(), wall);
    });
    body = rounded(body, 12, [&](const gp_Pnt& p, const gp_Dir& d) { // the corners of the two plates
        return (isParallel(d, z) && isNear(p.X(), length)) || (isParallel(d, x) && isNear(p.Z(), height));
    });
    for (const double side : {14.0, width - 14.0})
        body = BRepAlgoAPI_Cut(body, cylinder({length - 18, side, -1}, z, 4.5, wall + 2)).Shape();
    body = BRepAlgoAPI_Cut(body, cylinder({-1, width / 2, height - 24}, x, holeRadius, wall + 2)).Shape();

    const TopoDS_Shape sleeve = BRepAlgoAPI_Cut(cylinder({-4, width / 2, height - 24}, x, holeRadius, wall + 8),
                                                cylinder({-5, width / 2, height - 24}, x, 6.5, wall + 10))
                                    .Shape();
    return {{"Bracket", body, 0.27, 0.47, 0.68}, {"Bushing", sleeve, 0.83, 0.62, 0.24}};
}

std::vector<ExampleBody> makeGrip()
{
    constexpr double flat = 9; // below the axis
    const TopoDS_Shape round = roundedRims(loft({{0, 0, 11, 13},
                                                 {25, 1, 14, 15.5},
                                                 {55, 2, 15.5, 17},
                                                 {80, 1.5, 13, 14.5},
                                                 {100, 1, 12.5, 13.5},
                                                 {120, 2, 14, 14.5}}),
                                           4);
    gp_Trsf lying; // its axis along x, what was forward upwards
    lying.SetRotation(gp_Ax1(gp_Pnt(0, 0, 0), gp_Dir(1, 0, 1)), M_PI);
    gp_Trsf raised;
    raised.SetTranslation(gp_Vec(0, 0, flat));
    const TopoDS_Shape placed = BRepBuilderAPI_Transform(round, raised * lying).Shape();
    return {{"Grip", BRepAlgoAPI_Cut(placed, box(-10, -30, -30, 140, 30, 0)).Shape(), 0.80, 0.44, 0.25}};
}

std::vector<ExampleBody> makeHandle()
{
    const TopoDS_Shape grip = roundedRims(loft({{0, 0, 13, 11},
                                                {20, 0.5, 16.5, 13},
                                                {45, 3, 18.5, 14.5},
                                                {70, 6, 16, 12.5},
                                                {90, 9, 14, 11.5},
                                                {110, 13.5, 15.5, 12.5},
                                                {125, 18, 15, 12}}),
                                          3);
    const TopoDS_Shape ferrule = roundedRims(cylinder({0, 0, -16}, gp_Dir(0, 0, 1), 7.5, 16), 1.5);
    return {{"Grip", grip, 0.30, 0.34, 0.36}, {"Ferrule", ferrule, 0.79, 0.80, 0.82}};
}
