#pragma once

#include <BRepAdaptor_Curve.hxx>
#include <BRepAlgoAPI_Common.hxx>
#include <BRepAlgoAPI_Cut.hxx>
#include <BRepAlgoAPI_Fuse.hxx>
#include <BRepBuilderAPI_GTransform.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepBuilderAPI_MakeSolid.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepBuilderAPI_NurbsConvert.hxx>
#include <BRepBuilderAPI_Sewing.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <BRepFilletAPI_MakeChamfer.hxx>
#include <BRepFilletAPI_MakeFillet.hxx>
#include <BRepLib.hxx>
#include <BRepOffsetAPI_MakePipe.hxx>
#include <BRepOffsetAPI_MakeThickSolid.hxx>
#include <BRepOffsetAPI_ThruSections.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <BRepPrimAPI_MakeRevol.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <GCE2d_MakeSegment.hxx>
#include <GeomAPI_PointsToBSpline.hxx>
#include <GeomAPI_PointsToBSplineSurface.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_ConicalSurface.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <TColgp_Array1OfPnt.hxx>
#include <TColgp_Array2OfPnt.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_ListOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Shell.hxx>
#include <TopoDS_Wire.hxx>
#include <gp_Ax2.hxx>
#include <gp_Circ.hxx>
#include <gp_GTrsf.hxx>

#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

/// Solids that CAD programs write and libraries stumble over, made by rule [mm]: every kind of surface at many ranges of its
/// parameters, seams and poles in odd places, thin shells, springs, lofts, fillets that vary, images in mirrors.
namespace hard_shapes {

constexpr double pi = std::numbers::pi;

struct HardShape {
    std::string name;
    std::function<TopoDS_Shape()> make;
    double volume = 0; ///< where it is known in closed form [mm^3]; 0: not
};

inline gp_Ax2 axisAt(double x, double y, double z, const gp_Dir& along = gp_Dir(0, 0, 1))
{
    return {gp_Pnt(x, y, z), along};
}

inline TopoDS_Wire circle(double x, double y, double z, double radius)
{
    return BRepBuilderAPI_MakeWire(BRepBuilderAPI_MakeEdge(gp_Circ(axisAt(x, y, z), radius)));
}

inline TopoDS_Wire polygon(int sides, double radius, double z, double turn)
{
    BRepBuilderAPI_MakePolygon corners;
    for (int i = 0; i < sides; ++i)
        corners.Add(
            gp_Pnt(radius * std::cos(turn + 2 * pi * i / sides), radius * std::sin(turn + 2 * pi * i / sides), z));
    corners.Close();
    return corners.Wire();
}

inline TopoDS_Shape solidOf(const std::vector<TopoDS_Face>& faces)
{
    BRepBuilderAPI_Sewing sewing(1e-5);
    for (const TopoDS_Face& face : faces)
        sewing.Add(face);
    sewing.Perform();
    BRepBuilderAPI_MakeSolid solid;
    for (TopExp_Explorer shells(sewing.SewedShape(), TopAbs_SHELL); shells.More(); shells.Next())
        solid.Add(TopoDS::Shell(shells.Current()));
    return solid.Solid();
}

/// A cone once around from `begin`, closed by two disks, as countersinks and screws have it.
inline TopoDS_Shape frustum(double semiAngle, double begin, double low, double height)
{
    const Handle(Geom_ConicalSurface) cone = new Geom_ConicalSurface(gp_Ax3(axisAt(0, 0, 0)), semiAngle, low);
    const double high = low + height * std::tan(semiAngle);
    return solidOf({BRepBuilderAPI_MakeFace(cone, begin, begin + 2 * pi, 0, height / std::cos(semiAngle), 1e-7).Face(),
                    BRepBuilderAPI_MakeFace(circle(0, 0, 0, low), true).Face(),
                    BRepBuilderAPI_MakeFace(circle(0, 0, height, high), true).Face()});
}

inline double frustumVolume(double semiAngle, double low, double height)
{
    const double high = low + height * std::tan(semiAngle);
    return pi * height / 3 * (low * low + low * high + high * high);
}

/// A plate with a hole that is countersunk.
inline TopoDS_Shape sunkPlate(double semiAngle)
{
    const double depth = 2;
    const double radius = 2.2;
    const TopoDS_Shape plate = BRepPrimAPI_MakeBox(gp_Pnt(-10, -8, 0), gp_Pnt(10, 8, 4)).Shape();
    const TopoDS_Shape hole = BRepAlgoAPI_Cut(plate, BRepPrimAPI_MakeCylinder(axisAt(0, 0, -1), radius, 10).Shape());
    const TopoDS_Shape sink =
        BRepPrimAPI_MakeCone(axisAt(0, 0, 4 - depth), radius, radius + depth * std::tan(semiAngle), depth).Shape();
    return BRepAlgoAPI_Cut(hole, sink);
}

inline TopoDS_Shape spring(double pitch, double turns, double wire, double taper)
{
    const double radius = 10;
    const gp_Ax3 axes(axisAt(0, 0, 0));
    Handle(Geom_Surface) around;
    if (taper == 0)
        around = new Geom_CylindricalSurface(axes, radius);
    else
        around = new Geom_ConicalSurface(axes, taper, radius);
    const gp_Pnt2d begin(0, 0);
    const gp_Pnt2d end(2 * pi * turns, pitch * turns);
    TopoDS_Edge helix = BRepBuilderAPI_MakeEdge(GCE2d_MakeSegment(begin, end).Value(), around);
    BRepLib::BuildCurves3d(helix);
    const gp_Dir along(0, radius, pitch / (2 * pi));
    const TopoDS_Wire section =
        BRepBuilderAPI_MakeWire(BRepBuilderAPI_MakeEdge(gp_Circ(gp_Ax2(gp_Pnt(radius, 0, 0), along), wire)));
    return BRepOffsetAPI_MakePipe(BRepBuilderAPI_MakeWire(helix), BRepBuilderAPI_MakeFace(section).Face()).Shape();
}

/// A vase: a spline turned about an axis.
inline TopoDS_Shape vase(double angle)
{
    TColgp_Array1OfPnt points(1, 5);
    const std::array<std::pair<double, double>, 5> outline{{{6, 0}, {9, 6}, {4, 14}, {7, 20}, {5, 26}}};
    for (int i = 0; i < 5; ++i)
        points.SetValue(i + 1, gp_Pnt(outline.at(static_cast<std::size_t>(i)).first, 0,
                                      outline.at(static_cast<std::size_t>(i)).second));
    BRepBuilderAPI_MakeWire wire;
    wire.Add(BRepBuilderAPI_MakeEdge(GeomAPI_PointsToBSpline(points).Curve()));
    wire.Add(BRepBuilderAPI_MakeEdge(gp_Pnt(5, 0, 26), gp_Pnt(0, 0, 26)));
    wire.Add(BRepBuilderAPI_MakeEdge(gp_Pnt(0, 0, 26), gp_Pnt(0, 0, 0)));
    wire.Add(BRepBuilderAPI_MakeEdge(gp_Pnt(0, 0, 0), gp_Pnt(6, 0, 0)));
    const TopoDS_Face section = BRepBuilderAPI_MakeFace(wire.Wire());
    const gp_Ax1 axis(gp_Pnt(0, 0, 0), gp_Dir(0, 0, 1));
    return angle >= 2 * pi ? BRepPrimAPI_MakeRevol(section, axis).Shape()
                           : BRepPrimAPI_MakeRevol(section, axis, angle).Shape();
}

inline TopoDS_Shape loft(bool isRuled, int sides, double turn)
{
    BRepOffsetAPI_ThruSections sections(true, isRuled);
    sections.AddWire(polygon(sides, 8, 0, 0));
    sections.AddWire(polygon(sides, 5, 10, turn / 2));
    sections.AddWire(polygon(sides, 7, 22, turn));
    return sections.Shape();
}

/// A wavy sheet of one spline, made thick.
inline TopoDS_Shape wavySheet(double thickness)
{
    TColgp_Array2OfPnt points(1, 7, 1, 7);
    for (int i = 1; i <= 7; ++i)
        for (int j = 1; j <= 7; ++j)
            points.SetValue(i, j, gp_Pnt(6 * i, 5 * j, 3 * std::sin(0.9 * i) * std::cos(0.7 * j)));
    const Handle(Geom_BSplineSurface) surface = GeomAPI_PointsToBSplineSurface(points).Surface();
    const TopoDS_Face sheet = BRepBuilderAPI_MakeFace(surface, 1e-6);
    return BRepPrimAPI_MakePrism(sheet, gp_Vec(0, 0, thickness)).Shape();
}

inline TopoDS_Shape roundedBox(const gp_Pnt& low, const gp_Pnt& high, double radius)
{
    const TopoDS_Shape box = BRepPrimAPI_MakeBox(low, high).Shape();
    BRepFilletAPI_MakeFillet fillet(box);
    for (TopExp_Explorer edges(box, TopAbs_EDGE); edges.More(); edges.Next())
        fillet.Add(radius, TopoDS::Edge(edges.Current()));
    return fillet.Shape();
}

/// Open at one side.
inline TopoDS_Shape thinBox(double wall)
{
    const TopoDS_Shape box = BRepPrimAPI_MakeBox(30, 20, 12).Shape();
    TopTools_ListOfShape open;
    open.Append(TopExp_Explorer(box, TopAbs_FACE).Current());
    BRepOffsetAPI_MakeThickSolid thick;
    thick.MakeThickSolidByJoin(box, open, -wall, 1e-4);
    return thick.Shape();
}

/// Two rounded boxes in each other.
inline TopoDS_Shape hollowRoundedBox(double wall)
{
    return BRepAlgoAPI_Cut(roundedBox(gp_Pnt(0, 0, 0), gp_Pnt(30, 20, 12), 3),
                           roundedBox(gp_Pnt(wall, wall, wall), gp_Pnt(30 - wall, 20 - wall, 12 - wall), 3 - wall))
        .Shape();
}

inline TopoDS_Shape variableFillet(double from, double to)
{
    const TopoDS_Shape box = BRepPrimAPI_MakeBox(20, 16, 10).Shape();
    BRepFilletAPI_MakeFillet fillet(box);
    int count = 0;
    for (TopExp_Explorer edges(box, TopAbs_EDGE); edges.More() && count < 3; edges.Next(), ++count)
        fillet.Add(from, to, TopoDS::Edge(edges.Current()));
    return fillet.Shape();
}

inline TopoDS_Shape transformed(const TopoDS_Shape& shape, const gp_Trsf& transformation)
{
    return BRepBuilderAPI_Transform(shape, transformation, true).Shape();
}

inline TopoDS_Shape stretched(const TopoDS_Shape& shape, double x, double y, double z)
{
    gp_GTrsf transformation;
    transformation.SetValue(1, 1, x);
    transformation.SetValue(2, 2, y);
    transformation.SetValue(3, 3, z);
    return BRepBuilderAPI_GTransform(shape, transformation, true).Shape();
}

inline void addCones(std::vector<HardShape>& all)
{
    for (int degrees = 10; degrees <= 75; degrees += 5)
        for (const double begin : {-pi, 0.0, 1.0}) {
            const double angle = degrees * pi / 180;
            all.push_back({"cone of " + std::to_string(degrees) + " degrees from " + std::to_string(begin).substr(0, 4),
                           [=] { return frustum(angle, begin, 0.6, 0.4); }, frustumVolume(angle, 0.6, 0.4)});
        }
    for (int degrees = 30; degrees <= 60; degrees += 5)
        all.push_back({"hole countersunk by " + std::to_string(degrees) + " degrees",
                       [=] { return sunkPlate(degrees * pi / 180); }});
    all.push_back({"cone to its apex", [] { return BRepPrimAPI_MakeCone(7, 0, 11).Shape(); }, pi * 49 * 11 / 3});
    all.push_back({"slice of a cone", [] { return BRepPrimAPI_MakeCone(7, 2, 11, 2.0).Shape(); },
                   2.0 / 2 * 11 / 3 * (49 + 14 + 4)});
}

inline void addRound(std::vector<HardShape>& all)
{
    all.push_back({"ball", [] { return BRepPrimAPI_MakeSphere(7).Shape(); }, 4.0 / 3 * pi * 343});
    for (const double low : {-1.2, -0.3, 0.4})
        for (const double around : {1.0, pi, 2 * pi})
            all.push_back({"zone of a ball from " + std::to_string(low).substr(0, 4) + ", " +
                               std::to_string(around).substr(0, 3) + " around",
                           [=] { return BRepPrimAPI_MakeSphere(7, low, 1.4, around).Shape(); }});
    for (const double tube : {0.3, 2.0, 4.8})
        for (const double around : {0.7, 2 * pi})
            all.push_back({"ring of " + std::to_string(tube).substr(0, 3) + ", " + std::to_string(around).substr(0, 3),
                           [=] { return BRepPrimAPI_MakeTorus(5, tube, around).Shape(); },
                           pi * tube * tube * 5 * around});
    for (const double angle : {0.2, pi, 1.9 * pi, 2 * pi})
        all.push_back({"vase turned by " + std::to_string(angle).substr(0, 3), [=] { return vase(angle); }});
    for (const double tilt : {0.0, 0.4, 1.1})
        all.push_back(
            {"crossing holes at " + std::to_string(tilt).substr(0, 3), [=] {
                 const TopoDS_Shape body = BRepPrimAPI_MakeCylinder(axisAt(0, 0, 0), 6, 20).Shape();
                 const gp_Dir along(std::cos(tilt), 0, std::sin(tilt));
                 const gp_Pnt begin(-20 * std::cos(tilt), 0, 10 - 20 * std::sin(tilt));
                 return BRepAlgoAPI_Cut(body, BRepPrimAPI_MakeCylinder(gp_Ax2(begin, along), 3, 40).Shape()).Shape();
             }});
    all.push_back(
        {"ball without a corner",
         [] {
             return BRepAlgoAPI_Cut(BRepPrimAPI_MakeSphere(7).Shape(), BRepPrimAPI_MakeBox(20, 20, 20).Shape()).Shape();
         },
         4.0 / 3 * pi * 343 * 7 / 8});
    all.push_back({"lens",
                   [] {
                       return BRepAlgoAPI_Common(BRepPrimAPI_MakeSphere(gp_Pnt(0, 0, 6), 8).Shape(),
                                                 BRepPrimAPI_MakeSphere(gp_Pnt(0, 0, -6), 8).Shape())
                           .Shape();
                   },
                   2 * pi * 4 * (3 * 8 - 2) / 3});
    all.push_back({"ball on a bar", [] {
                       return BRepAlgoAPI_Fuse(BRepPrimAPI_MakeSphere(gp_Pnt(0, 0, 20), 5).Shape(),
                                               BRepPrimAPI_MakeCylinder(axisAt(0, 0, 0), 2, 20).Shape())
                           .Shape();
                   }});
}

inline void addFree(std::vector<HardShape>& all)
{
    for (const double turns : {0.6, 2.0, 5.0})
        all.push_back({"spring of " + std::to_string(turns).substr(0, 3) + " turns",
                       [=] { return spring(4, turns, 0.8, 0); }, pi * 0.64 * turns * std::hypot(2 * pi * 10, 4.0)});
    all.push_back({"tapered spring", [] { return spring(5, 3, 0.9, 0.2); }});
    for (const bool isRuled : {false, true})
        for (const int sides : {3, 6})
            all.push_back({std::string(isRuled ? "ruled" : "smooth") + " loft of " + std::to_string(sides) + " sides",
                           [=] { return loft(isRuled, sides, 0.5); }});
    for (const double thickness : {0.4, 5.0})
        all.push_back(
            {"wavy sheet of " + std::to_string(thickness).substr(0, 3), [=] { return wavySheet(thickness); }});
    for (const double wall : {0.3, 1.5}) {
        const std::string walls = "walls of " + std::to_string(wall).substr(0, 3);
        all.push_back({"box with " + walls, [=] { return thinBox(wall); }});
        all.push_back({"hollow rounded box with " + walls, [=] { return hollowRoundedBox(wall); }});
    }
    for (const double to : {0.3, 2.0, 4.0})
        all.push_back(
            {"fillet from 1.5 to " + std::to_string(to).substr(0, 3), [=] { return variableFillet(1.5, to); }});
    const auto block = [] { return variableFillet(1.5, 3); };
    all.push_back({"mirrored", [=] {
                       gp_Trsf mirror;
                       mirror.SetMirror(gp_Ax2(gp_Pnt(3, 1, 0), gp_Dir(1, 0.4, 0.2)));
                       return transformed(block(), mirror);
                   }});
    all.push_back({"a hundredth as large", [=] {
                       gp_Trsf scale;
                       scale.SetScaleFactor(0.01);
                       return transformed(block(), scale);
                   }});
    all.push_back({"a hundred times as large", [=] {
                       gp_Trsf scale;
                       scale.SetScaleFactor(100);
                       return transformed(block(), scale);
                   }});
    all.push_back({"egg", [] { return stretched(BRepPrimAPI_MakeSphere(7).Shape(), 1, 0.7, 1.6); },
                   4.0 / 3 * pi * 343 * 0.7 * 1.6});
    all.push_back({"oval tube",
                   [] {
                       const TopoDS_Shape tube = BRepAlgoAPI_Cut(BRepPrimAPI_MakeCylinder(6, 20).Shape(),
                                                                 BRepPrimAPI_MakeCylinder(5.5, 20).Shape());
                       return stretched(tube, 1, 0.5, 1);
                   },
                   pi * (36 - 5.5 * 5.5) * 20 * 0.5});
    all.push_back({"all splines", [=] { return BRepBuilderAPI_NurbsConvert(block(), true).Shape(); }});
    all.push_back({"ring of splines",
                   [] { return BRepBuilderAPI_NurbsConvert(BRepPrimAPI_MakeTorus(8, 3).Shape(), true).Shape(); },
                   2 * pi * pi * 8 * 9});
    all.push_back({"chamfered", [] {
                       const TopoDS_Shape bar = BRepPrimAPI_MakeCylinder(6, 14).Shape();
                       BRepFilletAPI_MakeChamfer chamfer(bar);
                       for (TopExp_Explorer edges(bar, TopAbs_EDGE); edges.More(); edges.Next())
                           if (BRepAdaptor_Curve(TopoDS::Edge(edges.Current())).GetType() == GeomAbs_Circle)
                               chamfer.Add(1.5, TopoDS::Edge(edges.Current()));
                       return chamfer.Shape();
                   }});
}

} // namespace hard_shapes
