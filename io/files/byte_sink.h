#pragma once

#include <string_view>

namespace knead {

/// Where bytes go one after the other: a file, or something on the way to it.
class ByteSink {
public:
    virtual ~ByteSink() = default;

    /// @throws Problem, when they cannot be taken
    virtual void write(std::string_view bytes) = 0;
};

} // namespace knead
