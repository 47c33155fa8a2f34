#pragma once

#include "core/message/message.h"
#include "core/model/part.h"

#include <optional>
#include <string>

namespace knead {

constexpr double leastVolumeShare = 1e-9; ///< of the cube of the size; a solid with less is flat

/// Whether a box is finite and no part of it is farther than 100 km from the origin, where positions lose their digits.
bool isWithinReach(const Box& box);

/// Why a part is of no use: "it has no volume". Nothing for a sound part.
std::optional<Message> sicknessOf(const Part& part);

/// What Model::missing says about a part that was left out.
Message leftOut(const std::string& partName, const Message& reason);

/// Takes the parts that are of no use out of a model, and says so in Model::missing.
void leaveOutSickParts(Model& model);

/// Takes nodes without parts out of a tree.
void removeEmptyNodes(PartNode& node);

/// @throws Problem about `path` that says what is missing, when no part is left.
void checkAnyPart(const std::string& path, const Model& model);

} // namespace knead
