#pragma once

#include "core/model/export_job.h"
#include "core/model/export_report.h"
#include "core/task/task_control.h"

#include <string>
#include <vector>

namespace knead {

/// Writes the parts of a job to one file; its ending decides the format. STEP, IGES and BREP are written and read back in a
/// process of their own, meshes here. Parts that have come apart are written as their pieces. The file appears whole or not at all.
/// @throws std::runtime_error, in a sentence for the person. @throws Cancelled
ExportReport exportFile(const std::string& path, ExportJob job, TaskControl& control);

/// What is wrong with the name of a file to write, a picture among them: a sentence, or nothing.
std::string problemWithName(const std::string& path);

/// The report beside a file: "part.step.report.json". @throws std::runtime_error, in a sentence
std::string writeReportBeside(const ExportReport& report);

} // namespace knead
