#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace knead {

/// The picture of the view with which a project was saved, as a PNG of whatever size; empty when it has none that is whole.
/// Reads little more than that. Any thread.
/// @throws Problem, when it is no file or no project, or cannot be read
std::vector<std::byte> projectThumbnail(const std::string& path);

} // namespace knead
