#pragma once

#include "app/describe/command_words.h"

#include <string>

namespace knead {

/// The manual page of the program, for man(7): "knead.1".
/// @param version "0.1.0"
std::string manPageOf(const CommandWords& program, const std::string& version);

/// The manual page of one of its commands: "knead-info.1".
std::string manPageOf(const CommandWords& program, const CommandWords& command, const std::string& version);

} // namespace knead
