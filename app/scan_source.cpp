#include "app/scan_source.h"

#include "app/cad_process.h"
#include "app/opened_shape.h"
#include "core/deformation/kept_faces.h"
#include "core/deformation/scan_field.h"
#include "core/message/message.h"
#include "core/model/file_names.h"

#include <utility>

namespace knead {

namespace {

/// The surfaces of some parts as one. @param which empty: all
TriangleMesh surfaceOfParts(const Model& model, const std::vector<bool>& which)
{
    TriangleMesh all;
    for (std::size_t p = 0; p < model.parts.size(); ++p)
        if (which.empty() || which[p])
            all = besides(std::move(all), model.parts[p].mesh);
    return all;
}

} // namespace

FieldFile readScan(const std::string& path, const std::string& unit, const ScannedParts& parts, TaskControl& control)
{
    TaskPortion reading(control, 0, 0.4);
    ImportOptions how;
    how.unit = unit;
    const Model scanned = importInChild(path, how, reading);
    TaskPortion laying(control, 0.4, 1);
    ScanField scan = scanField(surfaceOfParts(scanned, {}), surfaceOfParts(parts.model, parts.which),
                               {.staysInPlace = parts.isInPlace}, laying);
    FieldFile file{.path = path,
                   .format = "scan",
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
