#pragma once

#include "core/task/task_control.h"

#include <string>

namespace knead {

/// Reads the whole text of an IGES file once and refuses what the CAD reader would take without a word, or for which it
/// would ask for absurd memory: a file that is cut off, lines that lost their 80 columns, texts and lists longer than
/// the file, values that are no numbers.
/// @throws Problem. @throws Cancelled
void checkIgesText(const std::string& path, TaskControl& control = TaskControl::none());

} // namespace knead
