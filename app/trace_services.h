#pragma once

#include "ui/project/trace_services.h"

#include <cstdint>
#include <string>

namespace knead {

/// For the window.
TraceServices traceServices();

/// What leads to an entry of a project as a script for Python, which says at its end what state it came to, and what state the
/// session was in.
/// @param projectPath where the project was saved; empty: nowhere yet
/// @throws Problem when a script cannot say it
std::string traceScript(const Project& project, std::uint32_t entry, const std::string& projectPath);

} // namespace knead
