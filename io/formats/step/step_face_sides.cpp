#include "io/formats/step/step_face_sides.h"

#include "core/message/message.h"
#include "io/brep/outer_face.h"

#include <BRepAdaptor_Curve.hxx>
#include <BRepLib.hxx>
#include <BRepTools.hxx>
#include <BRepTools_ReShape.hxx>
#include <BRep_Tool.hxx>
#include <GeomAPI_ProjectPointOnCurve.hxx>
#include <Geom_CartesianPoint.hxx>
#include <Geom_Conic.hxx>
#include <Geom_Curve.hxx>
#include <Geom_SurfaceOfRevolution.hxx>
#include <Geom_TrimmedCurve.hxx>
#include <Interface_InterfaceModel.hxx>
#include <STEPControl_Reader.hxx>
#include <Standard_Failure.hxx>
#include <StepGeom_BSplineSurface.hxx>
#include <StepGeom_CartesianPoint.hxx>
#include <StepGeom_Conic.hxx>
#include <StepGeom_Curve.hxx>
#include <StepGeom_SphericalSurface.hxx>
#include <StepGeom_SurfaceCurve.hxx>
#include <StepGeom_SurfaceOfRevolution.hxx>
#include <StepShape_EdgeCurve.hxx>
#include <StepShape_EdgeLoop.hxx>
#include <StepShape_FaceBound.hxx>
#include <StepShape_FaceSurface.hxx>
#include <StepShape_OrientedEdge.hxx>
#include <StepShape_Vertex.hxx>
#include <StepShape_VertexLoop.hxx>
#include <StepShape_VertexPoint.hxx>
#include <StepToGeom.hxx>
#include <TopExp_Explorer.hxx>
#include <TopLoc_Location.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Solid.hxx>
#include <TransferBRep.hxx>
#include <Transfer_TransientProcess.hxx>
#include <XSControl_TransferReader.hxx>
#include <XSControl_WorkSession.hxx>
#include <gp_Lin.hxx>

#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <vector>

namespace knead {

namespace {

/// A place of the border of a face, and which way it goes around the face there.
struct Course {
    gp_Pnt place;
    gp_Vec direction; ///< unit
};

constexpr double parallel = 0.99;  // cosine from which two directions are one
constexpr double nearShare = 1e-4; // of the size of an edge: what is so near lies on it
constexpr double sameShare = 1e-9; // of the range of a curve: ends so near are one

bool mayHavePoles(const Handle(StepGeom_Surface) & surface)
{
    return !surface.IsNull() && (surface->IsKind(STANDARD_TYPE(StepGeom_SphericalSurface)) ||
                                 surface->IsKind(STANDARD_TYPE(StepGeom_SurfaceOfRevolution)) ||
                                 surface->IsKind(STANDARD_TYPE(StepGeom_BSplineSurface)));
}

Handle(Geom_Curve) curveOf(const Handle(StepShape_EdgeCurve) & edge)
{
    Handle(StepGeom_Curve) curve = edge->EdgeGeometry();
    if (const auto onSurface = Handle(StepGeom_SurfaceCurve)::DownCast(curve); !onSurface.IsNull())
        curve = onSurface->Curve3d();
    return curve.IsNull() ? Handle(Geom_Curve)() : StepToGeom::MakeCurve(curve);
}

/// The parameter of a curve at which a vertex lies.
std::optional<double> parameterOf(const Handle(StepShape_Vertex) & vertex, const Handle(Geom_Curve) & curve)
{
    const auto withPoint = Handle(StepShape_VertexPoint)::DownCast(vertex);
    const auto point = withPoint.IsNull() ? Handle(StepGeom_CartesianPoint)()
                                          : Handle(StepGeom_CartesianPoint)::DownCast(withPoint->VertexGeometry());
    if (point.IsNull())
        return std::nullopt;
    const GeomAPI_ProjectPointOnCurve projection(StepToGeom::MakeCartesianPoint(point)->Pnt(), curve);
    return projection.NbPoints() == 0 ? std::nullopt : std::optional(projection.LowerDistanceParameter());
}

/// In the middle of an edge, along the loop: at a vertex, edges that touch there could be taken for each other.
std::optional<Course> courseOf(const Handle(StepShape_OrientedEdge) & oriented)
{
    const auto edge = Handle(StepShape_EdgeCurve)::DownCast(oriented->EdgeElement());
    const Handle(Geom_Curve) curve = edge.IsNull() ? Handle(Geom_Curve)() : curveOf(edge);
    if (curve.IsNull())
        return std::nullopt;
    const std::optional<double> start = parameterOf(edge->EdgeStart(), curve);
    const std::optional<double> end = parameterOf(edge->EdgeEnd(), curve);
    if (!start || !end)
        return std::nullopt;
    const double low = edge->SameSense() ? *start : *end;
    double high = edge->SameSense() ? *end : *start;
    const double range = curve->IsClosed() ? curve->LastParameter() - curve->FirstParameter() : 0;
    if (high <= low + sameShare * range) {
        if (!curve->IsClosed())
            return std::nullopt;
        high += range;
    }
    double middle = 0.5 * (low + high);
    if (middle > curve->LastParameter())
        middle -= range;
    gp_Pnt place;
    gp_Vec along;
    curve->D1(middle, place, along);
    if (along.Magnitude() < gp::Resolution())
        return std::nullopt;
    return Course{place, along.Normalized() * (edge->SameSense() == oriented->Orientation() ? 1 : -1)};
}

/// The one bound of a face that is no single vertex, as of a pole; null when there are more.
Handle(StepShape_FaceBound) onlyBound(const Handle(StepShape_FaceSurface) & face)
{
    Handle(StepShape_FaceBound) only;
    for (int i = 1; i <= face->NbBounds(); ++i) {
        const Handle(StepShape_FaceBound) bound = face->BoundsValue(i);
        if (bound.IsNull() || bound->Bound().IsNull() || bound->Bound()->IsKind(STANDARD_TYPE(StepShape_VertexLoop)))
            continue;
        if (!only.IsNull())
            return {};
        only = bound;
    }
    return only;
}

/// Of the one loop that bounds the face, at an edge that is no seam: around the material as the surface is seen from its own front.
std::optional<Course> courseOf(const Handle(StepShape_FaceSurface) & face)
{
    const Handle(StepShape_FaceBound) bound = onlyBound(face);
    const auto loop =
        bound.IsNull() ? Handle(StepShape_EdgeLoop)() : Handle(StepShape_EdgeLoop)::DownCast(bound->Bound());
    if (loop.IsNull() || loop->EdgeList().IsNull())
        return std::nullopt;
    for (int i = 1; i <= loop->NbEdgeList(); ++i) {
        const Handle(StepShape_OrientedEdge) edge = loop->EdgeListValue(i);
        int uses = 0;
        for (int j = 1; j <= loop->NbEdgeList(); ++j)
            uses += loop->EdgeListValue(j)->EdgeElement() == edge->EdgeElement() ? 1 : 0;
        if (uses != 1)
            continue;
        std::optional<Course> course = courseOf(edge);
        if (!course)
            continue;
        if (bound->Orientation() != face->SameSense())
            course->direction.Reverse();
        return course;
    }
    return std::nullopt;
}

/// Whether a face goes round its border the other way. @return none where it does not have the place
std::optional<bool> goesAgainst(const TopoDS_Face& face, const Course& course)
{
    const TopoDS_Shape front = face.Oriented(TopAbs_FORWARD);
    for (TopExp_Explorer edges(front, TopAbs_EDGE); edges.More(); edges.Next()) {
        const TopoDS_Edge edge = TopoDS::Edge(edges.Current());
        double first = 0;
        double last = 0;
        const Handle(Geom_Curve) curve = BRep_Tool::Curve(edge, first, last);
        if (curve.IsNull())
            continue;
        const GeomAPI_ProjectPointOnCurve projection(course.place, curve, first, last);
        const double size = curve->Value(first).Distance(curve->Value(0.5 * (first + last)));
        if (projection.NbPoints() == 0 ||
            projection.LowerDistance() > nearShare * size + 2 * BRep_Tool::Tolerance(edge))
            continue;
        gp_Pnt place;
        gp_Vec along;
        curve->D1(projection.LowerDistanceParameter(), place, along);
        if (along.Magnitude() < gp::Resolution())
            continue;
        const double cosine = along.Normalized() * course.direction * (edge.Orientation() == TopAbs_REVERSED ? -1 : 1);
        if (std::abs(cosine) > parallel)
            return cosine < 0;
    }
    return std::nullopt;
}

/// How a face lies along u on its surface, which closes in itself that way.
struct Extent {
    double low;
    double high;
    double begin; ///< of the surface
    double end;

    explicit Extent(const TopoDS_Face& face)
    {
        double v0 = 0;
        double v1 = 0;
        BRepTools::UVBounds(face, low, high, v0, v1);
        BRep_Tool::Surface(face)->Bounds(begin, end, v0, v1);
    }

    bool meetsSeam() const
    {
        const double hair = 1e-6 * (end - begin);
        return low < begin + hair || high > end - hair;
    }

    bool isOnceAround() const { return high - low < 1.001 * (end - begin); }
};

/// Whether a face has seams and poles where they belong. Where it crosses the seam, OpenCASCADE may leave it none, or lay its border
/// over them, more than once around the surface.
bool isWhole(const TopoDS_Face& face)
{
    bool hasSeam = false;
    for (TopExp_Explorer edges(face, TopAbs_EDGE); edges.More(); edges.Next())
        hasSeam = hasSeam || BRep_Tool::IsClosed(TopoDS::Edge(edges.Current()), face);
    return hasSeam && Extent(face).isOnceAround();
}

/// A face as it was read, and as it should be.
struct Mend {
    TopoDS_Face before;
    TopoDS_Face after;
};

/// Turned about an axis through its middle a whole conic covers each place twice, with normals to both sides: then the side is
/// anyone's guess.
/// @param surface as the file has it; OpenCASCADE may have taken half of the conic
bool coversTwice(const Handle(StepGeom_Surface) & surface, const TopoDS_Face& face)
{
    const auto inFile = Handle(StepGeom_SurfaceOfRevolution)::DownCast(surface);
    const auto turned = Handle(Geom_SurfaceOfRevolution)::DownCast(BRep_Tool::Surface(face));
    if (inFile.IsNull() || turned.IsNull() || !inFile->SweptCurve()->IsKind(STANDARD_TYPE(StepGeom_Conic)))
        return false;
    Handle(Geom_Curve) curve = turned->BasisCurve();
    if (const auto half = Handle(Geom_TrimmedCurve)::DownCast(curve); !half.IsNull())
        curve = half->BasisCurve();
    const auto conic = Handle(Geom_Conic)::DownCast(curve);
    if (conic.IsNull() || !conic->IsClosed())
        return false;
    const double size = conic->Location().Distance(conic->Value(conic->FirstParameter()));
    return gp_Lin(turned->Axis()).Distance(conic->Location()) < 1e-6 * size;
}

struct Mends {
    std::vector<Mend> faces;
    int unsure = 0; ///< faces that may be the wrong ones
};

Mends mendsOf(const STEPControl_Reader& reader)
{
    Mends mends;
    const Handle(Transfer_TransientProcess)& process = reader.WS()->TransferReader()->TransientProcess();
    const Handle(Interface_InterfaceModel) model = reader.Model();
    for (int i = 1; i <= model->NbEntities(); ++i) {
        const auto entity = Handle(StepShape_FaceSurface)::DownCast(model->Value(i));
        if (entity.IsNull() || !mayHavePoles(entity->FaceGeometry()))
            continue;
        const TopoDS_Shape shape = TransferBRep::ShapeResult(process, entity);
        if (shape.IsNull() || shape.ShapeType() != TopAbs_FACE)
            continue;
        const TopoDS_Face before = TopoDS::Face(shape.Oriented(TopAbs_FORWARD));
        try {
            const std::optional<Course> course = courseOf(entity);
            const std::optional<bool> goesBack = course ? goesAgainst(before, *course) : std::nullopt;
            if (!goesBack || isWhole(before))
                continue;
            if (coversTwice(entity->FaceGeometry(), before))
                mends.unsure += Extent(before).meetsSeam() ? 1 : 0;
            else if (const std::optional<TopoDS_Face> after = outerFace(before, *goesBack))
                mends.faces.push_back({before, *after});
        } catch (const Standard_Failure&) { // a curve that cannot be: the face stays as it was read
        }
    }
    return mends;
}

class Mending {
public:
    Mending(const std::vector<Mend>& mends, CadDocument& document)
        : m_document(document)
    {
        for (const Mend& mend : mends) {
            m_faces.Replace(mend.before, mend.after);
            m_concerned.insert(geometryOf(mend.before));
            keepNotes(mend.before, mend.after);
        }
    }

    void mend(CadNode& node)
    {
        for (CadNode& child : node.children)
            mend(child);
        if (node.shape && isConcerned(*node.shape))
            node.shape = std::make_shared<const TopoDS_Shape>(mended(*node.shape));
    }

    /// Shells that are incomplete are so, mended or not.
    void mend(std::vector<IncompleteShell>& shells)
    {
        for (IncompleteShell& shell : shells)
            shell.shape = std::make_shared<const TopoDS_Shape>(m_solids.Value(m_faces.Value(*shell.shape)));
    }

private:
    bool isConcerned(const TopoDS_Shape& shape) const
    {
        for (TopExp_Explorer faces(shape, TopAbs_FACE); faces.More(); faces.Next())
            if (m_concerned.contains(geometryOf(faces.Current())))
                return true;
        return false;
    }

    /// Instances go on sharing what they shared.
    TopoDS_Shape mended(const TopoDS_Shape& shape)
    {
        TopoDS_Shape& own = m_mended[geometryOf(shape)];
        if (own.IsNull())
            own = outward(m_faces.Apply(shape.Located(TopLoc_Location()).Oriented(TopAbs_FORWARD)));
        for (const TopAbs_ShapeEnum kind : {TopAbs_SOLID, TopAbs_SHELL})
            for (TopExp_Explorer parts(shape, kind); parts.More(); parts.Next())
                keepNotes(parts.Current(), m_solids.Value(m_faces.Value(parts.Current())));
        return own.Located(shape.Location()).Oriented(shape.Orientation());
    }

    TopoDS_Shape outward(const TopoDS_Shape& shape)
    {
        for (TopExp_Explorer solids(shape, TopAbs_SOLID); solids.More(); solids.Next()) {
            TopoDS_Solid solid = TopoDS::Solid(solids.Current());
            if (BRepLib::OrientClosedSolid(solid) && !solid.IsSame(solids.Current()))
                m_solids.Replace(solids.Current(), solid);
        }
        return m_solids.Apply(shape);
    }

    /// What the file says of a shape is so of the one that is in its place.
    void keepNotes(const TopoDS_Shape& before, const TopoDS_Shape& after)
    {
        keepNote(m_document.colors, before, after);
        keepNote(m_document.displays, before, after);
        keepNote(m_document.names, before, after);
    }

    template <typename Value>
    static void keepNote(ShapeNotes<Value>& notes, const TopoDS_Shape& before, const TopoDS_Shape& after)
    {
        if (const std::optional<Value> note = notes.find(before); note && !after.IsNull())
            notes.set(after, *note);
    }

    CadDocument& m_document;
    BRepTools_ReShape m_faces;
    BRepTools_ReShape m_solids;
    std::set<const void*> m_concerned;
    std::map<const void*, TopoDS_Shape> m_mended; // by what they are made of
};

} // namespace

void mendFaceSides(const STEPControl_Reader& reader, const std::string& path, CadDocument& document)
{
    const Mends mends = mendsOf(reader);
    if (!mends.faces.empty()) {
        Mending mending(mends.faces, document);
        mending.mend(document.root);
        mending.mend(document.incompleteShells);
    }
    if (mends.unsure > 0)
        document.warnings.push_back(
            Message("Step", "%1: a turned face is bounded across its seam, and the file does not tell on which side of "
                            "its border it lies; check the volume of its part.")
                .with(shortName(path)));
}

} // namespace knead
