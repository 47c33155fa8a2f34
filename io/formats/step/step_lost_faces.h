#pragma once

#include "core/message/message.h"
#include "io/document/cad_document.h"
#include "io/formats/step/step_pruning.h"

#include <string>
#include <vector>

class STEPControl_Reader;

namespace knead {

/// What a STEP reader could not make of the shells that its file names.
struct StepLosses {
    std::vector<IncompleteShell> incomplete;
    std::vector<Message> missing; ///< as Model::missing, for solids and surfaces of which nothing was made
};

/// Compares shells with what they were transferred to. The reader itself is silent about faces that refer to entities
/// which do not exist, or which it does not understand.
/// @param pruned faces that were taken out before
StepLosses findLosses(const STEPControl_Reader& reader, const StepPruning& pruned);

} // namespace knead
