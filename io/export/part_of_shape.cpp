#include "io/export/part_of_shape.h"

#include "core/geometry/mass_properties.h"
#include "io/brep/face_integral.h"
#include "io/brep/tessellation.h"
#include "io/export/bent_faces.h"

#include <BRepBuilderAPI_Copy.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>

#include <cmath>

namespace knead {

PartToExport withShape(const PartToExport& part, const TopoDS_Shape& shape, const std::vector<std::uint32_t>& origin)
{
    PartToExport piece = part;
    const TopoDS_Shape copy = BRepBuilderAPI_Copy(shape, false).Shape();
    const double size = part.part.box.diagonal().norm();
    piece.part.mesh = tessellate(copy, {facetDeflection * size / 4, facetAngle});
    piece.part.watertight = isWatertight(piece.part.mesh);
    piece.part.volume = 1e-9 * std::abs(faceIntegralsOf(shape).volume);
    piece.part.faces.clear();
    for (const std::uint32_t face : origin)
        piece.part.faces.push_back(face < part.part.faces.size() ? part.part.faces[face]
                                                                 : decltype(part.part.faces)::value_type{});
    TopTools_IndexedMapOfShape edges;
    TopExp::MapShapes(shape, TopAbs_EDGE, edges);
    piece.part.edges = edges.Extent();
    return piece;
}

} // namespace knead
