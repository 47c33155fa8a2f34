#include "example_parts.h"

#include <BRepAdaptor_Curve.hxx>
#include <BRepAlgoAPI_Cut.hxx>
#include <BRepAlgoAPI_Fuse.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <BRepFilletAPI_MakeFillet.hxx>
#include <BRepOffsetAPI_MakePipe.hxx>
#include <BRepOffsetAPI_ThruSections.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <BRepPrimAPI_MakeRevol.hxx>
#include <GC_MakeArcOfCircle.hxx>
#include <GeomAPI_Interpolate.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_TrimmedCurve.hxx>
#include <ShapeUpgrade_UnifySameDomain.hxx>
#include <TColgp_HArray1OfPnt.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Wire.hxx>
#include <gp.hxx>
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

/// A point of a half section through something round [mm].
struct ProfilePoint {
    double radius;
    double height;
};

gp_Pnt placeOf(const ProfilePoint& point)
{
    return {point.radius, 0, point.height};
}

TopoDS_Edge line(const ProfilePoint& from, const ProfilePoint& to)
{
    return BRepBuilderAPI_MakeEdge(placeOf(from), placeOf(to)).Edge();
}

TopoDS_Edge smoothCurve(const std::vector<ProfilePoint>& points)
{
    Handle(TColgp_HArray1OfPnt) places = new TColgp_HArray1OfPnt(1, static_cast<int>(points.size()));
    for (std::size_t i = 0; i < points.size(); ++i)
        places->SetValue(static_cast<int>(i) + 1, placeOf(points[i]));
    GeomAPI_Interpolate through(places, false, 1e-6);
    through.Perform();
    return BRepBuilderAPI_MakeEdge(through.Curve()).Edge();
}

/// Something round about z with an opening at the top: both curves run from the axis upwards, and the rim between
/// them is a half circle.
TopoDS_Shape vessel(const std::vector<ProfilePoint>& outside, const std::vector<ProfilePoint>& inside)
{
    const ProfilePoint& out = outside.back();
    const ProfilePoint& in = inside.back();
    const double half = 0.5 * std::hypot(out.radius - in.radius, out.height - in.height);
    const ProfilePoint top{0.5 * (out.radius + in.radius), 0.5 * (out.height + in.height) + half};
    const GC_MakeArcOfCircle rim(placeOf(out), placeOf(top), placeOf(in));
    BRepBuilderAPI_MakeWire wire;
    const std::vector<ProfilePoint> wall(outside.begin() + 1, outside.end()); // the foot is flat
    const std::vector<ProfilePoint> well(inside.begin() + 1, inside.end());
    wire.Add(line(outside.front(), wall.front()));
    wire.Add(smoothCurve(wall));
    wire.Add(BRepBuilderAPI_MakeEdge(rim.Value()).Edge());
    wire.Add(smoothCurve(well));
    wire.Add(line(well.front(), inside.front()));
    wire.Add(line(inside.front(), outside.front()));
    const gp_Ax1 axis(gp_Pnt(0, 0, 0), gp_Dir(0, 0, 1));
    return BRepPrimAPI_MakeRevol(BRepBuilderAPI_MakeFace(wire.Wire()).Face(), axis).Shape();
}

/// All edges.
TopoDS_Shape roundedAllAround(const TopoDS_Shape& shape, double radius)
{
    return rounded(shape, radius, [](const gp_Pnt& /*middle*/, const gp_Dir& /*d*/) { return true; });
}

/// A star upright about z, with a ray along y.
TopoDS_Shape star(double outer, double inner, double foot, double height)
{
    BRepBuilderAPI_MakePolygon outline;
    for (int i = 0; i < 10; ++i) {
        const double radius = i % 2 == 0 ? outer : inner;
        const double angle = M_PI / 2 + i * M_PI / 5;
        outline.Add(gp_Pnt(radius * std::cos(angle), radius * std::sin(angle), foot));
    }
    outline.Close();
    const TopoDS_Face face = BRepBuilderAPI_MakeFace(outline.Wire()).Face();
    return BRepPrimAPI_MakePrism(face, gp_Vec(0, 0, height)).Shape();
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

std::vector<ExampleBody> makeTube()
{
    constexpr double length = 200;
    const gp_Pnt foot(0, 0, 0);
    const TopoDS_Shape outside = cylinder(foot, gp::DX(), 10, length);
    return {{"Tube", BRepAlgoAPI_Cut(outside, cylinder(foot, gp::DX(), 8, length)).Shape(), 0.62, 0.65, 0.7}};
}

std::vector<ExampleBody> makeCantilever()
{
    constexpr double thickness = 10;
    TopoDS_Shape arm = box(0, 0, 0, 120, 20, thickness);
    for (const double along : {7.0, 18.0})
        arm = BRepAlgoAPI_Cut(arm, cylinder(gp_Pnt(along, 10, 0), gp_Dir(0, 0, 1), 3, thickness)).Shape();
    return {{"Arm", arm, 0.31, 0.53, 0.73}};
}

std::vector<ExampleBody> makePrintedBracket()
{
    constexpr double wall = 4;
    constexpr double width = 30; // along y
    const gp_Dir y(0, 1, 0);
    TopoDS_Shape body = unified(BRepAlgoAPI_Fuse(box(0, 0, 0, 60, width, wall), box(0, 0, 0, wall, width, 40)).Shape());
    body = rounded(body, 4, [&](const gp_Pnt& p, const gp_Dir& d) { // the inner corner
        return isParallel(d, y) && isNear(p.X(), wall) && isNear(p.Z(), wall);
    });
    body = BRepAlgoAPI_Cut(body, cylinder({42, width / 2, -1}, gp_Dir(0, 0, 1), 5, wall + 2)).Shape();
    body = BRepAlgoAPI_Cut(body, cylinder({-1, width / 2, 26}, gp_Dir(1, 0, 0), 4, wall + 2)).Shape();
    return {{"Bracket", body, 0.84, 0.55, 0.24}};
}

std::vector<ExampleBody> makeBowl()
{
    const TopoDS_Shape bowl = vessel({{0, 0}, {20, 0}, {33, 7}, {43, 20}, {48, 38}},
                                     {{0, 4}, {18, 4}, {30.5, 9.5}, {39.8, 21.3}, {44.5, 38}});
    return {{"Bowl", bowl, 0.54, 0.60, 0.36}};
}

std::vector<ExampleBody> makeVase()
{
    const TopoDS_Shape vase = vessel({{0, 0}, {20, 0}, {29, 18}, {32, 40}, {25, 68}, {18, 88}, {22, 107}},
                                     {{0, 6}, {16, 6}, {24, 19}, {27, 40}, {20.2, 66.5}, {13, 88}, {17, 107}});
    return {{"Vase", vase, 0.71, 0.40, 0.25}};
}

std::vector<ExampleBody> makeJug()
{
    const TopoDS_Shape cup = vessel({{0, 0}, {24, 0}, {32, 16}, {33, 36}, {28, 58}, {29, 78}},
                                    {{0, 5}, {21, 5}, {27.5, 17}, {28.5, 36}, {23.5, 58}, {24.5, 78}});
    // The handle is drawn along an arc from the shoulder to the belly, into the wall.
    const GC_MakeArcOfCircle way(gp_Pnt(-26.5, 0, 64), gp_Pnt(-52, 0, 44), gp_Pnt(-30.5, 0, 22));
    const TopoDS_Wire spine = BRepBuilderAPI_MakeWire(BRepBuilderAPI_MakeEdge(way.Value()).Edge()).Wire();
    gp_Pnt start;
    gp_Vec along;
    way.Value()->D1(way.Value()->FirstParameter(), start, along);
    const gp_Elips section(gp_Ax2(start, along, gp_Dir(0, 1, 0)), 6, 4.5);
    const TopoDS_Face face =
        BRepBuilderAPI_MakeFace(BRepBuilderAPI_MakeWire(BRepBuilderAPI_MakeEdge(section).Edge()).Wire()).Face();
    const TopoDS_Shape handle = BRepOffsetAPI_MakePipe(spine, face).Shape();
    return {{"Jug", BRepAlgoAPI_Fuse(cup, handle).Shape(), 0.71, 0.40, 0.25}};
}

std::vector<ExampleBody> makeCushion()
{
    return {{"Cushion", roundedAllAround(box(0, 0, 0, 90, 90, 26), 12), 0.56, 0.83, 0.82}};
}

std::vector<ExampleBody> makeRod()
{
    TopoDS_Shape rod = box(20, -7, -7, 140, 7, 7);
    for (const double end : {0.0, 140.0})
        rod = BRepAlgoAPI_Fuse(rod, roundedRims(cylinder({end, 0, 0}, gp_Dir(1, 0, 0), 10, 20), 2)).Shape();
    return {{"Rod", rod, 0.91, 0.53, 0.23}};
}

std::vector<ExampleBody> makeCake()
{
    return {{"Cake", roundedRims(cylinder({0, 0, 0}, gp_Dir(0, 0, 1), 32, 14), 4), 0.29, 0.47, 0.78}};
}

std::vector<ExampleBody> makeStamp()
{
    const TopoDS_Shape disk = cylinder({0, 0, 8}, gp_Dir(0, 0, 1), 26, 8);
    return {{"Stamp", BRepAlgoAPI_Fuse(disk, star(22, 10, 0, 8)).Shape(), 0.42, 0.64, 0.56}};
}
