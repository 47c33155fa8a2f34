#pragma once

#include "core/simulation/command.h"
#include "io/project/json_fields.h"

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace knead {

/// Commands as a JSON list, one on a line, with the step before which each takes effect:
///
///     [{"step": 12, "command": "set-gravity", "gravity_m_s2": [0, 0, -9.81]},
///     {"step": 40, "command": "remove-fixture", "fixture": 0}]
///
/// Numbers are SI and come back with the same bits. Tool parts are numbers of the table, which gets those that it lacks.
std::string commandsToJson(std::span<const RecordedCommand> commands, ToolPartTable& tools);

/// The other way. What simulations check themselves is not checked here: materials out of range, tools that do not exist.
/// @param source what messages call the text
/// @param longList elements that lists of objects may have together; counts down
/// @throws Problem "SOURCE: [3].gravity_m_s2 must hold 3 numbers, got 7.", or with line and column where the text
///         is no JSON
std::vector<RecordedCommand> commandsFromJson(const std::string& text, const std::string& source,
                                              const ToolPartTable& tools, std::size_t& longList);

/// One command alone, without a step: {"command": "remove-fixture", "fixture": 0}. Tool parts as above.
std::string commandToJson(const Command& command, ToolPartTable& tools);
/// @throws as commandsFromJson()
Command commandFromJson(const std::string& text, const std::string& source, const ToolPartTable& tools,
                        std::size_t& longList);

} // namespace knead
