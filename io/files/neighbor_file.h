#pragma once

#include <string>

namespace knead {

/// Whether a file that another file names is an ordinary one, in the folder of that one or below. Links in there may not lead out of
/// it, and pipes and devices are no files: a file of a stranger names what it likes.
/// @param file its path: absolute, or from where this process is
/// @param path of the file that names it
bool isNeighborFile(const std::string& file, const std::string& path);

} // namespace knead
