#pragma once

#include "ui/services.h"

#include <string>
#include <vector>

namespace knead {

/// The functions of io as the window wants them.
/// @throws std::runtime_error when the resources folder is missing or its materials cannot be read
Services fileServices();

/// Opens the window and runs it until it is closed.
/// @param files from the command line; the window opens them together
/// @return the exit code of the program
/// @throws std::runtime_error as fileServices
int runWindow(int argc, char** argv, const std::vector<std::string>& files);

} // namespace knead
