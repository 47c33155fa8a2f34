#pragma once

#include "core/document/byte_stream.h"
#include "core/document/project.h"
#include "io/project/command_json.h"

#include <algorithm>
#include <cstdint>
#include <string>

/// Whole projects as numbers that processes can tell each other.
namespace knead::digests {

/// What was done: commands and where they led, but not whether the moment is kept.
inline void write(ByteWriter& bytes, const HistoryRecord& entry)
{
    ToolPartTable tools;
    bytes(entry.parent);
    bytes(entry.start);
    bytes(entry.name);
    bytes(entry.wallTime);
    bytes(commandsToJson(entry.commands, tools));
    bytes(entry.step);
    bytes(entry.time);
    bytes(entry.hash);
    bytes(entry.isKey);
}

inline std::uint64_t of(const HistoryRecord& entry)
{
    ByteWriter bytes;
    write(bytes, entry);
    return checksumOf(bytes.take());
}

/// The history with its moments, and what else changes while one works; what was imported apart.
inline std::uint64_t of(const Project& project)
{
    ByteWriter bytes;
    for (const HistoryRecord& entry : project.entries) {
        write(bytes, entry);
        bytes(entry.moment ? checksumOf(*entry.moment) : 0);
    }
    bytes(project.current);
    bytes(static_cast<std::uint64_t>(project.starts.size()));
    for (const ProjectMark& mark : project.marks) {
        bytes(mark.entry);
        bytes(mark.text);
    }
    for (const auto& [name, json] : project.panels) {
        bytes(name);
        bytes(json);
    }
    bytes(checksumOf(project.view.thumbnail));
    return checksumOf(bytes.take());
}

/// Whether one history is the beginning of the other.
inline bool beginAlike(const Project& a, const Project& b)
{
    const auto isSame = [](const HistoryRecord& one, const HistoryRecord& other) { return of(one) == of(other); };
    const auto count = static_cast<std::ptrdiff_t>(std::min(a.entries.size(), b.entries.size()));
    return std::equal(a.entries.begin(), a.entries.begin() + count, b.entries.begin(), isSame);
}

} // namespace knead::digests
