#pragma once

#include "core/message/message.h"

#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

/// What reads bytes of strangers, to be tried with any bytes: by libFuzzer, each target a program of its own (./dev fuzz targets), and by
/// io_fuzz_targets_test, with seeds and some changes to them.
namespace knead::fuzz {

struct Target {
    std::vector<std::string> (*seeds)(); ///< sound ones, made by our own writers

    /// @return whether the bytes were taken; a Problem is caught and says that they were not
    /// @throws anything else, which is a finding, as is whatever ends the program
    bool (*read)(std::string_view bytes);
};

/// Something came out that must not: not what was written, or what hurts who uses it.
struct Finding : std::logic_error {
    using std::logic_error::logic_error;
};

template <class Read>
bool isTaken(const Read& read)
{
    try {
        read();
        return true;
    } catch (const Problem&) {
        return false;
    }
}

/// What was taken can be written, and what was written is read and gives the same bytes again.
template <class Value, class Write, class Read>
void requireSameBack(const Value& value, const Write& write, const Read& read)
{
    try {
        const auto bytes = write(value);
        if (write(read(bytes)) != bytes)
            throw Finding("what was written is read as something else");
    } catch (const Problem& problem) {
        throw Finding(std::string("what was written is refused: ") + problem.what());
    }
}

} // namespace knead::fuzz
