#pragma once

#include "core/model/export_job.h"
#include "core/model/export_report.h"
#include "core/task/task_control.h"
#include "io/formats/cad_format.h"

#include <string>

namespace knead {

/// A file that is ready to be put on a disk, and what was found when it was read back.
struct ExportedFile {
    std::string bytes;
    ExportReport report;
};

/// Writes the parts of a job as STEP, IGES or BREP, reads that back and compares. Takes the OpenCASCADE lock; may crash where
/// OpenCASCADE does, see isolated_export.h.
/// @throws Problem. @throws Cancelled
ExportedFile exportCad(FormatKind kind, ExportJob job, TaskControl& control);

} // namespace knead
