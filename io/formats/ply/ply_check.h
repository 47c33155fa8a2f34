#pragma once

#include <string>

namespace knead {

/// Looks through the header of a PLY file, and refuses what makes the mesh reader hang or crash: a header without end, types
/// and counts that are none, and numbers after it that are fewer than it promises.
/// @throws Problem
void checkPly(const std::string& path);

} // namespace knead
