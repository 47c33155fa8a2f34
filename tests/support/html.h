#pragma once

#include <string>

namespace knead {

/// Text as it stands in a page.
inline std::string escaped(const std::string& text)
{
    std::string result;
    for (const char c : text)
        result += c == '<' ? "&lt;" : c == '>' ? "&gt;" : c == '&' ? "&amp;" : c == '\'' ? "&#39;" : std::string(1, c);
    return result;
}

} // namespace knead
