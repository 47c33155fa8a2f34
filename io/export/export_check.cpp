#include "io/export/export_check.h"

#include "core/message/message.h"
#include "core/model/face_names.h"
#include "io/brep/exact_shapes.h"
#include "io/brep/free_edges.h"
#include "io/brep/shape_measure.h"
#include "io/export/deviation.h"
#include "io/export/face_order.h"
#include "io/export/place_words.h"
#include "io/export/smooth_edges.h"
#include "io/morph/millimetre_map.h"

#include <BRepCheck_Analyzer.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedDataMapOfShapeListOfShape.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Edge.hxx>

#include <algorithm>
#include <cmath>
#include <set>

namespace knead {

namespace {

constexpr double closeColor = 0.01; // per channel

bool isClose(const std::optional<Color>& a, const std::optional<Color>& b)
{
    if (!a || !b)
        return !a && !b;
    return std::abs(a->r - b->r) < closeColor && std::abs(a->g - b->g) < closeColor &&
           std::abs(a->b - b->b) < closeColor;
}

bool keepsColors(const CadPartToWrite& written, const Part& back)
{
    const auto colorOf = [](const std::optional<Color>& own, const std::optional<Color>& whole) {
        return own ? own : whole;
    };
    for (std::size_t i = 0; i < std::min(written.faces.size(), back.faces.size()); ++i)
        if (!isClose(colorOf(written.faces[i].color, written.color), colorOf(back.faces[i].color, back.color)))
            return false;
    return !written.faces.empty() || isClose(written.color, back.color);
}

bool keepsNamesOfFaces(const CadPartToWrite& written, const Part& back)
{
    for (std::size_t i = 0; i < std::min(written.faces.size(), back.faces.size()); ++i)
        if (written.faces[i].name != back.faces[i].name)
            return false;
    return true;
}

TopoDS_Shape asOne(const std::vector<TopoDS_Shape>& shapes)
{
    if (shapes.size() == 1)
        return shapes.front();
    TopoDS_Compound all;
    const BRep_Builder builder;
    builder.MakeCompound(all);
    for (const TopoDS_Shape& shape : shapes)
        builder.Add(all, shape);
    return all;
}

/// Faces of the source that did not come back fit: far off, not valid, or beside a gap.
/// @param misses how far each is off [m]
std::vector<std::uint32_t> misfitsOf(const ReadyPart& written, const std::vector<double>& misses,
                                     const TopoDS_Shape& back)
{
    std::set<std::uint32_t> misfits;
    for (std::size_t i = 0; i < misses.size(); ++i)
        if (misses[i] > roughFaces * written.report.tolerance)
            misfits.insert(static_cast<std::uint32_t>(i));
    TopTools_IndexedMapOfShape faces;
    TopExp::MapShapes(back, TopAbs_FACE, faces);
    const std::size_t count = written.origin.empty() ? misses.size() : written.origin.size();
    if (static_cast<std::size_t>(faces.Extent()) != count)
        return {misfits.begin(), misfits.end()};
    const BRepCheck_Analyzer check(back);
    TopTools_IndexedDataMapOfShapeListOfShape facesOfEdges;
    TopExp::MapShapesAndAncestors(back, TopAbs_EDGE, TopAbs_FACE, facesOfEdges);
    const auto isAtGap = [&](const TopoDS_Shape& face) {
        for (TopExp_Explorer edges(face, TopAbs_EDGE); edges.More(); edges.Next())
            if (!BRep_Tool::Degenerated(TopoDS::Edge(edges.Current())) &&
                facesOfEdges.FindFromKey(edges.Current()).Extent() < 2)
                return true;
        return false;
    };
    for (int i = 1; i <= faces.Extent(); ++i) {
        const auto number = static_cast<std::size_t>(i) - 1;
        if (!check.IsValid(faces(i)) || (written.report.wasClosed && isAtGap(faces(i))))
            misfits.insert(written.origin.empty() ? static_cast<std::uint32_t>(number) : written.origin[number]);
    }
    return {misfits.begin(), misfits.end()};
}

/// Brings what was written into the order in which its faces came back.
void followOrder(ReadyPart& written, const TopoDS_Shape& back)
{
    const double near = 1e3 * std::max(written.report.tolerance, written.report.flatTolerance);
    const std::vector<std::uint32_t> order = orderReadBack(written.out.shape, back, near);
    if (std::ranges::is_sorted(order))
        return;
    std::vector<std::uint32_t> origin;
    std::vector<PartFace> faces;
    for (const std::uint32_t face : order) {
        origin.push_back(written.origin.empty() ? face : written.origin[face]);
        faces.push_back(face < written.out.faces.size() ? written.out.faces[face] : PartFace{});
    }
    written.origin = std::move(origin);
    if (!written.out.faces.empty())
        written.out.faces = std::move(faces);
}

/// The solids of a part may come back as several parts: then these are added up.
void compare(ReadyPart& written, const std::vector<const Part*>& backs, const TopoDS_Shape& shape)
{
    PartExportReport& report = written.report;
    if (report.form == PartExportReport::Form::exact && !shape.IsNull())
        followOrder(written, shape);
    report.valid = report.closed = report.nameKept = report.colorsKept = !backs.empty();
    for (const Part* back : backs) {
        report.solidsAfter += back->solids;
        report.facesAfter += static_cast<int>(back->faces.size());
        report.edgesAfter += back->edges;
        report.volume += back->volume;
        report.valid = report.valid && back->valid && !back->insideOut;
        written.cameBackInsideOut = written.cameBackInsideOut || back->insideOut;
        report.closed = report.closed && back->watertight;
        report.freeEdges += back->openEdges.size();
        report.maxTolerance = std::max(report.maxTolerance, back->maxTolerance);
        report.nameKept = report.nameKept && back->name.starts_with(written.out.name);
        report.colorsKept = report.colorsKept && (backs.size() > 1 || keepsColors(written.out, *back));
    }
    if (haveTellingNames(written.out.faces) && backs.size() == 1 && !keepsNamesOfFaces(written.out, *backs.front()))
        report.remarks.push_back(Message("Export", "not all names of its faces were found again."));
    if (written.cameBackInsideOut)
        report.remarks.push_back(Message("Export", "other programs may read it inside out, as it came back here."));
    if (report.form == PartExportReport::Form::faceted)
        measureFlatDeviation(written.skin, backs, report);
    if (written.source.IsNull() || backs.empty())
        return;
    const std::vector<double> misses = measureDeviation(written, shape, report);
    if (report.flatFaces > 0 && !measurePatches(written, backs, report)) {
        report.valid = false;
        report.remarks.push_back(Message("Export", "its faces were not found again as they were written."));
    }
    if (written.next && !report.isFit())
        written.misfits = misfitsOf(written, misses, shape);
    const SmoothEdges edges =
        compareSmoothEdges(written.source, shape, written.origin, MillimetreMap(*written.map), 1e3 * report.tolerance);
    report.smoothEdges = edges.count;
    report.largestKink = edges.largestAngle;
    if (edges.largestAngle > largestKinkOfSoundParts)
        report.remarks.push_back(
            Message("Export", "faces that met smoothly now meet at an angle near %1; a smaller tolerance may help.")
                .with(placeWords(1e-3 * edges.where)));
}

} // namespace

std::vector<Message> checkWritten(std::vector<ReadyPart>& written, const Model& model, TaskControl& control)
{
    std::vector<Message> warnings = model.missing;
    std::vector<TopoDS_Shape> shapes;
    if (!model.parts.empty() && model.parts.front().exact)
        shapes = shapesFromBytes(*model.parts.front().exact->bytes);
    std::size_t next = 0;
    for (std::size_t i = 0; i < written.size(); ++i) {
        control.throwIfCancelled();
        control.report(static_cast<double>(i) / static_cast<double>(written.size()), "comparing with the skin");
        // A part of several solids comes back as several, numbered.
        std::vector<const Part*> backs;
        const auto wanted = static_cast<std::size_t>(std::max(1, countDistinct(written[i].out.shape, TopAbs_SOLID)));
        std::vector<TopoDS_Shape> ofParts;
        for (; backs.size() < wanted && next < model.parts.size(); ++next) {
            const Part& part = model.parts[next];
            backs.push_back(&part);
            if (part.exact)
                ofParts.push_back(shapes[part.exact->number]);
        }
        compare(written[i], backs, asOne(ofParts));
    }
    if (next != model.parts.size())
        warnings.push_back(
            Message("Export", "The file holds %1 parts where %2 were written.").with(model.parts.size(), next));
    return warnings;
}

} // namespace knead
