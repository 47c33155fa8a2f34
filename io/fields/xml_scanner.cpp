#include "io/fields/xml_scanner.h"

#include <algorithm>
#include <array>
#include <utility>

namespace knead {

namespace {

constexpr std::string_view xmlBlanks = " \t\r\n";

/// Where the text goes on behind `mark`; the end where it is missing.
std::size_t behind(std::string_view text, std::string_view mark, std::size_t from)
{
    const std::size_t found = text.find(mark, from);
    return found == text.npos ? text.size() : found + mark.size();
}

std::string withoutEntities(std::string_view text)
{
    static constexpr std::array<std::pair<std::string_view, char>, 5> entities{
        {{"&lt;", '<'}, {"&gt;", '>'}, {"&quot;", '"'}, {"&apos;", '\''}, {"&amp;", '&'}}};
    std::string result;
    while (!text.empty()) {
        const auto entity =
            std::ranges::find_if(entities, [&](const auto& one) { return text.starts_with(one.first); });
        result += entity == entities.end() ? text.front() : entity->second;
        text.remove_prefix(entity == entities.end() ? 1 : entity->first.size());
    }
    return result;
}

} // namespace

std::string XmlTag::attribute(std::string_view wanted) const
{
    std::string_view rest = attributes;
    while (true) {
        rest.remove_prefix(std::min(rest.find_first_not_of(xmlBlanks), rest.size()));
        const std::size_t equals = rest.find('=');
        if (equals == rest.npos)
            return {};
        std::string_view key = rest.substr(0, equals);
        key = key.substr(0, key.find_last_not_of(xmlBlanks) + 1);
        rest.remove_prefix(equals + 1);
        rest.remove_prefix(std::min(rest.find_first_not_of(xmlBlanks), rest.size()));
        if (rest.empty() || (rest.front() != '"' && rest.front() != '\''))
            return {};
        const std::size_t end = rest.find(rest.front(), 1);
        if (end == rest.npos)
            return {};
        if (key == wanted)
            return withoutEntities(rest.substr(1, end - 1));
        rest.remove_prefix(end + 1);
    }
}

std::optional<XmlTag> XmlScanner::next()
{
    while (true) {
        const std::size_t begin = m_text.find('<', m_at);
        if (begin == m_text.npos)
            return {};
        const std::string_view text = m_text.substr(begin);
        if (text.starts_with("<!--")) {
            m_at = behind(m_text, "-->", begin + 4);
            continue;
        }
        const std::size_t end = text.find('>');
        if (end == text.npos)
            return {};
        m_at = begin + end + 1;
        if (text.starts_with("<?") || text.starts_with("<!"))
            continue;
        std::string_view inside = text.substr(1, end - 1);
        XmlTag tag;
        tag.isEnd = inside.starts_with('/');
        tag.isClosed = inside.ends_with('/');
        inside.remove_prefix(tag.isEnd ? 1 : 0);
        inside.remove_suffix(tag.isClosed && !inside.empty() ? 1 : 0);
        const std::size_t nameEnd = std::min(inside.find_first_of(xmlBlanks), inside.size());
        tag.name = inside.substr(0, nameEnd);
        tag.attributes = inside.substr(nameEnd);
        return tag;
    }
}

std::string_view XmlScanner::textHere() const
{
    return m_text.substr(m_at, std::min(m_text.find('<', m_at), m_text.size()) - m_at);
}

} // namespace knead
