#include "io/brep/moved_parts.h"

#include "io/brep/exact_shapes.h"

#include <TopLoc_Location.hxx>
#include <TopoDS_Shape.hxx>
#include <gp_Trsf.hxx>
#include <gp_Vec.hxx>

#include <map>
#include <memory>
#include <string>
#include <vector>

namespace knead {

namespace {

/// @param by in lengths of the shapes
std::string moved(const std::string& bytes, const Vec3& by)
{
    gp_Trsf move;
    move.SetTranslation(gp_Vec(by.x(), by.y(), by.z()));
    std::vector<TopoDS_Shape> shapes = shapesFromBytes(bytes);
    for (TopoDS_Shape& shape : shapes)
        shape.Move(TopLoc_Location(move));
    return shapesToBytes(shapes);
}

} // namespace

void moveParts(Model& model, const Vec3& by)
{
    std::map<const std::string*, std::shared_ptr<const std::string>> movedBytes; // parts of a file have them together
    for (Part& part : model.parts) {
        for (Vec3& vertex : part.mesh.vertices)
            vertex += by;
        for (std::vector<Vec3>& edge : part.openEdges)
            for (Vec3& place : edge)
                place += by;
        if (!part.box.isEmpty())
            part.box.translate(by);
        if (!part.exact)
            continue;
        std::shared_ptr<const std::string>& bytes = movedBytes[part.exact->bytes.get()];
        if (bytes == nullptr)
            bytes = std::make_shared<const std::string>(moved(*part.exact->bytes, by / part.exact->unit));
        part.exact->bytes = bytes;
    }
}

} // namespace knead
