#include "app/field_source.h"

#include "app/cad_process.h"
#include "app/project_field.h"
#include "app/scan_source.h"
#include "core/model/field_formats.h"
#include "io/project/project_file.h"

namespace knead {

FieldFile readFieldSource(const std::string& path, const FieldChoice& choice, const TriangleMesh& parts,
                          TaskControl& control)
{
    if (isProjectFile(path))
        return projectField(path, choice.step ? std::optional(static_cast<std::uint32_t>(*choice.step)) : std::nullopt,
                            control);
    if (isScanFile(path))
        return readScan(path, choice, parts, control);
    return readFieldInChild(path, choice, control);
}

} // namespace knead
