#include "app/scan_source.h"

#include "app/cad_process.h"
#include "app/opened_shape.h"
#include "core/deformation/kept_faces.h"
#include "core/deformation/scan_field.h"
#include "core/message/message.h"
#include "core/model/field_formats.h"

#include <utility>

namespace knead {

namespace {

/// The surfaces of all parts as one.
TriangleMesh surfaceOfParts(const Model& model)
{
    TriangleMesh all;
    for (const Part& part : model.parts)
        all = besides(std::move(all), part.mesh);
    return all;
}

} // namespace

FieldFile readScan(const std::string& path, const FieldChoice& choice, const TriangleMesh& parts, TaskControl& control)
{
    TaskPortion reading(control, 0, 0.4);
    ImportOptions how;
    how.unit = choice.unit;
    const Model scanned = importInChild(path, how, reading);
    TaskPortion laying(control, 0.4, 1);
    ScanField scan = scanField(surfaceOfParts(scanned), parts, {.staysInPlace = choice.isInPlace}, laying);
    FieldFile file{.path = path,
                   .format = scanFormat,
                   .steps = {scanned.format},
                   .names = {"distance"},
                   .step = 0,
                   .name = {},
                   .unit = scanned.unit.empty() ? "mm" : scanned.unit,
                   .field = std::move(scan.field),
                   .warnings = std::move(scan.remarks)};
    for (const Message& remark : remarksOnImport(scanned))
        file.warnings.push_back(remark);
    return file;
}

} // namespace knead
