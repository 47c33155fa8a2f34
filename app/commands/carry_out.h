#pragma once

#include "app/terminal_control.h"

#include <functional>

namespace knead {

/// Does the work of a command, with its progress at the terminal. What goes wrong is said there in a sentence.
/// @param work what a failure of it counts as is exit_status::wrongUse until it says otherwise
/// @return the exit status: that of the work, or of how it ended
int carryOut(const std::function<int(TerminalControl& control, int& failure)>& work);

} // namespace knead
