#pragma once

#include <array>
#include <cstdint>
#include <cstdio>
#include <string>

namespace knead {

/// A hash as people and JSON take it: 64 bits do not fit into a JSON number, hence sixteen hexadecimal digits.
inline std::string hexadecimal(std::uint64_t number)
{
    std::array<char, 17> text{};
    std::snprintf(text.data(), text.size(), "%016llx", static_cast<unsigned long long>(number));
    return text.data();
}

} // namespace knead
