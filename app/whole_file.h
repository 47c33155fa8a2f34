#pragma once

#include <string>

namespace knead {

/// Writes a text; the file appears whole or not at all.
/// @param remedy what to do when it cannot be written, as the end of a sentence: "choose another place."
/// @throws std::runtime_error, in a sentence
void writeWhole(const std::string& path, const std::string& text, const std::string& remedy);

} // namespace knead
