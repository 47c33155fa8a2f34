#pragma once

#include "core/model/export_job.h"
#include "core/model/export_report.h"
#include "core/task/task_control.h"

#include <string>

namespace knead {

/// Writes the parts of a job to STEP, IGES or BREP as the ending of the path says, in a process of its own, reads that back and
/// compares. The file appears whole or not at all: what lay there before stays until then. Cancelling ends the process at once.
/// @param program that calls runExportWorker() when isExportWorker()
/// @throws Problem: which file, what is wrong, what to do. @throws Cancelled
ExportReport exportIsolated(const std::string& program, const std::string& path, const ExportJob& job,
                            TaskControl& control);

} // namespace knead
