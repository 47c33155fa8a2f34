#pragma once

#include "core/session/deformed_model.h"

namespace knead {

/// WriteAndRead in processes of their own, by way of a STEP file in a folder that is gone afterwards.
WrittenModel writeAndReadInChildren(ExportJob job, TaskControl& control);

} // namespace knead
