#pragma once

#include "core/task/task_control.h"

#include <string>

namespace knead {

/// What a look at the text of a STEP file tells before the CAD reader sees it.
struct StepCheck {
    std::string protocol; ///< "AP203", "AP214", "AP242" ...; empty when the schema is another one
    std::string schema;   ///< as written in the file
};

/// Reads the whole text once, in about the time of copying it, and refuses what is known to hang or crash the CAD
/// reader: numbers that are none (NaN, INF), lists nested thousands deep, a file that ends in its middle.
/// @throws Problem. @throws Cancelled
StepCheck checkStepText(const std::string& path, TaskControl& control = TaskControl::none());

} // namespace knead
