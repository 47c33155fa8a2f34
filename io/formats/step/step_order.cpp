#include "io/formats/step/step_order.h"

#include <algorithm>
#include <cctype>
#include <map>
#include <string_view>
#include <vector>

namespace knead {

namespace {

constexpr std::string_view firstStyle = "= MECHANICAL_DESIGN_GEOMETRIC_PRESENTATION_REPRESENTATION(";
constexpr std::size_t stepLineLength = 72;

using Number = unsigned long;

/// What an entity is, without its number; references are apart from the texts around them.
struct Entity {
    std::vector<std::string> texts; ///< one more than references; without line breaks, but for those in quotes
    std::vector<Number> references;
};

using Entities = std::map<Number, Entity>; ///< in the order of the file

bool isDigit(char c)
{
    return std::isdigit(static_cast<unsigned char>(c)) != 0;
}

/// Goes through the entities of a text, "#7 = NAME(...);" each.
class Parser {
public:
    explicit Parser(std::string_view text)
        : m_text(text)
    {
    }

    Entities parse()
    {
        Entities entities;
        while (m_at < m_text.size()) {
            if (m_text[m_at] != '#') {
                ++m_at;
                continue;
            }
            const Number number = readNumber();
            m_at = std::min(m_text.find('=', m_at), m_text.size() - 1) + 1;
            entities[number] = readEntity();
        }
        return entities;
    }

private:
    /// @pre at a '#'
    Number readNumber()
    {
        Number number = 0;
        for (++m_at; m_at < m_text.size() && isDigit(m_text[m_at]); ++m_at)
            number = 10 * number + static_cast<Number>(m_text[m_at] - '0');
        return number;
    }

    Entity readEntity()
    {
        Entity entity{{""}, {}};
        bool inQuotes = false;
        bool isNewLine = false;
        while (m_at < m_text.size()) {
            const char c = m_text[m_at];
            if (c == '#' && !inQuotes) {
                entity.references.push_back(readNumber());
                entity.texts.emplace_back();
                continue;
            }
            ++m_at;
            if (!inQuotes && c == ';')
                break;
            inQuotes = inQuotes != (c == '\'');
            isNewLine = !inQuotes && (c == '\n' || (isNewLine && c == ' '));
            if (!isNewLine)
                entity.texts.back() += c;
        }
        return entity;
    }

    std::string_view m_text;
    std::size_t m_at = 0;
};

/// Numbers entities anew: each that no other refers to, and then what it refers to, as OpenCASCADE does.
class Renumbering {
public:
    explicit Renumbering(const Entities& entities)
        : m_entities(entities)
        , m_next(entities.empty() ? 0 : entities.begin()->first)
    {
        for (const Number root : roots())
            visit(root);
    }

    std::string text() const
    {
        std::string text;
        for (const Number number : m_order)
            append(text, number);
        return text;
    }

private:
    /// In the order of what they say, apart from the numbers that change.
    std::vector<Number> roots() const
    {
        std::map<Number, bool> isReferredTo;
        for (const auto& [number, entity] : m_entities)
            for (const Number reference : entity.references)
                isReferredTo[reference] = true;
        std::multimap<std::string, Number> sorted;
        for (const auto& [number, entity] : m_entities)
            if (!isReferredTo[number])
                sorted.emplace(keyOf(entity), number);
        std::vector<Number> all;
        for (const auto& [key, number] : sorted)
            all.push_back(number);
        return all;
    }

    std::string keyOf(const Entity& entity) const
    {
        std::string key = entity.texts[0].substr(0, entity.texts[0].find('('));
        for (const Number reference : entity.references)
            if (!m_entities.contains(reference)) {
                const std::string digits = std::to_string(reference);
                key += std::string(20 - std::min<std::size_t>(digits.size(), 20), ' ') + digits;
            }
        for (const std::string& text : entity.texts)
            key += text;
        return key;
    }

    void visit(Number number)
    {
        const auto found = m_entities.find(number);
        if (found == m_entities.end() || !m_numbers.try_emplace(number, m_next).second)
            return;
        ++m_next;
        m_order.push_back(number);
        for (const Number reference : found->second.references)
            visit(reference);
    }

    Number numberOf(Number old) const
    {
        const auto found = m_numbers.find(old);
        return found == m_numbers.end() ? old : found->second;
    }

    void append(std::string& text, Number number) const
    {
        const Entity& entity = m_entities.at(number);
        std::string line = '#' + std::to_string(numberOf(number));
        line += " =" + entity.texts[0];
        for (std::size_t i = 0; i < entity.references.size(); ++i) {
            if (line.size() > stepLineLength) {
                text += line + "\n";
                line = "  ";
            }
            line += '#' + std::to_string(numberOf(entity.references[i]));
            line += entity.texts[i + 1];
        }
        text += line + ";\n";
    }

    const Entities& m_entities;
    std::map<Number, Number> m_numbers; ///< old and new
    std::vector<Number> m_order;
    Number m_next;
};

} // namespace

std::string withStylesInOrder(const std::string& step)
{
    const std::size_t style = step.find(firstStyle);
    const std::size_t begin = style == std::string::npos ? style : step.rfind('#', style);
    const std::size_t end = step.rfind("ENDSEC;");
    if (begin == std::string::npos || end == std::string::npos || begin > end)
        return step;
    const Entities entities = Parser(std::string_view(step).substr(begin, end - begin)).parse();
    return step.substr(0, begin) + Renumbering(entities).text() + step.substr(end);
}

} // namespace knead
