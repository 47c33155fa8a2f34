#include "io/fields/table_columns.h"

#include "core/model/readable_name.h"
#include "io/files/lower_case.h"

#include <algorithm>

namespace knead {

namespace {

/// Whether the rest of a heading without its axis means a place; in lower case, without blanks and signs.
constexpr std::array<std::string_view, 16> wordsForPlaces{
    "",      "coord",  "coordinate", "coordinates", "coordcoor", "coordcor", "coor",       "cor",
    "point", "points", "position",   "pos",         "location",  "loc",      "koordinate", "orig"};
constexpr std::array<std::string_view, 12> wordsForLabels{
    "node", "nodeid", "nodenumber", "nodelabel", "nodeno", "id", "label", "number", "no", "nr", "knoten", "index"};
constexpr std::array<std::string_view, 2> shortDisplacements{"d", "u"};

std::string plainWord(std::string_view heading)
{
    std::string word;
    for (const char c : lowerCase(std::string(heading)))
        if (std::isalnum(static_cast<unsigned char>(c)) != 0 || static_cast<unsigned char>(c) >= 128)
            word += c;
    return word;
}

/// A heading as a vector's name and an axis.
struct Heading {
    std::string stem; ///< "displacement", as in the file; "" of "X"
    std::size_t axis = 0;
};

std::optional<std::size_t> axisOf(char letter)
{
    if (letter >= 'x' && letter <= 'z')
        return static_cast<std::size_t>(letter - 'x');
    if (letter >= '1' && letter <= '3')
        return static_cast<std::size_t>(letter - '1');
    return {};
}

std::string_view withoutSigns(std::string_view text)
{
    constexpr std::string_view signs = " _-.:;@#\"'\t";
    while (!text.empty() && signs.find(text.back()) != signs.npos)
        text.remove_suffix(1);
    while (!text.empty() && signs.find(text.front()) != signs.npos)
        text.remove_prefix(1);
    return text;
}

/// "xx" and "xy" are components of a tensor, not of a vector.
bool endsWithAxis(std::string_view stem)
{
    return !stem.empty() &&
           axisOf(static_cast<char>(std::tolower(static_cast<unsigned char>(stem.back())))).has_value();
}

std::optional<Heading> headingOf(std::string_view text)
{
    text = withoutSigns(withoutUnit(withoutSigns(text)));
    if (text.empty())
        return {};
    const auto lower = [](char c) { return static_cast<char>(std::tolower(static_cast<unsigned char>(c))); };
    if (plainWord(text) == "u" || plainWord(text) == "v" || plainWord(text) == "w")
        return Heading{"u", static_cast<std::size_t>(lower(text.front()) - 'u')};
    if (text.size() == 2 && text.back() == '0' && axisOf(lower(text.front()))) // "X0": where it was
        return Heading{"", *axisOf(lower(text.front()))};
    // ParaView counts components from 0: "Points:0".
    if (text.size() > 2 && (text[text.size() - 2] == ':' || text[text.size() - 2] == '_') && text.back() >= '0' &&
        text.back() <= '2' && plainWord(text).starts_with("points"))
        return Heading{"", static_cast<std::size_t>(text.back() - '0')};
    if (text.size() > 2 && text[text.size() - 2] == ':' && text.back() >= '0' && text.back() <= '2')
        return Heading{std::string(withoutSigns(text.substr(0, text.size() - 2))),
                       static_cast<std::size_t>(text.back() - '0')};
    if (const auto axis = axisOf(lower(text.back()))) {
        const std::string_view raw = text.substr(0, text.size() - 1);
        if (!endsWithAxis(raw))
            return Heading{std::string(withoutSigns(raw)), *axis};
    }
    const bool isAlone = text.size() > 1 && std::isalnum(static_cast<unsigned char>(text[1])) == 0;
    if (const auto axis = axisOf(lower(text.front())); axis && isAlone)
        return Heading{std::string(withoutSigns(text.substr(1))), *axis};
    return {};
}

bool isAmong(const auto& words, const std::string& word)
{
    return std::ranges::find(words, word) != words.end();
}

/// "u" of "U.U1".
std::string nameOf(const std::string& stem)
{
    const std::string plain = plainWord(stem);
    if (plain.size() == 2 && plain[0] == plain[1])
        return std::string(1, stem.front());
    return isAmong(shortDisplacements, plain) ? "displacement" : stem;
}

/// One vector while its columns are looked for.
struct Candidate {
    VectorColumns vector;
    std::array<bool, 3> has{};
    bool isWhole() const { return has[0] && has[1] && has[2]; }
};

Candidate& candidateOf(std::vector<std::pair<std::string, Candidate>>& candidates, const std::string& stem)
{
    const std::string key = plainWord(stem);
    const auto found = std::ranges::find(candidates, key, &std::pair<std::string, Candidate>::first);
    if (found != candidates.end())
        return found->second;
    candidates.emplace_back(key, Candidate{});
    candidates.back().second.vector.name = readableName(stem);
    return candidates.back().second;
}

} // namespace

std::optional<TableColumns> columnsNamed(const std::vector<std::string>& headings)
{
    TableColumns result;
    std::vector<std::pair<std::string, Candidate>> candidates;
    for (std::size_t column = 0; column < headings.size(); ++column) {
        if (!result.label && isAmong(wordsForLabels, plainWord(withoutUnit(headings[column])))) {
            result.label = column;
            continue;
        }
        const auto heading = headingOf(headings[column]);
        if (!heading)
            continue;
        Candidate& candidate = candidateOf(candidates, heading->stem);
        if (candidate.has[heading->axis])
            continue;
        candidate.has[heading->axis] = true;
        candidate.vector.columns[heading->axis] = column;
        if (candidate.vector.unit.empty())
            candidate.vector.unit = unitIn(headings[column]);
    }
    bool hasNodes = false;
    for (auto& [key, candidate] : candidates) {
        if (!candidate.isWhole())
            continue;
        if (!isAmong(wordsForPlaces, key)) {
            candidate.vector.name = nameOf(candidate.vector.name);
            result.vectors.push_back(candidate.vector);
        } else if (!hasNodes) {
            result.nodes = candidate.vector;
            hasNodes = true;
        }
    }
    return hasNodes ? std::optional(result) : std::nullopt;
}

std::optional<TableColumns> columnsCounted(std::size_t count, bool isFirstWhole)
{
    TableColumns result;
    const bool hasLabel = (count == 4 || count == 7) && isFirstWhole;
    const std::size_t first = hasLabel ? 1 : 0;
    if (count - first != 3 && count - first != 6)
        return {};
    if (hasLabel)
        result.label = 0;
    result.nodes = {"", "", {first, first + 1, first + 2}};
    if (count - first == 6)
        result.vectors = {{"displacement", "", {first + 3, first + 4, first + 5}}};
    return result;
}

} // namespace knead
