#pragma once

#include "support/fuzz_random.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <vector>

/// Damage to files of any format, and to texts of numbers and lines.
namespace knead::fuzz {

/// A place in a text.
struct Span {
    std::size_t begin = 0;
    std::size_t length = 0;
};

inline constexpr std::array<std::string_view, 28> oddNumbers{
    "0",       "0.",    "-0.",    "-1",    "-1.",        "1",           "2",
    "3",       "1e308", "-1e308", "1e400", "1e-300",     "1e-9",        "1e5",
    "1e9",     "1e30",  "nan",    "NaN",   "inf",        "-Infinity",   "1.#INF",
    "1.#QNAN", "65536", "1e",     "--5",   "2147483647", "-2147483648", "99999999999999999999",
};

inline std::string changedNumber(std::string_view word, Random& random)
{
    const std::string text(word);
    switch (random.below(7)) {
    case 0:
        return text.starts_with('-') ? text.substr(1) : "-" + text;
    case 1:
        return text + "000";
    case 2: {
        const char digit = static_cast<char>('0' + random.below(10));
        return text + std::string(1 + random.below(60), digit);
    }
    case 3: // one more or less, or another last digit
        return text.substr(0, text.size() - 1) + static_cast<char>('0' + random.below(10));
    case 4:
        return std::to_string(random.below(100));
    default:
        return std::string(random.oneOf(oddNumbers));
    }
}

/// Words that are numbers, as most text formats write them.
inline std::vector<Span> numbersIn(std::string_view text)
{
    const auto isPart = [](char c) {
        return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '.' || c == '-' || c == '+' || c == '_' ||
               c == '#';
    };
    std::vector<Span> result;
    for (std::size_t begin = 0; begin < text.size();) {
        std::size_t end = begin;
        while (end < text.size() && isPart(text[end]))
            ++end;
        const std::string_view word = text.substr(begin, end - begin);
        if (!word.empty() && word.find_first_not_of("0123456789.+-eE") == word.npos &&
            word.find_first_of("0123456789") != word.npos)
            result.push_back({begin, word.size()});
        begin = std::max(end, begin + 1);
    }
    return result;
}

inline void changeNumber(std::string& text, Random& random)
{
    const std::vector<Span> numbers = numbersIn(text);
    if (numbers.empty())
        return;
    const Span place = random.oneOf(numbers);
    text.replace(place.begin, place.length,
                 changedNumber(std::string_view(text).substr(place.begin, place.length), random));
}

inline Span someBlock(const std::string& bytes, Random& random)
{
    const std::size_t begin = random.below(bytes.size());
    const std::size_t longest = random.chance(80) ? 64 : bytes.size();
    return {begin, std::min(1 + random.below(longest), bytes.size() - begin)};
}

/// One of the numbers that lengths, counts and coordinates of binary formats go wrong by, least byte first.
inline std::string oddFourBytes(Random& random)
{
    static constexpr std::array<std::uint32_t, 14> numbers{
        0,          1,          2,          255,        65'535,     65'536,     0x7FFFFFFF, 0x80000000,
        0xFFFFFFFF, 0x7F800000, 0x7FC00000, 0xFF7FFFFF, 0x00000001, 0x501502F9, // infinity, no number, -3e38, 1e-45, 1e10
    };
    const std::uint32_t number = random.chance(80) ? random.oneOf(numbers) : static_cast<std::uint32_t>(random.next());
    std::string bytes;
    for (unsigned i = 0; i < 4; ++i)
        bytes += static_cast<char>(number >> (8 * i) & 0xFFU);
    return bytes;
}

/// Changes one thing, of any kind.
inline void mutateBytes(std::string& bytes, Random& random)
{
    if (bytes.empty())
        return;
    const std::size_t place = random.below(bytes.size());
    const Span block = someBlock(bytes, random);
    const std::string content = bytes.substr(block.begin, block.length);
    const auto anyByte = [&] {
        return random.chance(50) ? static_cast<char>(random.chance(50) ? 0 : 255) : static_cast<char>(random.next());
    };
    switch (random.below(9)) {
    case 0:
        bytes[place] = static_cast<char>(static_cast<unsigned char>(bytes[place]) ^ (1U << random.below(8)));
        break;
    case 1:
        bytes[place] = anyByte();
        break;
    case 2: {
        const char byte = anyByte();
        bytes.insert(place, 1 + random.below(64), byte);
        break;
    }
    case 3:
        bytes.erase(block.begin, block.length);
        break;
    case 4:
        bytes.insert(place, content);
        break;
    case 5:
        bytes.replace(place, std::min(block.length, bytes.size() - place), content);
        break;
    case 6:
        bytes.resize(place);
        break;
    default: {
        const std::string number = oddFourBytes(random);
        bytes.replace(place, std::min(number.size(), bytes.size() - place), number);
    }
    }
}

/// The line around a place, with its end.
inline Span lineAt(const std::string& text, std::size_t place)
{
    const std::size_t before = place == 0 ? text.npos : text.rfind('\n', place - 1);
    const std::size_t begin = before == text.npos ? 0 : before + 1;
    const std::size_t end = text.find('\n', place);
    return {begin, (end == text.npos ? text.size() : end + 1) - begin};
}

/// The word around a place; one letter where there is none.
inline Span wordAt(const std::string& text, std::size_t place)
{
    const auto isLetter = [&](std::size_t i) { return std::isalnum(static_cast<unsigned char>(text[i])) != 0; };
    std::size_t begin = place;
    while (begin > 0 && isLetter(begin - 1))
        --begin;
    std::size_t end = place;
    while (end < text.size() && isLetter(end))
        ++end;
    return {begin, std::max<std::size_t>(end - begin, 1)};
}

/// Changes one line, word or number of a text, or one of its bytes.
inline void mutateText(std::string& text, Random& random)
{
    if (text.empty())
        return;
    const Span line = lineAt(text, random.below(text.size()));
    const Span other = lineAt(text, random.below(text.size()));
    const std::string lineText = text.substr(line.begin, line.length);
    const Span word = wordAt(text, random.below(text.size()));
    const Span otherWord = wordAt(text, random.below(text.size()));
    switch (random.below(12)) {
    case 0:
        text.erase(line.begin, line.length);
        break;
    case 1:
        text.insert(other.begin, lineText);
        break;
    case 2:
        for (std::size_t i = random.below(200); i > 0; --i)
            text.insert(line.begin, lineText);
        break;
    case 3:
        text.replace(other.begin, other.length, lineText);
        break;
    case 4:
        text.replace(word.begin, word.length, text.substr(otherWord.begin, otherWord.length));
        break;
    case 5:
        text.erase(word.begin, word.length);
        break;
    case 6:
    case 7:
        mutateBytes(text, random);
        break;
    default:
        changeNumber(text, random);
    }
}

} // namespace knead::fuzz
