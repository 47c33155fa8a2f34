#pragma once

#include "app/deformation_plan.h"
#include "core/model/export_options.h"
#include "core/model/export_report.h"
#include "core/model/import_options.h"
#include "core/model/part.h"
#include "core/task/task_control.h"

#include <functional>
#include <string>
#include <vector>

namespace knead {

/// A file whose parts are to be deformed and written to another one.
struct MorphRequest {
    std::string input;
    std::string output; ///< its ending is the format
    std::vector<DeformationWish> wishes;
    std::vector<std::string> parts; ///< that are deformed, see partsNamed(); empty: all
    ImportOptions import;
    ExportOptions write; ///< without a unit: that of the file
};

/// What came of it.
struct MorphReport {
    Model model; ///< before
    std::vector<DeformationWish> wishes;
    DeformationPlan plan;
    ExportReport written;
};

/// @param isReady called when all that was asked for makes sense, before anything is written
/// @throws std::runtime_error, in a sentence. @throws Cancelled
MorphReport morphFile(MorphRequest request, TaskControl& control, const std::function<void()>& isReady = {});

} // namespace knead
