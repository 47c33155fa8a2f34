#include "io/export/bent_faces.h"

#include "core/message/message.h"
#include "io/brep/face_integral.h"
#include "io/export/divided_shape.h"
#include "io/export/face_order.h"

#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>

#include <algorithm>
#include <set>
#include <stdexcept>
#include <utility>

namespace knead {

namespace {

constexpr double flatShare = 0.4; // of what single flat faces may be off, that their triangles are drawn with
constexpr double leastSide =
    1.0 / 150; // of the size, to which their triangles are divided however short the map's features are

/// Why the faces of a shape cannot be used; empty when they can.
Message whyNot(const MorphedShape& shape)
{
    const auto isFailed = [](const MorphedFaceNote& note) { return note.kind == MorphedFaceKind::failed; };
    const auto failed = std::count_if(shape.notes.begin(), shape.notes.end(), isFailed);
    if (failed > 0) {
        const auto first = std::find_if(shape.notes.begin(), shape.notes.end(), isFailed);
        return Message("Export", "%1 of its faces could not be carried along: %2.").with(failed, first->problem);
    }
    if (!shape.isValid)
        return Message("Export", "its faces do not fit together any more as they are bent now.");
    return {};
}

/// "3, 7, 12"
std::string numbersOf(const std::set<std::uint32_t>& faces)
{
    constexpr std::size_t mostNamed = 8;
    std::string words;
    std::size_t named = 0;
    for (const std::uint32_t face : faces)
        if (++named <= mostNamed)
            words += (named == 1 ? "" : ", ") + std::to_string(face);
    return faces.size() > mostNamed ? words + ", ..." : words;
}

/// What a face of the source is of, in the part.
std::uint32_t originOf(std::uint32_t face, const ReadyPart& ready)
{
    return ready.manner == FaceManner::divided ? ready.originOfDivided[face] : face;
}

void setFacesByOrigin(const Part& part, ReadyPart& ready)
{
    std::vector<std::uint32_t> origin;
    for (const std::uint32_t face : ready.origin)
        origin.push_back(originOf(face, ready));
    setFaces(part, origin, ready.out);
}

/// What came of bending faces.
struct Bent {
    bool isDone = false;
    Message reason;                    ///< why they cannot be used
    std::vector<std::uint32_t> faulty; ///< those of the source because of which, as far as known
};

/// Tries one manner after the other.
class FaceBender {
public:
    FaceBender(const PartToExport& part, ReadyPart& ready)
        : m_part(part)
        , m_ready(ready)
    {
    }

    /// @return as bendFaces()
    Message run(const FaceChoice& choice, TaskControl& control)
    {
        m_firstFace = choice.firstFace;
        // What cannot be divided is better smooth and misread by some than flat.
        const bool isMisread = choice.from == FaceManner::own && hasBoredClosedFaces(m_ready.source) &&
                               withoutClosedFaces(m_ready.source).origin.size() > m_part.part.faces.size();
        const FaceManner from = isMisread ? FaceManner::divided : choice.from;
        if (from == FaceManner::flat)
            return choice.reason;
        m_ready.manner = FaceManner::own;
        m_ready.next =
            from == FaceManner::own && hasClosedFaces(m_ready.source) ? FaceManner::divided : FaceManner::flat;
        Bent bent{false, choice.reason, choice.flat};
        if (!choice.flat.empty() && !isMisread) {
            if (from == FaceManner::divided)
                divide();
        } else {
            bent = bendWhole(from, control, bent);
            if (bent.isDone)
                return {};
            if (bent.faulty.empty() && m_ready.manner == FaceManner::own)
                bent.faulty = choice.misfits; // what came back unfit the last time, and could not be divided
        }
        TaskPortion portion(control, 0.8, 1);
        if (bendAroundFaulty(bent, portion))
            return {};
        if (m_ready.manner == FaceManner::divided)
            m_ready.report.remarks.pop_back(); // see divide()
        return bent.reason;
    }

private:
    /// Its own faces, then divided ones.
    Bent bendWhole(FaceManner from, TaskControl& control, Bent bent)
    {
        if (from == FaceManner::own) {
            TaskPortion portion(control, 0, 0.4);
            bent = bend(portion, {});
        }
        if (!bent.isDone && divide()) {
            TaskPortion portion(control, 0.4, 0.8);
            bent = bend(portion, {});
        }
        return bent;
    }

    /// Divides the faces of the source that close in themselves, and says so. @return false when there are none
    bool divide()
    {
        const DividedShape divided = withoutClosedFaces(m_ready.source);
        if (divided.origin.size() <= m_part.part.faces.size())
            return false;
        const std::size_t added = divided.origin.size() - m_part.part.faces.size();
        m_ready.source = divided.shape;
        m_ready.originOfDivided = divided.origin;
        m_ready.manner = FaceManner::divided;
        m_ready.next = FaceManner::flat;
        setFaces(m_part.part, divided.origin, m_ready.out);
        m_ready.report.remarks.push_back(added == 1
                                             ? Message("Export", "1 face was added: those that close in themselves "
                                                                 "came in two, which other programs read more surely.")
                                             : Message("Export", "%1 faces were added: those that close in themselves "
                                                                 "came in two, which other programs read more surely.")
                                                   .with(added));
        return true;
    }

    /// Carries the faces of the source through the map.
    /// @param flat those that are to be triangles
    Bent bend(TaskControl& control, const std::set<std::uint32_t>& flat)
    {
        PartExportReport& report = m_ready.report;
        const double size = m_part.part.box.diagonal().norm();
        const MorphOptions options{
            .tolerance = 1e3 * report.tolerance,
            .findsForms = m_ready.findsForms && flat.empty(), // triangles divide edges by their parameters before
            .flat = flat,
            .flatFineness = {.deflection = 1e3 * flatShare * flatTolerance(),
                             .angle = facetAngle,
                             .longestSide = 1e3 * std::max(m_ready.map->featureSize(), leastSide * size),
                             .shortestSide = 1e3 * leastSide * size / 2},
            .mostFlat = mostFacets,
        };
        MorphedShape morphed = morphShape(m_ready.source, *m_ready.map, options, control);
        if (const Message reason = whyNot(morphed); !reason.empty())
            return {false, reason, morphed.faulty};
        report.keptFaces =
            static_cast<int>(std::count_if(morphed.notes.begin(), morphed.notes.end(), [](const MorphedFaceNote& note) {
                return note.kind == MorphedFaceKind::kept;
            }));
        m_ready.notes = std::move(morphed.notes);
        m_ready.origin = std::move(morphed.origin);
        m_ready.out.shape = outward(morphed.shape);
        if (m_firstFace > 0)
            putFaceFirst(m_part.part, m_firstFace, m_ready);
        return {true, {}, {}};
    }

    double flatTolerance() const
    {
        return std::max(m_ready.report.tolerance, facetDeflection * m_part.part.box.diagonal().norm());
    }

    /// Faces that failed, or made the solid invalid, become triangles; so do those that fail beside them then.
    /// @return whether there is a solid
    bool bendAroundFaulty(const Bent& first, TaskControl& control)
    {
        constexpr int mostRounds = 3;
        TopTools_IndexedMapOfShape faces;
        TopExp::MapShapes(m_ready.source, TopAbs_FACE, faces);
        std::set<std::uint32_t> flat;
        std::vector<std::uint32_t> faulty = first.faulty;
        for (int round = 0; round < mostRounds; ++round) {
            const std::size_t before = flat.size();
            for (const std::uint32_t face : faulty)
                addWhole(face, flat);
            if (flat.size() == before || flat.size() == static_cast<std::size_t>(faces.Extent()))
                return false;
            try {
                const Bent bent = bend(control, flat);
                if (bent.isDone) {
                    tellOfFlatFaces(flat, first.reason);
                    return true;
                }
                faulty = bent.faulty;
            } catch (const Cancelled&) {
                throw;
            } catch (const std::runtime_error&) { // a face that cannot be drawn either
                return false;
            }
        }
        return false;
    }

    /// Adds a face, and the other half of it where it was divided.
    void addWhole(std::uint32_t face, std::set<std::uint32_t>& faces) const
    {
        faces.insert(face);
        if (m_ready.manner == FaceManner::divided)
            for (std::uint32_t other = 0; other < m_ready.originOfDivided.size(); ++other)
                if (originOf(other, m_ready) == originOf(face, m_ready))
                    faces.insert(other);
    }

    void tellOfFlatFaces(const std::set<std::uint32_t>& flat, const Message& why)
    {
        std::set<std::uint32_t> ofPart;
        for (const std::uint32_t face : flat)
            ofPart.insert(originOf(face, m_ready));
        PartExportReport& report = m_ready.report;
        report.flatFaces = static_cast<int>(ofPart.size());
        report.flatTolerance = flatTolerance();
        report.reason = why;
        report.remarks.push_back(
            (ofPart.size() == 1
                 ? Message("Export", "\"%1\": face %2 is made of flat triangles; its other faces are smooth.")
                 : Message("Export", "\"%1\": faces %2 are made of flat triangles; its other faces are smooth."))
                .with(report.name, numbersOf(ofPart)));
        setFacesByOrigin(m_part.part, m_ready);
        m_ready.next = FaceManner::flat;
    }

    const PartToExport& m_part;
    ReadyPart& m_ready;
    std::size_t m_firstFace = 0; ///< see FaceChoice
};

} // namespace

Message bendFaces(const PartToExport& part, const FaceChoice& choice, TaskControl& control, ReadyPart& ready)
{
    return FaceBender(part, ready).run(choice, control);
}

TriangleMesh skinOfFlatFaces(const ReadyPart& ready, const TriangleMesh& skin)
{
    std::set<std::uint32_t> flat;
    for (std::uint32_t face = 0; face < ready.notes.size(); ++face)
        if (ready.isFlat(face))
            flat.insert(originOf(face, ready));
    TriangleMesh patch{.vertices = skin.vertices, .triangles = {}, .faceOfTriangle = {}};
    for (std::size_t t = 0; t < skin.triangles.size(); ++t)
        if (flat.contains(skin.faceOfTriangle[t]))
            patch.triangles.push_back(skin.triangles[t]);
    return patch;
}

void putFaceFirst(const Part& part, std::size_t first, ReadyPart& ready)
{
    const OrderedShape ordered = withFaceFirst(ready.out.shape, first);
    ready.out.shape = ordered.shape;
    const std::vector<std::uint32_t> before = std::exchange(ready.origin, {});
    for (const std::uint32_t face : ordered.order)
        ready.origin.push_back(before.empty() ? face : before[face]);
    setFacesByOrigin(part, ready);
}

void setFaces(const Part& part, const std::vector<std::uint32_t>& origin, CadPartToWrite& out)
{
    out.faces.clear();
    for (const std::uint32_t face : origin)
        out.faces.push_back(face < part.faces.size() ? part.faces[face] : PartFace{});
}

TopoDS_Shape outward(const TopoDS_Shape& shape)
{
    return faceIntegralsOf(shape).volume < 0 ? shape.Reversed() : shape;
}

} // namespace knead
