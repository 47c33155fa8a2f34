#pragma once

#include "core/message/message.h"
#include "core/task/task_control.h"

#include <string>

class STEPControl_Reader;

namespace knead {

/// Looks for the files that a STEP assembly refers to (DOCUMENT_FILE), which are beside it or in folders there. They are read
/// with it; their text is checked as that of the assembly is.
/// @param path of the assembly
/// @return a sentence about those that are missing; empty when none is
/// @throws Problem, when one of them is damaged. @throws Cancelled
Message checkReferredFiles(const STEPControl_Reader& reader, const std::string& path, TaskControl& control);

/// What a STEP file without solids and surfaces holds instead, as a sentence; empty when it is nothing known.
Message otherContent(const std::string& path);

} // namespace knead
