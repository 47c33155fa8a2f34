#pragma once

#include <algorithm>
#include <cctype>
#include <string>

namespace knead {

/// Of the letters A to Z; others stay as they are.
inline std::string lowerCase(std::string text)
{
    std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return std::tolower(c); });
    return text;
}

} // namespace knead
