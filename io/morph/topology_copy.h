#pragma once

#include "core/task/task_control.h"
#include "io/morph/edge_morph.h"
#include "io/morph/face_morph.h"
#include "io/morph/millimetre_map.h"
#include "io/morph/patch_maker.h"

#include <BRep_Builder.hxx>
#include <TopTools_DataMapOfShapeShape.hxx>
#include <TopTools_IndexedDataMapOfShapeListOfShape.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS_Shape.hxx>

#include <cstdint>
#include <map>
#include <vector>

namespace knead {

/// Copies the topology of a shape around geometry that is carried along. Faces, edges and vertices are numbered from 1, as
/// TopExp::MapShapes() does.
class TopologyCopy {
public:
    /// All must outlive it.
    TopologyCopy(const TopoDS_Shape& source, const MillimetreMap& map, const MorphOptions& options);

    TopologyCopy(const TopologyCopy&) = delete;
    TopologyCopy& operator=(const TopologyCopy&) = delete;

    /// Carries edges and faces along, in parallel.
    /// @throws Cancelled
    void computeGeometry(TaskControl& control);

    /// The new shape. Tolerances are not measured yet.
    /// @throws Cancelled, and Problem, when a face that is to be flat cannot be drawn
    TopoDS_Shape build(TaskControl& control);

    /// Whether triangles take the place of a face.
    bool isFlat(int face) const { return m_options.flat.contains(static_cast<std::uint32_t>(face - 1)); }

    /// Per face of the new shape, which of the source it is of, from 0.
    std::vector<std::uint32_t> originsIn(const TopoDS_Shape& shape) const;

    /// What became of the faces, in their order.
    const std::vector<MorphedFace>& faceResults() const { return m_faceResults; }

    /// Faces that met smoothly in the source do so again where they really do.
    void markSmoothEdges() const;

private:
    TopoDS_Shape imageOf(const TopoDS_Shape& source) const;
    bool isBesideSmooth(const TopoDS_Edge& edge) const;
    void makeFlatFaces(TaskControl& control);
    void makeVertices();
    void makeEdge(const TopoDS_Edge& edge, const MorphedEdge& geometry);
    MorphedFace::EdgeCurves inRangeOfImage(MorphedFace::EdgeCurves curves) const;
    TopoDS_Face makeFace(const TopoDS_Face& face, const MorphedFace& geometry);
    void addWires(const TopoDS_Face& face, TopoDS_Face& image);
    void addCopy(TopoDS_Shape& parent, const TopoDS_Shape& child);
    TopoDS_Shape copyOf(const TopoDS_Shape& shape);

    const TopoDS_Shape& m_source;
    const MillimetreMap& m_map;
    const MorphOptions& m_options;
    PatchMaker m_patchMaker;
    BRep_Builder m_builder;
    TopTools_IndexedMapOfShape m_vertices;
    TopTools_IndexedMapOfShape m_edges;
    TopTools_IndexedMapOfShape m_faces;
    TopTools_IndexedDataMapOfShapeListOfShape m_facesOfEdge;
    std::vector<MorphedEdge> m_edgeResults;
    std::vector<MorphedFace> m_faceResults;
    TopTools_DataMapOfShapeShape m_images;               // of forward shapes
    std::map<int, std::vector<TopoDS_Face>> m_flatFaces; // in the place of faces
};

} // namespace knead
