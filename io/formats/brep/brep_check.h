#pragma once

#include <string>

namespace knead {

/// Looks over the text of a BREP file and refuses what hangs the reader or makes it ask for absurd memory: versions it
/// does not know, counts that are negative or larger than the file, missing sections.
/// @throws Problem
void checkBrepText(const std::string& path);

} // namespace knead
