#pragma once

#include "ui/project/project_services.h"

namespace knead {

/// Project files, locks and recoveries of io as the window wants them.
ProjectServices projectServices();

} // namespace knead
