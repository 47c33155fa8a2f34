#pragma once

#include "app/describe/command_words.h"

#include <string>

namespace knead {

/// What shells offer after the Tab key: commands, their options, and what these take. Each is a file that the shell finds by its
/// name in a folder of its own.

/// share/bash-completion/completions/knead
std::string bashCompletionOf(const CommandWords& program);

/// share/zsh/site-functions/_knead
std::string zshCompletionOf(const CommandWords& program);

/// share/fish/vendor_completions.d/knead.fish
std::string fishCompletionOf(const CommandWords& program);

} // namespace knead
