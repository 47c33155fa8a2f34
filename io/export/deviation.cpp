#include "io/export/deviation.h"

#include "core/geometry/surface_distance.h"
#include "core/message/message.h"
#include "io/morph/millimetre_map.h"
#include "io/morph/trimmed_face.h"

#include <BRepAdaptor_Curve.hxx>
#include <BRepTopAdaptor_FClass2d.hxx>
#include <BRep_Tool.hxx>
#include <Extrema_GenLocateExtPS.hxx>
#include <GeomAPI_ProjectPointOnCurve.hxx>
#include <GeomAPI_ProjectPointOnSurf.hxx>
#include <GeomAdaptor_Surface.hxx>
#include <Standard_Failure.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedDataMapOfShapeListOfShape.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <stdexcept>

namespace knead {

namespace {

constexpr int samplesPerSide = 6; // of a face's box of parameters
constexpr int samplesPerPoorSide = 24;
constexpr int checksPerEdge = 4;
constexpr int checksPerPoorEdge = 200;
constexpr std::size_t flatSamples = 20'000; // of a surface

/// Places of a face: inside, and on its border.
/// @param fellShort its fit, or edges do not lie on it: then it is looked at more closely
/// @param note on its fit; null where it has none
std::vector<Vec2> samplesOf(const TrimmedFace& face, bool fellShort, const MorphedFaceNote* note)
{
    const BRepTopAdaptor_FClass2d classifier(face.face(), 1e-9);
    std::vector<Vec2> samples = face.borderSamples(fellShort ? checksPerPoorEdge : checksPerEdge);
    const auto add = [&](const Vec2& at) {
        if (classifier.Perform(gp_Pnt2d(at[0], at[1]), true) == TopAbs_IN)
            samples.push_back(at);
    };
    const int perSide = fellShort ? samplesPerPoorSide : samplesPerSide;
    for (int i = 0; i < perSide; ++i)
        for (int j = 0; j < perSide; ++j) {
            const Vec2 share((i + 0.5) / perSide, (j + 0.5) / perSide);
            add(face.low() + share.cwiseProduct(face.high() - face.low()));
        }
    if (note != nullptr && note->kind == MorphedFaceKind::fitted)
        add(note->worst);
    return samples;
}

/// How far places are from a surface that was read back.
class SurfaceMiss {
public:
    SurfaceMiss(const Handle(Geom_Surface) & surface, double enough)
        : m_surface(surface)
        , m_adaptor(surface)
        , m_enough(enough)
    {
    }

    /// At the parameters it should have there, or from these downhill, or wherever it is nearest: what comes later takes
    /// longer, and is for surfaces whose parameters did not survive the file.
    double of(const Vec2& parameters, const Vec3& place)
    {
        const gp_Pnt point = toPoint(place);
        double miss = m_adaptor.Value(parameters[0], parameters[1]).Distance(point);
        if (miss <= m_enough)
            return miss;
        Extrema_GenLocateExtPS nearest(m_adaptor, 1e-9, 1e-9);
        nearest.Perform(point, parameters[0], parameters[1]);
        if (nearest.IsDone())
            miss = std::min(miss, std::sqrt(nearest.SquareDistance()));
        if (miss <= m_enough || m_fruitless >= mostFruitless)
            return miss;
        const GeomAPI_ProjectPointOnSurf projection(point, m_surface);
        if (projection.NbPoints() > 0)
            miss = std::min(miss, projection.LowerDistance());
        m_fruitless += miss > m_enough ? 1 : 0;
        return miss;
    }

private:
    static constexpr int mostFruitless = 12; // searches all over: then the surface is really off

    Handle(Geom_Surface) m_surface;
    GeomAdaptor_Surface m_adaptor;
    double m_enough; // [mm]
    int m_fruitless = 0;
};

std::string threeDigits(double number)
{
    char text[32];
    std::snprintf(text, sizeof text, "%.3g", number);
    return text;
}

/// Names the faces that are farther off than was allowed, numbered from 0 as in recipes.
/// @param ofFaces how far each is off [m]
void noteMisses(const std::vector<double>& ofFaces, PartExportReport& report)
{
    constexpr std::size_t mostNamed = 12;
    std::string numbers;
    std::size_t count = 0;
    for (std::size_t i = 0; i < ofFaces.size(); ++i) {
        if (ofFaces[i] <= report.tolerance)
            continue;
        if (count++ < mostNamed)
            numbers += (count == 1 ? "" : ", ") + std::to_string(i);
    }
    if (count == 0)
        return;
    const auto worst = std::max_element(ofFaces.begin(), ofFaces.end());
    const std::string allowed = threeDigits(1e3 * report.tolerance);
    const std::string off = threeDigits(1e3 * *worst);
    if (count == 1)
        report.remarks.push_back(
            Message("Export",
                    "\"%1\": face %2 does not come as close to the skin as was aimed at, %3 mm; face %4 is %5 mm off.")
                .with(report.name, numbers, allowed, worst - ofFaces.begin(), off));
    else
        report.remarks.push_back(
            Message(
                "Export",
                "\"%1\": %2 faces, %3, do not come as close to the skin as was aimed at, %4 mm; face %5 is %6 mm off.")
                .with(report.name, count, count > mostNamed ? numbers + ", ..." : numbers, allowed,
                      worst - ofFaces.begin(), off));
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
        TopExp::MapShapesAndUniqueAncestors(written.source, TopAbs_EDGE, TopAbs_FACE, m_facesOfEdge);
    }

    std::vector<double> into(PartExportReport& report) const
    {
        std::vector<double> ofFaces(static_cast<std::size_t>(m_sources.Extent()), 0);
        const std::vector<int> backOfFace = backs();
        double sum = 0;
        for (int i = 1; i <= static_cast<int>(backOfFace.size()); ++i) {
            const auto number = static_cast<std::size_t>(i) - 1;
            if (m_written.isFlat(number))
                continue;
            try {
                ofFaces[number] = measure(i, m_backs(backOfFace[number]), report, sum);
            } catch (const std::runtime_error&) { // a face that could not be looked at: it was kept as it is
            } catch (const Standard_Failure&) {
            }
        }
        if (report.samples > 0)
            report.meanDeviation = sum / static_cast<double>(report.samples);
        noteMisses(ofFaces, report);
        return ofFaces;
    }

private:
    /// Per face of the source, its number among those that were read back; none when nothing says which is which.
    std::vector<int> backs() const
    {
        const auto sources = static_cast<std::size_t>(m_sources.Extent());
        const std::vector<std::uint32_t>& origin = m_written.origin;
        const std::size_t written = origin.empty() ? sources : origin.size();
        if (static_cast<std::size_t>(m_backs.Extent()) != written)
            return {};
        std::vector<int> numbers(sources, 0);
        for (std::size_t i = 0; i < written; ++i)
            numbers[origin.empty() ? i : origin[i]] = static_cast<int>(i) + 1;
        return numbers;
    }

    /// @return the largest distance of the face [m]
    double measure(int index, const TopoDS_Shape& backFace, PartExportReport& report, double& sum) const
    {
        const TrimmedFace source(TopoDS::Face(m_sources(index).Oriented(TopAbs_FORWARD)));
        const Handle(Geom_Surface) surface = BRep_Tool::Surface(TopoDS::Face(backFace));
        if (surface.IsNull())
            return 0;
        SurfaceMiss back(surface, 1e3 * report.tolerance);
        const auto number = static_cast<std::size_t>(index) - 1;
        const bool hasNotes = m_written.notes.size() == static_cast<std::size_t>(m_sources.Extent());
        const MorphedFaceNote* note = hasNotes ? &m_written.notes[number] : nullptr;
        const bool fellShort = (note != nullptr && !note->converged) ||
                               1e-3 * BRep_Tool::MaxTolerance(backFace, TopAbs_EDGE) > report.tolerance;
        const std::vector<Vec2> samples = samplesOf(source, fellShort, note);
        std::vector<Vec3> points;
        for (const Vec2& at : samples)
            points.push_back(source.at(at));
        std::vector<Vec3> places(points.size());
        m_map.evaluate(points, places);
        double largest = 0;
        for (std::size_t i = 0; i < samples.size(); ++i) {
            const double distance = 1e-3 * back.of(samples[i], places[i]);
            largest = std::max(largest, distance);
            sum += distance;
            ++report.samples;
        }
        if (fellShort)
            largest = std::max(largest, 1e-3 * missOfEdges(index, backFace, 1e3 * report.tolerance));
        report.largestDeviation = std::max(report.largestDeviation, largest);
        return largest;
    }

    /// Whether triangles end at an edge, which came in pieces then.
    bool isCut(const TopoDS_Edge& edge) const
    {
        const int at = m_facesOfEdge.FindIndex(edge);
        for (const TopoDS_Shape& face : m_facesOfEdge(at))
            if (m_written.isFlat(static_cast<std::size_t>(m_sources.FindIndex(face) - 1)))
                return true;
        return false;
    }

    /// The largest of a face [mm].
    double missOfEdges(int index, const TopoDS_Shape& backFace, double enough) const
    {
        double largest = 0;
        for (TopExp_Explorer edges(m_sources(index), TopAbs_EDGE); edges.More(); edges.Next()) {
            const TopoDS_Edge& edge = TopoDS::Edge(edges.Current());
            if (BRep_Tool::Degenerated(edge) || isCut(edge))
                continue;
            try {
                largest = std::max(largest, missOfEdge(edge, backFace, enough));
            } catch (const Standard_Failure&) { // of an edge without a curve nothing can be said
            }
        }
        return largest;
    }

    /// How far an edge of a face that was read back is from where it should be, as far as its tolerance leaves room for more
    /// than `enough` [mm].
    double missOfEdge(const TopoDS_Edge& source, const TopoDS_Shape& back, double enough) const
    {
        const BRepAdaptor_Curve wanted(source);
        const double first = wanted.FirstParameter();
        const double range = wanted.LastParameter() - first;
        std::vector<Vec3> points;
        for (int i = 0; i <= checksPerPoorEdge; ++i)
            points.push_back(toVec3(wanted.Value(first + range * i / checksPerPoorEdge).XYZ()));
        std::vector<Vec3> places(points.size());
        m_map.evaluate(points, places);
        const auto endsMiss = [&](const TopoDS_Edge& edge) {
            const BRepAdaptor_Curve curve(edge);
            const Vec3 begin = toVec3(curve.Value(curve.FirstParameter()).XYZ());
            const Vec3 end = toVec3(curve.Value(curve.LastParameter()).XYZ());
            return std::min((begin - places.front()).norm() + (end - places.back()).norm(),
                            (end - places.front()).norm() + (begin - places.back()).norm());
        };
        // Readers keep the order of faces, not that of edges: it is the one that ends where it should. Of two between the
        // same ends it is the nearer one.
        double leastEndsMiss = std::numeric_limits<double>::max();
        std::vector<TopoDS_Edge> candidates;
        for (TopExp_Explorer edges(back, TopAbs_EDGE); edges.More(); edges.Next())
            if (const TopoDS_Edge& edge = TopoDS::Edge(edges.Current()); !BRep_Tool::Degenerated(edge)) {
                candidates.push_back(edge);
                leastEndsMiss = std::min(leastEndsMiss, endsMiss(edge));
            }
        double least = std::numeric_limits<double>::max();
        for (const TopoDS_Edge& edge : candidates)
            if (endsMiss(edge) <= leastEndsMiss + enough)
                least = std::min(least, BRep_Tool::Tolerance(edge) > enough ? largestDistance(places, edge) : 0);
        return candidates.empty() ? 0 : least;
    }

    static double largestDistance(const std::vector<Vec3>& places, const TopoDS_Edge& edge)
    {
        double first = 0;
        double last = 0;
        const Handle(Geom_Curve) curve = BRep_Tool::Curve(edge, first, last);
        if (curve.IsNull())
            return 0;
        double largest = 0;
        for (const Vec3& place : places) {
            const GeomAPI_ProjectPointOnCurve projection(toPoint(place), curve, first, last);
            double distance =
                std::min(toPoint(place).Distance(curve->Value(first)), toPoint(place).Distance(curve->Value(last)));
            if (projection.NbPoints() > 0)
                distance = std::min(distance, projection.LowerDistance());
            largest = std::max(largest, distance);
        }
        return largest;
    }

    const ReadyPart& m_written;
    MillimetreMap m_map;
    TopTools_IndexedMapOfShape m_sources;
    TopTools_IndexedMapOfShape m_backs;
    TopTools_IndexedDataMapOfShapeListOfShape m_facesOfEdge;
};

struct Distances {
    double largest = 0; ///< [m]
    double sum = 0;     ///< [m]
    std::size_t count = 0;
};

/// Adds the distances of points of one surface to another one.
void addDistances(const TriangleMesh& from, const TriangleMesh& to, Distances& distances)
{
    const SurfaceDistance surface(to);
    const auto add = [&](const Vec3& point) {
        const double distance = surface.nearest(point).distance;
        distances.largest = std::max(distances.largest, distance);
        distances.sum += distance;
        ++distances.count;
    };
    const std::size_t stride = from.triangles.size() / flatSamples + 1;
    for (std::size_t t = 0; t < from.triangles.size(); t += stride) {
        const auto& [a, b, c] = from.triangles[t];
        add(from.vertices[a]);
        add((from.vertices[a] + from.vertices[b] + from.vertices[c]) / 3);
    }
}

TriangleMesh together(const std::vector<const Part*>& parts)
{
    TriangleMesh all;
    std::uint32_t firstFace = 0;
    for (const Part* part : parts) {
        const auto first = static_cast<std::uint32_t>(all.vertices.size());
        all.vertices.insert(all.vertices.end(), part->mesh.vertices.begin(), part->mesh.vertices.end());
        for (const auto& [a, b, c] : part->mesh.triangles)
            all.triangles.push_back({first + a, first + b, first + c});
        for (const std::uint32_t face : part->mesh.faceOfTriangle)
            all.faceOfTriangle.push_back(firstFace + face);
        firstFace += static_cast<std::uint32_t>(part->faces.size());
    }
    return all;
}

} // namespace

std::vector<double> measureDeviation(const ReadyPart& written, const TopoDS_Shape& back, PartExportReport& report)
{
    return DeviationMeasure(written, back).into(report);
}

bool measurePatches(const ReadyPart& written, const std::vector<const Part*>& backs, PartExportReport& report)
{
    std::size_t faces = 0;
    for (const Part* back : backs)
        faces += back->faces.size();
    if (faces != written.origin.size())
        return false;
    const TriangleMesh back = together(backs);
    TriangleMesh patches{.vertices = back.vertices, .triangles = {}, .faceOfTriangle = {}};
    for (std::size_t t = 0; t < back.triangles.size(); ++t)
        if (written.isFlat(written.origin[back.faceOfTriangle[t]]))
            patches.triangles.push_back(back.triangles[t]);
    if (written.skin.triangles.empty() || patches.triangles.empty())
        return false;
    Distances distances;
    addDistances(written.skin, patches, distances);
    addDistances(patches, written.skin, distances);
    report.largestFlatDeviation = distances.largest;
    return true;
}

void measureFlatDeviation(const TriangleMesh& skin, const std::vector<const Part*>& backs, PartExportReport& report)
{
    const TriangleMesh back = together(backs);
    if (skin.triangles.empty() || back.triangles.empty())
        return;
    Distances distances;
    addDistances(skin, back, distances);
    addDistances(back, skin, distances);
    report.largestDeviation = std::max(report.largestDeviation, distances.largest);
    report.samples += distances.count;
    report.meanDeviation = distances.sum / static_cast<double>(distances.count);
}

} // namespace knead
