#include "io/trace/python_text.h"

#include "io/json/exact_number.h"
#include "io/json/json_text.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstddef>
#include <string_view>
#include <utility>

namespace knead::python_text {

namespace {

/// Words that a variable of a trace cannot be.
constexpr auto reserved = std::to_array<std::string_view>(
    {"False", "None",     "True",  "and",    "as",   "assert", "async",  "await",    "break",
     "class", "continue", "def",   "del",    "elif", "else",   "except", "finally",  "for",
     "from",  "global",   "if",    "import", "in",   "is",     "lambda", "nonlocal", "not",
     "or",    "pass",     "raise", "return", "try",  "while",  "with",   "yield",    "knead",
     "model", "sim",      "step",  "act",    "how",  "float",  "range",  "print",    "tool_parts"});

bool isUtf8(const std::string& value)
{
    try {
        static_cast<void>(nlohmann::json(value).dump());
        return true;
    } catch (const nlohmann::json::type_error&) {
        return false;
    }
}

std::string bytes(const std::string& value)
{
    constexpr const char* digits = "0123456789abcdef";
    std::string text = "b\"";
    for (const char c : value) {
        const auto byte = static_cast<unsigned char>(c);
        text += "\\x";
        text += digits[byte >> 4U];
        text += digits[byte & 0xfU];
    }
    return text + '"';
}

/// The separators of lines and paragraphs of Unicode become something else: a text field of Qt would make ends of lines of them.
std::string withSeparators(std::string text, std::string_view ofLines, std::string_view ofParagraphs)
{
    for (const auto& [separator, other] :
         {std::pair<std::string_view, std::string_view>("\u2028", ofLines), {"\u2029", ofParagraphs}})
        for (std::size_t at = text.find(separator); at != text.npos; at = text.find(separator, at))
            text.replace(at, separator.size(), other);
    return text;
}

std::string withoutSeparators(std::string json)
{
    return withSeparators(std::move(json), "\\u2028", "\\u2029");
}

std::string withCommas(const auto& values)
{
    std::string text;
    for (const double value : values)
        text += (text.empty() ? "" : ", ") + number(value);
    return '(' + text + ')';
}

} // namespace

std::string number(double value)
{
    if (std::isnan(value))
        return "float(\"nan\")";
    if (std::isinf(value))
        return value > 0 ? "float(\"inf\")" : "float(\"-inf\")";
    return exactText(value);
}

std::string tuple(const Vec3& value)
{
    return withCommas(std::array{value.x(), value.y(), value.z()});
}

std::string tuple(const Quaternion& value)
{
    return withCommas(std::array{value.w(), value.x(), value.y(), value.z()});
}

std::string text(const std::string& value)
{
    return withoutSeparators(quoted(value));
}

std::string path(const std::string& value)
{
    return isUtf8(value) ? text(value) : bytes(value);
}

std::string comment(const std::string& value)
{
    std::string line = withSeparators(value, " ", " ");
    for (char& c : line)
        if (static_cast<unsigned char>(c) < ' ')
            c = ' ';
    return "# " + line;
}

std::string list(const std::vector<std::uint32_t>& numbers)
{
    constexpr std::size_t shortest = 3; // that is worth a range
    std::string text;
    for (std::size_t begin = 0; begin < numbers.size();) {
        std::size_t end = begin + 1;
        while (end < numbers.size() && numbers[end] == numbers[begin] + (end - begin))
            ++end;
        if (end - begin < shortest)
            end = begin + 1;
        text += text.empty() ? "" : ", ";
        text += end - begin > 1 ? "*range(" + std::to_string(numbers[begin]) + ", " +
                                      std::to_string(std::uint64_t{numbers[end - 1]} + 1) + ')'
                                : std::to_string(numbers[begin]);
        begin = end;
    }
    return '[' + text + ']';
}

std::string literal(const std::string& json)
{
    static constexpr std::array<std::pair<std::string_view, std::string_view>, 3> words{
        {{"true", "True"}, {"false", "False"}, {"null", "None"}}};
    std::string python;
    bool isText = false;
    for (std::size_t i = 0; i < json.size();) {
        const std::string_view rest = std::string_view(json).substr(i);
        const auto word = std::ranges::find_if(words, [&](const auto& pair) { return rest.starts_with(pair.first); });
        const bool isWord = !isText && word != words.end();
        const std::size_t length = isWord ? word->first.size() : isText && rest[0] == '\\' ? 2 : 1;
        isText ^= length == 1 && rest[0] == '"';
        python += isWord ? word->second : rest.substr(0, length);
        i += length;
    }
    return withoutSeparators(std::move(python));
}

std::string material(const Material& material, const std::vector<MaterialPreset>& presets)
{
    const auto preset = std::ranges::find(presets, material, &MaterialPreset::material);
    Arguments arguments;
    if (preset != presets.end()) {
        arguments.add(text(preset->id));
    } else {
        for (const MaterialField& field : materialFields())
            arguments.addUnless(Material{}.*field.value, field.key, material.*field.value);
    }
    return "knead.Material(" + arguments.all() + ')';
}

std::string Names::add(const std::string& name, const std::string& other)
{
    std::string base;
    for (const char c : name) {
        const auto letter = static_cast<unsigned char>(c);
        if (letter < 0x80 && std::isalnum(letter) != 0)
            base += static_cast<char>(std::tolower(letter));
        else if (!base.empty() && base.back() != '_')
            base += '_';
    }
    while (!base.empty() && base.back() == '_')
        base.pop_back();
    if (base.empty() || std::isdigit(static_cast<unsigned char>(base.front())) != 0)
        base = other + (base.empty() ? "" : '_' + base);
    std::string candidate = base;
    for (int i = 2; std::ranges::find(reserved, candidate) != reserved.end() || !m_taken.insert(candidate).second; ++i)
        candidate = base + '_' + std::to_string(i);
    return candidate;
}

Arguments& Arguments::add(const std::string& value)
{
    m_text += (m_text.empty() ? "" : ", ") + value;
    return *this;
}

Arguments& Arguments::addUnless(double usual, const char* key, double value)
{
    return addUnless(number(usual), key, number(value));
}

Arguments& Arguments::addUnless(const std::string& usual, const char* key, const std::string& value)
{
    return value == usual ? *this : add(key, value);
}

} // namespace knead::python_text
