#include "app/field_source.h"

#include "app/cad_process.h"
#include "app/project_field.h"
#include "core/model/file_formats.h"
#include "io/project/project_file.h"

#include <algorithm>

namespace knead {

namespace {

/// Whether it is called like a file of triangles.
bool isCalledMesh(const std::string& path)
{
    return std::ranges::any_of(fileFormats, [&](const FileFormat& format) {
        return format.isRead && !format.isSmooth && isNamedAs(format.kind, path);
    });
}

} // namespace

FieldFile readFieldSource(const std::string& path, const FieldChoice& choice, const ScannedParts& parts,
                          TaskControl& control)
{
    if (isProjectFile(path))
        return projectField(path, choice.step ? std::optional(static_cast<std::uint32_t>(*choice.step)) : std::nullopt,
                            control);
    if (isCalledMesh(path))
        return readScan(path, choice.unit, parts, control);
    return readFieldInChild(path, choice, control);
}

} // namespace knead
