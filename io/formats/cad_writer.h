#pragma once

#include "core/model/export_options.h"
#include "core/model/part.h"
#include "core/task/task_control.h"
#include "io/formats/cad_format.h"

#include <TopoDS_Shape.hxx>

#include <optional>
#include <string>
#include <vector>

namespace knead {

/// A part to be written: a shape with what is known about it.
struct CadPartToWrite {
    TopoDS_Shape shape; ///< placed in the world [mm]
    std::string name;
    std::optional<Color> color;
    std::vector<PartFace> faces; ///< as TopExp::MapShapes() numbers them; may be fewer
    std::string layer;
    bool visible = true;
};

/// Writes parts to STEP (AP214 or AP242, with curves on surfaces), IGES (solids) or BREP (shapes alone), in an assembly with
/// names and colors of parts and faces (IGES has no names of faces), and layers. Take an OcctSession before.
/// @param tree whose parts are numbers among `parts`; those that are not in it are left out
/// @param options its unit must be one of lengthUnits()
/// @return the bytes of the file
/// @throws Problem. @throws Cancelled
std::string writeCad(FormatKind kind, const std::vector<CadPartToWrite>& parts, const PartNode& tree,
                     const ExportOptions& options, TaskControl& control);

} // namespace knead
