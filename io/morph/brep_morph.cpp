#include "io/morph/brep_morph.h"

#include "core/task/parallel_progress.h"
#include "io/morph/edge_morph.h"
#include "io/morph/millimetre_map.h"
#include "io/morph/morph_tolerances.h"

#include <BRepAdaptor_Curve.hxx>
#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <GeomAdaptor_Surface.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_DataMapOfShapeShape.hxx>
#include <TopTools_IndexedDataMapOfShapeListOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_CompSolid.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Iterator.hxx>
#include <TopoDS_Shell.hxx>
#include <TopoDS_Solid.hxx>
#include <TopoDS_Vertex.hxx>
#include <TopoDS_Wire.hxx>

#include <algorithm>
#include <array>
#include <cmath>

namespace knead {

namespace {

constexpr double vertexSlack = 1.5;    // by which the map may widen what a vertex covered
constexpr double widestVertex = 0.005; // of the size of the shape
constexpr double smoothAngle = 0.01;   // [rad] up to which faces meet smoothly

/// Copies the topology of a shape around geometry that is there already.
class TopologyCopy {
public:
    TopologyCopy(const TopoDS_Shape& source, const MillimetreMap& map, const MorphOptions& options)
        : m_source(source)
        , m_map(map)
        , m_options(options)
    {
        TopExp::MapShapes(source, TopAbs_VERTEX, m_vertices);
        TopExp::MapShapes(source, TopAbs_EDGE, m_edges);
        TopExp::MapShapes(source, TopAbs_FACE, m_faces);
    }

    void computeGeometry(TaskControl& control)
    {
        m_edgeResults.resize(static_cast<std::size_t>(m_edges.Extent()));
        m_faceResults.resize(static_cast<std::size_t>(m_faces.Extent()));
        TaskPortion edges(control, 0, 0.2);
        forEachBlock(m_edgeResults.size(), 1, edges, "bending edges", [&](std::size_t i, std::size_t) {
            const TopoDS_Shape& edge = m_edges(static_cast<int>(i) + 1);
            m_edgeResults[i] = morphEdge(TopoDS::Edge(edge.Oriented(TopAbs_FORWARD)), m_map, m_options);
        });
        TaskPortion faces(control, 0.2, 1);
        forEachBlock(m_faceResults.size(), 1, faces, "bending faces", [&](std::size_t i, std::size_t) {
            const TopoDS_Shape& face = m_faces(static_cast<int>(i) + 1);
            const MillimetreMap map = m_map.forFace(placesOnEdges(face));
            m_faceResults[i] = morphFace(TopoDS::Face(face.Oriented(TopAbs_FORWARD)), map, m_options);
        });
    }

    TopoDS_Shape build()
    {
        makeVertices();
        for (int i = 1; i <= m_edges.Extent(); ++i)
            makeEdge(TopoDS::Edge(m_edges(i).Oriented(TopAbs_FORWARD)), m_edgeResults[static_cast<std::size_t>(i - 1)]);
        for (int i = 1; i <= m_faces.Extent(); ++i)
            makeFace(TopoDS::Face(m_faces(i).Oriented(TopAbs_FORWARD)), m_faceResults[static_cast<std::size_t>(i - 1)]);
        return copyOf(m_source);
    }

    const TopTools_IndexedMapOfShape& faces() const { return m_faces; }
    const std::vector<MorphedFace>& faceResults() const { return m_faceResults; }
    TopoDS_Shape imageOf(const TopoDS_Shape& source) const
    {
        return m_images(source.Oriented(TopAbs_FORWARD)).Oriented(source.Orientation());
    }

    /// Faces that met smoothly in the source do so again where they really do.
    void markSmoothEdges() const
    {
        TopTools_IndexedDataMapOfShapeListOfShape facesOfEdge;
        TopExp::MapShapesAndAncestors(m_source, TopAbs_EDGE, TopAbs_FACE, facesOfEdge);
        for (int i = 1; i <= facesOfEdge.Extent(); ++i) {
            if (facesOfEdge(i).IsEmpty())
                continue;
            const TopoDS_Edge edge = TopoDS::Edge(facesOfEdge.FindKey(i));
            const TopoDS_Face first = TopoDS::Face(facesOfEdge(i).First());
            const TopoDS_Face last = TopoDS::Face(facesOfEdge(i).Last());
            if (!BRep_Tool::HasContinuity(edge, first, last) || BRep_Tool::Continuity(edge, first, last) == GeomAbs_C0)
                continue;
            const TopoDS_Edge image = TopoDS::Edge(imageOf(edge.Oriented(TopAbs_FORWARD)));
            const TopoDS_Face firstImage = TopoDS::Face(imageOf(first));
            const TopoDS_Face lastImage = TopoDS::Face(imageOf(last));
            if (meetSmoothly(image, firstImage, lastImage))
                m_builder.Continuity(image, firstImage, lastImage, GeomAbs_C1);
        }
    }

private:
    static std::vector<Vec3> placesOnEdges(const TopoDS_Shape& face)
    {
        constexpr int perEdge = 8;
        std::vector<Vec3> places;
        for (TopExp_Explorer edge(face, TopAbs_EDGE); edge.More(); edge.Next()) {
            if (BRep_Tool::Degenerated(TopoDS::Edge(edge.Current())))
                continue;
            const BRepAdaptor_Curve curve(TopoDS::Edge(edge.Current()));
            for (int i = 0; i <= perEdge; ++i)
                places.push_back(toVec3(
                    curve.Value(curve.FirstParameter() + (curve.LastParameter() - curve.FirstParameter()) * i / perEdge)
                        .XYZ()));
        }
        return places;
    }

    void makeVertices()
    {
        std::vector<Vec3> points;
        for (int i = 1; i <= m_vertices.Extent(); ++i)
            points.push_back(toVec3(BRep_Tool::Pnt(TopoDS::Vertex(m_vertices(i))).XYZ()));
        std::vector<Vec3> places(points.size());
        m_map.evaluate(points, places);
        for (int i = 1; i <= m_vertices.Extent(); ++i) {
            const auto index = static_cast<std::size_t>(i - 1);
            const double before = BRep_Tool::Tolerance(TopoDS::Vertex(m_vertices(i)));
            const bool stays = (places[index] - points[index]).norm() <= m_options.rigidTolerance();
            TopoDS_Vertex vertex;
            m_builder.MakeVertex(vertex, toPoint(stays ? points[index] : places[index]),
                                 stays ? before : std::max({1e-7, 0.1 * m_options.tolerance, vertexSlack * before}));
            m_images.Bind(m_vertices(i).Oriented(TopAbs_FORWARD), vertex);
        }
    }

    void makeEdge(const TopoDS_Edge& edge, const MorphedEdge& geometry)
    {
        const bool isDegenerated = BRep_Tool::Degenerated(edge);
        TopoDS_Edge image;
        if (geometry.curve.IsNull()) {
            m_builder.MakeEdge(image);
            m_builder.Degenerated(image, isDegenerated);
        } else {
            // What moves as a whole is as exact as it was.
            m_builder.MakeEdge(image, geometry.curve, geometry.isExact ? BRep_Tool::Tolerance(edge) : 1e-7);
            m_builder.Range(image, geometry.first, geometry.last);
        }
        for (TopoDS_Iterator child(edge); child.More(); child.Next()) {
            const TopoDS_Vertex vertex = TopoDS::Vertex(child.Value());
            const TopoDS_Vertex vertexImage = TopoDS::Vertex(imageOf(vertex));
            m_builder.Add(image, vertexImage);
            const bool isInside = vertex.Orientation() == TopAbs_INTERNAL || vertex.Orientation() == TopAbs_EXTERNAL;
            if (isInside && !isDegenerated)
                m_builder.UpdateVertex(vertexImage, BRep_Tool::Parameter(vertex, edge), image, 1e-7);
        }
        if (!geometry.curve.IsNull())
            m_builder.Range(image, geometry.first, geometry.last);
        image.Closed(edge.Closed());
        m_builder.SameParameter(image, true);
        m_builder.SameRange(image, true);
        m_images.Bind(edge, image);
    }

    void makeFace(const TopoDS_Face& face, const MorphedFace& geometry)
    {
        TopoDS_Face image;
        if (geometry.surface.IsNull())
            image = TopoDS::Face(face.EmptyCopied());
        else
            m_builder.MakeFace(image, geometry.surface, TopLoc_Location(), 1e-7);
        m_builder.NaturalRestriction(image, BRep_Tool::NaturalRestriction(face));
        for (const MorphedFace::EdgeCurves& curves : geometry.edges) {
            const TopoDS_Edge edge = TopoDS::Edge(m_images(curves.edge));
            if (curves.curves[1].IsNull())
                m_builder.UpdateEdge(edge, curves.curves[0], geometry.surface, TopLoc_Location(), 1e-7);
            else
                m_builder.UpdateEdge(edge, curves.curves[0], curves.curves[1], geometry.surface, TopLoc_Location(),
                                     1e-7);
            m_builder.Range(edge, geometry.surface, TopLoc_Location(), curves.first, curves.last);
        }
        for (TopoDS_Iterator child(face); child.More(); child.Next())
            m_builder.Add(image, copyOf(child.Value()));
        m_images.Bind(face, image);
    }

    TopoDS_Shape copyOf(const TopoDS_Shape& shape)
    {
        const TopoDS_Shape forward = shape.Oriented(TopAbs_FORWARD);
        if (m_images.IsBound(forward))
            return imageOf(shape);
        TopoDS_Shape image = emptyLike(shape);
        for (TopoDS_Iterator child(forward); child.More(); child.Next())
            m_builder.Add(image, copyOf(child.Value()));
        image.Closed(shape.Closed());
        m_images.Bind(forward, image);
        return image.Oriented(shape.Orientation());
    }

    TopoDS_Shape emptyLike(const TopoDS_Shape& shape) const
    {
        switch (shape.ShapeType()) {
        case TopAbs_WIRE: {
            TopoDS_Wire wire;
            m_builder.MakeWire(wire);
            return wire;
        }
        case TopAbs_SHELL: {
            TopoDS_Shell shell;
            m_builder.MakeShell(shell);
            return shell;
        }
        case TopAbs_SOLID: {
            TopoDS_Solid solid;
            m_builder.MakeSolid(solid);
            return solid;
        }
        case TopAbs_COMPSOLID: {
            TopoDS_CompSolid solid;
            m_builder.MakeCompSolid(solid);
            return solid;
        }
        default: {
            TopoDS_Compound compound;
            m_builder.MakeCompound(compound);
            return compound;
        }
        }
    }

    static bool meetSmoothly(const TopoDS_Edge& edge, const TopoDS_Face& first, const TopoDS_Face& second)
    {
        constexpr int looks = 8;
        std::array<double, 2> begin{};
        std::array<double, 2> end{};
        const std::array faces{first, second};
        std::array<Handle(Geom2d_Curve), 2> curves;
        for (std::size_t side = 0; side < 2; ++side) {
            // The second side of a seam is that of the edge reversed.
            const bool reversed = side == 1 && first.IsSame(second);
            curves[side] = BRep_Tool::CurveOnSurface(reversed ? TopoDS::Edge(edge.Reversed()) : edge, faces[side],
                                                     begin[side], end[side]);
            if (curves[side].IsNull())
                return false;
        }
        for (int i = 1; i < looks; ++i) {
            std::array<gp_Vec, 2> normals;
            for (std::size_t side = 0; side < 2; ++side) {
                const gp_Pnt2d at = curves[side]->Value(begin[side] + (end[side] - begin[side]) * i / looks);
                gp_Pnt place;
                gp_Vec u;
                gp_Vec v;
                GeomAdaptor_Surface(BRep_Tool::Surface(faces[side])).D1(at.X(), at.Y(), place, u, v);
                normals[side] = u.Crossed(v);
                if (normals[side].Magnitude() < 1e-30)
                    return false;
                if (faces[side].Orientation() == TopAbs_REVERSED)
                    normals[side].Reverse();
            }
            if (normals[0].Angle(normals[1]) > smoothAngle)
                return false;
        }
        return true;
    }

    const TopoDS_Shape& m_source;
    const MillimetreMap& m_map;
    const MorphOptions& m_options;
    BRep_Builder m_builder;
    TopTools_IndexedMapOfShape m_vertices;
    TopTools_IndexedMapOfShape m_edges;
    TopTools_IndexedMapOfShape m_faces;
    std::vector<MorphedEdge> m_edgeResults;
    std::vector<MorphedFace> m_faceResults;
    TopTools_DataMapOfShapeShape m_images; // of forward shapes
};

double sizeOf(const TopTools_IndexedMapOfShape& vertices)
{
    Box box;
    for (int i = 1; i <= vertices.Extent(); ++i)
        box.extend(toVec3(BRep_Tool::Pnt(TopoDS::Vertex(vertices(i))).XYZ()));
    return box.isEmpty() ? 0 : box.diagonal().norm();
}

} // namespace

MorphedShape morphShape(const TopoDS_Shape& shape, const SmoothMap& map, const MorphOptions& options,
                        TaskControl& control)
{
    const MillimetreMap millimetres(map);
    TopologyCopy copy(shape, millimetres, options);
    TaskPortion geometry(control, 0, 0.85);
    copy.computeGeometry(geometry);
    MorphedShape result;
    result.shape = copy.build();
    result.sourceFaces = copy.faces();
    for (int i = 1; i <= copy.faces().Extent(); ++i) {
        const MorphedFace& face = copy.faceResults()[static_cast<std::size_t>(i - 1)];
        result.faces.push_back(copy.imageOf(copy.faces()(i)));
        result.notes.push_back({face.kind, face.error, face.worst, face.converged, face.poles, face.problem});
    }
    control.throwIfCancelled();
    control.report(0.85, "measuring tolerances");
    result.largestEdgeTolerance = raiseTolerances(result.shape);
    copy.markSmoothEdges();
    control.throwIfCancelled();
    control.report(0.9, "checking");
    TopTools_IndexedMapOfShape vertices;
    TopExp::MapShapes(result.shape, TopAbs_VERTEX, vertices);
    result.isValid = widenVertices(result.shape, widestVertex * sizeOf(vertices), result.widenedVertices);
    control.report(1, "checking");
    return result;
}

} // namespace knead
