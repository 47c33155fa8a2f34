#include "io/export/export_check.h"

#include "io/exact_shapes.h"
#include "io/export/place_words.h"
#include "io/export/smooth_edges.h"
#include "io/free_edges.h"
#include "io/morph/millimetre_map.h"
#include "io/morph/trimmed_face.h"
#include "io/shape_measure.h"

#include <BRepTopAdaptor_FClass2d.hxx>
#include <BRep_Tool.hxx>
#include <GeomAPI_ProjectPointOnSurf.hxx>
#include <Standard_Failure.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <stdexcept>

namespace knead {

namespace {

constexpr int samplesPerSide = 6; // of a face's box of parameters
constexpr int checksPerEdge = 4;
constexpr double visibleKink = 0.5 * std::numbers::pi / 180; // in reflections [rad]
constexpr double closeColor = 0.01;                          // per channel

bool isClose(const std::optional<Color>& a, const std::optional<Color>& b)
{
    if (!a || !b)
        return !a && !b;
    return std::abs(a->r - b->r) < closeColor && std::abs(a->g - b->g) < closeColor &&
           std::abs(a->b - b->b) < closeColor;
}

/// Places of a face: inside, and on its border.
std::vector<Vec2> samplesOf(const TrimmedFace& face)
{
    const BRepTopAdaptor_FClass2d classifier(face.face(), 1e-9);
    std::vector<Vec2> samples = face.borderSamples(checksPerEdge);
    for (int i = 0; i < samplesPerSide; ++i)
        for (int j = 0; j < samplesPerSide; ++j) {
            const Vec2 share((i + 0.5) / samplesPerSide, (j + 0.5) / samplesPerSide);
            const Vec2 at = face.low() + share.cwiseProduct(face.high() - face.low());
            if (classifier.Perform(gp_Pnt2d(at[0], at[1]), true) == TopAbs_IN)
                samples.push_back(at);
        }
    return samples;
}

/// How far a place is from a surface: at the parameters it should have there, or wherever that is nearer.
double distanceTo(const Handle(Geom_Surface) & surface, const Vec2& parameters, const Vec3& place, double enough)
{
    const gp_Pnt point = toPoint(place);
    const double there = surface->Value(parameters[0], parameters[1]).Distance(point);
    if (there <= enough)
        return there;
    const GeomAPI_ProjectPointOnSurf projection(point, surface);
    return projection.NbPoints() > 0 ? std::min(there, projection.LowerDistance()) : there;
}

/// Measures how far the faces that were read back are from where the map takes those of the source.
class DeviationMeasure {
public:
    DeviationMeasure(const ReadyPart& written, const TopoDS_Shape& back)
        : m_written(written)
        , m_map(*written.map)
    {
        TopExp::MapShapes(written.source, TopAbs_FACE, m_sources);
        TopExp::MapShapes(back, TopAbs_FACE, m_backs);
    }

    void into(PartExportReport& report) const
    {
        if (m_sources.Extent() != m_backs.Extent())
            return; // nothing says which face is which
        double sum = 0;
        for (int i = 1; i <= m_sources.Extent(); ++i) {
            try {
                measure(i, report, sum);
            } catch (const std::runtime_error&) { // a face that could not be looked at: it was kept as it is
            } catch (const Standard_Failure&) {
            }
        }
        if (report.samples > 0)
            report.meanDeviation = sum / static_cast<double>(report.samples);
    }

private:
    void measure(int index, PartExportReport& report, double& sum) const
    {
        const TrimmedFace source(TopoDS::Face(m_sources(index).Oriented(TopAbs_FORWARD)));
        const Handle(Geom_Surface) back = BRep_Tool::Surface(TopoDS::Face(m_backs(index)));
        if (back.IsNull())
            return;
        const std::vector<Vec2> samples = samplesOf(source);
        std::vector<Vec3> points;
        for (const Vec2& at : samples)
            points.push_back(source.at(at));
        std::vector<Vec3> places(points.size());
        m_map.evaluate(points, places);
        for (std::size_t i = 0; i < samples.size(); ++i) {
            const double distance = 1e-3 * distanceTo(back, samples[i], places[i], 1e3 * report.tolerance);
            report.largestDeviation = std::max(report.largestDeviation, distance);
            sum += distance;
            ++report.samples;
        }
    }

    const ReadyPart& m_written;
    MillimetreMap m_map;
    TopTools_IndexedMapOfShape m_sources;
    TopTools_IndexedMapOfShape m_backs;
};

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
    if (written.source.IsNull() || backs.size() != 1)
        return;
    DeviationMeasure(written, shape).into(report);
    const SmoothEdges edges =
        compareSmoothEdges(written.source, shape, MillimetreMap(*written.map), 1e3 * report.tolerance);
    report.smoothEdges = edges.count;
    report.largestKink = edges.largestAngle;
    if (edges.largestAngle > visibleKink)
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
