#pragma once

#include "support/byte_mutation.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

/// Damage to IGES files (version 5.3) that only a reader of entities notices.
namespace knead::fuzz {

inline constexpr std::size_t igesColumns = 80;
inline constexpr std::size_t igesSectionColumn = 72; // S, G, D, P or T, counted from 0
inline constexpr std::size_t igesValueColumns = 64;  // of a P line
inline constexpr std::size_t igesFieldColumns = 8;   // of a D line

struct IgesEntity {
    std::array<std::string, 2> directory; ///< columns 1 to 72 of both lines
    std::string values;                   ///< "110,0.,0.,0.,1.,0.,0.;"
};

/// An IGES file cut into entities.
struct IgesText {
    std::string start;  ///< lines of the sections S and G as they are
    std::string global; ///< how many lines each has, as the T line says it: "S      1G      4"
    std::vector<IgesEntity> entities;

    std::string text() const;
};

inline std::string igesLine(std::string columns, char section, std::size_t number)
{
    std::array<char, 16> end{};
    std::snprintf(end.data(), end.size(), "%c%07zu", section, number);
    columns.resize(igesSectionColumn, ' ');
    return columns + end.data() + "\n";
}

inline std::string inField(std::string word)
{
    return word.size() >= igesFieldColumns ? word.substr(0, igesFieldColumns)
                                           : std::string(igesFieldColumns - word.size(), ' ') + word;
}

/// Values on lines, cut after commas where there are some.
inline std::vector<std::string> valueLines(std::string_view values)
{
    std::vector<std::string> lines;
    while (values.size() > igesValueColumns) {
        const std::size_t comma = values.substr(0, igesValueColumns).rfind(',');
        const std::size_t length = comma == values.npos ? igesValueColumns : comma + 1;
        lines.emplace_back(values.substr(0, length));
        values.remove_prefix(length);
    }
    lines.emplace_back(values);
    return lines;
}

/// With lines counted anew, so that only what was changed is wrong.
inline std::string IgesText::text() const
{
    std::string directory;
    std::string parameters;
    std::size_t count = 0;
    for (std::size_t i = 0; i < entities.size(); ++i) {
        const std::vector<std::string> lines = valueLines(entities[i].values);
        std::array<std::string, 2> own = entities[i].directory;
        own[0].replace(igesFieldColumns, igesFieldColumns, inField(std::to_string(count + 1)));
        own[1].replace(3 * igesFieldColumns, igesFieldColumns, inField(std::to_string(lines.size())));
        directory += igesLine(own[0], 'D', 2 * i + 1) + igesLine(own[1], 'D', 2 * i + 2);
        for (std::string line : lines) {
            line.resize(igesValueColumns, ' ');
            parameters += igesLine(line + inField(std::to_string(2 * i + 1)), 'P', ++count);
        }
    }
    std::array<char, 40> counts{};
    std::snprintf(counts.data(), counts.size(), "D%7zuP%7zu", 2 * entities.size(), count);
    return start + directory + parameters + igesLine(global + counts.data(), 'T', 1);
}

inline IgesText parsedIges(const std::string& text)
{
    IgesText result;
    std::map<std::size_t, std::string> values; // by the number of the directory line
    std::array<std::size_t, 2> counts{};
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
        if (line.size() < igesColumns)
            continue;
        const std::string columns = line.substr(0, igesSectionColumn);
        switch (line[igesSectionColumn]) {
        case 'S':
        case 'G':
            result.start += line + "\n";
            ++counts[line[igesSectionColumn] == 'S' ? 0 : 1];
            break;
        case 'D':
            if (result.entities.empty() || !result.entities.back().directory[1].empty())
                result.entities.push_back({{columns, ""}, ""});
            else
                result.entities.back().directory[1] = columns;
            break;
        case 'P': {
            std::string content = columns.substr(0, igesValueColumns);
            content.resize(content.find_last_not_of(' ') + 1);
            values[std::strtoul(columns.c_str() + igesValueColumns, nullptr, 10)] += content;
            break;
        }
        default:
            break;
        }
    }
    for (std::size_t i = 0; i < result.entities.size(); ++i) {
        result.entities[i].values = values[2 * i + 1];
        result.entities[i].directory[1].resize(igesSectionColumn, ' ');
    }
    std::array<char, 40> terminate{};
    std::snprintf(terminate.data(), terminate.size(), "S%7zuG%7zu", counts[0], counts[1]);
    result.global = terminate.data();
    return result;
}

namespace iges {

inline std::vector<Span> valuesIn(std::string_view values)
{
    std::vector<Span> result;
    std::size_t begin = 0;
    for (std::size_t i = 0; i < values.size(); ++i)
        if (values[i] == ',' || values[i] == ';') {
            result.push_back({begin, i - begin});
            begin = i + 1;
        }
    return result;
}

/// A pointer, a count, a coordinate, the type: whatever stands there.
inline void changeValue(IgesText& iges, Random& random)
{
    IgesEntity& entity = random.oneOf(iges.entities);
    const std::vector<Span> places = valuesIn(entity.values);
    if (places.empty())
        return;
    // Types, counts and pointers stand first; after them come many coordinates.
    const Span place =
        places[random.chance(60) ? random.below(std::min<std::size_t>(places.size(), 6)) : random.below(places.size())];
    const std::string before = entity.values.substr(place.begin, place.length);
    const std::string pointer = std::to_string(2 * random.below(iges.entities.size()) + 1);
    std::string after;
    switch (random.below(6)) {
    case 0:
        after = pointer;
        break;
    case 1:
        after = "-" + pointer;
        break;
    case 2: // an even number is no entity
        after = std::to_string(2 * random.below(2 * iges.entities.size()));
        break;
    case 3:
        after = random.chance(50) ? "" : "3Habc";
        break;
    default:
        after = before.empty() ? "1" : changedNumber(before, random);
    }
    entity.values.replace(place.begin, place.length, after);
}

inline void dropOrRepeatValue(IgesText& iges, Random& random)
{
    IgesEntity& entity = random.oneOf(iges.entities);
    const std::vector<Span> places = valuesIn(entity.values);
    if (places.size() < 2)
        return;
    const Span place = places[random.below(places.size() - 1)];
    const std::string value = entity.values.substr(place.begin, place.length + 1);
    if (random.chance(50))
        entity.values.erase(place.begin, place.length + 1);
    else
        for (std::size_t i = random.chance(80) ? 1 : random.below(300); i > 0; --i)
            entity.values.insert(place.begin, value);
}

inline void cutValues(IgesText& iges, Random& random)
{
    std::string& values = random.oneOf(iges.entities).values;
    values.resize(random.below(values.size() + 1));
    if (random.chance(50))
        values += ";";
}

inline void swapValues(IgesText& iges, Random& random)
{
    std::swap(random.oneOf(iges.entities).values, random.oneOf(iges.entities).values);
}

inline void deleteEntity(IgesText& iges, Random& random)
{
    iges.entities.erase(iges.entities.begin() + static_cast<std::ptrdiff_t>(random.below(iges.entities.size())));
}

/// An entity that refers to itself in place of another.
inline void pointToSelf(IgesText& iges, Random& random)
{
    const std::size_t index = random.below(iges.entities.size());
    std::string& values = iges.entities[index].values;
    const std::vector<Span> places = valuesIn(values);
    if (places.size() < 2)
        return;
    const Span place = places[1 + random.below(places.size() - 1)];
    values.replace(place.begin, place.length, std::to_string(2 * index + 1));
}

/// Type, structure, line font, level, view, transformation, label, status, color, form ...
inline void changeDirectory(IgesText& iges, Random& random)
{
    static constexpr std::array<std::string_view, 22> words{
        "0",   "1",   "-1",  "3",   "100", "102", "106",      "108",      "110", "116", "120",
        "124", "126", "128", "142", "144", "186", "99999999", "-9999999", "x",   "",    "514"};
    std::string& line = random.oneOf(iges.entities).directory[random.below(2)];
    const std::size_t place = igesFieldColumns * random.below(igesSectionColumn / igesFieldColumns);
    const std::string pointer = std::to_string(2 * random.below(iges.entities.size()) + 1);
    const std::string& donor = random.oneOf(iges.entities).directory[random.below(2)];
    line.replace(place, igesFieldColumns,
                 random.chance(40)   ? donor.substr(place, igesFieldColumns)
                 : random.chance(50) ? inField((random.chance(50) ? "-" : "") + pointer)
                                     : inField(std::string(random.oneOf(words))));
}

/// Counts of letters before H, in the section of the file's own facts or in an entity.
inline void changeTextLength(std::string& text, Random& random)
{
    std::vector<Span> lengths;
    for (const Span& number : numbersIn(text))
        if (const std::size_t end = number.begin + number.length; end < text.size() && text[end] == 'H')
            lengths.push_back(number);
    // "4HUNIT" is one word to numbersIn(), so digits before H are looked for too.
    for (std::size_t i = 1; i < text.size(); ++i)
        if (text[i] == 'H' && std::isdigit(static_cast<unsigned char>(text[i - 1])) != 0)
            lengths.push_back({i - 1, 1});
    if (lengths.empty())
        return;
    static constexpr std::array<std::string_view, 7> words{"0", "1", "9", "99", "-1", "99999", "99999999999"};
    const Span place = random.oneOf(lengths);
    const std::string_view word = random.oneOf(words);
    text.replace(place.begin, random.chance(70) ? std::min(word.size(), text.size() - place.begin) : place.length,
                 word);
}

/// Section letters, sequence numbers, pointers back, line lengths.
inline void changeColumns(std::string& text, Random& random)
{
    const Span line = lineAt(text, random.below(text.size()));
    if (line.length <= igesSectionColumn)
        return;
    static constexpr std::string_view letters = "SGDPTC x";
    const std::size_t place = line.begin + random.below(line.length);
    const std::size_t width = 1 + random.below(20);
    switch (random.below(5)) {
    case 0:
        text[line.begin + igesSectionColumn] = letters[random.below(letters.size())];
        break;
    case 1:
        text.replace(line.begin + igesSectionColumn + 1, std::min<std::size_t>(7, line.length - igesSectionColumn - 1),
                     inField(std::to_string(random.below(1000))).substr(1));
        break;
    case 2:
        text.replace(line.begin + igesValueColumns, igesFieldColumns, inField(std::to_string(random.below(200))));
        break;
    case 3:
        text.erase(place, width);
        break;
    default:
        text.insert(place, std::string(width, ' '));
    }
}

} // namespace iges

/// Changes one thing of an IGES text. @param other is what entities may be taken from
inline void mutateIges(std::string& text, const std::string& other, Random& random)
{
    if (text.empty() || random.chance(5))
        return mutateText(text, random);
    if (random.chance(2)) {
        text.resize(random.below(text.size()));
        return;
    }
    if (random.chance(5))
        return iges::changeTextLength(text, random);
    if (random.chance(10))
        return iges::changeColumns(text, random);
    IgesText parsed = parsedIges(text);
    const IgesText donor = parsedIges(other);
    if (parsed.entities.empty() || donor.entities.empty())
        return mutateText(text, random);
    using Mutation = void (*)(IgesText&, Random&);
    static constexpr std::array<Mutation, 11> mutations{
        iges::changeValue,     iges::changeValue,     iges::changeValue,  iges::changeValue,
        iges::changeDirectory, iges::changeDirectory, iges::pointToSelf,  iges::dropOrRepeatValue,
        iges::cutValues,       iges::swapValues,      iges::deleteEntity,
    };
    if (random.chance(4))
        random.oneOf(parsed.entities).values = donor.entities[random.below(donor.entities.size())].values;
    else
        random.oneOf(mutations)(parsed, random);
    text = parsed.text();
}

} // namespace knead::fuzz
