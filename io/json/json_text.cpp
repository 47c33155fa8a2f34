#include "io/json/json_text.h"

#include "io/json/exact_number.h"

#include <nlohmann/json.hpp>

#include <array>
#include <limits>

namespace knead {

std::string quoted(const std::string& text)
{
    return nlohmann::json(text).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

std::string stretchesText(const std::vector<std::uint32_t>& numbers)
{
    std::string text;
    for (std::size_t begin = 0; begin < numbers.size();) {
        std::size_t end = begin + 1;
        while (end < numbers.size() && numbers[end - 1] != std::numeric_limits<std::uint32_t>::max() &&
               numbers[end] == numbers[end - 1] + 1)
            ++end;
        const std::string first = std::to_string(numbers[begin]);
        text += text.empty() ? "" : ", ";
        text += end - begin > 1 ? '[' + first + ", " + std::to_string(numbers[end - 1]) + ']' : first;
        begin = end;
    }
    return '[' + text + ']';
}

ObjectText& ObjectText::put(const std::string& key, const std::string& json)
{
    m_text += m_text.empty() ? "\"" : ", \"";
    m_text += key + "\": " + json;
    return *this;
}

ObjectText& ObjectText::number(const std::string& key, double value)
{
    return put(key, exactText(value));
}

ObjectText& ObjectText::numbers(const std::string& key, const Vec3& value)
{
    return put(key, listText(std::array{value.x(), value.y(), value.z()}, exactText));
}

ObjectText& ObjectText::numbers(const std::string& key, const Quaternion& value)
{
    return put(key, listText(std::array{value.w(), value.x(), value.y(), value.z()}, exactText));
}

PageText& PageText::put(const std::string& key, const std::string& json)
{
    m_text += m_text.empty() ? "  \"" : ",\n  \"";
    m_text += key + "\": " + json;
    return *this;
}

PageText& PageText::list(const std::string& key, const std::vector<std::string>& items)
{
    std::string text = "[";
    for (const std::string& item : items)
        text += (&item == items.data() ? "\n    " : ",\n    ") + item;
    return put(key, text + "\n  ]");
}

} // namespace knead
