#pragma once

#include "core/document/history_replay.h"
#include "core/document/project.h"
#include "core/model/export_report.h"
#include "core/task/task_control.h"

#include <cstdint>
#include <string>
#include <vector>

namespace knead {

/// What of a project is to be repeated.
struct ReplayChoices {
    std::vector<std::uint32_t> entries; ///< ascending; they exist
    HistoryReplay::From from = HistoryReplay::From::starts;
    std::vector<std::string> exports; ///< files for the parts as they are at the entry, which is the only one
};

/// What repeating came to.
struct ReplayReport {
    std::vector<RepeatedEntry> entries;
    std::vector<std::string> files;    ///< written, in the order asked for
    std::vector<ExportReport> exports; ///< on those that are no pictures

    bool isSame() const; ///< all of them
};

/// Repeats entries of a project and writes what comes out, whether it is the same or not.
/// @throws std::runtime_error, in a sentence; also when there is something to write and the entry was not reached. Cancelled
ReplayReport replayProject(const Project& project, const ReplayChoices& choices, TaskControl& control);

} // namespace knead
