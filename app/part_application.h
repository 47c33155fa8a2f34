#pragma once

#include "core/document/project.h"
#include "core/model/export_report.h"
#include "core/session/part_transfer.h"
#include "core/task/task_control.h"

#include <cstdint>
#include <optional>
#include <string>

namespace knead {

/// What was done in a project, for another part: see transferToPart(). Of its present branch, up to the entry that is shown.
/// @param projectPath where the project is; empty: it was not saved, and its files must still be there
/// @throws std::runtime_error, in a sentence; Cancelled
PartTransfer transferProject(const Project& project, const std::string& projectPath, const std::string& part,
                             TransferOptions options, TaskControl& control);

/// The shape that a project has at its present entry, carried to the other part without any simulation: written to a CAD file.
/// @throws as transferProject(), and as exportFile()
ExportReport carryShape(const std::string& projectPath, const PartTransfer& transfer, std::uint32_t entry,
                        const std::string& output, TaskControl& control);

} // namespace knead
