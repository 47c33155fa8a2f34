#pragma once

#include "core/aggregate/material.h"

#include <string>
#include <vector>

namespace knead {

/// Reads material presets from a JSON file (resources/materials/materials.json).
/// @throws std::runtime_error naming file, preset and key.
std::vector<MaterialPreset> readMaterials(const std::string& path);

} // namespace knead
