#pragma once

#include "core/message/message.h"
#include "core/model/import_options.h"
#include "core/model/part.h"
#include "core/session/filled_model.h"
#include "core/session/frame.h"
#include "core/session/prepared_project.h"
#include "core/task/task_control.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace knead {

/// What can be measured: parts of a CAD or mesh file at rest, or those of a project as they are at an entry of its history.
struct OpenedShape {
    FilledModel content;                ///< as it is filled there
    FramePointer frame;                 ///< where it is there
    std::optional<std::uint32_t> entry; ///< of a project
    std::vector<std::string> entries;   ///< of a project: what its history calls them, in order
    std::vector<Message> warnings;      ///< what was found when a file was read
};

/// A project at an entry of its history, none: its present one.
/// @throws std::runtime_error, in a sentence; Cancelled
PreparedProject openEntry(const std::string& path, std::optional<std::uint32_t> entry, TaskControl& control);

/// What a person should know of a file that was read.
std::vector<Message> remarksOnImport(const Model& model);

/// @param entry of a project; none: its present one
/// @throws std::runtime_error, in a sentence; Cancelled
OpenedShape openShape(const std::string& path, std::optional<std::uint32_t> entry, const ImportOptions& how,
                      TaskControl& control);

} // namespace knead
