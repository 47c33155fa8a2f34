#include "io/export/export_check.h"

#include "io/exact_shapes.h"
#include "io/export/deviation.h"
#include "io/export/place_words.h"
#include "io/export/smooth_edges.h"
#include "io/free_edges.h"
#include "io/morph/millimetre_map.h"
#include "io/shape_measure.h"

#include <algorithm>
#include <cmath>

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
    for (std::size_t i = 0; i < std::min(written.faceColors.size(), back.faces.size()); ++i)
        if (!isClose(colorOf(written.faceColors[i], written.color), colorOf(back.faces[i].color, back.color)))
            return false;
    return !written.faceColors.empty() || isClose(written.color, back.color);
}

/// The solids of a part may come back as several parts: then these are added up.
void compare(ReadyPart& written, const std::vector<const Part*>& backs, const TopoDS_Shape& shape)
{
    PartExportReport& report = written.report;
    report.valid = report.closed = report.nameKept = report.colorsKept = !backs.empty();
    for (const Part* back : backs) {
        report.solidsAfter += back->solids;
        report.facesAfter += static_cast<int>(back->faces.size());
        report.edgesAfter += back->edges;
        report.volume += back->volume;
        report.valid = report.valid && back->valid;
        report.closed = report.closed && back->watertight;
        report.freeEdges += back->openEdges.size();
        report.maxTolerance = std::max(report.maxTolerance, back->maxTolerance);
        report.nameKept = report.nameKept && back->name.starts_with(written.out.name);
        report.colorsKept = report.colorsKept && (backs.size() > 1 || keepsColors(written.out, *back));
    }
    if (report.form == PartExportReport::Form::faceted)
        measureFlatDeviation(written.skin, backs, report);
    if (written.source.IsNull() || backs.size() != 1)
        return;
    measureDeviation(written, shape, report);
    const SmoothEdges edges =
        compareSmoothEdges(written.source, shape, MillimetreMap(*written.map), 1e3 * report.tolerance);
    report.smoothEdges = edges.count;
    report.largestKink = edges.largestAngle;
    if (edges.largestAngle > largestKinkOfSoundParts)
        report.remarks.push_back("faces that met smoothly now meet at an angle near " + placeWords(1e-3 * edges.where) +
                                 "; a smaller tolerance may help.");
}

} // namespace

std::vector<std::string> checkWritten(std::vector<ReadyPart>& written, const Model& model, TaskControl& control)
{
    std::vector<std::string> warnings = model.missing;
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
        TopoDS_Shape shape;
        for (; backs.size() < wanted && next < model.parts.size(); ++next) {
            const Part& part = model.parts[next];
            backs.push_back(&part);
            if (part.exact)
                shape = shapes[part.exact->number];
        }
        compare(written[i], backs, shape);
    }
    if (next != model.parts.size())
        warnings.push_back("The file holds " + std::to_string(model.parts.size()) + " parts where " +
                           std::to_string(next) + " were written.");
    return warnings;
}

} // namespace knead
