#include "app/project_field.h"

#include "app/opened_shape.h"
#include "core/message/message.h"
#include "core/model/field_formats.h"
#include "core/model/file_names.h"
#include "core/session/session_field.h"
#include "io/project/project_file.h"

#include <algorithm>
#include <utility>

namespace knead {

FieldFile projectField(const std::string& path, std::optional<std::uint32_t> entry, TaskControl& control)
{
    if (!isProjectFile(path))
        throw Problem(aboutFile(path, Message("Session field", "this is no project of Knead.")));
    TaskPortion opening(control, 0, 0.7);
    OpenedShape shape = openShape(path, entry, {}, opening);
    TaskPortion mapping(control, 0.7, 1);
    SessionField session = sessionField(shape.content, *shape.frame, mapping);
    DisplacementField field = joinedField(session);
    if (std::ranges::all_of(field.displacements, [](const Vec3& u) { return u.isZero(0); }))
        throw Problem(aboutFile(path, Message("Session field", "nothing has moved at its entry %1: there is no field.")
                                          .with(shape.entry.value_or(0))));
    return {.path = path,
            .format = projectFormat,
            .steps = std::move(shape.entries),
            .names = {"displacements"},
            .step = shape.entry.value_or(0),
            .name = "displacements",
            .unit = "m",
            .field = std::move(field),
            .warnings = std::move(session.leftOut)};
}

} // namespace knead
