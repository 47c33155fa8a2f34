#include "io/document/cad_part.h"

#include "core/geometry/mass_properties.h"
#include "core/message/message.h"
#include "core/model/number_words.h"
#include "io/brep/face_integral.h"
#include "io/brep/free_edges.h"
#include "io/brep/millimeter.h"
#include "io/brep/shape_box.h"
#include "io/brep/shape_measure.h"
#include "io/brep/solid_measure.h"
#include "io/brep/tessellation.h"
#include "io/document/size_limits.h"
#include "io/mesh/open_borders.h"

#include <BRepCheck_Analyzer.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Edge.hxx>

#include <algorithm>
#include <cmath>
#include <set>
#include <unordered_map>
#include <utility>

namespace knead {

namespace {

double maxToleranceOf(const TopoDS_Shape& shape)
{
    double tolerance = 0;
    for (const TopAbs_ShapeEnum kind : {TopAbs_FACE, TopAbs_EDGE, TopAbs_VERTEX})
        tolerance = std::max(tolerance, BRep_Tool::MaxTolerance(shape, kind));
    return millimeter * tolerance;
}

/// The shell that a face of the file belongs to may have a color of its own.
std::unordered_map<const void*, Color> colorsOfShells(const TopoDS_Shape& original, const ShapeColors& colors)
{
    std::unordered_map<const void*, Color> result;
    for (TopExp_Explorer shells(original, TopAbs_SHELL); shells.More(); shells.Next())
        if (const auto color = colors.find(shells.Current()))
            for (TopExp_Explorer faces(shells.Current(), TopAbs_FACE); faces.More(); faces.Next())
                result.emplace(faces.Current().TShape().get(), *color);
    return result;
}

/// Their colors and names.
void addFaces(const CadBody& body, const CadNode& leaf, const CadDocument& notes, Part& part)
{
    part.color = notes.colors.find(body.original);
    if (!part.color)
        part.color = leaf.color;
    const auto ofShells = colorsOfShells(body.original, notes.colors);
    TopTools_IndexedMapOfShape faces;
    TopExp::MapShapes(body.shape, TopAbs_FACE, faces);
    for (int i = 1; i <= faces.Extent(); ++i) {
        const TopoDS_Shape face = body.originOf(faces(i));
        std::optional<Color> color = notes.colors.find(face);
        if (const auto found = ofShells.find(face.TShape().get()); !color && found != ofShells.end())
            color = found->second;
        part.faces.push_back({color, notes.names.find(face).value_or(std::string())});
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
void addSolid(const TopoDS_Shape& body, double volume, const ImportOptions& options, Part& part)
{
    SolidMeasure measure = measureSolid(body, volume, part.box.diagonal().norm(), options);
    part.volume = std::abs(measure.volume);
    part.watertight = measure.isWatertight;
    part.mesh = std::move(measure.mesh);
    part.insideOut = measure.volume < 0;
    if (part.insideOut) {
        if (options.heal)
            part.repairs.push_back(Message("Import", "The solid was inside out and has been turned."));
        else
            part.warnings.push_back(Message("Import", "was inside out and has been turned."));
        for (TriangleMesh::Triangle& triangle : part.mesh.triangles)
            std::swap(triangle[1], triangle[2]);
    }
    if (options.linearDeflection == 0 && measure.disagreement > 1e-3 && measure.isWatertight && part.volume > 0)
        part.warnings.push_back(Message("Import", "has faces that do not meet well: its volume is uncertain by %1.")
                                    .with(percentWords(measure.disagreement)));
}

/// Faces that the modeler found no triangles for, where that leaves the mesh open.
std::size_t countBareFaces(const Part& part)
{
    if (part.watertight || isWatertight(part.mesh))
        return 0;
    const std::set<std::uint32_t> covered(part.mesh.faceOfTriangle.begin(), part.mesh.faceOfTriangle.end());
    return part.faces.size() - covered.size();
}

/// Whether objects can be filled in: the b-rep is closed, and so is its mesh.
void judge(Part& part, std::size_t freeEdges)
{
    const double diagonal = part.box.isEmpty() ? 0 : part.box.diagonal().norm();
    if (freeEdges > 0) {
        const Message borders = describeBorders(freeEdges, part.openEdges);
        part.warnings.push_back(
            part.solids == 0
                ? Message("Import", "is an open surface: %1. It is shown and cannot be filled.").with(borders)
                : Message("Import", "is not closed: %1. It is shown and cannot be filled.").with(borders));
    } else if (part.solids == 0) {
        part.warnings.push_back(
            Message("Import", "is a closed surface but no solid; it is shown and cannot be filled."));
    } else if (!part.watertight) {
        part.warnings.push_back(
            Message("Import", "could not be covered with a closed net of triangles; it cannot be filled."));
    }
    if (!part.valid)
        part.warnings.push_back(
            Message("Import", "does not pass the geometry checks; look at it closely before you trust it."));
    if (part.maxTolerance > 0.01 * diagonal)
        part.warnings.push_back(Message("Import", "has gaps of up to %1, a hundredth of its size or more.")
                                    .with(lengthWords(part.maxTolerance)));
}

} // namespace

std::vector<CadBody> splitIntoBodies(const TopoDS_Shape& shape)
{
    std::vector<CadBody> bodies;
    TopTools_IndexedMapOfShape solids;
    TopExp::MapShapes(shape, TopAbs_SOLID, solids);
    for (int solid = 1; solid <= solids.Extent(); ++solid)
        if (countDistinct(solids(solid), TopAbs_FACE) > 0)
            bodies.push_back({solids(solid), solids(solid), {}, {}, {}});

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
        bodies.push_back({loose, loose, {}, {}, {}});
    return bodies;
}

Part makePart(const CadBody& body, const CadNode& leaf, const CadDocument& notes, const ImportOptions& options,
              TaskControl& control)
{
    control.report(0, "measuring parts");
    const TopoDS_Shape& shape = body.shape;
    Part part;
    part.solids = countDistinct(shape, TopAbs_SOLID);
    part.shells = countDistinct(shape, TopAbs_SHELL);
    part.edges = countDistinct(shape, TopAbs_EDGE);
    part.maxTolerance = maxToleranceOf(shape);
    part.valid = body.isValid ? *body.isValid : BRepCheck_Analyzer(shape, true, true).IsValid();
    part.repairs = body.repairs;
    part.box = boxOfFaces(shape);
    const FaceIntegrals integrals = body.measured();
    part.area = std::pow(millimeter, 2) * integrals.area;
    addFaces(body, leaf, notes, part);
    simplifyColors(part);

    const int freeEdges = freeEdgesOf(shape).Extent();
    control.throwIfCancelled();
    control.report(0.3, "making triangles");
    if (isWithinReach(part.box)) {
        const Tessellation start = tessellationFor(part.box.diagonal().norm(), options);
        if (part.solids > 0 && freeEdges == 0)
            addSolid(shape, std::pow(millimeter, 3) * integrals.volume, options, part);
        else
            part.mesh = tessellate(shape, start);
        const std::size_t bareFaces = countBareFaces(part);
        if (bareFaces > 0)
            part.warnings.push_back(
                bareFaces == 1
                    ? Message("Import", "has 1 face that no triangles could be found for; it is not shown there.")
                    : Message("Import", "has %1 faces that no triangles could be found for; it is not shown there.")
                          .with(bareFaces));
        if (!part.mesh.empty() && bareFaces == 0)
            part.box = tightened(part.box, massProperties(part.mesh).box, start.deflection);
        part.openEdges = freeBordersOf(shape);
    }
    judge(part, static_cast<std::size_t>(freeEdges));
    return part;
}

} // namespace knead
