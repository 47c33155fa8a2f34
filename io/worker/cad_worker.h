#pragma once

namespace knead {

/// All that the program knead-cad-worker does: reads or writes one file for the process that started it, locked in (see
/// confineOwnProcess()).
/// @return the exit status, when it was not started that way
int workForParent(int argc, char** argv);

} // namespace knead
