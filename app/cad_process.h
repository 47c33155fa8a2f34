#pragma once

#include "core/model/file_preview.h"
#include "core/model/import_options.h"
#include "core/model/part.h"
#include "core/task/task_control.h"

#include <string>
#include <vector>

namespace knead {

/// Reads a file in a process of its own, with the limits that its size calls for. Every import of the program goes this way:
/// window, commands and recipes. On any thread, any number at a time.
/// @throws std::runtime_error, in a sentence for the person. @throws Cancelled
Model importInChild(const std::string& path, const ImportOptions& options, TaskControl& control);

/// Several files beside each other, as many as there are cores; they become one model with a node per file. What cannot be
/// read is missing from it, and Model::missing says why.
/// @throws std::runtime_error when not one of them can be read. @throws Cancelled
Model importInChildren(const std::vector<std::string>& paths, const ImportOptions& options, TaskControl& control);

/// Looks into a file in a process of its own. @throws as importInChild()
FilePreview previewInChild(const std::string& path, TaskControl& control);

/// Whether this process was started by importInChild() of another one; then it is to call readForParent() and nothing else.
bool isReadingProcess(int argc, char** argv);
/// @return the exit status
int readForParent(int argc, char** argv);

/// Which program reads files when it is told to; by default the running one. For programs that are not knead, such as tests.
void setReadingProgram(const std::string& path);

} // namespace knead
