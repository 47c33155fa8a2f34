#include "io/morph/topology_copy.h"

#include "core/message/message.h"
#include "core/task/parallel_progress.h"
#include "io/morph/parameter_curves.h"
#include "io/morph/trimmed_face.h"

#include <BRep_Tool.hxx>
#include <GeomAdaptor_Surface.hxx>
#include <TopAbs.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
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

namespace knead {

namespace {

constexpr double vertexSlack = 1.5;  // by which the map may widen what a vertex covered
constexpr double smoothAngle = 0.01; // [rad] up to which faces meet smoothly

TopoDS_Shape emptyLike(const TopoDS_Shape& shape)
{
    const BRep_Builder builder;
    switch (shape.ShapeType()) {
    case TopAbs_WIRE: {
        TopoDS_Wire wire;
        builder.MakeWire(wire);
        return wire;
    }
    case TopAbs_SHELL: {
        TopoDS_Shell shell;
        builder.MakeShell(shell);
        return shell;
    }
    case TopAbs_SOLID: {
        TopoDS_Solid solid;
        builder.MakeSolid(solid);
        return solid;
    }
    case TopAbs_COMPSOLID: {
        TopoDS_CompSolid solid;
        builder.MakeCompSolid(solid);
        return solid;
    }
    default: {
        TopoDS_Compound compound;
        builder.MakeCompound(compound);
        return compound;
    }
    }
}

bool meetSmoothly(const TopoDS_Edge& edge, const TopoDS_Face& first, const TopoDS_Face& second)
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

} // namespace

TopologyCopy::TopologyCopy(const TopoDS_Shape& source, const MillimetreMap& map, const MorphOptions& options)
    : m_source(source)
    , m_map(map)
    , m_options(options)
    , m_patchMaker(options.flatFineness,
                   {.imageOf = [this](const TopoDS_Edge& edge) { return TopoDS::Edge(imageOf(edge)); },
                    .numberOf = [this](const TopoDS_Edge& edge) { return m_edges.FindIndex(edge); },
                    .isBesideSmooth = [this](const TopoDS_Edge& edge) { return isBesideSmooth(edge); }})
{
    TopExp::MapShapes(source, TopAbs_VERTEX, m_vertices);
    TopExp::MapShapes(source, TopAbs_EDGE, m_edges);
    TopExp::MapShapes(source, TopAbs_FACE, m_faces);
    TopExp::MapShapesAndUniqueAncestors(source, TopAbs_EDGE, TopAbs_FACE, m_facesOfEdge);
}

void TopologyCopy::computeGeometry(TaskControl& control)
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
        if (isFlat(static_cast<int>(i) + 1))
            return;
        const TopoDS_Shape& face = m_faces(static_cast<int>(i) + 1);
        const MillimetreMap map = m_map.forFace(placesOnEdges(face));
        m_faceResults[i] = morphFace(TopoDS::Face(face.Oriented(TopAbs_FORWARD)), map, m_options);
    });
}

TopoDS_Shape TopologyCopy::build(TaskControl& control)
{
    makeVertices();
    for (int i = 1; i <= m_edges.Extent(); ++i)
        makeEdge(TopoDS::Edge(m_edges(i).Oriented(TopAbs_FORWARD)), m_edgeResults[static_cast<std::size_t>(i - 1)]);
    std::vector<TopoDS_Face> images(static_cast<std::size_t>(m_faces.Extent()));
    for (int i = 1; i <= m_faces.Extent(); ++i)
        if (!isFlat(i))
            images[static_cast<std::size_t>(i - 1)] =
                makeFace(TopoDS::Face(m_faces(i)), m_faceResults[static_cast<std::size_t>(i - 1)]);
    makeFlatFaces(control); // when edges have their curves on all faces, and before wires have their edges
    for (int i = 1; i <= m_faces.Extent(); ++i)
        if (!isFlat(i))
            addWires(TopoDS::Face(m_faces(i)), images[static_cast<std::size_t>(i - 1)]);
    return copyOf(m_source);
}

void TopologyCopy::makeFlatFaces(TaskControl& control)
{
    std::size_t count = 0;
    for (int i = 1; i <= m_faces.Extent(); ++i) {
        if (!isFlat(i))
            continue;
        control.throwIfCancelled();
        m_flatFaces[i] = m_patchMaker.facesFor(TopoDS::Face(m_faces(i)), m_map.forFace(placesOnEdges(m_faces(i))));
        count += m_flatFaces[i].size();
        if (count > m_options.mostFlat)
            throw Problem(Message("Export", "too many triangles would be needed"));
    }
}

std::vector<std::uint32_t> TopologyCopy::originsIn(const TopoDS_Shape& shape) const
{
    TopTools_IndexedMapOfShape faces;
    TopExp::MapShapes(shape, TopAbs_FACE, faces);
    std::vector<std::uint32_t> origins(static_cast<std::size_t>(faces.Extent()));
    for (int i = 1; i <= m_faces.Extent(); ++i) {
        const auto number = static_cast<std::uint32_t>(i - 1);
        if (!isFlat(i))
            origins[static_cast<std::size_t>(faces.FindIndex(imageOf(m_faces(i))) - 1)] = number;
        else
            for (const TopoDS_Face& face : m_flatFaces.at(i))
                origins[static_cast<std::size_t>(faces.FindIndex(face) - 1)] = number;
    }
    return origins;
}

void TopologyCopy::markSmoothEdges() const
{
    TopTools_IndexedDataMapOfShapeListOfShape facesOfEdge;
    TopExp::MapShapesAndAncestors(m_source, TopAbs_EDGE, TopAbs_FACE, facesOfEdge);
    for (int i = 1; i <= facesOfEdge.Extent(); ++i) {
        if (facesOfEdge(i).IsEmpty())
            continue;
        const TopoDS_Edge edge = TopoDS::Edge(facesOfEdge.FindKey(i));
        const TopoDS_Face first = TopoDS::Face(facesOfEdge(i).First());
        const TopoDS_Face last = TopoDS::Face(facesOfEdge(i).Last());
        if (isFlat(m_faces.FindIndex(first)) || isFlat(m_faces.FindIndex(last)))
            continue;
        if (!BRep_Tool::HasContinuity(edge, first, last) || BRep_Tool::Continuity(edge, first, last) == GeomAbs_C0)
            continue;
        const TopoDS_Edge image = TopoDS::Edge(imageOf(edge.Oriented(TopAbs_FORWARD)));
        const TopoDS_Face firstImage = TopoDS::Face(imageOf(first));
        const TopoDS_Face lastImage = TopoDS::Face(imageOf(last));
        if (meetSmoothly(image, firstImage, lastImage))
            m_builder.Continuity(image, firstImage, lastImage, GeomAbs_C1);
    }
}

TopoDS_Shape TopologyCopy::imageOf(const TopoDS_Shape& source) const
{
    return m_images(source.Oriented(TopAbs_FORWARD)).Composed(source.Orientation());
}

bool TopologyCopy::isBesideSmooth(const TopoDS_Edge& edge) const
{
    for (const TopoDS_Shape& face : m_facesOfEdge.FindFromKey(edge))
        if (!isFlat(m_faces.FindIndex(face)))
            return true;
    return false;
}

void TopologyCopy::makeVertices()
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

void TopologyCopy::makeEdge(const TopoDS_Edge& edge, const MorphedEdge& geometry)
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
            m_builder.UpdateVertex(vertexImage, geometry.rangedParameter(BRep_Tool::Parameter(vertex, edge)), image,
                                   1e-7);
    }
    if (!geometry.curve.IsNull())
        m_builder.Range(image, geometry.first, geometry.last);
    image.Closed(edge.Closed());
    m_builder.SameParameter(image, true);
    m_builder.SameRange(image, true);
    m_images.Bind(edge, image);
}

/// Over the range that the edge has now.
MorphedFace::EdgeCurves TopologyCopy::inRangeOfImage(MorphedFace::EdgeCurves curves) const
{
    const MorphedEdge& edge = m_edgeResults[static_cast<std::size_t>(m_edges.FindIndex(curves.edge) - 1)];
    if (!edge.hasOtherRange())
        return curves;
    const double first = edge.rangedParameter(curves.first);
    const double last = edge.rangedParameter(curves.last);
    for (Handle(Geom2d_Curve) & curve : curves.curves)
        if (!curve.IsNull())
            curve = rangedCurve(curve, curves.first, curves.last, first, last, {.degree = m_options.degree});
    curves.first = first;
    curves.last = last;
    return curves;
}

/// Without its border.
TopoDS_Face TopologyCopy::makeFace(const TopoDS_Face& face, const MorphedFace& geometry)
{
    TopoDS_Face image;
    if (geometry.surface.IsNull())
        image = TopoDS::Face(face.Oriented(TopAbs_FORWARD).EmptyCopied());
    else
        m_builder.MakeFace(image, geometry.surface, TopLoc_Location(), 1e-7);
    m_builder.NaturalRestriction(image, BRep_Tool::NaturalRestriction(face));
    for (const MorphedFace::EdgeCurves& ofSource : geometry.edges) {
        const TopoDS_Edge edge = TopoDS::Edge(m_images(ofSource.edge));
        const MorphedFace::EdgeCurves curves = inRangeOfImage(ofSource);
        if (curves.curves[1].IsNull())
            m_builder.UpdateEdge(edge, curves.curves[0], geometry.surface, TopLoc_Location(), 1e-7);
        else
            m_builder.UpdateEdge(edge, curves.curves[0], curves.curves[1], geometry.surface, TopLoc_Location(), 1e-7);
        m_builder.Range(edge, geometry.surface, TopLoc_Location(), curves.first, curves.last);
    }
    return image;
}

void TopologyCopy::addWires(const TopoDS_Face& face, TopoDS_Face& image)
{
    // Seen from the other side, wires run the other way around.
    const bool isMirrored = m_faceResults[static_cast<std::size_t>(m_faces.FindIndex(face) - 1)].isMirrored;
    for (TopoDS_Iterator child(face.Oriented(TopAbs_FORWARD)); child.More(); child.Next())
        addCopy(image, isMirrored ? child.Value().Reversed() : child.Value());
    m_images.Bind(face.Oriented(TopAbs_FORWARD), isMirrored ? image.Reversed() : TopoDS_Shape(image));
}

/// Adds what a child of the source became: an edge may have become several ones, a face triangles.
void TopologyCopy::addCopy(TopoDS_Shape& parent, const TopoDS_Shape& child)
{
    const auto pieces = m_patchMaker.pieces().find(m_edges.FindIndex(child));
    const auto flat = m_flatFaces.find(m_faces.FindIndex(child));
    if (pieces != m_patchMaker.pieces().end()) {
        std::vector<TopoDS_Edge> inOrder = pieces->second;
        if (child.Orientation() == TopAbs_REVERSED)
            std::reverse(inOrder.begin(), inOrder.end());
        for (const TopoDS_Edge& piece : inOrder)
            m_builder.Add(parent, piece.Oriented(child.Orientation()));
    } else if (flat != m_flatFaces.end()) {
        // Triangles run as the face does where it was met first in the whole, not in this parent.
        const TopAbs_Orientation first = m_faces(m_faces.FindIndex(child)).Orientation();
        for (const TopoDS_Face& face : flat->second)
            m_builder.Add(parent, face.Oriented(TopAbs::Compose(first, child.Orientation())));
    } else {
        m_builder.Add(parent, copyOf(child));
    }
}

TopoDS_Shape TopologyCopy::copyOf(const TopoDS_Shape& shape)
{
    const TopoDS_Shape forward = shape.Oriented(TopAbs_FORWARD);
    if (m_images.IsBound(forward))
        return imageOf(shape);
    TopoDS_Shape image = emptyLike(shape);
    for (TopoDS_Iterator child(forward); child.More(); child.Next())
        addCopy(image, child.Value());
    image.Closed(shape.Closed());
    m_images.Bind(forward, image);
    return image.Oriented(shape.Orientation());
}

} // namespace knead
