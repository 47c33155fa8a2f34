#pragma once

#include "core/model/file_formats.h"

#include <string>

namespace knead {

/// Tells what a file is by its content; the ending decides only where the content cannot (an OBJ that starts
/// unusually).
/// @throws std::runtime_error, in a sentence that names the file and what it really is: missing, empty, a folder, an
///         archive, another kind of document, or no known format.
FormatKind recognizeFormat(const std::string& path);

/// "bracket.step" for "/home/ann/bracket.step": how sentences name a file. Shortened when absurdly long.
std::string shortName(const std::string& path);

/// @throws std::runtime_error "<short name>: <sentence>".
[[noreturn]] void failReading(const std::string& path, const std::string& sentence);

} // namespace knead
