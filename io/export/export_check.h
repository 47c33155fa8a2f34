#pragma once

#include "core/message/message.h"
#include "io/export/exact_part.h"

#include <vector>

namespace knead {

/// Smooth faces that are off by so many tolerances are better flat.
inline constexpr double roughFaces = 20;

/// Compares a file that was read back with what was written, part by part, and completes the reports of these.
/// @param written in the order of the tree
/// @param model what reading gave, with its exact shapes
/// @return sentences about what does not belong to one part
std::vector<Message> checkWritten(std::vector<ReadyPart>& written, const Model& model, TaskControl& control);

} // namespace knead
