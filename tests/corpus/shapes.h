#pragma once

#include <string>

namespace knead::corpus {

/// Writes the solids of support/hard_shapes.h as STEP files, g000.step and on. @return how many
/// @throws std::runtime_error when one cannot be made or written
int writeShapes(const std::string& folder);

} // namespace knead::corpus
