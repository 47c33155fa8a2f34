#pragma once

#include "example_parts.h"

#include <string>
#include <vector>

/// Writes bodies as STEP AP214 in millimetres, with names and colors. The same bodies give the same bytes.
/// @throws std::runtime_error
void writeStepFile(const std::string& path, const std::string& name, const std::vector<ExampleBody>& bodies);
