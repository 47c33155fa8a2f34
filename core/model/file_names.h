#pragma once

#include "core/message/message.h"

#include <string>

namespace knead {

/// "bracket.step" for "/home/ann/bracket.step": how sentences name a file. Shortened when absurdly long.
std::string shortName(const std::string& path);

/// "<short name>: <sentence>".
Message aboutFile(const std::string& path, const Message& sentence);

} // namespace knead
