#pragma once

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstring>
#include <string_view>

namespace knead {

/// The number whose bytes stand at a place. @pre they are there
template <typename Number>
Number numberAt(std::string_view bytes, std::size_t place, std::endian order = std::endian::little)
{
    char raw[sizeof(Number)];
    std::memcpy(raw, bytes.data() + place, sizeof raw);
    if (order != std::endian::native)
        std::reverse(raw, raw + sizeof raw);
    Number number;
    std::memcpy(&number, raw, sizeof raw);
    return number;
}

} // namespace knead
