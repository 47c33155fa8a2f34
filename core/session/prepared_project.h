#pragma once

#include "core/document/project.h"
#include "core/session/history_navigation.h"

namespace knead {

/// A project made ready to be shown, on a task thread.
struct PreparedProject {
    Project project;
    HistoryDestination destination; ///< at its current entry
};

/// Makes a project ready to be shown. Runs on a task thread.
/// @throws std::runtime_error with a sentence; Cancelled
PreparedProject prepareProject(Project project, const Packing& packing, TaskControl& control);

} // namespace knead
