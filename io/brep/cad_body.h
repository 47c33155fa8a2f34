#pragma once

#include "core/message/message.h"
#include "io/brep/face_integral.h"

#include <TopTools_DataMapOfShapeShape.hxx>
#include <TopoDS_Shape.hxx>

#include <memory>
#include <optional>
#include <string>
#include <vector>

class BRepCheck_Analyzer;

namespace knead {

/// What becomes one part: a solid, or the shells and faces that belong to none.
struct CadBody {
    TopoDS_Shape shape;                   ///< [mm]
    TopoDS_Shape original;                ///< as the file has it
    TopTools_DataMapOfShapeShape origins; ///< faces that healing made, and the face of the file each stands for
    std::vector<Message> repairs;         ///< as Part::repairs
    std::optional<bool> isValid;          ///< what the geometry checks say, once they were made
    std::shared_ptr<const BRepCheck_Analyzer> failure; ///< the checks of this shape, when it is known not to pass them
    std::optional<FaceIntegrals> integrals;            ///< over the faces of the shape, once they were made

    FaceIntegrals measured() const { return integrals ? *integrals : faceIntegralsOf(shape); }

    /// The face of the file, which knows its color.
    TopoDS_Shape originOf(const TopoDS_Shape& face) const { return origins.IsBound(face) ? origins(face) : face; }
};

} // namespace knead
