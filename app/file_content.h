#pragma once

#include <optional>
#include <string>

namespace knead {

/// The text of a file. None when it is not there.
std::optional<std::string> textOf(const std::string& path);

/// SHA-256 of the bytes of a file, hexadecimal. Empty when it cannot be read.
std::string digestOf(const std::string& path);

/// The same of a text.
std::string digestOfText(const std::string& text);

} // namespace knead
