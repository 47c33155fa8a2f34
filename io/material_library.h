#pragma once

#include "core/aggregate/material.h"

#include <string>
#include <vector>

namespace knead {

/// Reads material presets from a JSON file (resources/materials/materials.json).
/// @throws Problem naming file, preset and key.
std::vector<MaterialPreset> readMaterials(const std::string& path);

/// Where the materials that a person saved are kept: knead/materials.json in the folder for settings.
std::string ownMaterialsFile();

/// The same as readMaterials(); none when there is no file.
std::vector<MaterialPreset> readOwnMaterials(const std::string& path);

/// Writes presets so that readMaterials() gives the same bits, whole or not at all; makes the folder.
/// @throws Problem
void writeMaterials(const std::string& path, const std::vector<MaterialPreset>& presets);

} // namespace knead
