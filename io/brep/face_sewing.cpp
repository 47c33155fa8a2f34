#include "io/brep/face_sewing.h"

#include "core/message/message.h"
#include "core/model/number_words.h"
#include "io/brep/free_edges.h"
#include "io/brep/millimeter.h"
#include "io/brep/shape_measure.h"

#include <BRepAdaptor_Curve.hxx>
#include <BRepBuilderAPI_Sewing.hxx>
#include <BRep_Tool.hxx>
#include <Precision.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedDataMapOfShapeListOfShape.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>

#include <algorithm>
#include <array>
#include <cmath>

namespace knead {

namespace {

constexpr std::array toleranceShares{1e-6, 1e-5, 3e-5, 1e-4, 3e-4, 1e-3}; // of the diagonal
constexpr double sameArea = 1e-3; // relative; the area of trimmed curved faces is not integrated better
constexpr int seamSamples = 16;

/// The largest distance between the two sides of an edge that two faces share [mm].
double widestGap(const TopoDS_Shape& shape)
{
    TopTools_IndexedDataMapOfShapeListOfShape facesOfEdge;
    TopExp::MapShapesAndAncestors(shape, TopAbs_EDGE, TopAbs_FACE, facesOfEdge);
    double gap = 0;
    for (int i = 1; i <= facesOfEdge.Extent(); ++i) {
        const TopoDS_Edge& edge = TopoDS::Edge(facesOfEdge.FindKey(i));
        const TopTools_ListOfShape& faces = facesOfEdge(i);
        if (BRep_Tool::Degenerated(edge) || faces.Extent() != 2 || faces.First().IsSame(faces.Last()))
            continue;
        const BRepAdaptor_Curve one(edge, TopoDS::Face(faces.First()));
        const BRepAdaptor_Curve other(edge, TopoDS::Face(faces.Last()));
        const double first = one.FirstParameter();
        const double last = one.LastParameter();
        for (int sample = 0; sample <= seamSamples; ++sample) {
            const double parameter = first + (last - first) * sample / seamSamples;
            gap = std::max(gap, one.Value(parameter).Distance(other.Value(parameter)));
        }
    }
    return gap;
}

/// Features smaller than the tolerance vanish in sewing; then it is too large.
bool isAllThere(const CadBody& sewn, const CadBody& before)
{
    const double area = before.measured().area;
    return countDistinct(sewn.shape, TopAbs_FACE) == countDistinct(before.shape, TopAbs_FACE) &&
           std::abs(sewn.measured().area - area) <= sameArea * area;
}

class Sewer {
public:
    explicit Sewer(const CadBody& body)
        : m_body(body)
        , m_diagonal(diagonalOf(body.shape))
    {
        m_body.integrals = body.measured();
        TopExp::MapShapes(body.shape, TopAbs_FACE, m_faces);
    }

    std::optional<CadBody> run(TaskControl& control)
    {
        std::optional<CadBody> best; // is sewn on: what is joined stays joined
        int fewest = freeEdgesOf(m_body.shape).Extent();
        for (const double share : toleranceShares) {
            if (fewest == 0)
                break;
            control.throwIfCancelled();
            const double tolerance = std::max(share * m_diagonal, Precision::Confusion());
            const CadBody& before = best ? *best : m_body;
            if (!canBeSewn(before.shape, tolerance))
                continue;
            std::optional<CadBody> candidate = sewnWith(before, tolerance);
            if (!candidate || !isAllThere(*candidate, m_body))
                continue;
            const int free = freeEdgesOf(candidate->shape).Extent();
            if (free >= fewest)
                continue;
            fewest = free;
            m_tolerance = tolerance;
            best = std::move(candidate);
        }
        if (best)
            best->repairs.push_back(sentenceFor(best->shape));
        return best;
    }

private:
    Message sentenceFor(const TopoDS_Shape& shape) const
    {
        constexpr double nothing = 1e-9; // [m]
        const int count = m_faces.Extent();
        const std::string tolerance = lengthWords(millimeter * m_tolerance);
        const double gap = millimeter * widestGap(shape);
        if (gap < nothing)
            return count == 1 ? Message("Repair", "1 separate face was sewn with a tolerance of %1.").with(tolerance)
                              : Message("Repair", "%1 separate faces were sewn with a tolerance of %2.")
                                    .with(count, tolerance);
        return count == 1
                   ? Message(
                         "Repair",
                         "1 separate face was sewn with a tolerance of %1; the widest gap between two of them is %2.")
                         .with(tolerance, lengthWords(gap))
                   : Message("Repair", "%1 separate faces were sewn with a tolerance of %2; the widest gap between two "
                                       "of them is %3.")
                         .with(count, tolerance, lengthWords(gap));
    }

    CadBody m_body; // with its integrals
    double m_diagonal;
    double m_tolerance = 0;
    TopTools_IndexedMapOfShape m_faces;
};

} // namespace

std::optional<CadBody> sewnWith(const CadBody& body, double tolerance)
{
    TopTools_IndexedMapOfShape faces;
    TopExp::MapShapes(body.shape, TopAbs_FACE, faces);
    BRepBuilderAPI_Sewing sewing(tolerance);
    for (int i = 1; i <= faces.Extent(); ++i)
        sewing.Add(faces(i));
    sewing.Perform();
    CadBody result{.shape = sewing.SewedShape(), .original = body.original, .repairs = body.repairs};
    if (result.shape.IsNull())
        return std::nullopt;
    result.integrals = faceIntegralsOf(result.shape);
    if (!isAllThere(result, body))
        return std::nullopt;
    for (int i = 1; i <= faces.Extent(); ++i)
        result.origins.Bind(sewing.ModifiedSubShape(faces(i)), body.originOf(faces(i)));
    return result;
}

std::optional<CadBody> sewn(const CadBody& body, TaskControl& control)
{
    return Sewer(body).run(control);
}

} // namespace knead
