#pragma once

#include <string>

namespace knead {

/// The folder with examples, materials and icons: $KNEAD_RESOURCES, else share/knead beside the program's bin folder, else
/// the one of the source tree it was built from.
/// @throws std::runtime_error when none of them exists, naming what was looked for.
std::string resourcesFolder();

/// The bundled materials. @throws as resourcesFolder()
std::string materialsFile();

} // namespace knead
