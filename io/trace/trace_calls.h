#pragma once

#include "core/simulation/command.h"
#include "io/project/json_fields.h"
#include "io/trace/trace_start.h"

#include <memory>
#include <string>
#include <vector>

namespace knead {

/// What the module knead is asked to do for a command.
struct TraceCall {
    std::string result = {}; ///< the variable that holds what comes of it; empty: none
    std::string action;      ///< "ball_1.go_to"
    std::string arguments = {};
    bool isOfMany = false;   ///< such as come one after the other, many a second
    std::string before = {}; ///< whole lines that it needs
};

/// Puts commands in words of the module knead; gives names to tools and fixtures as they come. Copies go on on their own.
class TraceCalls {
public:
    explicit TraceCalls(std::shared_ptr<const TraceStart> start, python_text::Names names);

    /// @throws Problem for what only a saved project keeps
    TraceCall of(const RecordedCommand& recorded);

private:
    struct Words;
    struct Variables {
        python_text::Names names;
        std::vector<std::string> tools = {};    ///< by ToolId
        std::vector<std::string> fixtures = {}; ///< by FixtureId
    };

    std::shared_ptr<const TraceStart> m_start;
    std::shared_ptr<const Variables> m_variables; ///< those of copies, until one gives another name
    ToolPartTable m_parts;
    bool m_hasParts = false; ///< the script has them
};

} // namespace knead
