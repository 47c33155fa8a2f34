#include "io/cad_part.h"

#include "core/geometry/mass_properties.h"
#include "io/shape_box.h"
#include "io/size_limits.h"
#include "io/solid_measure.h"
#include "io/tessellation.h"

#include <BRepCheck_Analyzer.hxx>
#include <BRepGProp.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <GProp_GProps.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Edge.hxx>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <utility>

namespace knead {

namespace {

constexpr double millimeter = 1e-3;
constexpr double leastVolumeShare = 1e-9; // of the cube of the diagonal; a solid with less is flat

std::string percent(double share)
{
    std::ostringstream text;
    text.precision(2);
    text << 100 * share << " %";
    return text.str();
}

int countDistinct(const TopoDS_Shape& shape, TopAbs_ShapeEnum kind)
{
    TopTools_IndexedMapOfShape found;
    TopExp::MapShapes(shape, kind, found);
    return found.Extent();
}

/// Edges that bound a face on one side only. On a closed surface faces run along each edge as often one way as the
/// other.
int countFreeEdges(const TopoDS_Shape& shape)
{
    TopTools_IndexedMapOfShape edges;
    TopExp::MapShapes(shape, TopAbs_EDGE, edges);
    std::vector<int> balance(static_cast<std::size_t>(edges.Extent()), 0);
    for (TopExp_Explorer faces(shape, TopAbs_FACE); faces.More(); faces.Next())
        for (TopExp_Explorer uses(faces.Current(), TopAbs_EDGE); uses.More(); uses.Next()) {
            const TopoDS_Edge& edge = TopoDS::Edge(uses.Current());
            if (BRep_Tool::Degenerated(edge))
                continue;
            const TopAbs_Orientation orientation = edge.Orientation();
            const int step = orientation == TopAbs_FORWARD ? 1 : orientation == TopAbs_REVERSED ? -1 : 0;
            balance[static_cast<std::size_t>(edges.FindIndex(edge)) - 1] += step;
        }
    return static_cast<int>(std::count_if(balance.begin(), balance.end(), [](int b) { return b != 0; }));
}

double maxToleranceOf(const TopoDS_Shape& shape)
{
    double tolerance = 0;
    for (const TopAbs_ShapeEnum kind : {TopAbs_FACE, TopAbs_EDGE, TopAbs_VERTEX})
        tolerance = std::max(tolerance, BRep_Tool::MaxTolerance(shape, kind));
    return millimeter * tolerance;
}

double areaOf(const TopoDS_Shape& shape)
{
    GProp_GProps properties;
    BRepGProp::SurfaceProperties(shape, properties);
    return std::abs(properties.Mass()) * std::pow(millimeter, 2);
}

void addColors(const TopoDS_Shape& body, const std::optional<Color>& defaultColor, const ShapeColors& colors,
               Part& part)
{
    part.color = colors.find(body);
    if (!part.color)
        part.color = defaultColor;
    TopTools_IndexedMapOfShape faces;
    TopExp::MapShapes(body, TopAbs_FACE, faces);
    for (int face = 1; face <= faces.Extent(); ++face)
        part.faces.push_back({colors.find(faces(face))});
    for (TopExp_Explorer shells(body, TopAbs_SHELL); shells.More(); shells.Next())
        if (const auto color = colors.find(shells.Current()))
            for (TopExp_Explorer uses(shells.Current(), TopAbs_FACE); uses.More(); uses.Next()) {
                PartFace& face = part.faces[static_cast<std::size_t>(faces.FindIndex(uses.Current())) - 1];
                if (!face.color)
                    face.color = color;
            }
}

/// A color that all faces have is the color of the part; faces keep only what differs.
void simplifyColors(Part& part)
{
    const auto sameAsFirst = [&](const PartFace& face) { return face.color == part.faces.front().color; };
    if (!part.faces.empty() && part.faces.front().color &&
        std::all_of(part.faces.begin(), part.faces.end(), sameAsFirst))
        part.color = part.faces.front().color;
    for (PartFace& face : part.faces)
        if (face.color == part.color)
            face.color.reset();
}

/// Measures and triangles of a closed solid, turned outward.
void addSolid(const TopoDS_Shape& body, const ImportOptions& options, Part& part)
{
    SolidMeasure measure = measureSolid(body, part.box.diagonal().norm(), options);
    part.volume = std::abs(measure.volume);
    part.mesh = std::move(measure.mesh);
    if (measure.volume < 0) {
        part.warnings.emplace_back("was inside out and has been turned.");
        for (TriangleMesh::Triangle& triangle : part.mesh.triangles)
            std::swap(triangle[1], triangle[2]);
    }
    if (options.linearDeflection == 0 && measure.disagreement > 1e-3 && isWatertight(part.mesh) && part.volume > 0)
        part.warnings.push_back("has faces that do not meet well: its volume is uncertain by " +
                                percent(measure.disagreement) + ".");
}

/// Whether objects can be filled in: the b-rep is closed, and so is its mesh.
void judge(Part& part, int freeEdges)
{
    const double diagonal = part.box.isEmpty() ? 0 : part.box.diagonal().norm();
    const std::string edges = std::to_string(freeEdges) + (freeEdges == 1 ? " free edge" : " free edges");
    if (part.solids == 0) {
        part.warnings.push_back(freeEdges == 0
                                    ? "is a closed surface but no solid; it is shown and cannot be filled."
                                    : "is a surface with " + edges + ", no solid; it is shown and cannot be filled.");
    } else if (freeEdges > 0) {
        part.warnings.push_back("is not closed: " + edges + "; it cannot be filled.");
    } else if (part.volume <= leastVolumeShare * std::pow(diagonal, 3)) {
        part.warnings.emplace_back("has no volume; it cannot be filled.");
    } else if (!isWatertight(part.mesh)) {
        part.warnings.emplace_back("could not be covered with a closed net of triangles; it cannot be filled.");
    } else {
        part.watertight = true;
    }
    if (!part.valid)
        part.warnings.emplace_back("does not pass the geometry checks; look at it closely before you trust it.");
    if (part.maxTolerance > 0.01 * diagonal)
        part.warnings.emplace_back("has gaps of up to a hundredth of its size or more.");
}

} // namespace

std::vector<TopoDS_Shape> splitIntoBodies(const TopoDS_Shape& shape)
{
    std::vector<TopoDS_Shape> bodies;
    TopTools_IndexedMapOfShape solids;
    TopExp::MapShapes(shape, TopAbs_SOLID, solids);
    for (int solid = 1; solid <= solids.Extent(); ++solid)
        if (countDistinct(solids(solid), TopAbs_FACE) > 0)
            bodies.push_back(solids(solid));

    TopoDS_Compound loose;
    const BRep_Builder builder;
    builder.MakeCompound(loose);
    bool found = false;
    const auto add = [&](TopAbs_ShapeEnum kind, TopAbs_ShapeEnum outside) {
        for (TopExp_Explorer shapes(shape, kind, outside); shapes.More(); shapes.Next()) {
            builder.Add(loose, shapes.Current());
            found = found || countDistinct(shapes.Current(), TopAbs_FACE) > 0;
        }
    };
    add(TopAbs_SHELL, TopAbs_SOLID);
    add(TopAbs_FACE, TopAbs_SHELL);
    if (found)
        bodies.push_back(loose);
    return bodies;
}

Part makePart(const TopoDS_Shape& body, const std::optional<Color>& defaultColor, const ShapeColors& colors,
              const ImportOptions& options)
{
    Part part;
    part.solids = countDistinct(body, TopAbs_SOLID);
    part.shells = countDistinct(body, TopAbs_SHELL);
    part.edges = countDistinct(body, TopAbs_EDGE);
    part.maxTolerance = maxToleranceOf(body);
    part.valid = BRepCheck_Analyzer(body).IsValid();
    part.box = boxOfFaces(body);
    part.area = areaOf(body);
    addColors(body, defaultColor, colors, part);
    simplifyColors(part);

    const int freeEdges = countFreeEdges(body);
    if (isWithinReach(part.box)) {
        const Tessellation start = tessellationFor(part.box.diagonal().norm(), options);
        if (part.solids > 0 && freeEdges == 0)
            addSolid(body, options, part);
        else
            part.mesh = tessellate(body, start);
        if (!part.mesh.empty())
            part.box = tightened(part.box, massProperties(part.mesh).box, start.deflection);
    }
    judge(part, freeEdges);
    return part;
}

} // namespace knead
