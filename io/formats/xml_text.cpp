#include "io/formats/xml_text.h"

namespace knead {

std::string xmlText(std::string_view text)
{
    std::string result;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char c = text[i];
        const std::string_view letter = text.substr(i, 3);
        if (letter == "\xEF\xBF\xBE" || letter == "\xEF\xBF\xBF") // U+FFFE and U+FFFF
            i += 2;
        else if (c == '&')
            result += "&amp;";
        else if (c == '<')
            result += "&lt;";
        else if (c == '>')
            result += "&gt;";
        else if (c == '"')
            result += "&quot;";
        else if (static_cast<unsigned char>(c) >= ' ')
            result += c;
    }
    return result;
}

} // namespace knead
