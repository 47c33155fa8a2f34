#pragma once

#include "core/document/project.h"
#include "core/document/session_trace.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <string>

namespace knead {

/// Sessions as scripts. The functions may be called from any thread and block; what they throw is a std::runtime_error with a
/// sentence for the person.
struct TraceServices {
    std::string ending; ///< of scripts: "py"

    /// What a start of a project is, to be gone on with by what was done.
    /// @param projectPath where the project was saved as it is; empty: nowhere yet
    std::function<std::unique_ptr<SessionTrace>(const Project&, std::uint32_t start, const std::string& projectPath)>
        begin;

    /// The whole script of what leads to the present entry. @param projectPath as above
    std::function<std::string(const Project&, const std::string& projectPath)> script;
};

} // namespace knead
