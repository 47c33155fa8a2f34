#pragma once

#include "core/message/message.h"
#include "core/model/file_formats.h"
#include "core/model/file_names.h"

#include <cstdint>
#include <string>

namespace knead {

/// Tells what a file is by its content; the ending decides only where the content cannot (an OBJ that starts
/// unusually).
/// @throws Problem that names the file and what it really is: missing, empty, a folder, an
///         archive, another kind of document, or no known format.
FormatKind recognizeFormat(const std::string& path);

/// How long a file is [bytes]. @throws Problem, when it is missing, empty, a folder or no ordinary file
std::uintmax_t sizeOfFile(const std::string& path);

/// @throws Problem aboutFile().
[[noreturn]] void failReading(const std::string& path, const Message& sentence);

} // namespace knead
