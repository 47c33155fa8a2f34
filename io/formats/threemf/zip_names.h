#pragma once

#include <optional>
#include <string>
#include <vector>

namespace knead {

/// The names of the files in a zip archive, as its directory at the end lists them; the first thousand.
/// @return nothing when the directory is missing or damaged, as in an archive that is cut off
std::optional<std::vector<std::string>> zipEntryNames(const std::string& path);

} // namespace knead
