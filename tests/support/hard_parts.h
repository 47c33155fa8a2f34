#pragma once

#include "support/hard_surfaces.h"

#include <BRepAdaptor_Surface.hxx>
#include <BRepOffsetAPI_DraftAngle.hxx>
#include <BRepOffsetAPI_MakePipeShell.hxx>
#include <BRepPrimAPI_MakeWedge.hxx>
#include <GC_MakeArcOfCircle.hxx>
#include <GC_MakeArcOfEllipse.hxx>
#include <GeomAPI_Interpolate.hxx>
#include <Geom_Parabola.hxx>
#include <Geom_ToroidalSurface.hxx>
#include <Geom_TrimmedCurve.hxx>
#include <TColgp_HArray1OfPnt.hxx>
#include <gp_Elips.hxx>
#include <gp_Parab.hxx>

/// Solids as designers draw them: sections pushed and turned, pipes, shells, drafts, holes by the dozen, and all of that far from the
/// origin and turned.
namespace hard_shapes {

inline std::string rounded(double number)
{
    std::string text = std::to_string(number);
    return text.substr(0, text.find('.') + 3);
}

inline TopoDS_Face faceOf(const TopoDS_Wire& wire)
{
    return BRepBuilderAPI_MakeFace(wire, true).Face();
}

inline TopoDS_Shape pushed(const TopoDS_Wire& wire, double height)
{
    return BRepPrimAPI_MakePrism(faceOf(wire), gp_Vec(0, 0, height)).Shape();
}

/// A cylinder once around from `begin`, closed by two disks.
inline TopoDS_Shape drum(double begin, double radius, double height)
{
    const Handle(Geom_CylindricalSurface) side = new Geom_CylindricalSurface(gp_Ax3(axisAt(0, 0, 0)), radius);
    return solidOf({BRepBuilderAPI_MakeFace(side, begin, begin + 2 * pi, 0, height, 1e-7).Face(),
                    BRepBuilderAPI_MakeFace(circle(0, 0, 0, radius), true).Face(),
                    BRepBuilderAPI_MakeFace(circle(0, 0, height, radius), true).Face()});
}

/// A whole torus of two faces that begin anywhere, each closed around the tube.
inline TopoDS_Shape ring(double around, double across, double radius, double tube)
{
    const Handle(Geom_ToroidalSurface) surface = new Geom_ToroidalSurface(gp_Ax3(axisAt(0, 0, 0)), radius, tube);
    return solidOf(
        {BRepBuilderAPI_MakeFace(surface, around, around + pi, across, across + 2 * pi, 1e-7).Face(),
         BRepBuilderAPI_MakeFace(surface, around + pi, around + 2 * pi, across, across + 2 * pi, 1e-7).Face()});
}

inline void addRanges(std::vector<HardShape>& all)
{
    for (const double begin : {-pi, 0.5, 4.0})
        all.push_back({"drum from " + rounded(begin), [=] { return drum(begin, 5, 8); }, pi * 25 * 8});
    for (const double angle : {0.05, 1.0, 3.0, 6.2})
        all.push_back({"slice of a drum of " + rounded(angle),
                       [=] { return BRepPrimAPI_MakeCylinder(5, 8, angle).Shape(); }, angle / 2 * 25 * 8});
    for (const double around : {-pi, 1.3})
        for (const double across : {-pi, 0.0, 0.9})
            all.push_back({"ring from " + rounded(around) + " and " + rounded(across),
                           [=] { return ring(around, across, 8, 2.5); }, 2 * pi * pi * 8 * 2.5 * 2.5});
    // Its flat ends must not lie in each other's way.
    for (const auto& [low, high] : {std::pair(-0.5, 1.1), std::pair(1.0, 1.9), std::pair(2.5, 4.1)})
        all.push_back({"zone of a ring from " + rounded(low),
                       [low = low, high = high] { return BRepPrimAPI_MakeTorus(8, 3, low, high).Shape(); }});
    for (const double length : {0.05, 1.0, 400.0})
        all.push_back(
            {"bar of " + rounded(length), [=] { return BRepPrimAPI_MakeBox(4, 6, length).Shape(); }, 24 * length});
    for (const double top : {0.0, 0.2, 9.0})
        all.push_back({"wedge to " + rounded(top), [=] { return BRepPrimAPI_MakeWedge(10, 6, 8, top).Shape(); },
                       (10 + top) / 2 * 6 * 8});
}

/// Two half circles and two lines.
inline TopoDS_Wire slot(double length, double radius)
{
    const gp_Pnt a(0, -radius, 0);
    const gp_Pnt b(length, -radius, 0);
    const gp_Pnt c(length, radius, 0);
    const gp_Pnt d(0, radius, 0);
    BRepBuilderAPI_MakeWire wire;
    wire.Add(BRepBuilderAPI_MakeEdge(a, b));
    wire.Add(BRepBuilderAPI_MakeEdge(GC_MakeArcOfCircle(b, gp_Pnt(length + radius, 0, 0), c).Value()));
    wire.Add(BRepBuilderAPI_MakeEdge(c, d));
    wire.Add(BRepBuilderAPI_MakeEdge(GC_MakeArcOfCircle(d, gp_Pnt(-radius, 0, 0), a).Value()));
    return wire.Wire();
}

inline TopoDS_Wire star(int teeth, double inner, double outer)
{
    BRepBuilderAPI_MakePolygon corners;
    for (int i = 0; i < 2 * teeth; ++i) {
        const double radius = i % 2 == 0 ? outer : inner;
        corners.Add(gp_Pnt(radius * std::cos(pi * i / teeth), radius * std::sin(pi * i / teeth), 0));
    }
    corners.Close();
    return corners.Wire();
}

/// One closed spline without a kink.
inline TopoDS_Wire blob(int lobes, double depth)
{
    constexpr int count = 60;
    const Handle(TColgp_HArray1OfPnt) points = new TColgp_HArray1OfPnt(1, count);
    for (int i = 0; i < count; ++i) {
        const double angle = 2 * pi * i / count;
        const double radius = 8 + depth * std::cos(lobes * angle);
        points->SetValue(i + 1, gp_Pnt(radius * std::cos(angle), radius * std::sin(angle), 0));
    }
    GeomAPI_Interpolate interpolation(points, true, 1e-6);
    interpolation.Perform();
    return BRepBuilderAPI_MakeWire(BRepBuilderAPI_MakeEdge(interpolation.Curve()));
}

inline TopoDS_Wire ellipse(double z, double major, double minor)
{
    return BRepBuilderAPI_MakeWire(BRepBuilderAPI_MakeEdge(gp_Elips(axisAt(0, 0, z), major, minor)));
}

/// An S of one spline in the plane of x and z.
inline TopoDS_Wire bendingPath(double depth)
{
    const Handle(TColgp_HArray1OfPnt) points = new TColgp_HArray1OfPnt(1, 5);
    for (int i = 0; i < 5; ++i)
        points->SetValue(i + 1, gp_Pnt(depth * std::sin(pi * i / 2), 0, 10.0 * i));
    GeomAPI_Interpolate interpolation(points, false, 1e-6);
    interpolation.Perform();
    return BRepBuilderAPI_MakeWire(BRepBuilderAPI_MakeEdge(interpolation.Curve()));
}

/// A pipe of two straight pieces and a bow between them.
inline TopoDS_Shape bentPipe(double bow, double radius)
{
    const double end = 10 + bow;
    BRepBuilderAPI_MakeWire path;
    path.Add(BRepBuilderAPI_MakeEdge(gp_Pnt(0, 0, 0), gp_Pnt(0, 0, 10)));
    path.Add(BRepBuilderAPI_MakeEdge(
        GC_MakeArcOfCircle(gp_Pnt(0, 0, 10), gp_Pnt(bow * (1 - std::cos(pi / 4)), 0, 10 + bow * std::sin(pi / 4)),
                           gp_Pnt(bow, 0, end))
            .Value()));
    path.Add(BRepBuilderAPI_MakeEdge(gp_Pnt(bow, 0, end), gp_Pnt(bow + 12, 0, end)));
    return BRepOffsetAPI_MakePipe(path.Wire(), faceOf(circle(0, 0, 0, radius))).Shape();
}

inline TopoDS_Shape between(const std::vector<TopoDS_Wire>& wires, bool isRuled)
{
    BRepOffsetAPI_ThruSections sections(true, isRuled);
    for (const TopoDS_Wire& wire : wires)
        sections.AddWire(wire);
    return sections.Shape();
}

/// An arc of a conic turned about the axis: the nose of something.
inline TopoDS_Shape turnedArc(const TopoDS_Edge& arc, const gp_Pnt& tip, const gp_Pnt& rim, const gp_Pnt& foot)
{
    BRepBuilderAPI_MakeWire wire;
    wire.Add(arc);
    wire.Add(BRepBuilderAPI_MakeEdge(rim, foot));
    wire.Add(BRepBuilderAPI_MakeEdge(foot, tip));
    return BRepPrimAPI_MakeRevol(faceOf(wire.Wire()), gp_Ax1(gp_Pnt(0, 0, 0), gp_Dir(0, 0, 1))).Shape();
}

inline void addSections(std::vector<HardShape>& all)
{
    for (const double length : {0.5, 20.0})
        all.push_back(
            {"slot of " + rounded(length), [=] { return pushed(slot(length, 3), 4); }, 4 * (6 * length + pi * 9)});
    for (const int teeth : {3, 24})
        all.push_back({"star of " + std::to_string(teeth), [=] { return pushed(star(teeth, 6, 8), 5); },
                       5 * teeth * 6 * 8 * std::sin(pi / teeth)});
    for (const int sides : {3, 60})
        all.push_back({"prism of " + std::to_string(sides) + " sides",
                       [=] { return pushed(polygon(sides, 7, 0, 0.1), 9); },
                       9 * sides / 2.0 * 49 * std::sin(2 * pi / sides)});
    for (const int lobes : {2, 5})
        all.push_back({"blob of " + std::to_string(lobes) + " lobes", [=] { return pushed(blob(lobes, 1.5), 6); },
                       6 * pi * (64 + 1.5 * 1.5 / 2)});
    all.push_back({"oval bar", [] { return pushed(ellipse(0, 9, 3), 12); }, pi * 27 * 12});
    for (const double depth : {1.0, 5.0})
        all.push_back({"pipe along an S of " + rounded(depth), [=] {
                           const TopoDS_Wire path = bendingPath(depth);
                           BRepAdaptor_Curve curve(TopoDS::Edge(TopExp_Explorer(path, TopAbs_EDGE).Current()));
                           gp_Pnt begin;
                           gp_Vec along;
                           curve.D1(curve.FirstParameter(), begin, along);
                           const TopoDS_Wire section = BRepBuilderAPI_MakeWire(
                               BRepBuilderAPI_MakeEdge(gp_Circ(gp_Ax2(begin, gp_Dir(along)), 2)));
                           return BRepOffsetAPI_MakePipe(path, faceOf(section)).Shape();
                       }});
    for (const double bow : {3.0, 12.0})
        all.push_back(
            {"pipe with a bow of " + rounded(bow), [=] { return bentPipe(bow, 2); }, pi * 4 * (22 + pi / 2 * bow)});
    all.push_back({"round to square", [] { return between({circle(0, 0, 0, 6), polygon(4, 6, 15, 0.3)}, false); }});
    for (const bool isRuled : {false, true})
        all.push_back(
            {std::string(isRuled ? "ruled" : "smooth") + " loft of ovals", [=] {
                 return between({ellipse(0, 8, 5), ellipse(8, 5, 4.9), ellipse(14, 9, 2), ellipse(24, 4, 3)}, isRuled);
             }});
    all.push_back({"twisted prism", [] {
                       std::vector<TopoDS_Wire> wires;
                       for (int i = 0; i <= 6; ++i)
                           wires.push_back(polygon(4, 6, 4.0 * i, 0.25 * i));
                       return between(wires, false);
                   }});
    all.push_back({"half an egg",
                   [] {
                       const gp_Elips outline(gp_Ax2(gp_Pnt(0, 0, 0), gp_Dir(0, 1, 0), gp_Dir(0, 0, 1)), 12, 7);
                       const gp_Pnt tip(0, 0, 12);
                       const gp_Pnt rim(7, 0, 0);
                       return turnedArc(BRepBuilderAPI_MakeEdge(outline, tip, rim), tip, rim, gp_Pnt(0, 0, 0));
                   },
                   2.0 / 3 * pi * 12 * 49});
    all.push_back({"dish",
                   [] {
                       const gp_Parab outline(gp_Ax2(gp_Pnt(0, 0, 0), gp_Dir(0, 1, 0), gp_Dir(0, 0, 1)), 2);
                       const gp_Pnt tip(0, 0, 0);
                       const gp_Pnt rim(8, 0, 8); // z = x^2 / 8
                       return turnedArc(BRepBuilderAPI_MakeEdge(outline, tip, rim), tip, rim, gp_Pnt(0, 0, 8));
                   },
                   pi * 64 * 8 / 2});
}

inline TopoDS_Shape cut(const TopoDS_Shape& from, const TopoDS_Shape& what)
{
    return BRepAlgoAPI_Cut(from, what).Shape();
}

/// Open at the top.
inline TopoDS_Shape thickened(const TopoDS_Shape& body, double wall)
{
    TopoDS_Shape top;
    double height = -1e9;
    for (TopExp_Explorer faces(body, TopAbs_FACE); faces.More(); faces.Next()) {
        const BRepAdaptor_Surface surface(TopoDS::Face(faces.Current()));
        if (surface.GetType() == GeomAbs_Plane && surface.Plane().Location().Z() > height &&
            std::abs(surface.Plane().Axis().Direction().Z()) > 0.9) {
            height = surface.Plane().Location().Z();
            top = faces.Current();
        }
    }
    TopTools_ListOfShape open;
    open.Append(top);
    BRepOffsetAPI_MakeThickSolid thick;
    thick.MakeThickSolidByJoin(body, open, -wall, 1e-4);
    return thick.Shape();
}

inline void addHollow(std::vector<HardShape>& all)
{
    for (const double wall : {0.1, 1.0}) {
        all.push_back({"ball with a void, walls of " + rounded(wall),
                       [=] { return cut(BRepPrimAPI_MakeSphere(9).Shape(), BRepPrimAPI_MakeSphere(9 - wall).Shape()); },
                       4.0 / 3 * pi * (729 - std::pow(9 - wall, 3))});
        all.push_back({"bowl with walls of " + rounded(wall),
                       [=] {
                           return cut(cut(BRepPrimAPI_MakeSphere(9).Shape(), BRepPrimAPI_MakeSphere(9 - wall).Shape()),
                                      BRepPrimAPI_MakeBox(gp_Pnt(-10, -10, 0), gp_Pnt(10, 10, 10)).Shape());
                       },
                       2.0 / 3 * pi * (729 - std::pow(9 - wall, 3))});
        all.push_back({"tube with walls of " + rounded(wall),
                       [=] {
                           return cut(BRepPrimAPI_MakeCylinder(7, 30).Shape(),
                                      BRepPrimAPI_MakeCylinder(axisAt(0, 0, -1), 7 - wall, 32).Shape());
                       },
                       pi * 30 * (49 - std::pow(7 - wall, 2))});
        all.push_back(
            {"hollow ring, walls of " + rounded(wall),
             [=] { return cut(BRepPrimAPI_MakeTorus(12, 4).Shape(), BRepPrimAPI_MakeTorus(12, 4 - wall).Shape()); },
             2 * pi * pi * 12 * (16 - std::pow(4 - wall, 2))});
        all.push_back({"cup with walls of " + rounded(wall),
                       [=] { return thickened(BRepPrimAPI_MakeCone(6, 8, 15).Shape(), wall); }});
        all.push_back({"tray with walls of " + rounded(wall), [=] { return thickened(pushed(slot(20, 6), 8), wall); }});
    }
}

inline TopoDS_Shape holedPlate(int across, double radius)
{
    TopoDS_Shape plate = BRepPrimAPI_MakeBox(10.0 * across, 10.0 * across, 3).Shape();
    TopoDS_Compound holes;
    const BRep_Builder builder;
    builder.MakeCompound(holes);
    for (int i = 0; i < across; ++i)
        for (int j = 0; j < across; ++j)
            builder.Add(holes, BRepPrimAPI_MakeCylinder(axisAt(5 + 10.0 * i, 5 + 10.0 * j, -1), radius, 5).Shape());
    return cut(plate, holes);
}

inline TopoDS_Shape filleted(const TopoDS_Shape& body, double radius)
{
    BRepFilletAPI_MakeFillet fillet(body);
    for (TopExp_Explorer edges(body, TopAbs_EDGE); edges.More(); edges.Next())
        if (BRepAdaptor_Curve(TopoDS::Edge(edges.Current())).GetType() == GeomAbs_Circle)
            fillet.Add(radius, TopoDS::Edge(edges.Current()));
    return fillet.Shape();
}

/// A box whose upright sides lean in.
inline TopoDS_Shape drafted(double angle)
{
    const TopoDS_Shape box = BRepPrimAPI_MakeBox(20, 14, 10).Shape();
    BRepOffsetAPI_DraftAngle draft(box);
    const gp_Pln ground(gp_Pnt(0, 0, 0), gp_Dir(0, 0, 1));
    for (TopExp_Explorer faces(box, TopAbs_FACE); faces.More(); faces.Next()) {
        const TopoDS_Face face = TopoDS::Face(faces.Current());
        if (std::abs(BRepAdaptor_Surface(face).Plane().Axis().Direction().Z()) < 0.5)
            draft.Add(face, gp_Dir(0, 0, 1), angle, ground);
    }
    draft.Build();
    return draft.Shape();
}

inline void addWorked(std::vector<HardShape>& all)
{
    for (const double radius : {0.05, 1.0, 4.9})
        all.push_back({"box rounded by " + rounded(radius),
                       [=] { return roundedBox(gp_Pnt(0, 0, 0), gp_Pnt(16, 12, 10), radius); }});
    for (const double radius : {0.1, 2.0})
        all.push_back({"drum rounded by " + rounded(radius),
                       [=] { return filleted(BRepPrimAPI_MakeCylinder(6, 10).Shape(), radius); }});
    for (const double radius : {0.3, 1.5})
        all.push_back({"frustum rounded by " + rounded(radius),
                       [=] { return filleted(BRepPrimAPI_MakeCone(8, 5, 10).Shape(), radius); }});
    for (const double angle : {0.03, 0.3})
        all.push_back({"box drafted by " + rounded(angle), [=] { return drafted(angle); }});
    for (const double radius : {0.5, 4.5})
        all.push_back({"plate of 25 holes of " + rounded(radius), [=] { return holedPlate(5, radius); },
                       7500 - 25 * pi * radius * radius * 3});
    all.push_back({"boss on a plate",
                   [] {
                       return BRepAlgoAPI_Fuse(BRepPrimAPI_MakeBox(gp_Pnt(-15, -10, 0), gp_Pnt(15, 10, 3)).Shape(),
                                               BRepPrimAPI_MakeCone(axisAt(4, 1, 3), 5, 4, 8).Shape())
                           .Shape();
                   },
                   1800 + pi * 8 / 3 * (25 + 20 + 16)});
    for (const double angle : {0.2, 1.2})
        all.push_back({"drum cut at " + rounded(angle), [=] {
                           const gp_Dir along(std::sin(angle), 0, std::cos(angle));
                           const TopoDS_Shape half =
                               BRepPrimAPI_MakeBox(gp_Ax2(gp_Pnt(0, 0, 8), along), 60, 60, 60).Shape();
                           return cut(BRepPrimAPI_MakeCylinder(6, 16).Shape(), half);
                       }});
    for (const double apart : {3.0, 7.5})
        all.push_back({"balls " + rounded(apart) + " apart", [=] {
                           return BRepAlgoAPI_Fuse(BRepPrimAPI_MakeSphere(5).Shape(),
                                                   BRepPrimAPI_MakeSphere(gp_Pnt(apart, 0, 1), 4).Shape())
                               .Shape();
                       }});
    all.push_back({"groove around a drum", [] {
                       return cut(BRepPrimAPI_MakeCylinder(8, 20).Shape(),
                                  BRepPrimAPI_MakeTorus(axisAt(0, 0, 10), 8, 2).Shape());
                   }});
    all.push_back({"hole through a ball",
                   [] {
                       return cut(BRepPrimAPI_MakeSphere(8).Shape(),
                                  BRepPrimAPI_MakeCylinder(axisAt(0, 0, -10), 3, 20).Shape());
                   },
                   4.0 / 3 * pi * std::pow(64 - 9, 1.5)});
    all.push_back({"hole through a ring", [] {
                       return cut(BRepPrimAPI_MakeTorus(12, 4).Shape(),
                                  BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(0, 0, 0), gp_Dir(1, 0, 0)), 1.5, 20).Shape());
                   }});
    all.push_back({"keyhole", [] {
                       const TopoDS_Shape hole =
                           BRepAlgoAPI_Fuse(BRepPrimAPI_MakeCylinder(axisAt(0, 0, -1), 3, 6).Shape(),
                                            BRepPrimAPI_MakeBox(gp_Pnt(-1, -7, -1), gp_Pnt(1, 0, 5)).Shape());
                       return cut(BRepPrimAPI_MakeBox(gp_Pnt(-8, -9, 0), gp_Pnt(8, 8, 4)).Shape(), hole);
                   }});
}

/// A spline from pole to pole, turned about the axis.
inline TopoDS_Shape turnedSpline()
{
    const std::array<std::pair<double, double>, 5> outline{{{0, 6}, {4, 4}, {5, 0}, {3.5, -4}, {0, -6}}};
    const Handle(TColgp_HArray1OfPnt) points = new TColgp_HArray1OfPnt(1, 5);
    for (int i = 0; i < 5; ++i)
        points->SetValue(i + 1, gp_Pnt(outline.at(static_cast<std::size_t>(i)).first, 0,
                                       outline.at(static_cast<std::size_t>(i)).second));
    GeomAPI_Interpolate interpolation(points, false, 1e-7);
    interpolation.Load(gp_Vec(1, 0, 0), gp_Vec(-1, 0, 0));
    interpolation.Perform();
    BRepBuilderAPI_MakeWire wire;
    wire.Add(BRepBuilderAPI_MakeEdge(interpolation.Curve()));
    wire.Add(BRepBuilderAPI_MakeEdge(gp_Pnt(0, 0, -6), gp_Pnt(0, 0, 6)));
    return BRepPrimAPI_MakeRevol(faceOf(wire.Wire()), gp_Ax1(gp_Pnt(0, 0, 0), gp_Dir(0, 0, 1))).Shape();
}

/// What is bored or necked across the seam and elsewhere: its face has one border, and is on the far side of it.
inline void addBored(std::vector<HardShape>& all)
{
    constexpr double hole = 1.5;
    const auto drill = [](double azimuth, double elevation) {
        const gp_Dir along(std::cos(azimuth) * std::cos(elevation), std::sin(azimuth) * std::cos(elevation),
                           std::sin(elevation));
        return BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(0, 0, 0), along), hole, 16).Shape();
    };
    const auto ball = [] { return BRepPrimAPI_MakeSphere(5).Shape(); };
    // A drum of that radius and the cap on it.
    const double height = std::sqrt(25 - hole * hole);
    const double plug = pi * hole * hole * height + pi * (5 - height) * (5 - height) * (10 + height) / 3;
    const double ballVolume = 4.0 / 3 * pi * 125;
    for (const double azimuth : {0.0, 0.5, pi, 4.5})
        for (const double elevation : {-0.9, 0.0, 1.2}) {
            const std::string where = " at " + rounded(azimuth) + ", " + rounded(elevation);
            all.push_back(
                {"bored ball" + where, [=] { return cut(ball(), drill(azimuth, elevation)); }, ballVolume - plug});
            all.push_back({"ball on a neck" + where,
                           [=] { return BRepAlgoAPI_Fuse(ball(), drill(azimuth, elevation)).Shape(); },
                           ballVolume + pi * hole * hole * 16 - plug});
        }
    for (const double azimuth : {0.0, 1.6}) {
        const std::string where = " at " + rounded(azimuth);
        all.push_back({"bored ball of splines" + where,
                       [=] { return cut(BRepBuilderAPI_NurbsConvert(ball(), true).Shape(), drill(azimuth, 0.4)); },
                       ballVolume - plug});
        all.push_back({"bored egg" + where, [=] { return cut(stretched(ball(), 1, 1, 1.3), drill(azimuth, 0.4)); }});
        all.push_back({"bored turned spline" + where, [=] { return cut(turnedSpline(), drill(azimuth, 0.4)); }});
        all.push_back(
            {"bored ring" + where, [=] { return cut(BRepPrimAPI_MakeTorus(6, 3).Shape(), drill(azimuth, 0.3)); }});
        all.push_back({"bored cone" + where, [=] {
                           return cut(BRepPrimAPI_MakeCone(axisAt(0, 0, -5), 6, 0, 14).Shape(), drill(azimuth, 0.3));
                       }});
    }
}

/// Turned by no round angle, and a long way off.
inline void addPlaced(std::vector<HardShape>& all)
{
    const auto placed = [](const TopoDS_Shape& shape, double away) {
        gp_Trsf turn;
        turn.SetRotation(gp_Ax1(gp_Pnt(0, 0, 0), gp_Dir(0.3, 1, 0.5)), 0.83);
        gp_Trsf shift;
        shift.SetTranslation(gp_Vec(away, -0.7 * away, 0.2 * away));
        return transformed(shape, shift * turn);
    };
    using Make = std::function<TopoDS_Shape()>;
    const std::vector<std::pair<std::string, Make>> shapes{
        {"frustum", [] { return frustum(pi / 4, -pi, 0.6, 0.4); }},
        {"sunk plate", [] { return sunkPlate(pi / 4); }},
        {"vase", [] { return vase(2 * pi); }},
        {"spring", [] { return spring(4, 2, 0.8, 0); }},
        {"slot", [] { return pushed(slot(20, 3), 4); }},
        {"ring", [] { return ring(-pi, 0, 8, 2.5); }},
        {"wavy sheet", [] { return wavySheet(2); }},
        {"rounded box", [] { return roundedBox(gp_Pnt(0, 0, 0), gp_Pnt(16, 12, 10), 2); }},
        {"hollow box", [] { return hollowRoundedBox(1.5); }},
        {"pipe", [] { return bentPipe(6, 2); }},
        {"loft", [] { return loft(false, 6, 0.5); }},
        {"plate with holes", [] { return holedPlate(3, 2); }}};
    for (const auto& [name, make] : shapes)
        for (const double away : {30.0, 2e4})
            all.push_back({name + " " + rounded(away) + " away", [=, make = make] { return placed(make(), away); }});
    for (const auto& [name, make] : shapes)
        all.push_back({name + " in a mirror", [make = make] {
                           gp_Trsf mirror;
                           mirror.SetMirror(gp_Ax2(gp_Pnt(3, 1, 0), gp_Dir(1, 0.4, 0.2)));
                           return transformed(make(), mirror);
                       }});
}

} // namespace hard_shapes
