#pragma once

#include "ui/services.h"

#include <string>
#include <vector>

namespace knead {

/// Sets what must be set before an application object exists: the surface format of the view. Tests call it too.
void prepareGraphics();

/// Shows the main window and runs it until it is closed.
/// Where nothing can be drawn, it says so in a box and on stderr instead.
/// @param files the first is opened; the window holds one document
/// @return the exit code of the program
int showMainWindow(int argc, char** argv, Services services, const std::vector<std::string>& files);

} // namespace knead
