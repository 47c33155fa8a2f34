#include "app/opened_shape.h"

#include "app/cad_process.h"
#include "core/model/file_names.h"
#include "core/session/prepared_project.h"
#include "io/project/packing.h"
#include "io/project/project_file.h"

#include <stdexcept>
#include <utility>

namespace knead {

namespace {

OpenedShape openProject(const std::string& path, std::optional<std::uint32_t> entry, TaskControl& control)
{
    TaskPortion reading(control, 0, 0.3);
    Project project = readProject(path, reading);
    if (project.model == nullptr || project.entries.empty())
        throw std::runtime_error(shortName(path) + ": the project has no parts.");
    project.current = entry.value_or(project.current);
    if (project.current >= project.entries.size())
        throw std::runtime_error(shortName(path) + " has no entry " + std::to_string(project.current) +
                                 "; its last is " + std::to_string(project.entries.size() - 1) + ".");
    TaskPortion going(control, 0.3, 1);
    PreparedProject prepared = prepareProject(std::move(project), zstandardPacking(), going);
    OpenedShape shape{.content = *prepared.destination.content,
                      .frame = prepared.destination.frame,
                      .entry = prepared.project.current};
    shape.content.bodies = shape.frame->filled; // perhaps filled anew, or in pieces
    return shape;
}

} // namespace

OpenedShape openShape(const std::string& path, std::optional<std::uint32_t> entry, const ImportOptions& how,
                      TaskControl& control)
{
    if (isProjectFile(path))
        return openProject(path, entry, control);
    if (entry)
        throw std::runtime_error(shortName(path) + " is no project: it has no entries. Leave out --entry.");
    PreparedModel prepared = prepareFiles(importInChildren, {.paths = {path}, .options = how}, {}, control);
    if (prepared.content.bodies.empty())
        throw std::runtime_error(shortName(path) + ": no part of it is closed, so there is nothing to measure.");
    return {.content = std::move(prepared.content), .frame = std::move(prepared.frame), .entry = {}};
}

} // namespace knead
