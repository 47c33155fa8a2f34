#pragma once

#include "core/message/message.h"

#include <string>

namespace knead {

/// Writes a text; the file appears whole or not at all.
/// @param refused says that it cannot be written and what to do; "%1" is its path
/// @throws Problem
void writeWhole(const std::string& path, const std::string& text, const Message& refused);

} // namespace knead
