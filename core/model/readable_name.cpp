#include "core/model/readable_name.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdint>
#include <filesystem>

namespace knead {

namespace {

constexpr std::size_t longestName = 120;
constexpr char32_t replacement = 0xFFFD;

void append(std::string& text, char32_t letter)
{
    const auto byte = [&](char32_t bits) { text += static_cast<char>(static_cast<unsigned char>(bits)); };
    if (letter < 0x80) {
        byte(letter);
    } else if (letter < 0x800) {
        byte(0xC0 | (letter >> 6U));
        byte(0x80 | (letter & 0x3FU));
    } else if (letter < 0x10000) {
        byte(0xE0 | (letter >> 12U));
        byte(0x80 | ((letter >> 6U) & 0x3FU));
        byte(0x80 | (letter & 0x3FU));
    } else {
        byte(0xF0 | (letter >> 18U));
        byte(0x80 | ((letter >> 12U) & 0x3FU));
        byte(0x80 | ((letter >> 6U) & 0x3FU));
        byte(0x80 | (letter & 0x3FU));
    }
}

/// The letter that starts at `text[at]`; moves `at` behind it. Broken sequences give the replacement character.
char32_t nextLetter(std::string_view text, std::size_t& at)
{
    const auto first = static_cast<unsigned char>(text[at++]);
    if (first < 0x80)
        return first;
    const int more = first >= 0xF0 && first < 0xF5 ? 3 : first >= 0xE0 ? 2 : first >= 0xC2 ? 1 : 0;
    if (more == 0 || first >= 0xF5)
        return replacement;
    char32_t letter = first & (0x3FU >> static_cast<unsigned>(more));
    for (int i = 0; i < more; ++i) {
        if (at >= text.size() || (static_cast<unsigned char>(text[at]) & 0xC0U) != 0x80U)
            return replacement;
        letter = (letter << 6U) | (static_cast<unsigned char>(text[at++]) & 0x3FU);
    }
    static constexpr std::array<char32_t, 4> least{0, 0x80, 0x800, 0x10000};
    const bool isSurrogate = letter >= 0xD800 && letter < 0xE000;
    return letter < least[static_cast<std::size_t>(more)] || letter > 0x10FFFF || isSurrogate ? replacement : letter;
}

char32_t nextLetter(std::u16string_view text, std::size_t& at)
{
    const char32_t first = text[at++];
    if (first < 0xD800 || first >= 0xE000)
        return first;
    if (first >= 0xDC00 || at >= text.size() || text[at] < 0xDC00 || text[at] >= 0xE000)
        return replacement;
    return 0x10000 + ((first - 0xD800) << 10U) + (static_cast<char32_t>(text[at++]) - 0xDC00);
}

template <typename Text>
std::string readable(Text text)
{
    std::string name;
    for (std::size_t at = 0; at < text.size();) {
        const char32_t letter = nextLetter(text, at);
        const bool isSpace = letter <= 0x20 || (letter >= 0x7F && letter <= 0xA0);
        if (isSpace && (name.empty() || name.back() == ' '))
            continue;
        if (name.size() + 7 > longestName) {
            name += "...";
            break;
        }
        append(name, isSpace ? U' ' : letter);
    }
    while (!name.empty() && name.back() == ' ')
        name.pop_back();
    return name;
}

bool isUtf8(std::string_view text)
{
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t start = at;
        const char32_t letter = nextLetter(text, at);
        if (letter == replacement && text.substr(start, at - start) != "\xEF\xBF\xBD")
            return false;
    }
    return true;
}

/// The text as bytes when every letter of it is one; else empty.
std::string bytesOf(std::u16string_view text)
{
    std::string bytes;
    for (const char16_t letter : text) {
        if (letter > 0xFF)
            return {};
        bytes += static_cast<char>(static_cast<unsigned char>(letter));
    }
    return bytes;
}

/// UTF-8 with letters beyond ASCII that a reader took for one letter a byte: "BÃ¼gel". Nobody means such a name.
bool isForeignUtf8(std::string_view bytes)
{
    return isUtf8(bytes) && std::ranges::any_of(bytes, [](unsigned char byte) { return byte >= 0x80; });
}

/// In lower case, with one space for spaces and what stands for them.
std::string wordsOf(std::string_view name)
{
    std::string words;
    for (const char c : name) {
        const bool isSpace = c == ' ' || c == '_' || c == '-' || c == '(' || c == ')';
        if (!isSpace)
            words += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
        else if (!words.empty() && words.back() != ' ')
            words += ' ';
    }
    if (words.ends_with(' '))
        words.pop_back();
    return words;
}

/// "SOLID", "Body1": what shapes are called. A part may well be a "Body", "Shell" or "Edge" by the will of a person.
bool isShapeNumbered(std::string_view name)
{
    static constexpr std::array<std::string_view, 13> shapes{"compound", "compsolid", "solid",   "shell", "face",
                                                             "wire",     "edge",      "vertex",  "body",  "brep",
                                                             "surface",  "shape",     "assembly"};
    std::string_view word = name;
    while (!word.empty() && (std::isdigit(static_cast<unsigned char>(word.back())) != 0 || word.back() == ' '))
        word.remove_suffix(1);
    const bool isShouted = std::ranges::none_of(name, [](unsigned char c) { return std::islower(c) != 0; });
    return (isShouted || word.size() < name.size()) && std::ranges::find(shapes, wordsOf(word)) != shapes.end();
}

bool isDigits(std::string_view text)
{
    return std::ranges::all_of(text, [](unsigned char c) { return std::isdigit(c) != 0; });
}

/// "3f2504e0-4f89-11d3-9a0c-0305e82c3301"
bool isUuid(std::string_view name)
{
    constexpr std::array<std::size_t, 4> dashes{8, 13, 18, 23};
    if (name.size() != 36)
        return false;
    for (std::size_t i = 0; i < name.size(); ++i) {
        const bool isDash = std::ranges::find(dashes, i) != dashes.end();
        if (isDash ? name[i] != '-' : std::isxdigit(static_cast<unsigned char>(name[i])) == 0)
            return false;
    }
    return true;
}

} // namespace

std::string readableName(std::string_view utf8)
{
    if (isUtf8(utf8))
        return readable(utf8);
    std::u16string latin1;
    for (const char byte : utf8)
        latin1 += static_cast<char16_t>(static_cast<unsigned char>(byte));
    return readable(std::u16string_view(latin1));
}

std::string readableName(std::u16string_view utf16)
{
    const std::string bytes = bytesOf(utf16);
    return isForeignUtf8(bytes) ? readable(std::string_view(bytes)) : readable(utf16);
}

bool isGeneratedName(std::string_view name)
{
    // Of what translators write when they know none, and of documents that nobody has named.
    static constexpr std::array<std::string_view, 18> stock{"none",
                                                            "unknown",
                                                            "product",
                                                            "rhino product",
                                                            "document",
                                                            "root",
                                                            "default",
                                                            "untitled",
                                                            "unnamed",
                                                            "unsaved",
                                                            "noname",
                                                            "no name",
                                                            "manifold solid brep",
                                                            "solid",
                                                            "next assembly relationship",
                                                            "next assembly usage",
                                                            "next assembly usage occurrence",
                                                            "step translator"};
    if (name.starts_with("=>[") || name.starts_with("NAUO") || name.starts_with("Open CASCADE "))
        return true;
    return isDigits(name) || isUuid(name) || isShapeNumbered(name) ||
           std::ranges::find(stock, wordsOf(name)) != stock.end();
}

std::string bestPartName(const std::string& instance, const std::string& product, const std::string& fallback)
{
    if (!isGeneratedName(instance))
        return instance;
    return isGeneratedName(product) ? fallback : product;
}

std::string partNameFor(const std::string& path)
{
    const std::string stem = readableName(std::string_view(std::filesystem::path(path).stem().string()));
    return stem.empty() ? "part" : stem;
}

} // namespace knead
