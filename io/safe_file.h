#pragma once

#include <string>
#include <string_view>

namespace knead {

/// Writes a file whole or not at all: under a temporary name in the same folder, flushed to the disk, then renamed.
/// @throws std::runtime_error, in a sentence that names the file and why the disk refused; nothing is left behind.
void writeFileSafely(const std::string& path, std::string_view bytes);

/// Whether writeFileSafely() could begin there now; leaves nothing behind.
/// @throws std::runtime_error, as that would
void checkIsWritable(const std::string& path);

} // namespace knead
