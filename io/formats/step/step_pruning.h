#pragma once

#include "core/message/message.h"

#include <string>
#include <unordered_map>

class STEPControl_Reader;
class Standard_Transient;

namespace knead {

/// What was taken out of a STEP file before shapes are made of it.
struct StepPruning {
    std::unordered_map<const Standard_Transient*, int> lostFaces; ///< by shell
    Message damage; ///< what was wrong and what it cost, a sentence; empty when nothing was
};

/// Takes out what refers to nothing, or to something of the wrong kind, where the reader would crash: faces leave their shell,
/// other shapes their representation, and all else stays. Call it between reading and making shapes.
/// @param path for messages
/// @throws Problem, when the structure of an assembly itself is broken
StepPruning pruneHollowEntities(STEPControl_Reader& reader, const std::string& path);

} // namespace knead
