#pragma once

#include "io/formats/cad_format.h"
#include "io/importer.h"

#include <optional>
#include <string>
#include <vector>

namespace knead {

/// The CAD format that the ending of a path means; none for meshes and everything else.
std::optional<FormatKind> cadFormatFor(const std::string& path);

/// All formats that parts can be written in, smooth faces first.
const std::vector<FileFormat>& allExportFormats();

/// Whether the ending of a path is one of theirs.
bool isExportPath(const std::string& path);

/// ".step, .stp, ... and .ply", for sentences.
std::string exportEndings();

} // namespace knead
