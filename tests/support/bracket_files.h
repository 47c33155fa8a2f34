#pragma once

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepAlgoAPI_Fuse.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <STEPControl_Writer.hxx>
#include <ShapeUpgrade_UnifySameDomain.hxx>
#include <gp_Ax2.hxx>
#include <gp_Trsf.hxx>

#include <stdexcept>
#include <string>

/// Revisions of a bracket as CAD files.
namespace bracket_files {

/// Lengths in mm: a foot along x with two holes, and a wall at its beginning with one.
struct Bracket {
    double foot = 50;
    double footHole = 2.5;   ///< radius
    double wallHole = 4;     ///< radius
    bool isMirrored = false; ///< in the plane y = 0
    double scale = 1;
};

inline TopoDS_Shape hole(const gp_Pnt& from, const gp_Dir& along, double radius)
{
    return BRepPrimAPI_MakeCylinder(gp_Ax2(from, along), radius, 30).Shape();
}

inline TopoDS_Shape shapeOf(const Bracket& bracket)
{
    const TopoDS_Shape foot = BRepPrimAPI_MakeBox(gp_Pnt(0, 0, 0), gp_Pnt(bracket.foot, 24, 8)).Shape();
    const TopoDS_Shape wall = BRepPrimAPI_MakeBox(gp_Pnt(0, 0, 0), gp_Pnt(8, 24, 30)).Shape();
    TopoDS_Shape shape = BRepAlgoAPI_Fuse(foot, wall).Shape();
    const gp_Dir up(0, 0, 1);
    shape = BRepAlgoAPI_Cut(shape, hole({bracket.foot - 6, 6, -5}, up, bracket.footHole)).Shape();
    shape = BRepAlgoAPI_Cut(shape, hole({bracket.foot - 6, 18, -5}, up, bracket.footHole)).Shape();
    shape = BRepAlgoAPI_Cut(shape, hole({-5, 14, 21}, gp_Dir(1, 0, 0), bracket.wallHole)).Shape();
    ShapeUpgrade_UnifySameDomain unify(shape);
    unify.Build();
    gp_Trsf change;
    if (bracket.isMirrored)
        change.SetMirror(gp_Ax2(gp_Pnt(0, 0, 0), gp_Dir(0, 1, 0)));
    gp_Trsf larger;
    larger.SetScale(gp_Pnt(0, 0, 0), bracket.scale);
    return BRepBuilderAPI_Transform(unify.Shape(), larger * change, true).Shape();
}

inline std::string writeBracket(const std::string& path, const Bracket& bracket)
{
    STEPControl_Writer writer;
    writer.Transfer(shapeOf(bracket), STEPControl_AsIs);
    if (writer.Write(path.c_str()) != IFSelect_RetDone)
        throw std::runtime_error("The bracket cannot be written.");
    return path;
}

} // namespace bracket_files
