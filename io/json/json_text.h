#pragma once

#include "core/geometry/vec3.h"

#include <cstdint>
#include <string>
#include <vector>

namespace knead {

// What keeps its bits, or is read by people, is written as JSON here. Reports, and what processes tell each other, are values of
// nlohmann::json.

/// A text as JSON; what is no UTF-8 becomes what can be read.
std::string quoted(const std::string& text);

/// "[a, b]" of what `textOf` makes of each item.
template <class Items, class TextOf>
std::string listText(const Items& items, TextOf textOf)
{
    std::string text;
    for (const auto& item : items)
        text += (text.empty() ? "" : ", ") + textOf(item);
    return '[' + text + ']';
}

/// A whole number, for lists.
inline constexpr auto wholeText = [](auto number) { return std::to_string(number); };

/// Ascending numbers with stretches as pairs of their first and last: "[3, [7, 420]]".
std::string stretchesText(const std::vector<std::uint32_t>& numbers);

/// A JSON object on one line, piece by piece. Numbers keep their bits.
class ObjectText {
public:
    ObjectText& put(const std::string& key, const std::string& json);
    ObjectText& text(const std::string& key, const std::string& value) { return put(key, quoted(value)); }
    ObjectText& number(const std::string& key, double value);
    ObjectText& numbers(const std::string& key, const Vec3& value);
    ObjectText& numbers(const std::string& key, const Quaternion& value); ///< w, x, y, z

    bool isEmpty() const { return m_text.empty(); }
    std::string take() const { return "{" + m_text + "}"; }

private:
    std::string m_text;
};

/// A JSON file that people read: a key on each line, and an item on each line of a list.
class PageText {
public:
    PageText& put(const std::string& key, const std::string& json);
    PageText& list(const std::string& key, const std::vector<std::string>& items);

    std::string take() const { return "{\n" + m_text + "\n}\n"; }

private:
    std::string m_text;
};

} // namespace knead
