#pragma once

#include "core/message/message.h"

#include <optional>
#include <string>
#include <string_view>

namespace knead {

/// What a file is when it is certainly nothing that is read here: a sentence that says so and what to do.
/// Zip archives are not told, see zipContent().
/// @param head the first bytes of the file
std::optional<Message> foreignContent(std::string_view head);

/// What a zip archive holds.
struct ZipContent {
    bool isThreeMf = false;
    Message sentence; ///< what it is when it is no 3MF
};
ZipContent zipContent(const std::string& path);

} // namespace knead
